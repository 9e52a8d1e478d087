// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_shown.h"

#include "core/project/sweep.h"
#include "ui/text/shown_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

SweepScale SweepShown::scaleOf(std::size_t input) const {
    const SweepAxis& axis = result->inputs[input].axis;
    return {axis.spacing == SweepSpacing::logarithmic, ShownScale::at(axis.input)};
}

std::vector<double> SweepShown::placesOf(std::size_t input) const {
    const SweepScale scale = scaleOf(input);
    std::vector<double> places;
    for (const double value : result->inputs[input].values) {
        places.push_back(scale.at(value));
    }
    return places;
}

double SweepShown::placeOf(std::size_t point, std::size_t input) const {
    return scaleOf(input).at(result->valuesAt(point)[input]);
}

std::optional<double> SweepShown::presentPlace(std::size_t input) const {
    if (input >= present.size() || !present[input]) {
        return std::nullopt;
    }
    const double place = scaleOf(input).at(*present[input]);
    return std::isfinite(place) ? std::optional(place) : std::nullopt;
}

double SweepShown::shownAt(std::size_t point, std::size_t quantity) const {
    const SweepPoint& at = result->points[point];
    if (at.values.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return margins ? at.values[quantity].margin : at.values[quantity].value;
}

std::size_t SweepShown::pointNear(double across, double up) const {
    const auto nearest = [this](std::size_t input, double at) {
        const std::vector<double> places = placesOf(input);
        const auto away = [at](double place) { return std::abs(place - at); };
        return static_cast<std::size_t>(std::ranges::min_element(places, {}, away)
                                        - places.begin());
    };
    return result->index(nearest(0, across), isMap() ? nearest(1, up) : 0);
}

QString SweepShown::textOf(std::size_t point) const {
    return SweepText::point(*result, point, entry);
}

std::vector<ChartSeries>
SweepShown::statusMarks(double size, const std::function<double(std::size_t)>& height) const {
    ChartSeries refused{.key = refusedKey,
                        .name = tr("refused (×)"),
                        .kind = ChartSeries::Kind::points,
                        .colour = style::Drawn::refused,
                        .mark = ChartSeries::Mark::cross,
                        .markSize = size,
                        .sight = InSight::never};
    ChartSeries notReached = refused;
    notReached.key = notReachedKey;
    notReached.name = tr("does not reach size (▲)");
    notReached.colour = style::Drawn::sizeNotReached;
    notReached.mark = ChartSeries::Mark::triangle;
    for (std::size_t i = 0; i < result->points.size(); ++i) {
        const SweepStatus status = result->points[i].status;
        if (status == SweepStatus::refused || status == SweepStatus::notReached) {
            (status == SweepStatus::refused ? refused : notReached)
                .points.push_back({placeOf(i, 0), height(i)});
        }
    }
    std::vector<ChartSeries> marks;
    for (ChartSeries* of : {&refused, &notReached}) {
        if (!of->points.empty()) {
            marks.push_back(std::move(*of));
        }
    }
    return marks;
}

ChartTable SweepShown::table() const {
    ChartTable table{tableOf(*result, entry.quantities)};
    for (std::size_t i = 0; i < result->points.size(); ++i) {
        if (result->points[i].status != SweepStatus::pending) {
            const double across = placeOf(i, 0);
            ChartTable::Place& place = table.places.emplace_back();
            place.across = {across, across};
            if (isMap()) {
                place.up = {placeOf(i, 1), placeOf(i, 1)};
            }
        }
    }
    return table;
}

CsvTable SweepShown::tableOf(const SweepResult& sweep, const std::vector<std::size_t>& quantities) {
    CsvTable table;
    for (const SweptInput& input : sweep.inputs) {
        table.header << SweepText::inputAxis(input);
    }
    table.header << tr("State");
    for (const std::size_t q : quantities) {
        const QString name = SweepText::column(sweep.quantities[q]);
        table.header << name << tr("%1: lower limit").arg(name) << tr("%1: upper limit").arg(name)
                     << tr("%1: margin").arg(name);
    }
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const SweepPoint& point = sweep.points[i];
        if (point.status == SweepStatus::pending) {
            continue;
        }
        const std::vector<double> values = sweep.valuesAt(i);
        std::vector<CsvCell> row;
        for (std::size_t of = 0; of < values.size(); ++of) {
            row.emplace_back(ShownScale::at(sweep.inputs[of].axis.input).shown(values[of]));
        }
        row.emplace_back(SweepText::status(point));
        for (const std::size_t q : quantities) {
            const SweepValue value = point.values.empty() ? SweepValue{} : point.values[q];
            row.insert(row.end(), {value.value, value.low, value.high, value.margin});
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace sparkout
