// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_curves.h"

#include "ui/plot/quantity_colour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double dotSize = 5, footSize = 9, chosenSize = 12; ///< [px]
constexpr double foot = 0.03; ///< height of marks of points without values, share of the axis
constexpr double sweepRoom = 0.05;
constexpr int holdingAlpha = 46;

/// The quantities to draw: of too many sections those nearest to a limit at any point.
std::vector<std::size_t> quantitiesOf(const SweepShown& shown) {
    std::vector<std::size_t> quantities = shown.entry.quantities;
    if (quantities.size() > SweepCurves::mostCurves) {
        const auto least = [&shown](std::size_t q) {
            double margin = std::numeric_limits<double>::max();
            for (const SweepPoint& point : shown.result->points) {
                if (!point.values.empty() && point.values[q].margin < margin) {
                    margin = point.values[q].margin;
                }
            }
            return margin;
        };
        std::ranges::stable_sort(quantities, {}, least);
        quantities.resize(SweepCurves::mostCurves);
        std::ranges::sort(quantities);
    }
    return quantities;
}

/// The ranges in which all points are good, as positions.
std::vector<ChartSpan> holdingOf(const SweepShown& shown) {
    const std::vector<double> places = shown.placesOf(0);
    const std::vector<SweepPoint>& points = shown.result->points;
    std::vector<ChartSpan> ranges;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (points[i].good && i > 0 && points[i - 1].good) {
            ranges.back().high = places[i];
        } else if (points[i].good) {
            ranges.push_back({places[i], places[i]});
        }
    }
    return ranges;
}

} // namespace

LineChart SweepCurves::chart(const SweepShown& shown) {
    LineChart chart;
    if (shown.empty() || shown.isMap()) {
        return chart;
    }
    const std::vector<double> places = shown.placesOf(0);
    chart.across = {.label = SweepText::inputAxis(shown.result->inputs[0]),
                    .range = {places.front(), places.back()},
                    .room = sweepRoom / 2,
                    .ticker = QSharedPointer<SweepTicker>::create(shown.scaleOf(0))};
    chart.up = {.label = SweepText::axis(*shown.result, shown.entry, shown.margins),
                .room = sweepRoom,
                .leastRoom = 1e-2};
    chart.second = {.range = {0, 1}, .room = 0};
    const std::vector<std::size_t> quantities = quantitiesOf(shown);
    addCurves(chart, shown, quantities);
    addLimits(chart, shown, quantities);
    addMarks(chart, shown, quantities);
    if (std::vector<ChartSpan> holding = holdingOf(shown); !holding.empty()) {
        chart.zones = {{.ranges = std::move(holding),
                        .key = SweepShown::holdsKey,
                        .name = tr("requirements met"),
                        .colour = Drawn::everyRequirementHolds,
                        .alpha = holdingAlpha,
                        .hasEdges = false}};
    }
    if (const auto place = shown.presentPlace(0)) {
        chart.rules = {{.at = *place,
                        .key = SweepShown::presentKey,
                        .name = tr("current value"),
                        .pen = linePen(1.5, Qt::DotLine)}};
    }
    chart.placeText = [shown](double place) { return shown.textOf(shown.pointNear(place)); };
    chart.table = [shown] { return shown.table(); };
    return chart;
}

void SweepCurves::addCurves(LineChart& chart, const SweepShown& shown,
                            const std::vector<std::size_t>& quantities) {
    const std::vector<double> places = shown.placesOf(0);
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        const SweepQuantity& quantity = shown.result->quantities[quantities[i]];
        ChartSeries curve{.key = static_cast<int>(i),
                          .name = quantity.section < 0 ? SweepText::name(quantity)
                                                       : SweepText::where(quantity),
                          .colour = style::oneOfSeries(i),
                          .pen = runPen(static_cast<int>(i), {}),
                          .mark = ChartSeries::Mark::disc,
                          .markSize = dotSize};
        for (std::size_t at = 0; at < places.size(); ++at) {
            curve.points.push_back({places[at], shown.shownAt(at, quantities[i])});
        }
        chart.series.push_back(std::move(curve));
    }
}

/// Adds the limits, which may depend on the input; equal limits of several zones are one line.
void SweepCurves::addLimits(LineChart& chart, const SweepShown& shown,
                            const std::vector<std::size_t>& quantities) {
    const std::vector<double> places = shown.placesOf(0);
    std::vector<std::vector<XY>> drawn;
    const auto isSame = [](const XY& a, const XY& b) {
        return a.y == b.y || (std::isnan(a.y) && std::isnan(b.y));
    };
    for (const std::size_t q : quantities) {
        for (const bool isHigh : {false, true}) {
            std::vector<XY> line;
            for (std::size_t i = 0; i < places.size(); ++i) {
                const SweepPoint& point = shown.result->points[i];
                const SweepValue value = point.values.empty() ? SweepValue{} : point.values[q];
                const double limit = isHigh ? value.high : value.low;
                line.push_back({places[i], shown.margins && !std::isnan(value.margin) ? 0 : limit});
            }
            const bool isNone =
                std::ranges::all_of(line, [](const XY& at) { return std::isnan(at.y); });
            if (!isNone && std::ranges::none_of(drawn, [&](const std::vector<XY>& other) {
                    return std::ranges::equal(line, other, isSame);
                })) {
                chart.series.push_back({.key = SweepShown::limitKey,
                                        .name = tr("limit"),
                                        .colour = Drawn::limit,
                                        .pen = linePen(1.5, Qt::DashLine),
                                        .points = line,
                                        .sight = InSight::nearby});
                drawn.push_back(std::move(line));
            }
        }
    }
}

/// Adds the marks of points without values, and of the chosen one.
void SweepCurves::addMarks(LineChart& chart, const SweepShown& shown,
                           const std::vector<std::size_t>& quantities) {
    for (ChartSeries& marks : shown.statusMarks(footSize, [](std::size_t) { return foot; })) {
        marks.onSecond = true;
        chart.series.push_back(std::move(marks));
    }
    if (!shown.chosen) {
        return;
    }
    ChartSeries rings{.kind = ChartSeries::Kind::points,
                      .mark = ChartSeries::Mark::ring,
                      .markSize = chosenSize,
                      .sight = InSight::never};
    const double place = shown.placeOf(*shown.chosen, 0);
    ChartSeries atFoot = rings;
    atFoot.points = {{place, foot}};
    atFoot.onSecond = true;
    for (const std::size_t q : quantities) {
        rings.points.push_back({place, shown.shownAt(*shown.chosen, q)});
    }
    chart.series.push_back(std::move(atFoot));
    chart.series.push_back(std::move(rings));
}

} // namespace sparkout
