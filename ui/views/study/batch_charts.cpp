// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/batch_charts.h"

#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/study/batch_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using style::Drawn;

constexpr double countRoom = 1.08; ///< room above the highest bar of a histogram
constexpr double limitWidth = 2;   ///< [px]

constexpr double causeBar = 0.7;          ///< width of a bar relative to its row
constexpr double roomBesideCauses = 1.05; ///< room beside the longest bar
constexpr double causeShareSize = 6;      ///< [px]
constexpr double wholePercent = 100;      ///< [%]
constexpr qsizetype leastCauseRows = 5;   ///< keeps a single bar thin

constexpr double partPointSize = 5, worstRingSize = 11; ///< [px]

} // namespace

// --- histograms ---------------------------------------------------------------------------------

LineChart BatchCharts::histogram(const CharacteristicSummary& summary, bool tellsIndices) {
    const Characteristic& of = summary.characteristic;
    LineChart chart;
    const QString where = BatchText::where(of);
    if (tellsIndices && summary.ppk) {
        const QString ppk = QStringLiteral("Ppk %1").arg(BatchText::brief(*summary.ppk));
        for (const QString& name : {BatchText::name(of), BatchText::shortName(of)}) {
            chart.headings << QStringLiteral("%1, %2: %3").arg(where, Names::inSentence(name), ppk);
        }
        chart.headings << QStringLiteral("%1, %2").arg(where, ppk);
    }
    chart.headings << where;
    ChartSeries parts{.key = partsKey,
                      .name = tr("parts"),
                      .kind = ChartSeries::Kind::bars,
                      .colour = Drawn::frequency};
    for (const HistogramBar& bar : summary.histogram) {
        parts.barWidth = bar.high - bar.low;
        if (bar.count > 0) { // an empty bar would still be a line
            parts.points.push_back({(bar.low + bar.high) / 2, static_cast<double>(bar.count)});
        }
    }
    chart.series.push_back(std::move(parts));
    for (const std::optional<double>& limit : {of.low, of.high}) {
        if (limit) {
            chart.rules.push_back({.at = *limit,
                                   .key = limitsKey,
                                   .name = tr("drawing limits"),
                                   .colour = Drawn::limit,
                                   .pen = linePen(limitWidth)});
        }
    }
    if (summary.mean95) {
        chart.rules.push_back({.at = summary.moments.mean,
                               .key = meanKey,
                               .name = tr("mean"),
                               .colour = Drawn::mean,
                               .pen = linePen(1.5, Qt::DashLine)});
    }
    chart.placeText = [of, bars = summary.histogram](double place) {
        for (const HistogramBar& bar : bars) {
            if (place >= bar.low && place < bar.high) {
                return tr("%1: %2 %3, %n part(s)", nullptr, static_cast<int>(bar.count))
                    .arg(BatchText::full(of),
                         BatchText::mark(bar.low, of) + u'…' + BatchText::mark(bar.high, of),
                         unitText(of.unit));
            }
        }
        return QString();
    };
    return chart;
}

ChartGrid BatchCharts::histograms(const BatchSummary& summary, const std::string& name,
                                  bool tellsIndices) {
    ChartGrid grid{.sharesValues = true};
    ChartTable table;
    table.cells.byPlace = true;
    table.cells.header << tr("Where") << tr("From") << tr("To") << tr("Unit") << tr("Parts");
    ChartSpan values;
    double most = 1;
    for (const std::size_t i : placesOf(summary, name, mostPlaces)) {
        const CharacteristicSummary& each = summary.characteristics[i];
        const Characteristic& of = each.characteristic;
        for (const HistogramBar& bar : each.histogram) {
            const auto count = static_cast<double>(bar.count);
            values.add(bar.low);
            values.add(bar.high);
            most = std::max(most, count);
            table.cells.rows.push_back(
                {BatchText::where(of), bar.low, bar.high, unitText(of.unit), count});
            table.places.push_back({.across = {bar.low, bar.high}, .key = partsKey});
        }
        grid.cells.push_back(histogram(each, tellsIndices));
        for (const ChartRule& rule : grid.cells.back().rules) {
            values.add(rule.at);
        }
        grid.caption = BatchText::axis(of);
    }
    for (LineChart& chart : grid.cells) {
        chart.across = {.range = values, .hasGrid = false};
        chart.up = {
            .label = tr("Parts"), .range = {0, countRoom * most}, .room = 0, .isCounted = true};
    }
    if (!grid.cells.empty()) {
        grid.columns = grid.cells.size();
        grid.cells.front().table = [table] { return table; };
    }
    return grid;
}

CsvTable BatchCharts::histogramsTable(const BatchSummary& summary) {
    CsvTable table;
    table.ownUnits = true;
    table.header << tr("Where") << tr("Characteristic") << tr("From") << tr("To") << tr("Unit")
                 << tr("Parts");
    for (const CharacteristicSummary& each : summary.characteristics) {
        const Characteristic& of = each.characteristic;
        for (const HistogramBar& bar : each.histogram) {
            table.rows.push_back({BatchText::where(of), BatchText::name(of), bar.low, bar.high,
                                  unitText(of.unit), static_cast<double>(bar.count)});
        }
    }
    return table;
}

// --- causes of rejects --------------------------------------------------------------------------

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

// --- two quantities -----------------------------------------------------------------------------

QString BatchCharts::quantityName(const BatchOutcome& outcome, BatchQuantity quantity) {
    const Characteristic* const of = outcome.characteristicOf(quantity);
    return of ? QStringLiteral("%1, %2").arg(BatchText::full(*of), unitText(of->unit))
              : BatchText::factorAxis(outcome.factors[quantity]);
}

LineChart BatchCharts::scatter(const BatchOutcomePtr& outcome, BatchQuantity across,
                               BatchQuantity up) {
    const auto dots = [](Key key, const QString& name, Drawn colour) {
        return ChartSeries{.key = key,
                           .name = name,
                           .kind = ChartSeries::Kind::points,
                           .colour = colour,
                           .mark = ChartSeries::Mark::disc,
                           .markSize = partPointSize};
    };
    ChartSeries good = dots(goodKey, tr("parts"), Drawn::goodPart);
    ChartSeries outside = dots(outsideKey, tr("parts beyond a limit shown"), Drawn::partOutside);
    ChartSeries worst = dots(worstKey, tr("worst part"), Drawn::worstPart);
    worst.mark = ChartSeries::Mark::ring;
    worst.markSize = worstRingSize;
    std::vector<std::size_t> goodRows, outsideRows;
    const std::vector<PartRow>& rows = outcome->result.statistics.rows;
    const auto isOutside = [outcome, across, up](std::size_t row) {
        return outcome->isOutside(row, across) || outcome->isOutside(row, up);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const XY point{outcome->valueOf(i, across), outcome->valueOf(i, up)};
        if (std::isfinite(point.x) && std::isfinite(point.y)) {
            (isOutside(i) ? outside : good).points.push_back(point);
            (isOutside(i) ? outsideRows : goodRows).push_back(i);
            if (rows[i].part == outcome->summary.worstPart) {
                worst.points.push_back(point);
            }
        }
    }
    LineChart chart;
    const auto axis = [&](BatchQuantity quantity, bool isUpright) {
        const Characteristic* const of = outcome->characteristicOf(quantity);
        for (const std::optional<double>& limit :
             {of ? of->low : std::nullopt, of ? of->high : std::nullopt}) {
            if (limit) {
                chart.rules.push_back({.at = *limit,
                                       .isUpright = isUpright,
                                       .key = limitsKey,
                                       .name = tr("drawing limits"),
                                       .colour = Drawn::limit,
                                       .pen = linePen(1.5, Qt::DashLine)});
            }
        }
        return ChartAxis{.label = quantityName(*outcome, quantity), .leastRoom = 1e-3};
    };
    chart.across = axis(across, true);
    chart.up = axis(up, false);
    chart.pointed = outside.points.empty() ? 1 : 2;
    chart.series.push_back(std::move(good));
    for (ChartSeries* some : {&outside, &worst}) {
        if (!some->points.empty()) {
            chart.series.push_back(std::move(*some));
        }
    }
    chart.pointText = [=](std::size_t series, std::size_t point) {
        const std::size_t row = (series == 0 ? goodRows : outsideRows)[point];
        const auto value = [&](BatchQuantity quantity) {
            return QStringLiteral("%1 %2").arg(
                quantityName(*outcome, quantity),
                Names::significant(outcome->valueOf(row, quantity), 4));
        };
        return tr("Part %1: %2; %3")
            .arg(Names::part(outcome->result.statistics.rows[row].part), value(across), value(up));
    };
    chart.table = [=] {
        ChartTable table;
        table.cells.header << tr("Part") << quantityName(*outcome, across)
                           << quantityName(*outcome, up);
        for (std::size_t i = 0; i < outcome->result.statistics.rows.size(); ++i) {
            const double x = outcome->valueOf(i, across), y = outcome->valueOf(i, up);
            const auto part = static_cast<double>(outcome->result.statistics.rows[i].part + 1);
            table.cells.rows.push_back({part, x, y});
            table.places.push_back({{x, x}, {y, y}, isOutside(i) ? outsideKey : goodKey});
        }
        return table;
    };
    return chart;
}

} // namespace sparkout
