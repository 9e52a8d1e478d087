// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/verdict.h"
#include "core/study/outcome.h"
#include "ui/results/verdict_table.h"
#include "ui/table/csv_table.h"
#include "ui/table/value_table.h"

#include <QStyledItemDelegate>

#include <vector>

namespace sparkout {

/// A setting within its range of the machine: "2 × the lower limit, range 0.001…0.05 mm".
[[nodiscard]] QString rangeText(const ConstraintResult& requirement);

/// The requirements by their usage of the limit, the greatest first and settings of the machine
/// last: the worst of each kind, or all.
class MarginModel : public TableModel {
    Q_OBJECT
public:
    enum Column { requirement, usage, value, columnCount_ };
    static constexpr int usageRole = Qt::UserRole;     ///< double
    static constexpr int lightRole = Qt::UserRole + 1; ///< Light
    static constexpr int placeRole = Qt::UserRole + 2; ///< double for a range, otherwise invalid

    using TableModel::TableModel;

    void setOutcome(OutcomePtr outcome);
    void setAllPlaces(bool all);
    void setIcons(const LightIcons& icons);
    void setStacked(bool stacked); ///< a limit is below its value, for a narrow table

    [[nodiscard]] const ConstraintResult& at(int row) const {
        return m_rows[static_cast<std::size_t>(row)];
    }
    /// The row of the same requirement at the same place, otherwise of its kind; −1 if there is
    /// none.
    [[nodiscard]] int rowOf(const ConstraintResult& wanted) const;
    [[nodiscard]] QString asTsv() const;
    [[nodiscard]] CsvTable table() const; ///< with all digits

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int columnsShown() const override { return columnCount_; }
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    void fill();
    [[nodiscard]] static QString text(const ConstraintResult& c, int column);
    [[nodiscard]] static QString stackedText(const ConstraintResult& c, int column);

    OutcomePtr m_outcome;
    std::vector<ConstraintResult> m_rows;
    LightIcons m_icons;
    bool m_all = false, m_stacked = false;
};

/// Draws a requirement's name with its light on the first line of the text, in a row of any height.
class MarginName : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// Draws the usage as a bar with its percentage; a line marks the limit. A range of the machine is
/// a scale with the setting on it.
class MarginBar : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override;
};

} // namespace sparkout
