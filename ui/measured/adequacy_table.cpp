// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/adequacy_table.h"

#include "ui/measured/measured_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <utility>

namespace sparkout {

namespace {

struct AdequacyTable {
    Q_DECLARE_TR_FUNCTIONS(AdequacyTable)
};

CsvCell optionalCell(const std::optional<double>& value) {
    return value ? CsvCell(*value) : CsvCell();
}

void addEnds(std::vector<CsvCell>& row, const std::optional<Interval>& interval) {
    row.push_back(interval ? CsvCell(interval->low) : CsvCell());
    row.push_back(interval ? CsvCell(interval->high) : CsvCell());
}

std::vector<ValueHead> headsOf() {
    return {
        {.text = AdequacyTable::tr("Quantity"), .key = "quantity", .isText = true},
        {.text = AdequacyTable::tr("Verdict"), .key = "verdict", .isText = true},
        {.text = AdequacyTable::tr("n"),
         .tip = AdequacyTable::tr("Number of measured parts"),
         .key = "count"},
        {.text = AdequacyTable::tr("Mean ± 95 %, µm"),
         .tip = AdequacyTable::tr("Mean of the measured parts with Student's interval: the mean of "
                                  "endlessly many such parts lies in it with 95 %"),
         .key = "mean"},
        {.text = AdequacyTable::tr("Predicted, µm"),
         .tip = AdequacyTable::tr(
             "Range that 95 % of the parts of the batch lie in; of corners, all of them"),
         .key = "predicted"},
        {.text = AdequacyTable::tr("F"),
         .tip = AdequacyTable::tr(
             "Variance of the measured parts over that of the batch, with what it stays between by "
             "chance with 95 %: Fisher's test"),
         .key = "scatter"},
        {.text = AdequacyTable::tr("Inside"),
         .tip = AdequacyTable::tr("Measured parts within the predicted range, as a share with the "
                                  "95 % bounds of Clopper and Pearson"),
         .key = "inside"},
    };
}

/// With all its numbers and their digits.
CsvTable sheetOf(const Project& project, const std::vector<AdequacyRow>& rows) {
    CsvTable table;
    const QString unit = unitText("µm");
    const auto inUnit = [&unit](const QString& name) {
        return QStringLiteral("%1, %2").arg(name, unit);
    };
    table.header << AdequacyTable::tr("Quantity") << AdequacyTable::tr("Where")
                 << AdequacyTable::tr("n") << inUnit(AdequacyTable::tr("Mean"))
                 << inUnit(AdequacyTable::tr("Mean, 95 % from"))
                 << inUnit(AdequacyTable::tr("Mean, 95 % to")) << inUnit(AdequacyTable::tr("s"))
                 << inUnit(AdequacyTable::tr("Predicted from"))
                 << inUnit(AdequacyTable::tr("Predicted to"))
                 << inUnit(AdequacyTable::tr("Predicted mean"))
                 << inUnit(AdequacyTable::tr("Predicted s")) << AdequacyTable::tr("F")
                 << AdequacyTable::tr("F, 95 % from") << AdequacyTable::tr("F, 95 % to")
                 << AdequacyTable::tr("Parts inside")
                 << AdequacyTable::tr("Share inside, 95 % from")
                 << AdequacyTable::tr("Share inside, 95 % to") << AdequacyTable::tr("Verdict");
    for (const AdequacyRow& of : rows) {
        const MeasuredStatistics& parts = of.measured;
        std::vector<CsvCell> row{MeasuredText::quantity(parts.quantity),
                                 MeasuredText::place(project, parts.place),
                                 static_cast<double>(parts.count), parts.mean};
        addEnds(row, of.mean95);
        row.push_back(optionalCell(parts.deviation));
        addEnds(row, of.predicted ? std::optional(Interval{of.predicted->low, of.predicted->high})
                                  : std::nullopt);
        row.push_back(of.predicted ? CsvCell(of.predicted->mean) : CsvCell());
        row.push_back(of.predicted ? optionalCell(of.predicted->deviation) : CsvCell());
        row.push_back(of.scatter ? CsvCell(of.scatter->ratio) : CsvCell());
        addEnds(row, of.scatter ? std::optional(Interval{of.scatter->low, of.scatter->high})
                                : std::nullopt);
        row.push_back(of.share ? CsvCell(static_cast<double>(of.share->inside)) : CsvCell());
        addEnds(row, of.share ? std::optional(of.share->interval) : std::nullopt);
        row.emplace_back(MeasuredText::verdict(of.verdict));
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace

ValueTable adequacyTable(const Project& project, const std::vector<AdequacyRow>& rows) {
    ValueTable table{.columns = headsOf(), .sheet = sheetOf(project, rows), .isList = true};
    for (const AdequacyRow& row : rows) {
        const QString name = MeasuredText::name(project, row.measured);
        const auto count = static_cast<double>(row.measured.count);
        table.addRow({.text = name}, {{.text = name},
                                      {.text = MeasuredText::briefVerdict(row.verdict),
                                       .tip = MeasuredText::verdict(row.verdict)},
                                      {.text = QString::number(row.measured.count), .value = count},
                                      {.text = MeasuredText::mean(row)},
                                      {.text = MeasuredText::predicted(row)},
                                      {.text = MeasuredText::scatter(row)},
                                      {.text = MeasuredText::share(row)}});
    }
    return table;
}

} // namespace sparkout
