// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/line_chart.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace sparkout {

QColor chartColour(const ChartColour& colour, const QPalette& palette) {
    if (const auto* drawn = std::get_if<style::Drawn>(&colour)) {
        return style::colour(*drawn, palette);
    }
    if (const auto* fixed = std::get_if<QColor>(&colour)) {
        return *fixed;
    }
    const Tone* const of = std::get_if<Tone>(&colour);
    return of ? tone(*of, palette) : palette.color(QPalette::Text);
}

void ChartSpan::add(double value) {
    if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
}

void LineChart::read(const ChartSeries& of, const QString& name, Digits digits) {
    const auto line = std::make_shared<const std::vector<XY>>(of.points);
    const bool isPath = of.kind == ChartSeries::Kind::path;
    const bool isLogarithmic = (of.onSecond ? second : up).isLogarithmic;
    readings.push_back({of.key, {{}, name, digits, [=](double x) {
                                     return isPath ? lastValueAt(*line, x, isLogarithmic)
                                                   : valueAt(*line, x, isLogarithmic);
                                 }}});
}

const ChartSeries* LineChart::find(int key) const {
    const auto found = std::ranges::find(series, key, &ChartSeries::key);
    return found == series.end() ? nullptr : &*found;
}

namespace {

/// Adds what is always included, then the nearby objects.
ChartSpan spanOf(const LineChart& chart, bool isUpright, bool onSecond) {
    ChartSpan all;
    for (const InSight sight : {InSight::always, InSight::nearby}) {
        const ChartSpan before = all;
        const auto add = [&](double value) {
            if (sight == InSight::always
                || (value > before.low - before.size() && value < before.high + before.size())) {
                all.add(value);
            }
        };
        for (const ChartSeries& of : chart.series) {
            if (of.sight != sight || (!isUpright && of.onSecond != onSecond)) {
                continue;
            }
            for (const auto* line : {&of.points, &of.lower}) {
                for (const XY& point : *line) {
                    add(isUpright ? point.x : point.y);
                }
            }
        }
        for (const ChartZone& of : chart.zones) {
            for (const ChartSpan& range : of.ranges) {
                if (of.sight == sight && of.isUpright == isUpright && !onSecond) {
                    add(range.low);
                    add(range.high);
                }
            }
        }
        for (const ChartRule& of : chart.rules) {
            if (of.sight == sight && of.isUpright == isUpright && !onSecond) {
                add(of.at);
            }
        }
    }
    return all;
}

} // namespace

ChartSpan LineChart::places() const {
    return across.range.empty() ? spanOf(*this, true, false) : across.range;
}

ChartSpan LineChart::values(bool onSecond) const {
    const ChartAxis& axis = onSecond ? second : up;
    ChartSpan span = axis.range.empty() ? spanOf(*this, false, onSecond) : axis.range;
    if (axis.isSymmetric && !span.empty()) {
        const double most = std::max({std::abs(span.low), std::abs(span.high), 1e-12});
        span = {-most, most};
    }
    return span;
}

} // namespace sparkout
