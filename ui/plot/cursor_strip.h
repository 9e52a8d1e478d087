// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/read_curves.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/table_model.h"

#include <QTimer>
#include <QWidget>

#include <array>

class QLabel;

namespace sparkout {

/// The readings of a plot's two cursors: a row for each curve, below their places; columns at A, at
/// B and for B − A, for each zone, section or run.
class CursorModel : public TableModel {
    Q_OBJECT
public:
    using Places = std::array<std::optional<double>, 2>;
    using TableModel::TableModel;

    void show(const QString& axis, const Places& places, const ReadCurves& curves);
    [[nodiscard]] QString asTsv() const; ///< with all digits
    [[nodiscard]] CsvTable table() const;

private:
    [[nodiscard]] int rowsShown() const override {
        return m_rows.empty() ? 0 : static_cast<int>(m_rows.size()) - 1;
    }
    [[nodiscard]] int columnsShown() const override {
        return 1 + perGroup * static_cast<int>(m_groups.size());
    }
    [[nodiscard]] QVariant cell(int line, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    static constexpr int perGroup = 3; ///< A, B and the difference

    struct Row {
        QString name;
        Digits digits = Digits::hundredths;
        bool place = false; ///< the row of the cursors' places
        std::vector<std::optional<double>> values;
    };
    [[nodiscard]] QString header(int section, QChar between) const;
    [[nodiscard]] QString valueText(const Row& row, int column) const;

    QStringList m_groups;
    std::vector<Row> m_rows;
};

class CopyTable;
class NumberField;
class PlotCursors;
class ReasonLabel;

/// The strip below a plot with cursors: fields for their places, and the values of the curves
/// there.
class CursorStrip : public QWidget {
    Q_OBJECT
public:
    explicit CursorStrip(PlotCursors& cursors, QWidget* parent = nullptr);

    [[nodiscard]] NumberField* field(std::size_t cursor) const { return m_fields.at(cursor); }
    [[nodiscard]] CursorModel* model() const { return m_model; }
    void retranslate();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void follow(); ///< updates later, in the event loop
    void fill();
    void showReason();
    void showDifference();

    PlotCursors& m_cursors;
    QLabel* m_axis;
    QLabel* m_difference; ///< difference of the places
    std::array<QLabel*, 2> m_letters{};
    std::array<NumberField*, 2> m_fields{};
    ReasonLabel* m_reason;
    CursorModel* m_model;
    CopyTable* m_table;
    QTimer m_later;
};

} // namespace sparkout
