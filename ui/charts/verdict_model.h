// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/light.h"
#include "core/study/outcome.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/table_model.h"

#include <QIcon>

#include <array>
#include <vector>

namespace sparkout {

[[nodiscard]] QString lightName(Light light); ///< "holds", "close to the limit", "fails"
/// As the light has it, or that strips are left and the value is not of the whole surface.
[[nodiscard]] QString lightName(const ConstraintResult& constraint);

/// The requirements, zone by zone, then those of the part, of the passes and of the settings: a row
/// a requirement under a row that names the group.
class VerdictModel : public TableModel {
    Q_OBJECT
public:
    enum Column { requirement, value, limit, margin, columnCount_ };
    using TableModel::TableModel;

    void setOutcome(OutcomePtr outcome);
    void setGreyed(bool grey); ///< the numbers are of inputs that are no longer those shown
    void setIcons(const std::array<QIcon, 3>& icons);
    void retranslate() override;

    [[nodiscard]] bool isZoneRow(int row) const;
    /// Null for a row that names a zone. Valid as long as the outcome is shown.
    [[nodiscard]] const ConstraintResult* constraintAt(int row) const;
    /// The whole table as tab-separated text with a head line, zone and light in columns of their
    /// own.
    [[nodiscard]] QString asTsv() const;
    [[nodiscard]] CsvTable table() const; ///< with all digits

    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override { return columnCount_; }
    [[nodiscard]] QVariant cell(int line, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    struct Row {
        const ConstraintResult* constraint; ///< null: the row names the group of the next one
        Zone zone;
        int group; ///< index of the zone or section; below 0 −1 − scope
    };
    [[nodiscard]] static int groupOf(const ConstraintResult& constraint);
    [[nodiscard]] static QString groupName(const Row& row);
    [[nodiscard]] QVariant zoneData(const Row& row, bool first, int role) const;
    [[nodiscard]] QVariant requirementData(const Row& row, int column, int role) const;
    [[nodiscard]] QString text(const ConstraintResult& c, int column) const;

    OutcomePtr m_outcome;
    std::vector<Row> m_rows;
    std::array<QIcon, 3> m_icons;
    bool m_grey = false;
};

} // namespace sparkout
