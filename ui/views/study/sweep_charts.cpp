// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/sweep_charts.h"

#include "ui/chart/quantity_colour.h"
#include "ui/kit/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
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

namespace {

/// A corner of a cell and the value there.
struct Corner {
    QPointF at;
    double value;
    [[nodiscard]] bool above() const { return value >= 0; }
};

std::optional<QPointF> crossing(const Corner& a, const Corner& b) {
    if (a.above() == b.above()) {
        return std::nullopt;
    }
    return a.at + (b.at - a.at) * (a.value / (a.value - b.value));
}

/// Corners in turn around the cell.
void addCell(const std::array<Corner, 4>& corners, std::vector<QLineF>& lines) {
    std::vector<QPointF> ends;
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (std::isnan(corners[i].value)) {
            return;
        }
        sum += corners[i].value;
        if (const auto at = crossing(corners[i], corners[(i + 1) % corners.size()])) {
            ends.push_back(*at);
        }
    }
    if (ends.size() == 2) {
        lines.emplace_back(ends[0], ends[1]);
    } else if (ends.size() == 4) { // the middle belongs to the first corner's side, or not
        const std::size_t shift = (sum >= 0) == corners[0].above() ? 0 : 3;
        lines.emplace_back(ends[shift], ends[(shift + 1) % 4]);
        lines.emplace_back(ends[(shift + 2) % 4], ends[(shift + 3) % 4]);
    }
}

} // namespace

std::vector<QLineF> zeroLines(const std::vector<double>& across, const std::vector<double>& up,
                              const std::function<double(std::size_t, std::size_t)>& at) {
    std::vector<QLineF> lines;
    const auto corner = [&](std::size_t i, std::size_t j) {
        return Corner{{across[i], up[j]}, at(i, j)};
    };
    for (std::size_t j = 0; j + 1 < up.size(); ++j) {
        for (std::size_t i = 0; i + 1 < across.size(); ++i) {
            addCell({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)},
                    lines);
        }
    }
    return lines;
}

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
