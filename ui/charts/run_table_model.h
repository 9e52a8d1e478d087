// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/run_table.h"
#include "ui/tables/table_model.h"

namespace sparkout {

/// What the chosen runs differ in: a row an input or result under a row that names which of the
/// two, a column a run, the present one first.
class RunTableModel : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void setRows(std::vector<RunRow> rows, const QStringList& runs);
    [[nodiscard]] const std::vector<RunRow>& rows() const { return m_rows; }
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    [[nodiscard]] CsvTable
    table() const; ///< with all digits and the units in a column of their own

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_lines.size()); }
    [[nodiscard]] int columnsShown() const override {
        return m_lines.empty() ? 0 : 1 + static_cast<int>(m_runs.size());
    }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] const RunRow* rowAt(int row) const; ///< null: it names a group
    [[nodiscard]] QString text(int row, int column) const;

    std::vector<RunRow> m_rows;
    QStringList m_runs;
    std::vector<int> m_lines; ///< of the table: index of a row, or below 0 a group
};

} // namespace sparkout
