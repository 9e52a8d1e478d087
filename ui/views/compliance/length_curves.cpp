// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/length_curves.h"

#include "core/project/part.h"
#include "ui/text/names.h"

#include <algorithm>

namespace sparkout {

double LengthCurves::middle_um(const Part& part) {
    return (part.upper_deviation_um + part.lower_deviation_um) / 2;
}

LineChart LengthCurves::chart() {
    LineChart chart;
    chart.isFramed = true;
    chart.across.label = tr("From the headstock end of the ground length, mm");
    chart.up.label = tr("Diameter from the middle of the field, µm");
    chart.up.room = 0.08;
    return chart;
}

void LengthCurves::addLimits(LineChart& chart, const Part& part, int key) {
    constexpr double farAway = 3;
    const double limit_um = (part.upper_deviation_um - part.lower_deviation_um) / 2;
    ChartSpan drawn = chart.values();
    drawn.add(0);
    if (limit_um < farAway * std::max(-drawn.low, drawn.high)) {
        drawn.add(-limit_um);
        drawn.add(limit_um);
    }
    chart.up.range = drawn;
    for (const double limit : {-limit_um, limit_um}) {
        chart.series.push_back(
            {.key = key,
             .name = tr("limits of the field, ±%1 µm").arg(Names::significant(limit_um)),
             .colour = style::Drawn::limit,
             .pen = linePen(1.5, Qt::DashLine),
             .points = {{0, limit}, {part.length_mm, limit}}});
    }
}

void LengthCurves::read(LineChart& chart, const ChartSeries& of, Digits digits) {
    if (of.points.size() < 2 || of.points.front().x >= of.points.back().x) {
        return;
    }
    if (of.kind != ChartSeries::Kind::band) {
        chart.read(of, tr("%1, µm").arg(of.name), digits);
        return;
    }
    ChartSeries lower = of;
    lower.points = of.lower;
    chart.read(lower, tr("%1: minimum, µm").arg(of.name), digits);
    chart.read(of, tr("%1: maximum, µm").arg(of.name), digits);
}

} // namespace sparkout
