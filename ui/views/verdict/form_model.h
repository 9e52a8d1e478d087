// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/table_model.h"

#include <optional>

namespace sparkout {

/// The form of zones that hold several sections: a row a quantity, a column a zone.
class FormModel : public TableModel {
    Q_OBJECT
public:
    enum Row { roundness, cylindricity, totalRunout, taper, crown, count_ };

    using TableModel::TableModel;

    /// Empty where each zone is one section.
    void setOutcome(OutcomePtr outcome);
    void setGreyed(bool grey); ///< the numbers are of inputs that are no longer those shown
    void retranslate() override;
    /// Nothing where strips stay uncut.
    [[nodiscard]] std::optional<double> value_um(int row, int zone) const;
    /// The whole table as tab-separated text with a head line.
    [[nodiscard]] QString asTsv() const;

private:
    [[nodiscard]] int rowsShown() const override { return columnsShown() > 0 ? count_ : 0; }
    [[nodiscard]] int columnsShown() const override;
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int row, int role) const override;
    [[nodiscard]] QString text(int row, int zone) const;
    [[nodiscard]] QString zoneName(int zone, bool full) const;
    [[nodiscard]] static QString rowName(int row);
    [[nodiscard]] static QString rowHint(int row);

    OutcomePtr m_outcome;
    bool m_grey = false;
};

} // namespace sparkout
