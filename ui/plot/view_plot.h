// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/legend_drawing.h"
#include "ui/plot/plot_history.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/plot/read_curves.h"
#include "ui/tables/csv_table.h"

#include <QPointer>

#include <qcustomplot.h>

#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

namespace sparkout {

class PlotCursors;
class PlotTools;
class Settings;
struct CursorSubject;
struct PlotSubject;

/// A plot of a view: dims with a run that is out of date, follows the window's language, palette
/// and font, reports what is under the mouse, knows what of it the user hid; with tools it is
/// moved, copied and saved, with cursors read. A chart says what is drawn, how it is read and
/// fitted.
class ViewPlot : public QCustomPlot {
    Q_OBJECT
public:
    explicit ViewPlot(QWidget* parent = nullptr); ///< without a cell, a layer "bands" at the back

    void setDimmed(bool dim);
    [[nodiscard]] bool isDimmed() const { return m_dim; }
    [[nodiscard]] QColor toned(style::Drawn what) const; ///< its colour, faint while dimmed
    [[nodiscard]] QColor toned(Tone tone) const;
    [[nodiscard]] QColor ink() const; ///< of the texts, faint while dimmed
    void retranslate();               ///< numbers and texts
    virtual void restyle();           ///< by palette and font; here background and axes

    virtual void fit() = 0; ///< makes all visible; no replot
    [[nodiscard]] virtual LegendEntries legendEntries() const { return {}; }
    [[nodiscard]] virtual CsvTable table() const {
        return {};
    }                                  ///< what is shown, within the visible range
    virtual void toggleCurve(int key); ///< of the legend
    virtual void showOnly(int key);    ///< again: all

    /// What is visible, for the history [the ranges of all axes].
    [[nodiscard]] virtual PlotHistory::State visibleRange() const;
    virtual void setVisibleRange(const PlotHistory::State& range); ///< no replot
    /// Axes that wheel, drag and keys move within an axis rect [bottom and left].
    [[nodiscard]] virtual QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const;

    [[nodiscard]] virtual ReadCurves readCurves() const { return {}; } ///< the shown ones
    [[nodiscard]] virtual QCPRange readSpan() const { return {}; }     ///< where they can be read
    /// For the cursors; the horizontal axis goes by its label.
    [[nodiscard]] virtual CursorSubject cursorSubject();

    /// Measures points of an item by the bottom and left axis of an axis rect.
    static void anchor(std::initializer_list<QCPItemPosition*> points, QCPAxisRect& rect);
    /// Upright or level through an axis rect, at a value of its bottom or left axis.
    QCPItemStraightLine* addRule(QCPAxisRect& rect, double at, bool upright = true);
    QCPGraph* addLine(const QCPAxisRect& rect); ///< over its bottom and left axis
    static QCPCurve* addCurve(const QCPAxisRect& rect);

    /// Navigation, copies and files, once; the subject needs a heading and what is special.
    virtual PlotTools& addTools(PlotSubject subject, Settings* settings);
    [[nodiscard]] PlotTools* tools() const { return m_tools; } ///< null: none
    PlotCursors& addCursors();                                 ///< once, after the tools
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }

signals:
    void contentChanged();             ///< hence the legend
    void pointed(const QString& text); ///< values under the mouse; empty: at nothing

protected:
    virtual void setTexts() {}
    /// When a new font, else a new palette, has come.
    virtual void takeLook(bool font);
    /// What the user hid, or shows again, in the legend; here what is keyed.
    virtual void showChoice();
    /// Hidden and shown with an entry of the legend; null: nothing.
    void setKeyed(int key, std::initializer_list<QCPLayerable*> drawn);
    [[nodiscard]] LegendEntry lineEntry(int key, const QPen& pen, const QString& text) const;
    [[nodiscard]] LegendEntry areaEntry(int key, const QColor& colour, const QString& text) const;
    void contentSet(); ///< other things are drawn: look, texts, choice and range, for all of them
    /// The entries of the legend that showOnly() chooses one of.
    [[nodiscard]] virtual LegendEntries besides(int) const { return legendEntries(); }
    [[nodiscard]] virtual QString valuesAt(const QPointF&) const { return {}; } ///< under the mouse
    virtual void onMouse(QMouseEvent* event); ///< has moved; here reports the values
    virtual void pointAway();                 ///< the mouse has left
    /// With the left button, pressed and let go without a drag between.
    void onClick(std::function<void(const QPointF& at)> clicked);
    void built();                       ///< ends a constructor: look and texts
    void setBuilt() { m_built = true; } ///< the same without them: there is nothing yet

    [[nodiscard]] bool shows(int key) const { return m_choice.shows(key); } ///< of the legend
    [[nodiscard]] const CurveChoice& choice() const { return m_choice; }
    /// An axis rect in a cell of the layout.
    QCPAxisRect* addRect(int row = 0, int column = 0);
    /// The same in a row, closed by axes without numbers above and to the right.
    QCPAxisRect* addCell(int row = 0);
    /// The axes on a side of all these rects have one range from now on.
    static void tie(const std::vector<QCPAxisRect*>& rects, QCPAxis::AxisType side);

    void changeEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void followChoice();

    CurveChoice m_choice;
    std::vector<std::pair<int, QPointer<QCPLayerable>>> m_keyed; ///< with the key of each
    PlotTools* m_tools = nullptr;
    PlotCursors* m_cursors = nullptr;
    bool m_dim = false, m_built = false;
};

} // namespace sparkout
