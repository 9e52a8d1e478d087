// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/batch_figures.h"

#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "ui/views/batch/batch_text.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

struct BatchFigures {
    Q_DECLARE_TR_FUNCTIONS(BatchFigures)
};

using Figures = CharacteristicFigures;

const QString dash = QStringLiteral("–");

/// The displayed percentiles: those of ±3s of a normal quantity, and the median.
struct ShownPercentile {
    const char* key;
    double order;
};
constexpr ShownPercentile shownPercentiles[] = {
    {"low_percentile", 0.00135}, {"median", 0.5}, {"high_percentile", 0.99865}};

QString percentileName(double order) {
    return order == 0.5 ? BatchFigures::tr("Median")
                        : BatchFigures::tr("Percentile %1 %").arg(QLocale().toString(100 * order));
}

QString percentileHint(double order) {
    const QString text =
        order < 0.5 ? BatchFigures::tr("%1 % of the parts lie below this value, as below mean − 3 "
                                       "s of a normal quantity; given for 741 parts or more")
        : order > 0.5 ? BatchFigures::tr("%1 % of the parts lie above this value, as above mean + "
                                         "3 s of a normal quantity; given for 741 parts or more")
                      : QString();
    return text.isEmpty() ? text : text.arg(QLocale().toString(100 * std::min(order, 1 - order)));
}

QString percentileText(const Figures& figures, double order) {
    const auto found = std::ranges::find(figures.of->percentiles, order, &Percentile::order);
    return figures.isSample && found != figures.of->percentiles.end()
               ? BatchText::percentile(*found, *figures.of)
               : dash;
}

QString textOf(const Output<Figures>& row, const Figures& figures) {
    const Characteristic& of = figures.of->characteristic;
    const std::string_view key = row.key;
    const OutputValue value = row.of(figures);
    if (key == "normality_probability") {
        return BatchText::normality(*figures.of);
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return key == "standard_deviation" ? BatchText::scatter(*number, of)
                                           : BatchText::value(*number, of);
    }
    if (const auto* interval = std::get_if<Interval>(&value)) {
        return BatchText::range(*interval, of);
    }
    if (const auto* estimate = std::get_if<Estimate>(&value)) {
        return BatchText::capability(*estimate);
    }
    const auto* const share = std::get_if<Share>(&value);
    return share ? BatchText::share(*share) : dash;
}

class Filler {
public:
    Filler(ValueTable& table, const std::vector<Figures>& places)
        : m_table(table), m_places(places) {}

    template <class Text>
    void add(ValueHead head, Text text) {
        std::vector<ValueCell> cells;
        for (const Figures& place : m_places) {
            cells.push_back({.text = text(place)});
        }
        m_table.addRow(std::move(head), std::move(cells));
    }

private:
    ValueTable& m_table;
    const std::vector<Figures>& m_places;
};

} // namespace

ValueTable batchFigures(const BatchSummary& summary, const std::string& name, bool tellsIndices) {
    ValueTable table;
    std::vector<Figures> places;
    for (const std::size_t place : placesOf(summary, name)) {
        places.push_back({&summary.characteristics[place], summary.isSample, summary.drifts});
        const Characteristic& of = places.back().of->characteristic;
        table.columns.push_back(
            {BatchText::where(of), Names::ofMachine(BatchText::full(of), of.knowsMachine), {}});
    }
    if (places.empty()) {
        return table;
    }
    Filler filler(table, places);
    for (const Output<Figures>& row : characteristicOutputs()) {
        const std::string_view key = row.key;
        if (key == "pp") {
            for (const ShownPercentile& each : shownPercentiles) {
                filler.add({percentileName(each.order), {}, percentileHint(each.order), each.key},
                           [&each](const Figures& of) { return percentileText(of, each.order); });
            }
        }
        if (row.detail || !*row.label) {
            continue;
        }
        const bool isHidden =
            !tellsIndices && (key == "mean_interval_95" || key == "pp" || key == "ppk");
        const QString label = key == "normality_probability"
                                  ? BatchText::shortNormalityName(summary)
                                  : outputBrief(row);
        filler.add({label, {}, outputHint(row), row.key},
                   [&](const Figures& of) { return isHidden ? dash : textOf(row, of); });
    }
    return table;
}

QString figureText(const CharacteristicFigures& figures, std::string_view key) {
    const auto row = std::ranges::find_if(
        characteristicOutputs(), [key](const Output<Figures>& each) { return each.key == key; });
    return row == characteristicOutputs().end() ? dash : textOf(*row, figures);
}

CsvTable batchFiguresTable(const BatchSummary& summary) {
    CsvTable table;
    table.ownUnits = true;
    table.header << BatchFigures::tr("Where") << BatchFigures::tr("Characteristic")
                 << BatchFigures::tr("Unit");
    addOutputHeads(table.header, characteristicOutputs());
    table.header << BatchFigures::tr("Normality, test");
    const std::vector<Figures> all = figuresOf(summary);
    if (summary.isSample && !all.empty()) {
        for (const Percentile& percentile : all.front().of->percentiles) {
            addEstimateHeads(table.header, percentileName(percentile.order));
        }
    }
    for (const Figures& figures : all) {
        const Characteristic& of = figures.of->characteristic;
        std::vector<CsvCell>& row = table.rows.emplace_back();
        row = {BatchText::where(of), BatchText::name(of), unitText(of.unit)};
        addOutputCells(row, characteristicOutputs(), &figures);
        const auto& normality = figures.of->normality;
        row.push_back(normality ? CsvCell(BatchText::test(normality->test)) : CsvCell());
        for (const Percentile& percentile : figures.of->percentiles) {
            if (summary.isSample) {
                const bool isStated = BatchText::isStated(percentile, *figures.of);
                row.push_back(isStated ? CsvCell(percentile.value) : CsvCell());
                addIntervalCells(row, isStated ? percentile.interval : std::nullopt);
            }
        }
    }
    return table;
}

} // namespace sparkout
