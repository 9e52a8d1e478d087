// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/view_plot.h"

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QPointer>

#include <functional>

class QCPAxis;
class QCPAxisRect;
class QCustomPlot;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace sparkout {

/// Moves a plot by mouse and keys, with a history. The wheel zooms at the mouse, over an axis that
/// axis only, with Shift it pans; a drag pans; a double click fits. Keys: + − zoom, arrows pan,
/// Ctrl+Up and Ctrl+Down zoom the values; the last plot pointed at is meant.
class PlotNavigation : public QObject {
    Q_OBJECT
public:
    /// Overrides of a plot; the defaults are in brackets.
    struct Hooks {
        std::function<void()> fit;                 ///< show everything [the axes' data]
        std::function<PlotHistory::State()> state; ///< visible state [ranges of all axes]
        std::function<void(const PlotHistory::State&)> setState; ///< without replot
        /// Axes moved by wheel, drag and keys in an axis rect [bottom and left].
        std::function<QList<QCPAxis*>(QCPAxisRect&)> axes;
    };

    explicit PlotNavigation(QCustomPlot& plot, Hooks hooks = {}, QObject* parent = nullptr);

    /// Ranges of all axes as a state, in the order of setRanges().
    [[nodiscard]] static PlotHistory::State rangesOf(const QCustomPlot& plot);
    static void setRanges(const QCustomPlot& plot, const PlotHistory::State& ranges);

    void fit();
    void back();
    void forward();
    void zoom(double factor);                             ///< zooms in if below 1
    void pan(int right, int up, bool zoomValues = false); ///< by a tenth of the range
    [[nodiscard]] bool canGoBack() const { return m_history.canGoBack(); }
    [[nodiscard]] bool canGoForward() const { return m_history.canGoForward(); }

    /// Called by the plot when another tool changed the visible state (a new entry) …
    void noteView(int gesture = 0);
    void amendView();   ///< … when a new result did, without a way back …
    void forgetViews(); ///< … or the plot was built anew.
    /// A number for noteView(): steps of one kind in quick succession are one gesture.
    [[nodiscard]] int gestureOf(int kind);

signals:
    void historyChanged();
    void moved(); ///< by mouse, keys, Back or Forward

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// An axis rect and its axes at a point.
    struct Target {
        QCPAxisRect* rect = nullptr;
        QList<QCPAxis*> axes;
    };
    [[nodiscard]] Target targetAt(const QPointF& at) const;
    [[nodiscard]] QList<QCPAxis*> axesOf(QCPAxisRect& rect) const;
    [[nodiscard]] QCPAxisRect* current() const;
    [[nodiscard]] PlotHistory::State state() const;
    void setState(const PlotHistory::State& state);
    void onWheel(QWheelEvent* event);
    bool onKey(const QKeyEvent* event);
    void onPress(QMouseEvent* event);
    void onRelease();
    void changed(int gesture);

    QCustomPlot& m_plot;
    Hooks m_hooks;
    PlotHistory m_history;
    QPointer<QCPAxisRect> m_current; ///< last pointed at
    QElapsedTimer m_sinceStep;
    PlotHistory::State m_pressed; ///< state at the beginning of the drag
    int m_kind = 0;
    int m_gesture = 0;
};

} // namespace sparkout
