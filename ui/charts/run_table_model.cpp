// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/run_table_model.h"

#include <QFont>

namespace sparkout {

namespace {

constexpr int inputsGroup = -1, resultsGroup = -2;
constexpr qsizetype longestCell = 60, longestHead = 48; ///< shown; the copy has all of it

QString briefly(const QString& text, qsizetype longest) {
    return text.size() > longest ? text.left(longest - 1) + u'…' : text;
}

/// A unit is never broken at its stroke.
QString inOneLine(QString text) {
    return text.replace(u'/', QStringLiteral("\u2060/\u2060"));
}

} // namespace

void RunTableModel::setRows(std::vector<RunRow> rows, const QStringList& runs) {
    beginResetModel();
    m_rows = std::move(rows);
    m_runs = runs;
    m_lines.clear();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (i == 0 || m_rows[i].isResult != m_rows[i - 1].isResult) {
            m_lines.push_back(m_rows[i].isResult ? resultsGroup : inputsGroup);
        }
        m_lines.push_back(static_cast<int>(i));
    }
    endResetModel();
}

const RunRow* RunTableModel::rowAt(int row) const {
    const int line = m_lines.at(static_cast<std::size_t>(row));
    return line < 0 ? nullptr : &m_rows[static_cast<std::size_t>(line)];
}

QString RunTableModel::text(int row, int column) const {
    const RunRow* const of = rowAt(row);
    if (!of) {
        const bool inputs = m_lines[static_cast<std::size_t>(row)] == inputsGroup;
        return column > 0 ? QString() : inputs ? tr("Inputs") : tr("Results");
    }
    if (column > 0) {
        return of->shown[column - 1];
    }
    return of->unit.isEmpty() ? of->what : QStringLiteral("%1, %2").arg(of->what, of->unit);
}

QVariant RunTableModel::cell(int row, int column, int role) const {
    const QString whole = text(row, column);
    switch (role) {
    case Qt::DisplayRole: return column > 0 ? briefly(whole, longestCell) : inOneLine(whole);
    case Qt::AccessibleTextRole: return whole;
    case Qt::ToolTipRole: return column > 0 && whole.size() > longestCell ? whole : QVariant();
    case Qt::TextAlignmentRole: return aligned(column > 0);
    case Qt::FontRole: {
        QFont font;
        font.setBold(true);
        return rowAt(row) ? QVariant() : font;
    }
    default: return {};
    }
}

QVariant RunTableModel::head(int column, int role) const {
    if (role == Qt::TextAlignmentRole) {
        return aligned(column > 0).toInt() | static_cast<int>(Qt::TextWordWrap);
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
        return {};
    }
    const QString name = column == 0 ? tr("What differs") : m_runs.value(column - 1);
    return role == Qt::DisplayRole ? briefly(name, longestHead) : name;
}

/// The name of a group cannot be selected.
Qt::ItemFlags RunTableModel::flags(const QModelIndex& index) const {
    const bool isGroup = index.isValid() && !rowAt(index.row());
    return isGroup ? Qt::ItemIsEnabled : TableModel::flags(index);
}

CsvTable RunTableModel::table() const {
    CsvTable table;
    table.ownUnits = true;
    table.header << tr("What differs") << tr("Unit") << m_runs;
    for (const RunRow& row : m_rows) {
        std::vector<CsvCell> cells{row.what, row.unit};
        cells.insert(cells.end(), row.cells.begin(), row.cells.end());
        table.rows.push_back(std::move(cells));
    }
    return table;
}

} // namespace sparkout
