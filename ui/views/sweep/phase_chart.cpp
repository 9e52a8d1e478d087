// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/phase_chart.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/plot/run_dash.h"
#include "ui/text/time_unit.h"
#include "ui/views/sweep/phase_text.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double phaseRoom = 0.05; ///< room beside and above the curves
constexpr int phaseFieldAlpha = 60, failingAlpha = 38;

void addPiece(ChartSeries& line, const PhasePiece& piece, double from_mm, double to_mm) {
    line.points.push_back({piece.from_mm, from_mm * units::umPerMm});
    line.points.push_back({piece.to_mm, to_mm * units::umPerMm});
    line.points.push_back({piece.to_mm, std::numeric_limits<double>::quiet_NaN()});
}

} // namespace

LineChart PhaseChart::of(const PhaseOutcomePtr& phases) {
    LineChart chart;
    chart.across = {.label = tr("Stock per side, mm"), .room = phaseRoom / 2};
    chart.up = {.label = tr("Deviation of the diameter from nominal, µm"), .room = phaseRoom};
    if (!phases) {
        return chart;
    }
    const PhaseDecision& decision = phases->decision;
    const Part& part = *phases->project.part;
    ChartSeries largest{.key = largestKey,
                        .name = tr("maximum diameter"),
                        .colour = style::oneOfSeries(0),
                        .pen = runPen(0, {})};
    ChartSeries smallest{.key = smallestKey,
                         .name = tr("minimum diameter"),
                         .colour = style::oneOfSeries(1),
                         .pen = runPen(1, {})};
    for (const DecidedPiece& each : decision.pieces) {
        const auto low = PhaseText::sizes(each.low), high = PhaseText::sizes(each.high);
        if (low && high) {
            addPiece(largest, each.piece, low->most_mm, high->most_mm);
            addPiece(smallest, each.piece, low->least_mm, high->least_mm);
        }
    }
    chart.series = {std::move(largest), std::move(smallest)};
    chart.zones = {{.ranges = {{part.lower_deviation_um, part.upper_deviation_um}},
                    .isUpright = false,
                    .key = toleranceKey,
                    .name = tr("tolerance band"),
                    .colour = Drawn::toleranceField,
                    .alpha = phaseFieldAlpha,
                    .sight = InSight::always}};
    ChartZone failing{.key = failsKey,
                      .name = tr("stocks that fail"),
                      .colour = Drawn::fails,
                      .alpha = failingAlpha,
                      .hatch = Hatch::rising};
    for (const StockRange& each : decision.failingRanges()) {
        failing.ranges.push_back({each.from_mm, each.to_mm});
    }
    if (!failing.ranges.empty()) {
        chart.zones.push_back(std::move(failing));
    }
    chart.rules = {{.at = part.stock_mm,
                    .key = statedKey,
                    .name = tr("stated stock"),
                    .pen = linePen(1.5, Qt::DotLine)}};
    chart.across.range = {decision.range.from_mm, decision.range.to_mm};
    chart.placeText = [phases](double stock_mm) {
        return PhaseText::stock(phases->decision, stock_mm);
    };
    chart.table = [phases] { return table(phases->decision); };
    return chart;
}

ChartTable PhaseChart::table(const PhaseDecision& decision) {
    std::size_t stages = 0;
    double longest_s = 0;
    for (const DecidedPiece& each : decision.pieces) {
        stages = std::max(stages, each.piece.counts.size());
        longest_s = std::max(longest_s, each.time_s);
    }
    const TimeUnit unit(longest_s);
    ChartTable table;
    QStringList& header = table.cells.header;
    header << tr("From stock per side, mm") << tr("To stock per side, mm");
    for (std::size_t i = 0; i < stages; ++i) {
        header << tr("Steps of stage %1").arg(i + 1);
    }
    header << unit.titled(tr("Time")) << tr("Minimum deviation of the diameter, µm")
           << tr("Maximum deviation of the diameter, µm") << tr("Verdict");
    for (const DecidedPiece& each : decision.pieces) {
        std::vector<CsvCell> row{each.piece.from_mm, each.piece.to_mm};
        for (std::size_t i = 0; i < stages; ++i) {
            row.push_back(i < each.piece.counts.size() ? CsvCell(double(each.piece.counts[i]))
                                                       : CsvCell());
        }
        row.emplace_back(unit.of(each.time_s));
        const auto low = PhaseText::sizes(each.low), high = PhaseText::sizes(each.high);
        row.push_back(low && high ? CsvCell(low->least_mm * units::umPerMm) : CsvCell());
        row.push_back(low && high ? CsvCell(high->most_mm * units::umPerMm) : CsvCell());
        row.emplace_back(PhaseText::pieceVerdict(each));
        table.cells.rows.push_back(std::move(row));
        table.places.push_back({.across = {each.piece.from_mm, each.piece.to_mm}});
    }
    return table;
}

} // namespace sparkout
