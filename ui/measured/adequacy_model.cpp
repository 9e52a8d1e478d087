// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/adequacy_model.h"

#include "ui/measured/measured_text.h"
#include "ui/text/texts.h"

#include <utility>

namespace sparkout {

namespace {

CsvCell optionalCell(const std::optional<double>& value) {
    return value ? CsvCell(*value) : CsvCell();
}

void addEnds(std::vector<CsvCell>& row, const std::optional<Interval>& interval) {
    row.push_back(interval ? CsvCell(interval->low) : CsvCell());
    row.push_back(interval ? CsvCell(interval->high) : CsvCell());
}

} // namespace

void AdequacyModel::show(const Project& project, std::vector<AdequacyRow> rows) {
    beginResetModel();
    m_project = project;
    m_rows = std::move(rows);
    endResetModel();
}

QString AdequacyModel::heading(int column) {
    switch (column) {
    case what: return tr("Quantity");
    case count: return tr("n");
    case mean: return tr("Mean ± 95 %, µm");
    case range: return tr("Predicted, µm");
    case scatter: return tr("F");
    case inside: return tr("Inside");
    case verdict: return tr("Verdict");
    default: return {};
    }
}

QString AdequacyModel::text(const Project& project, const AdequacyRow& row, int column) {
    switch (column) {
    case what: return MeasuredText::name(project, row.measured);
    case count: return QString::number(row.measured.count);
    case mean: return MeasuredText::mean(row);
    case range: return MeasuredText::predicted(row);
    case scatter: return MeasuredText::scatter(row);
    case inside: return MeasuredText::share(row);
    case verdict: return MeasuredText::briefVerdict(row.verdict);
    default: return {};
    }
}

QVariant AdequacyModel::cell(int row, int column, int role) const {
    const AdequacyRow& of = m_rows[static_cast<std::size_t>(row)];
    switch (role) {
    case Qt::DisplayRole: return text(m_project, of, column);
    case Qt::ToolTipRole:
        return column == verdict ? QVariant(MeasuredText::verdict(of.verdict)) : QVariant();
    case Qt::TextAlignmentRole: return aligned(column != what && column != verdict);
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1, %2: %3")
            .arg(MeasuredText::name(m_project, of.measured), heading(column),
                 text(m_project, of, column));
    default: return {};
    }
}

QVariant AdequacyModel::head(int column, int role) const {
    if (role == Qt::DisplayRole) {
        return heading(column);
    }
    if (role != Qt::ToolTipRole) {
        return {};
    }
    switch (column) {
    case count: return tr("Number of measured parts");
    case mean:
        return tr("Mean of the measured parts with Student's interval: the mean of endlessly many "
                  "such parts lies in it with 95 %");
    case range:
        return tr("Range that 95 % of the parts of the batch lie in; of corners, all of them");
    case scatter:
        return tr("Variance of the measured parts over that of the batch, with what it stays "
                  "between by chance with 95 %: Fisher's test");
    case inside:
        return tr("Measured parts within the predicted range, as a share with the 95 % bounds of "
                  "Clopper and Pearson");
    default: return {};
    }
}

CsvTable AdequacyModel::table() const {
    CsvTable table;
    const QString unit = unitText("µm");
    const auto inUnit = [&unit](const QString& name) {
        return QStringLiteral("%1, %2").arg(name, unit);
    };
    table.header << tr("Quantity") << tr("Where") << tr("n") << inUnit(tr("Mean"))
                 << inUnit(tr("Mean, 95 % from")) << inUnit(tr("Mean, 95 % to")) << inUnit(tr("s"))
                 << inUnit(tr("Predicted from")) << inUnit(tr("Predicted to"))
                 << inUnit(tr("Predicted mean")) << inUnit(tr("Predicted s")) << tr("F")
                 << tr("F, 95 % from") << tr("F, 95 % to") << tr("Parts inside")
                 << tr("Share inside, 95 % from") << tr("Share inside, 95 % to") << tr("Verdict");
    for (const AdequacyRow& of : m_rows) {
        const MeasuredStatistics& parts = of.measured;
        std::vector<CsvCell> row{MeasuredText::quantity(parts.quantity),
                                 MeasuredText::place(m_project, parts.place),
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

} // namespace sparkout
