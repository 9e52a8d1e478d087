// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/slider_scale.h"

#include "core/project/machine.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sparkout {

namespace {

constexpr double stopsWanted = 100; ///< approximate number of round values on a scale
constexpr std::size_t mostStops = 2000;
constexpr double logarithmicFrom = 20; ///< ratio of the ends
constexpr double finestShare = 0.1;    ///< below it a scale from zero is not refined
constexpr double tolerance = 1e-9;     ///< of a number of steps
constexpr double beyond = 1e-6;        ///< least size of a great step, relative to the value

/// Removes the rounding of a multiplication: 0.0038000000000000004 → 0.0038.
double tidy(double value) {
    char text[40];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 12);
    double tidied = value;
    std::from_chars(text, end, tidied);
    return tidied;
}

/// The greatest number of the series 1, 2, 5, 10 … at or below x; x > 0.
double roundBelow(double x) {
    const double decade = std::pow(10.0, std::floor(std::log10(x) + tolerance));
    const double lead = x / decade * (1 + tolerance);
    return tidy(decade * (lead < 2 ? 1 : lead < 5 ? 2 : 5));
}

/// The least number of the series at or above x; x > 0.
double roundAbove(double x) {
    const double below = roundBelow(x);
    if (below >= x * (1 - tolerance)) {
        return below;
    }
    const double lead = below / std::pow(10.0, std::floor(std::log10(below) + tolerance));
    return tidy(below * (lead > 1.5 && lead < 3 ? 2.5 : 2));
}

} // namespace

SliderSpec sliderSpec(const Project& project, const std::string& path, const Field& field) {
    SliderSpec spec{field.soft.unbounded() ? field.stated() : field.soft, field.stated(),
                    field.kind == Kind::integer || field.kind == Kind::optionalInteger, false,
                    std::nullopt};
    if (const std::vector<double>* machine = machineRange(project, path)) {
        const double low = std::max((*machine)[0], field.stated().low);
        const double high = std::min((*machine)[1], field.stated().high);
        if (low < high) {
            spec.usual = {low, high};
            if ((*machine)[2] > 0) {
                spec.step = (*machine)[2];
            }
            return spec;
        }
    }
    spec.zero = spec.usual.low > 0 && field.stated().contains(0);
    return spec;
}

SliderScale::SliderScale(const SliderSpec& spec, std::optional<double> value)
    : m_spec(spec), m_low(spec.zero ? 0 : spec.usual.low), m_high(spec.usual.high) {
    if (value && *value < m_low) {
        m_low = *value > 0 ? std::max(roundBelow(*value), spec.allowed.low) : *value;
    }
    if (value && *value > m_high) {
        m_high = *value > 0 ? std::min(roundAbove(*value), spec.allowed.high) : *value;
    }
    if (m_low == 0) {
        m_kind = Kind::fromZero;
    } else if (m_low > 0 && m_high / m_low >= logarithmicFrom) {
        m_kind = Kind::logarithmic;
    }
    findStops();
}

bool SliderScale::extended() const {
    return m_high > m_spec.usual.high || (m_low < m_spec.usual.low && !m_spec.zero);
}

double SliderScale::shareOf(double value) const {
    if (!(m_high > m_low)) {
        return 0;
    }
    const double inside = std::clamp(value, m_low, m_high);
    switch (m_kind) {
    case Kind::fromZero: return std::sqrt(inside / m_high);
    case Kind::logarithmic: return std::log(inside / m_low) / std::log(m_high / m_low);
    case Kind::even: break;
    }
    return (inside - m_low) / (m_high - m_low);
}

double SliderScale::slopeAt(double value) const {
    switch (m_kind) {
    case Kind::fromZero: return 2 * m_high * std::max(shareOf(value), finestShare);
    case Kind::logarithmic: return std::clamp(value, m_low, m_high) * std::log(m_high / m_low);
    case Kind::even: break;
    }
    return m_high - m_low;
}

double SliderScale::stepAt(double value) const {
    const double wanted = slopeAt(value) / stopsWanted;
    if (m_spec.step) {
        return tidy(*m_spec.step * roundBelow(std::max(1.0, wanted / *m_spec.step)));
    }
    const double step = roundBelow(wanted);
    return m_spec.integer ? std::max(1.0, step) : step;
}

/// From the low end on, each stop is the next multiple of the step that applies there.
void SliderScale::findStops() {
    const double origin = m_spec.step ? m_spec.usual.low : 0;
    double value = m_low;
    while (value < m_high && m_stops.size() < mostStops) {
        if (m_spec.allowed.contains(value)) {
            m_stops.push_back(value);
        }
        const double step = stepAt(value);
        value = tidy(origin + (std::floor((value - origin) / step + tolerance) + 1) * step);
    }
    m_stops.push_back(m_high);
}

double SliderScale::valueAt(double share) const {
    const auto above =
        std::lower_bound(m_stops.begin(), m_stops.end(), share,
                         [this](double stop, double wanted) { return shareOf(stop) < wanted; });
    if (above == m_stops.begin() || above == m_stops.end()) {
        return above == m_stops.end() ? m_stops.back() : *above;
    }
    const double below = *std::prev(above);
    return share - shareOf(below) < shareOf(*above) - share ? below : *above;
}

double SliderScale::stepped(double value, int steps) const {
    for (; steps > 0; --steps) {
        const auto next = std::upper_bound(m_stops.begin(), m_stops.end(), value);
        value = next == m_stops.end() ? m_stops.back() : *next;
    }
    for (; steps < 0; ++steps) {
        const auto next = std::lower_bound(m_stops.begin(), m_stops.end(), value);
        value = next == m_stops.begin() ? m_stops.front() : *std::prev(next);
    }
    return value;
}

double SliderScale::leapt(double value, int leaps) const {
    if (m_kind != Kind::logarithmic) {
        return stepped(value, 10 * leaps);
    }
    for (int i = 0; i < std::abs(leaps); ++i) {
        const double to =
            leaps > 0 ? roundAbove(value * (1 + beyond)) : roundBelow(value * (1 - beyond));
        value = valueAt(shareOf(to));
    }
    return value;
}

} // namespace sparkout
