// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/batch_charts.h"

#include "ui/text/names.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using style::Drawn;

constexpr double causeBar = 0.7;          ///< of a row
constexpr double roomBesideCauses = 1.05; ///< beside the longest bar
constexpr double causeShareSize = 6;      ///< [px]
constexpr double wholePercent = 100;      ///< [%]
constexpr qsizetype leastCauseRows = 5;   ///< so that a single bar is no wall

} // namespace

// --- why parts fail -----------------------------------------------------------------------------

CsvTable BatchCharts::rejectsTable(const BatchSummary& summary) {
    CsvTable table;
    table.header << tr("Cause") << tr("Parts") << tr("Share of the parts, %")
                 << tr("Share of all failures, summed up, %");
    double all = 0, upTo = 0;
    for (const RejectCause& cause : summary.causes) {
        all += static_cast<double>(cause.count);
    }
    for (const RejectCause& cause : summary.causes) {
        const auto count = static_cast<double>(cause.count);
        upTo += count;
        table.rows.push_back({cause.kind ? Names::constraint(*cause.kind) : tr("Size not reached"),
                              count, wholePercent * count / static_cast<double>(summary.parts),
                              wholePercent * upTo / all});
    }
    return table;
}

LineChart BatchCharts::rejects(const BatchOutcomePtr& outcome) {
    const CsvTable table = outcome ? rejectsTable(outcome->summary) : CsvTable();
    ChartSeries counts{.key = partsKey,
                       .name = tr("parts that fail it; a part that fails several counts at each"),
                       .kind = ChartSeries::Kind::bars,
                       .colour = Drawn::frequency,
                       .barWidth = causeBar};
    ChartSeries sums{.key = sumKey,
                     .name = tr("share of all failures, summed up"),
                     .colour = Drawn::cumulativeShare,
                     .mark = ChartSeries::Mark::disc,
                     .markSize = causeShareSize,
                     .onSecond = true};
    QStringList causes;
    for (const std::vector<CsvCell>& row : table.rows) {
        const auto at = static_cast<double>(causes.size());
        causes << std::get<QString>(row[0]);
        counts.points.push_back({at, std::get<double>(row[1])});
        sums.points.push_back({at, std::get<double>(row[3])});
    }
    const double most = table.empty() ? 1 : counts.points.front().y;
    LineChart chart;
    chart.isLying = true;
    chart.across = {
        .range = {-0.5, static_cast<double>(std::max(causes.size(), leastCauseRows)) - 0.5},
        .room = 0,
        .names = causes};
    chart.up = {
        .label = tr("Parts"), .range = {0, most * roomBesideCauses}, .room = 0, .isCounted = true};
    chart.second = {.label = tr("Share of all failures, summed up, %"),
                    .range = {0, wholePercent * roomBesideCauses},
                    .room = 0};
    if (!table.empty()) {
        chart.series = {std::move(counts), std::move(sums)};
    }
    chart.table = [table] { return ChartTable{table}; };
    chart.placeText = [table](double place) {
        const auto row = std::lround(place);
        if (row < 0 || row >= std::ssize(table.rows)) {
            return QString();
        }
        const std::vector<CsvCell>& cells = table.rows[static_cast<std::size_t>(row)];
        return tr("%1: %n part(s), %2 % of the batch", nullptr,
                  static_cast<int>(std::get<double>(cells[1])))
            .arg(std::get<QString>(cells[0]), Names::significant(std::get<double>(cells[2])));
    };
    return chart;
}

} // namespace sparkout
