// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/bar_scale.h"

#include "ui/chart/view_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sparkout {

namespace {

struct Span {
    double low = 0, high = 0;

    void take(double value) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

constexpr double numberRoom = 0.12; ///< beyond the bars, relative to the range

bool hasNumbersBeyond(const BarChart& chart) {
    return chart.hasTotals || !chart.sums.empty() || chart.shape != BarChart::Shape::stacked
           || chart.series.size() == 1;
}

Span spanOf(const BarChart& chart, bool onSecond) {
    Span span;
    const auto categories = static_cast<std::size_t>(chart.categories.size());
    for (std::size_t category = 0; category < categories; ++category) {
        Span stack;
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            const double value = chart.value(i, category);
            if (chart.series[i].onSecond != onSecond || !std::isfinite(value)) {
                continue;
            }
            span.take(value);
            (value < 0 ? stack.low : stack.high) += value;
        }
        if (chart.shape == BarChart::Shape::stacked) {
            span.take(stack.low);
            span.take(stack.high);
        }
    }
    if (onSecond) {
        span.high += numberRoom * (span.high - span.low);
        return span;
    }
    for (const BarBox& box : chart.boxes) {
        span.take(box.least);
        span.take(box.most);
    }
    for (const double sum : chart.sums) {
        span.take(sum);
    }
    const double lowest = span.low; // lowest value of the bars
    for (const BarLimit& limit : chart.limits) {
        span.take(limit.at);
    }
    if (chart.band) {
        span.take(chart.band->low);
        span.take(chart.band->high);
    }
    if (chart.most) {
        span.high = std::min(span.high, *chart.most);
    }
    if (hasNumbersBeyond(chart)) {
        const double room = numberRoom * (span.high - span.low);
        span.high += room;
        span.low = lowest < 0 ? std::min(span.low, lowest - room) : span.low;
    }
    return span;
}

double roundStep(double span, int steps) {
    const double rough = span / std::max(steps, 1);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double round : std::array{1.0, 2.0, 5.0}) {
        if (round * power >= rough * (1 - 1e-9)) {
            return round * power;
        }
    }
    return 10 * power;
}

BarScale scaleOf(const Span& span, int steps) {
    BarScale scale;
    const double size = span.high - span.low;
    if (!(size > 0) || !std::isfinite(size)) {
        return scale;
    }
    scale.step = roundStep(size, steps);
    const auto count = [&scale](double value) {
        return static_cast<int>(std::ceil(value / scale.step * (1 - 1e-9)));
    };
    scale.below = std::max(count(-span.low), 0);
    scale.above = std::max(count(span.high), 0);
    return scale;
}

} // namespace

double BarScale::clamped(double value) const {
    return std::isfinite(value) ? std::clamp(value, low(), high()) : 0;
}

double BarScale::share(double value) const {
    return (clamped(value) - low()) / (high() - low());
}

BarScales scalesOf(const BarChart& chart, int steps) {
    BarScales scales{scaleOf(spanOf(chart, false), steps), scaleOf(spanOf(chart, true), steps)};
    scales.first.below = scales.second.below = std::max(scales.first.below, scales.second.below);
    scales.first.above = scales.second.above = std::max(scales.first.above, scales.second.above);
    return scales;
}

QColor ChartLook::toned(const BarColour& colour) const {
    return style::dimmed(colour(palette), isDimmed);
}

QColor ChartLook::ink() const {
    return style::dimmed(palette.color(QPalette::Text), isDimmed);
}

// --- where things stand -------------------------------------------------------------------------

double ChartArea::room(const BarChart& chart) const {
    const auto categories = static_cast<double>(std::max<qsizetype>(chart.categories.size(), 1));
    return (chart.isLying ? rect.height() : rect.width()) / categories;
}

double ChartArea::barShare(const BarChart& chart) const {
    const double bars =
        chart.shape == BarChart::Shape::grouped ? static_cast<double>(chart.series.size()) : 1;
    return std::min(most, widest * std::max(bars, 1.0) / std::max(room(chart), 1.0));
}

double ChartArea::middle(const BarChart& chart, std::size_t category) const {
    const double start = chart.isLying ? rect.top() : rect.left();
    return start + (static_cast<double>(category) + 0.5) * room(chart);
}

double ChartArea::at(const BarChart& chart, const BarScale& scale, double value) const {
    const double share = scale.share(value);
    return chart.isLying ? rect.left() + share * rect.width()
                         : rect.bottom() - share * rect.height();
}

QRectF ChartArea::bar(const BarChart& chart, const BarScale& scale, std::size_t category,
                      double from, double to, double middleOf, double width) const {
    const double a = at(chart, scale, from), b = at(chart, scale, to);
    const double across = middle(chart, category) + middleOf - width / 2;
    return chart.isLying ? QRectF(std::min(a, b), across, std::abs(b - a), width)
                         : QRectF(across, std::min(a, b), width, std::abs(b - a));
}

} // namespace sparkout
