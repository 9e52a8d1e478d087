// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/charts/verdict_shop_text.h"
#include "ui/tables/table_model.h"

#include <vector>

namespace sparkout {

/// The shop's numbers: a row a quantity, a column a stage and a last one for the whole cycle.
class ShopModel : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void setOutcome(OutcomePtr outcome);
    void setGreyed(bool grey); ///< the numbers are of inputs that are no longer those shown
    void retranslate() override;

    [[nodiscard]] ShopRow rowAt(int row) const { return m_rows.at(static_cast<std::size_t>(row)); }
    /// Whether the number lies outside its band, which an icon and its texts say.
    [[nodiscard]] bool isOutside(int row, int column) const;
    /// The whole table as tab-separated text with a head line, and what lies outside in a column.
    [[nodiscard]] QString asTsv() const;

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override {
        return m_rows.empty() ? 0 : static_cast<int>(m_outcome->shop.stages.size()) + 1;
    }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] Operation operation() const;
    [[nodiscard]] bool isCycle(int column) const;
    [[nodiscard]] const ShopColumn& numbers(int column) const;
    [[nodiscard]] QString text(int row, int column) const;
    [[nodiscard]] QString sideText(int row, int column) const;
    [[nodiscard]] QString spoken(int row, int column) const;
    [[nodiscard]] QString columnName(int column) const;

    OutcomePtr m_outcome;
    std::vector<ShopRow> m_rows;
    bool m_grey = false;
};

} // namespace sparkout
