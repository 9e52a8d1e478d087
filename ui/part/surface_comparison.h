// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/setup_state.h"
#include "ui/session/surface_status.h"
#include "ui/tables/table_model.h"

#include <QStringList>

#include <vector>

namespace sparkout {

/// The surfaces side by side: a column for each, a row for the cycle time and for every requirement
/// that any of them has, with value and limit at its worst place.
class SurfaceComparison : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void setPart(const SetupState& state, std::vector<SurfaceStatus> statuses);
    [[nodiscard]] QString asTsv() const;

private:
    [[nodiscard]] int rowsShown() const override;
    [[nodiscard]] int columnsShown() const override;
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QString text(int row, int column) const;
    [[nodiscard]] const ConstraintResult* at(int row, int column) const;

    QStringList m_names;
    std::vector<SurfaceStatus> m_statuses;
    std::vector<ConstraintKind> m_kinds;
};

} // namespace sparkout
