// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/table_model.h"
#include "ui/tables/value_table.h"

namespace sparkout {

/// Shows such a table; whoever owns it makes the table anew for another result or language.
class ValueModel : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void setTable(ValueTable table);
    void setGreyed(bool grey); ///< the numbers are of inputs that are no longer those shown
    [[nodiscard]] const ValueTable& table() const { return m_table; }

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_table.rows.size()); }
    [[nodiscard]] int columnsShown() const override {
        return static_cast<int>(m_table.columns.size());
    }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] static QVariant headData(const ValueHead& head, int role, bool right);
    [[nodiscard]] QString spoken(int row, int column) const;

    ValueTable m_table;
    bool m_grey = false;
};

} // namespace sparkout
