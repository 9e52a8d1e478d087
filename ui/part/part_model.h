// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/part_study.h"
#include "ui/session/setup_state.h"
#include "ui/session/surface_status.h"
#include "ui/tables/table_model.h"

#include <map>
#include <vector>

namespace sparkout {

/// A row a surface: diameter, cycle time, verdict and least margin; behind them, once it was run,
/// what its search and its batch came to.
class PartModel : public TableModel {
    Q_OBJECT
public:
    enum Column { surface, diameter, time, verdict, margin, search, batch, columnCount_ };
    using TableModel::TableModel;

    void setPart(SetupState state, std::vector<SurfaceStatus> statuses);
    void setStudy(int id, const SurfaceStudyPtr& study); ///< of the surface
    void forgetStudies();
    [[nodiscard]] bool hasStudies() const { return !m_searches.empty() || !m_batches.empty(); }
    [[nodiscard]] QString asTsv() const;

private:
    using Studies = std::map<int, SurfaceStudyPtr>; ///< by the id of the surface
    [[nodiscard]] int rowsShown() const override;
    [[nodiscard]] int columnsShown() const override { return columnCount_; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QString text(std::size_t surface, int column) const;
    [[nodiscard]] QString searchText(const SurfaceStudy& study) const;
    [[nodiscard]] QString batchText(const SurfaceStudy& study) const;

    SetupState m_state;
    std::vector<SurfaceStatus> m_statuses;
    Studies m_searches, m_batches;
};

} // namespace sparkout
