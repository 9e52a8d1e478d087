// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/value_table.h"

namespace sparkout {

/// Shows such a table; its owner updates it for another result or language. A list can be sorted by
/// any column.
class ValueModel : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void setTable(ValueTable table);
    void update(ValueTable table); ///< the same rows: keeps the selection
    void setGreyed(bool grey);     ///< for numbers of outdated inputs
    [[nodiscard]] const ValueTable& table() const { return m_table; }
    [[nodiscard]] CsvTable shown() const { return m_table.inOrder(m_order); } ///< as sorted
    [[nodiscard]] QString asTsv() const;                                      ///< for the clipboard
    /// The row of the table on a line, and the line of a row.
    [[nodiscard]] int rowAt(int line) const;
    [[nodiscard]] int lineOf(int row) const;

    void sort(int column, Qt::SortOrder order) override; ///< negative: unsorted
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_table.rows.size()); }
    [[nodiscard]] int columnsShown() const override {
        return static_cast<int>(m_table.columns.size());
    }
    [[nodiscard]] QVariant cell(int line, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int line, int role) const override;
    [[nodiscard]] QVariant headData(const ValueHead& head, int role, bool right) const;
    [[nodiscard]] const ValueHead& headOf(int line) const;
    [[nodiscard]] QString spoken(int line, int column) const;
    [[nodiscard]] QVariant inkOf(const ValueCell& cell) const;
    void arrange();

    ValueTable m_table;
    std::vector<std::size_t> m_order; ///< the rows, line by line
    int m_sorted = -1;
    Qt::SortOrder m_direction = Qt::AscendingOrder;
    bool m_grey = false;
};

} // namespace sparkout
