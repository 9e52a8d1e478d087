// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/feed_curves.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double sameTime_s = 1e-9;

double edgeOf(const Spread& spread, Edge edge) {
    return edge == Edge::low ? spread.min : edge == Edge::mean ? spread.mean : spread.max;
}

enum class Shape { fallsToZero, ramp, held };

Shape shapeOf(Quantity quantity) {
    switch (quantity) {
    case Quantity::programmedSum:
    case Quantity::actualSum: return Shape::ramp;
    case Quantity::came:
    case Quantity::left: return Shape::held;
    default: return Shape::fallsToZero;
    }
}

/// The growth of an accumulated feed over a point.
double grownBy(const FeedPoint& point, Quantity quantity, Edge edge) {
    return edgeOf(quantity == Quantity::programmedSum ? point.programmed_um : point.actual_um,
                  edge);
}

} // namespace

CycleScale::CycleScale(const FeedSeries& series, CycleAxis axis, double longest_s) {
    switch (axis) {
    case CycleAxis::time: m_factor = 1 / timeUnit_s(longest_s); break;
    case CycleAxis::revolutions: m_factor = std::max(series.revolutions_per_s, 1e-9); break;
    case CycleAxis::strokes:
        m_bounds_s = series.strokeStart_s;
        m_bounds_s.push_back(series.end_s);
        break;
    }
}

double CycleScale::at(double time_s) const {
    if (m_bounds_s.size() < 2) {
        return time_s * m_factor;
    }
    const auto it = std::upper_bound(m_bounds_s.begin() + 1, m_bounds_s.end() - 1, time_s);
    const double from = *(it - 1), to = *it;
    const auto done = static_cast<double>(it - 1 - m_bounds_s.begin());
    return to > from ? done + (time_s - from) / (to - from) : done;
}

double CycleScale::time_s(double x) const {
    if (m_bounds_s.size() < 2) {
        return x / m_factor;
    }
    const double last = static_cast<double>(m_bounds_s.size() - 2);
    const double done = std::clamp(std::floor(x), 0.0, last);
    const auto i = static_cast<std::size_t>(done);
    return m_bounds_s[i] + (x - done) * (m_bounds_s[i + 1] - m_bounds_s[i]);
}

double valueOf(const FeedPoint& point, Quantity quantity, Edge edge) {
    switch (quantity) {
    case Quantity::programmed: return edgeOf(point.programmed_um, edge);
    case Quantity::actual: return edgeOf(point.actual_um, edge);
    case Quantity::programmedSum: return edgeOf(point.programmedSum_um, edge);
    case Quantity::actualSum: return edgeOf(point.actualSum_um, edge);
    case Quantity::came: return edgeOf(point.came_um, edge);
    case Quantity::left: return edgeOf(point.left_um, edge);
    case Quantity::axialFeed: return point.axialFeed_mm_min;
    case Quantity::force: return edgeOf(point.force_n, edge);
    }
    return 0;
}

std::vector<XY> polyline(const FeedPoints& points, Quantity quantity, Edge edge,
                         const CycleScale& scale) {
    const Shape shape = shapeOf(quantity);
    std::vector<XY> line;
    line.reserve(points.size() * 2 + 2);
    double lastEnd_s = 0, lastValue = 0;
    const auto put = [&](double time_s, double y) {
        const double x = scale.at(time_s);
        if (std::isfinite(x) && std::isfinite(y)) {
            line.push_back({line.empty() ? x : std::max(x, line.back().x), y});
        }
    };
    for (const FeedPoint& p : points) {
        const double value = valueOf(p, quantity, edge);
        const bool gap = !line.empty() && p.start_s > lastEnd_s + sameTime_s;
        if (shape == Shape::fallsToZero && gap) {
            put(lastEnd_s, 0);
            put(p.start_s, 0);
        } else if (shape != Shape::fallsToZero && gap) {
            put(p.start_s, lastValue);
        }
        if (shape != Shape::ramp) {
            put(p.start_s, value);
        } else if (line.empty()) {
            put(p.start_s, value - grownBy(p, quantity, edge));
        }
        put(p.end_s, value);
        lastEnd_s = p.end_s;
        lastValue = value;
    }
    return line;
}

FeedPoints within(const FeedPoints& points, double from_s, double to_s) {
    auto first = std::partition_point(points.begin(), points.end(),
                                      [&](const FeedPoint& p) { return p.end_s < from_s; });
    auto last = std::partition_point(first, points.end(),
                                     [&](const FeedPoint& p) { return p.start_s <= to_s; });
    if (first != points.begin()) {
        --first;
    }
    if (last != points.end()) {
        ++last;
    }
    return {first, last};
}

const FeedPoint* feedPointAt(const FeedPoints& points, double time_s) {
    const auto found = std::ranges::find_if(
        points, [time_s](const FeedPoint& p) { return p.start_s <= time_s && time_s < p.end_s; });
    return found == points.end() ? nullptr : &*found;
}

} // namespace sparkout
