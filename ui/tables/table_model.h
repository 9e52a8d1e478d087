// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace sparkout {

/// A flat table for a view. A subclass gives the number of rows and columns and the contents of
/// cells and heads.
class TableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    virtual void retranslate(); ///< the texts of cells and heads have changed
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index,
                                int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

protected:
    [[nodiscard]] virtual int rowsShown() const = 0;
    [[nodiscard]] virtual int columnsShown() const = 0;
    [[nodiscard]] virtual QVariant cell(int row, int column, int role) const = 0;
    [[nodiscard]] virtual QVariant head(int column, int role) const = 0;
    [[nodiscard]] virtual QVariant side(int /*row*/, int /*role*/) const { return {}; }

    void cellsChanged(); ///< the contents have changed, but not their number
    /// For Qt::TextAlignmentRole, vertically centred.
    [[nodiscard]] static QVariant aligned(bool right);
};

} // namespace sparkout
