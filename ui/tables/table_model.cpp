// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/table_model.h"

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

} // namespace sparkout
