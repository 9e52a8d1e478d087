// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/stiffness_table.h"
#include "ui/tables/pasted_cells.h"
#include "ui/tables/table_model.h"

#include <QString>

#include <array>
#include <vector>

namespace sparkout {

/// The readings of a stiffness trial, typed or pasted: place, load and deflection. A row without a
/// deflection has not been read yet; an empty row follows the last one.
class StiffnessModel : public TableModel {
    Q_OBJECT

public:
    enum Column { place, load, deflection, columns };

    /// The rows of the sheet: each place at half the load and at the load, twice.
    StiffnessModel(const std::vector<double>& places_mm, double load_n, QObject* parent = nullptr);

    [[nodiscard]] std::vector<StiffnessReading> readings() const; ///< the complete ones
    /// The fault of the first invalid row; empty if there is none.
    [[nodiscard]] QString fault() const;

    void paste(const QModelIndex& from, const PastedCells& cells);
    void clear(const QModelIndexList& cells);

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    void edited();

private:
    using Row = std::array<QString, columns>;

    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override { return columns; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] static QString faultOf(const Row& row, int column);
    void put(int row, int column, const QString& text);
    void follow(); ///< adds an empty row at the end

    std::vector<Row> m_rows;
};

} // namespace sparkout
