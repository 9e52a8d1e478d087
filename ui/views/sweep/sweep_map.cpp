// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_map.h"

#include "ui/kit/theme.h"
#include "ui/views/sweep/contour_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sparkout {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double mapSignSize = 8, mapChosenSize = 13, mapPresentSize = 12; ///< [px]
constexpr int cellsPerPoint = 4; ///< for the uneven steps of whole numbers
constexpr double uneven = 1e-6;  ///< relative to a step; larger deviations are not rounding

/// Cells of equal width along an axis, each with its point of the sweep.
struct Cells {
    double low = 0, high = 0; ///< middles of the first and the last cell
    std::vector<std::size_t> points;
};

Cells cellsOf(const std::vector<double>& places) {
    Cells cells{places.front(), places.back(), {}};
    const double step = (cells.high - cells.low) / static_cast<double>(places.size() - 1);
    bool even = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        even =
            even && std::abs(places[i] - cells.low - static_cast<double>(i) * step) < uneven * step;
    }
    const std::size_t count = even ? places.size() : places.size() * cellsPerPoint;
    for (std::size_t c = 0; c < count; ++c) {
        const double at =
            cells.low
            + (cells.high - cells.low) * static_cast<double>(c) / static_cast<double>(count - 1);
        const auto nearest =
            std::ranges::min_element(places, {}, [at](double p) { return std::abs(p - at); });
        cells.points.push_back(static_cast<std::size_t>(nearest - places.begin()));
    }
    return cells;
}

/// An axis that shows all cells.
ChartAxis axisOf(const SweepShown& shown, std::size_t input) {
    const std::vector<double> places = shown.placesOf(input);
    const double from = places.front(), to = places.back();
    const double half = (to - from) / static_cast<double>(2 * (places.size() - 1));
    return {.label = SweepText::inputAxis(shown.result->inputs[input]),
            .range = {from - half, to + half},
            .room = 0,
            .ticker = QSharedPointer<SweepTicker>::create(shown.scaleOf(input))};
}

ChartMap mapOf(const SweepShown& shown) {
    std::vector<double> worst;
    for (std::size_t i = 0; i < shown.result->points.size(); ++i) {
        const auto at = worstAt(shown.result->points[i], shown.entry);
        worst.push_back(at ? shown.shownAt(i, *at) : nan);
    }
    const Cells columns = cellsOf(shown.placesOf(0)), rows = cellsOf(shown.placesOf(1));
    ChartMap map{.label = SweepText::axis(*shown.result, shown.entry, shown.margins),
                 .across = {columns.low, columns.high},
                 .up = {rows.low, rows.high},
                 .columns = columns.points.size()};
    for (const std::size_t row : rows.points) {
        for (const std::size_t column : columns.points) {
            map.values.push_back(worst[shown.result->index(column, row)]);
        }
    }
    map.text = [shown](double across, double up) {
        return shown.textOf(shown.pointNear(across, up));
    };
    return map;
}

} // namespace

LineChart SweepMap::chart(const SweepShown& shown) {
    LineChart chart;
    if (shown.empty() || !shown.isMap()) {
        return chart;
    }
    chart.across = axisOf(shown, 0);
    chart.up = axisOf(shown, 1);
    chart.map = mapOf(shown);
    addContours(chart, shown);
    addMarks(chart, shown);
    chart.table = [shown] { return shown.table(); };
    return chart;
}

void SweepMap::addContours(LineChart& chart, const SweepShown& shown) {
    const SweepResult& sweep = *shown.result;
    const auto add = [&](ChartSeries line, const auto& valueOf) {
        for (const QLineF& piece :
             zeroLines(shown.placesOf(0), shown.placesOf(1), [&](std::size_t i, std::size_t j) {
                 return valueOf(sweep.points[sweep.index(i, j)]);
             })) {
            line.points.insert(
                line.points.end(),
                {{piece.x1(), piece.y1()}, {piece.x2(), piece.y2()}, {nan, nan}}); // a gap
        }
        if (!line.points.empty()) {
            chart.series.push_back(std::move(line));
        }
    };
    ChartSeries limit{.key = SweepShown::limitKey,
                      .name = tr("limit of this result"),
                      .kind = ChartSeries::Kind::path,
                      .colour = onMap::light,
                      .pen = linePen(2),
                      .outline = onMap::dark};
    ChartSeries holds = limit;
    holds.key = SweepShown::holdsKey;
    holds.name = tr("requirements met: edge");
    holds.colour = onMap::accent;
    add(std::move(limit), [&](const SweepPoint& point) {
        const auto worst = worstAt(point, shown.entry);
        return worst ? point.values[*worst].margin : nan;
    });
    const auto margin =
        std::ranges::find(sweep.quantities, std::string("least_margin"), &SweepQuantity::name);
    const auto q = static_cast<std::size_t>(margin - sweep.quantities.begin());
    add(std::move(holds), [q](const SweepPoint& point) {
        return q < point.values.size() ? point.values[q].value : nan;
    });
}

void SweepMap::addMarks(LineChart& chart, const SweepShown& shown) {
    const auto x = shown.presentPlace(0), y = shown.presentPlace(1);
    if (x && y) {
        chart.series.push_back({.key = SweepShown::presentKey,
                                .name = tr("current values"),
                                .kind = ChartSeries::Kind::points,
                                .colour = onMap::light,
                                .points = {{*x, *y}},
                                .mark = ChartSeries::Mark::diamond,
                                .markSize = mapPresentSize,
                                .outline = onMap::dark,
                                .swatch = Swatch::rhombus});
    }
    if (shown.chosen) {
        chart.series.push_back(
            {.key = SweepShown::chosenKey,
             .name = tr("chosen point"),
             .kind = ChartSeries::Kind::points,
             .points = {{shown.placeOf(*shown.chosen, 0), shown.placeOf(*shown.chosen, 1)}},
             .mark = ChartSeries::Mark::frame,
             .markSize = mapChosenSize,
             .swatch = Swatch::square});
    }
    for (ChartSeries& sign :
         shown.statusMarks(mapSignSize, [&shown](std::size_t i) { return shown.placeOf(i, 1); })) {
        chart.series.push_back(std::move(sign));
    }
}

} // namespace sparkout
