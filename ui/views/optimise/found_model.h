// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/studies.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/table_model.h"

#include <optional>

namespace sparkout {

/// The best cycles that a search came upon, the quickest first.
class FoundModel : public TableModel {
    Q_OBJECT
public:
    /// The last two of a search between dressings alone.
    enum Column { time, cycle, stages, change, gap, margin, parts, cost, columnCount_ };

    using TableModel::TableModel;

    /// With the time of the cycle compared with, if it ends by itself.
    void show(SearchOutcomePtr outcome, std::optional<double> before_s);
    void setBefore(std::optional<double> before_s); ///< the choice in the table stays
    [[nodiscard]] const SearchOutcomePtr& outcome() const { return m_outcome; }
    [[nodiscard]] CsvTable table() const; ///< with all digits

private:
    [[nodiscard]] int rowsShown() const override {
        return m_outcome ? static_cast<int>(m_outcome->found.size()) : 0;
    }
    [[nodiscard]] int columnsShown() const override { return hasInterval() ? columnCount_ : parts; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] QString text(const FoundCycle& found, int column) const;
    [[nodiscard]] std::optional<double> gapOf(const FoundCycle& found) const; ///< to the limit
    [[nodiscard]] QString kindOf(const FoundCycle& found) const;

    [[nodiscard]] bool hasInterval() const { return m_outcome && m_outcome->wear; }

    SearchOutcomePtr m_outcome;
    std::optional<double> m_before_s;
};

} // namespace sparkout
