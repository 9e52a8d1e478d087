// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/legend.h"
#include "ui/chart/quantity_colour.h"
#include "ui/chart/read_curves.h"
#include "ui/table/csv_table.h"
#include "ui/text/number_text.h"

#include <QColor>
#include <QFont>
#include <QList>
#include <QPalette>
#include <qcustomplot.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <vector>

/// Shared axes and safe ranges of the plots; texts and lines of the axes follow the palette.
namespace sparkout::style {

[[nodiscard]] bool isDark(const QPalette& palette);

[[nodiscard]] QColor dimmed(QColor colour, bool dim); ///< mostly transparent when dim

[[nodiscard]] QColor thinned(QColor colour, int alpha); ///< with this opacity, up to 255
/// The colour of an area behind the curves; stronger in the contrast theme, which has no other
/// colour there.
[[nodiscard]] QColor filling(QColor colour, int alpha, const QPalette& palette);

/// All axes, side by side. QCustomPlot's own order, and so that of drawing, changes with each start
/// of the program.
[[nodiscard]] QList<QCPAxis*> axesOf(const QCPAxisRect& rect);

void applyPalette(QCustomPlot& plot, const QPalette& palette);
void applyPalette(QCPAxis& axis, const QPalette& palette);
void setUpAxis(QCPAxis& axis); ///< sets its layers and plain numbers (NumberTicker)
void setLogarithmic(QCPAxis& axis, bool on);

/// Shrinks the names of the value axes down to a limit, and reduces the number of ticks, so that
/// they fit a low plot. True if the next replot shows a change.
bool fitValueAxes(QCPAxisRect& rect, const QFont& font);
/// The number of tick labels in that font that fit the height, at most the usual number.
[[nodiscard]] int ticksWithRoom(int height, const QFont& font);

/// Sets a range QCustomPlot can draw: finite, growing, not narrower than rounding allows. Other
/// ranges are ignored.
void setSafeRange(QCPAxis& axis, double low, double high);

/// Sets a range with a margin at both ends: the share `room` of the range, at least the share
/// `leastRoom` of the values.
void setRoomyRange(QCPAxis& axis, double low, double high, double room, double leastRoom);

} // namespace sparkout::style

namespace sparkout {

/// The numbers of an axis with a typographic minus; very small and large ones with a power of ten.
class NumberTicker : public QCPAxisTicker {
protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        const QString label =
            withPower(QCPAxisTicker::getTickLabel(tick, locale, format, precision));
        return label.startsWith(u'-') ? u'−' + label.mid(1) : label;
    }
};

/// Only whole numbers, for counts.
class WholeTicker : public QCPAxisTickerFixed {
public:
    WholeTicker() {
        setTickStep(1);
        setScaleStrategy(ssMultiples);
    }
};

/// The visible states of a plot, for Back and Forward.
class PlotHistory {
public:
    /// A visible state, as numbers defined by the plot (usually ranges of axes).
    using State = std::vector<double>;
    static constexpr std::size_t mostStates = 100;

    /// Forgets all, and starts from a state.
    void restart(State state);
    /// Adds a new visible state. Steps of one gesture (a positive number) are one entry; an
    /// unchanged state is not added.
    void visit(State state, int gesture = 0);
    /// Replaces the current state without a way back, for instance by a new result.
    void amend(State state);

    [[nodiscard]] bool canGoBack() const { return m_at > 0; }
    [[nodiscard]] bool canGoForward() const { return m_at + 1 < m_states.size(); }
    const State& back();    ///< requires canGoBack()
    const State& forward(); ///< requires canGoForward()
    [[nodiscard]] std::size_t size() const { return m_states.size(); }

private:
    std::vector<State> m_states{State{}};
    std::size_t m_at = 0; ///< index of the current state
    int m_gesture = 0;    ///< gesture of the current entry
};

class PlotCursors;
class PlotTools;
class Settings;
struct CursorSubject;
struct PlotSubject;

/// A plot of a view: it dims for an outdated run, follows the language, palette and font of the
/// window, reports the values under the mouse and keeps what the user hid; it has tools for moving,
/// copying and saving, and optionally cursors. Subclasses draw, read and fit the data.
class ViewPlot : public QCustomPlot {
    Q_OBJECT
public:
    explicit ViewPlot(QWidget* parent = nullptr); ///< without axes; has a layer "bands" at the back

    void setDimmed(bool dim);
    [[nodiscard]] bool isDimmed() const { return m_dim; }
    [[nodiscard]] QColor toned(style::Drawn what) const; ///< its colour, faint while dimmed
    [[nodiscard]] QColor toned(Tone tone) const;
    [[nodiscard]] QColor ink() const; ///< text colour, faint while dimmed
    void retranslate();               ///< numbers and texts
    virtual void restyle();           ///< applies palette and font, here to background and axes

    virtual void fit() = 0; ///< shows everything; no replot
    [[nodiscard]] virtual LegendEntries legendEntries() const { return {}; }
    [[nodiscard]] virtual CsvTable table() const {
        return {};
    }                                  ///< the data within the visible range
    virtual void toggleCurve(int key); ///< called by the legend
    virtual void showOnly(int key);    ///< again: all

    /// The visible state for the history [the ranges of all axes].
    [[nodiscard]] virtual PlotHistory::State visibleRange() const;
    virtual void setVisibleRange(const PlotHistory::State& range); ///< no replot
    /// Axes moved by wheel, drag and keys in an axis rect [bottom and left].
    [[nodiscard]] virtual QList<QCPAxis*> movedAxes(QCPAxisRect& rect) const;

    [[nodiscard]] virtual ReadCurves readCurves() const { return {}; } ///< the visible ones
    [[nodiscard]] virtual QCPRange readSpan() const { return {}; }     ///< readable range
    /// For the cursors; the name of the horizontal axis is its label.
    [[nodiscard]] virtual CursorSubject cursorSubject();

    /// Makes points of an item relative to the bottom and left axis of an axis rect.
    static void anchor(std::initializer_list<QCPItemPosition*> points, QCPAxisRect& rect);
    /// Adds a vertical or horizontal line through an axis rect, at a value of its bottom or left
    /// axis.
    QCPItemStraightLine* addRule(QCPAxisRect& rect, double at, bool upright = true);
    QCPGraph* addLine(const QCPAxisRect& rect); ///< on its bottom and left axis
    static QCPCurve* addCurve(const QCPAxisRect& rect);

    /// Adds navigation, copying and saving; call once. The subject needs a heading and any
    /// overrides.
    virtual PlotTools& addTools(PlotSubject subject, Settings* settings);
    [[nodiscard]] PlotTools* tools() const { return m_tools; } ///< null before addTools()
    PlotCursors& addCursors();                                 ///< call once, after addTools()
    [[nodiscard]] PlotCursors* cursors() const { return m_cursors; }

signals:
    void contentChanged();             ///< hence the legend
    void pointed(const QString& text); ///< values under the mouse; empty if there are none

protected:
    virtual void setTexts() {}
    /// Called for a new font, otherwise for a new palette.
    virtual void takeLook(bool font);
    virtual void showChoice() {} ///< applies the choice of visible curves
    [[nodiscard]] LegendEntry lineEntry(int key, const QPen& pen, const QString& text) const;
    [[nodiscard]] LegendEntry areaEntry(int key, const QColor& colour, const QString& text) const;
    /// The legend entries among which showOnly() chooses.
    [[nodiscard]] virtual LegendEntries besides(int) const { return legendEntries(); }
    [[nodiscard]] virtual QString valuesAt(const QPointF&) const { return {}; } ///< under the mouse
    virtual void onMouse(QMouseEvent* event); ///< called for mouse moves; here reports the values
    virtual void pointAway();                 ///< called when the mouse leaves
    /// Calls back for a left click without a drag.
    void onClick(std::function<void(const QPointF& at)> clicked);
    void built();                       ///< ends a constructor: look and texts
    void setBuilt() { m_built = true; } ///< marks the plot as built without content

    [[nodiscard]] bool shows(int key) const { return m_choice.shows(key); } ///< in the legend
    [[nodiscard]] const CurveChoice& choice() const { return m_choice; }
    /// Adds an axis rect in a cell of the layout, or of another one.
    QCPAxisRect* addRect(int row = 0, int column = 0, QCPLayoutGrid* into = nullptr);
    /// Adds an axis rect in a row, framed by axes without numbers at the top and right.
    QCPAxisRect* addCell(int row = 0);
    /// Ties the axes on one side of all these rects to one range.
    static void tie(const std::vector<QCPAxisRect*>& rects, QCPAxis::AxisType side);

    void changeEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void followChoice();

    CurveChoice m_choice;
    PlotTools* m_tools = nullptr;
    PlotCursors* m_cursors = nullptr;
    bool m_dim = false, m_built = false;
};

} // namespace sparkout
