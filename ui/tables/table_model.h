// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace sparkout {

/// A table as a view shows it: rows and columns that have nothing below them. A table of its own
/// says how many there are and what stands in a cell and at the heads.
class TableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    virtual void retranslate(); ///< cells and heads have other words
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

    void cellsChanged(); ///< what stands in them, not how many there are
    /// For Qt::TextAlignmentRole, in the middle of the height.
    [[nodiscard]] static QVariant aligned(bool right);
};

} // namespace sparkout
