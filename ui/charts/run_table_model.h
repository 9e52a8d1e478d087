// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/run_table.h"

#include <QAbstractTableModel>

namespace sparkout {

/// What the chosen runs differ in: a row an input or result under a row that names which of the
/// two, a column a run, the present one first.
class RunTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    void setRows(std::vector<RunRow> rows, const QStringList& runs);
    [[nodiscard]] const std::vector<RunRow>& rows() const { return m_rows; }
    [[nodiscard]] CsvTable
    table() const; ///< with all digits and the units in a column of their own

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    [[nodiscard]] const RunRow* rowAt(int row) const; ///< null: it names a group
    [[nodiscard]] QString text(int row, int column) const;

    std::vector<RunRow> m_rows;
    QStringList m_runs;
    std::vector<int> m_lines; ///< of the table: index of a row, or below 0 a group
};

} // namespace sparkout
