// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/adequacy.h"
#include "core/project/project.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/table_model.h"

#include <vector>

namespace sparkout {

/// Measured against predicted: a row a quantity in a zone or section.
class AdequacyModel : public TableModel {
    Q_OBJECT
public:
    enum Column { what, verdict, count, mean, range, scatter, inside, columnCount_ };

    using TableModel::TableModel;

    void show(const Project& project, std::vector<AdequacyRow> rows);
    [[nodiscard]] const std::vector<AdequacyRow>& rows() const { return m_rows; }

    [[nodiscard]] static QString heading(int column);
    [[nodiscard]] static QString text(const Project& project, const AdequacyRow& row, int column);
    /// With all digits, for spreadsheets.
    [[nodiscard]] CsvTable table() const;

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override { return columnCount_; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;

    Project m_project;
    std::vector<AdequacyRow> m_rows;
};

} // namespace sparkout
