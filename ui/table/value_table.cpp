// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/table/value_table.h"

#include "ui/table/pasted_cells.h"

#include <QStringList>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace sparkout {

void TableModel::retranslate() {
    cellsChanged();
    if (columnsShown() > 0) {
        emit headerDataChanged(Qt::Horizontal, 0, columnsShown() - 1);
    }
    if (rowsShown() > 0) {
        emit headerDataChanged(Qt::Vertical, 0, rowsShown() - 1);
    }
}

void TableModel::cellsChanged() {
    if (rowsShown() > 0 && columnsShown() > 0) {
        emit dataChanged(index(0, 0), index(rowsShown() - 1, columnsShown() - 1));
    }
}

int TableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rowsShown();
}

int TableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columnsShown();
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
    return index.isValid() ? cell(index.row(), index.column(), role) : QVariant();
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    return orientation == Qt::Horizontal ? head(section, role) : side(section, role);
}

QVariant TableModel::aligned(bool right) {
    return static_cast<int>((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

QString withoutPlus(const QString& shown) {
    return shown.startsWith(u'+') && pastedNumber(shown) ? shown.mid(1) : shown;
}

void ValueTable::addRow(ValueHead head, std::vector<ValueCell> of) {
    rows.push_back(std::move(head));
    cells.push_back(std::move(of));
}

CsvTable ValueTable::asTable() const {
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    return inOrder(order);
}

CsvTable ValueTable::sheetInOrder(const std::vector<std::size_t>& order) const {
    CsvTable table = sheet;
    table.rows.clear();
    for (const std::size_t row : order) {
        if (!rows[row].isGroup) {
            const auto groups = std::count_if(rows.begin(), rows.begin() + std::ptrdiff_t(row),
                                              [](const ValueHead& head) { return head.isGroup; });
            table.rows.push_back(sheet.rows.at(row - static_cast<std::size_t>(groups)));
        }
    }
    return table;
}

CsvTable ValueTable::inOrder(const std::vector<std::size_t>& order) const {
    if (!sheet.header.isEmpty()) {
        return sheetInOrder(order);
    }
    CsvTable table;
    if (!isList) {
        table.header << corner;
    }
    for (const ValueHead& column : columns) {
        table.header << column.fullName();
    }
    if (!remarks.isEmpty()) {
        table.header << remarks;
    }
    for (const std::size_t row : order) {
        if (rows[row].isGroup) {
            continue;
        }
        std::vector<CsvCell>& line = table.rows.emplace_back();
        if (!isList) {
            line.emplace_back(rows[row].fullName());
        }
        QStringList said;
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const ValueCell& cell = cells[row][column];
            const QString shown = columns[column].isText ? cell.text : withoutPlus(cell.text);
            line.push_back(cell.value.index() == 0 ? CsvCell(shown) : cell.value);
            if (!cell.remark.isEmpty()) {
                said << QStringLiteral("%1: %2").arg(columns[column].fullName(), cell.remark);
            }
        }
        if (!remarks.isEmpty()) {
            line.emplace_back(said.join(QStringLiteral("; ")));
        }
    }
    return table;
}

} // namespace sparkout
