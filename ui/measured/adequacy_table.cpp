// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/adequacy_table.h"

#include "ui/measured/measured_text.h"
#include "ui/tables/output_cells.h"
#include "ui/text/output_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <span>
#include <string_view>

namespace sparkout {

namespace {

struct AdequacyTable {
    Q_DECLARE_TR_FUNCTIONS(AdequacyTable)
};

/// The sort key; missing values come last.
template <class Of, class Number>
CsvCell orNone(const std::optional<Of>& of, Number Of::*number) {
    return of ? CsvCell(static_cast<double>((*of).*number)) : CsvCell(QString());
}

template <class Owner>
QString hintOf(std::span<const Output<Owner>> rows, std::string_view key) {
    const auto row = std::ranges::find(rows, key, &Output<Owner>::key);
    Q_ASSERT(row != rows.end());
    return outputHint(*row);
}

std::vector<ValueHead> headsOf() {
    return {
        {.text = AdequacyTable::tr("Quantity"), .key = "quantity", .isText = true},
        {.text = AdequacyTable::tr("Verdict"), .key = "verdict", .isText = true},
        {.text = AdequacyTable::tr("n"), .tip = hintOf(adequacyOutputs(), "count"), .key = "count"},
        {.text = AdequacyTable::tr("Mean ± 95 %, µm"),
         .tip = hintOf(adequacyOutputs(), "mean_95_um"),
         .key = "mean"},
        {.text = AdequacyTable::tr("Bias (limit), µm"),
         .tip = hintOf(adequacyOutputs(), "bias_95_um"),
         .key = "bias"},
        {.text = AdequacyTable::tr("Predicted, µm"),
         .tip = hintOf(predictedOutputs(), "low_um"),
         .key = "predicted"},
        {.text = AdequacyTable::tr("F"),
         .tip = hintOf(varianceRatioOutputs(), "value"),
         .key = "scatter"},
        {.text = AdequacyTable::tr("Inside"),
         .tip = hintOf(insideShareOutputs(), "interval_95"),
         .key = "inside"}};
}

/// The table with all numbers and their digits.
CsvTable sheetOf(const Project& project, const std::vector<AdequacyRow>& rows) {
    CsvTable table;
    table.header << AdequacyTable::tr("Quantity") << AdequacyTable::tr("Where");
    addOutputHeads(table.header, adequacyOutputs());
    addOutputHeads(table.header, predictedOutputs());
    addOutputHeads(table.header, varianceRatioOutputs());
    addOutputHeads(table.header, insideShareOutputs());
    table.header << AdequacyTable::tr("Verdict");
    for (const AdequacyRow& row : rows) {
        const auto ownerOf = [](const auto& part) { return part ? &*part : nullptr; };
        const AdequacyOf of{project, row};
        std::vector<CsvCell>& cells = table.rows.emplace_back();
        cells = {MeasuredText::quantity(row.measured.quantity),
                 MeasuredText::place(project, row.measured.place)};
        addOutputCells(cells, adequacyOutputs(), &of);
        addOutputCells(cells, predictedOutputs(), ownerOf(row.predicted));
        addOutputCells(cells, varianceRatioOutputs(), ownerOf(row.scatter));
        addOutputCells(cells, insideShareOutputs(), ownerOf(row.share));
        cells.emplace_back(MeasuredText::verdict(row.verdict));
    }
    return table;
}

} // namespace

ValueTable adequacyTable(const Project& project, const std::vector<AdequacyRow>& rows) {
    ValueTable table{.columns = headsOf(), .sheet = sheetOf(project, rows), .isList = true};
    for (const AdequacyRow& row : rows) {
        const QString name = MeasuredText::name(project, row.measured);
        const auto count = static_cast<double>(row.measured.count);
        table.addRow(
            {.text = name},
            {{.text = name},
             {.text = MeasuredText::briefVerdict(row.verdict),
              .tip = MeasuredText::verdict(row.verdict)},
             {.text = QString::number(row.measured.count), .value = count},
             {.text = MeasuredText::mean(row), .value = row.measured.mean},
             {.text = MeasuredText::bias(row), .value = orNone(row.bias95, &Interval::low)},
             {.text = MeasuredText::predicted(row),
              .value = orNone(row.predicted, &PredictedRange::low)},
             {.text = MeasuredText::scatter(row),
              .value = orNone(row.scatter, &VarianceRatio::ratio)},
             {.text = MeasuredText::share(row), .value = orNone(row.share, &InsideShare::inside)}});
    }
    return table;
}

} // namespace sparkout
