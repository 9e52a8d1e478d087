// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/painted_layer.h"
#include "ui/chart/read_curves.h"
#include "ui/table/csv_table.h"
#include "ui/table/value_table.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <functional>
#include <optional>

class QLabel;

namespace sparkout {

class CopyTable;
class NumberField;
class ReasonLabel;

/// The properties of a plot that its cursors need.
struct CursorSubject {
    std::function<QString()> axis;      ///< name of the horizontal axes, with the unit
    std::function<QCPRange()> span;     ///< the places there are
    std::function<ReadCurves()> curves; ///< the visible curves, row by row
    /// Converts a place into a value that survives a change of the axis' unit, and back [identity].
    std::function<double(double)> keep, place;
};

/// Two vertical lines, A and B, through every axis rect of a plot, to read its curves at. They are
/// dragged with the mouse, moved with Shift and arrows (A) or Ctrl, Shift and arrows (B), or placed
/// by typing; while shown they are part of exported pictures.
class PlotCursors : public PaintedLayer {
    Q_OBJECT
public:
    static constexpr std::size_t count = 2;

    PlotCursors(QCustomPlot& plot, CursorSubject subject);

    QAction* toggle; ///< shows and hides them
    [[nodiscard]] bool shown() const { return toggle->isChecked() && !mParentPlot->isHidden(); }
    /// The place of a cursor on the current axis; empty before it was first shown.
    [[nodiscard]] std::optional<double> at(std::size_t cursor) const;
    void moveTo(std::size_t cursor, double x);
    [[nodiscard]] static QString letter(std::size_t cursor); ///< "A", "B"
    [[nodiscard]] const CursorSubject& subject() const { return m_subject; }
    [[nodiscard]] QCustomPlot& plot() const { return *mParentPlot; }
    void retranslate();

signals:
    void moved();
    void shownChanged();

protected:
    void draw(QCPPainter* painter) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drawTag(QCPPainter& painter, const QCPAxisRect& rect, std::size_t cursor, double x) const;
    void showThem(bool on);
    [[nodiscard]] std::vector<QCPAxisRect*> rects() const; ///< rects with a horizontal axis
    [[nodiscard]] std::optional<std::size_t> cursorAt(const QPointF& at) const;
    void dragTo(const QPointF& at);
    bool onMouse(QMouseEvent& event);
    bool onKey(const QKeyEvent& event);
    bool takes(QEvent& event); ///< handles an event of the visible cursors
    void step(std::size_t cursor, int steps);
    [[nodiscard]] double rounded(double x) const; ///< to the resolution of a pixel

    CursorSubject m_subject;
    std::array<std::optional<double>, count> m_kept;
    std::optional<std::size_t> m_dragged;
    QCPAxisRect* m_pressedIn = nullptr; ///< while dragged, the one the mouse was pressed in
    bool m_pointing = false;            ///< the mouse is on a cursor
};

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
