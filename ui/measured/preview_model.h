// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"
#include "ui/tables/table_model.h"

#include <QStringList>

#include <string_view>
#include <vector>

namespace sparkout {

/// The first rows of a table of measurements, as they are taken apart, with the faults of cells.
class PreviewModel : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void show(std::string_view text, const MeasuredTable& table);
    void setFaults(const CellFaults& faults);

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override { return m_columns; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] QString faultAt(int row, int column) const;

    QStringList m_heads;
    std::vector<QStringList> m_rows;
    std::vector<std::size_t> m_lines; ///< in which the rows begin
    int m_columns = 0;
    CellFaults m_faults; ///< of these lines
};

} // namespace sparkout
