// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/plot_history.h"

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

/// Moves a plot by mouse and keys, and remembers where it was. The wheel zooms at the mouse, over
/// an axis that axis only, with Shift it pans; a drag pans; a double click fits. Keys: + − zoom,
/// arrows pan, Ctrl+Up and Ctrl+Down zoom the values; the last plot pointed at is meant.
class PlotNavigation : public QObject {
    Q_OBJECT
public:
    /// What the plot does differently from the defaults in brackets.
    struct Hooks {
        std::function<void()> fit;                 ///< show everything [the axes' data]
        std::function<PlotHistory::State()> state; ///< what is visible [ranges of all axes]
        std::function<void(const PlotHistory::State&)> setState; ///< no replot needed
        /// Axes that wheel, drag and keys move within an axis rect [bottom and left].
        std::function<QList<QCPAxis*>(QCPAxisRect&)> axes;
    };

    explicit PlotNavigation(QCustomPlot& plot, Hooks hooks = {}, QObject* parent = nullptr);

    /// Of all axes, as numbers of a state; in the order of setRanges().
    [[nodiscard]] static PlotHistory::State rangesOf(const QCustomPlot& plot);
    static void setRanges(const QCustomPlot& plot, const PlotHistory::State& ranges);

    void fit();
    void back();
    void forward();
    void zoom(double factor);                             ///< below 1 shows less
    void pan(int right, int up, bool zoomValues = false); ///< by a tenth of the range each
    [[nodiscard]] bool canGoBack() const { return m_history.canGoBack(); }
    [[nodiscard]] bool canGoForward() const { return m_history.canGoForward(); }

    /// For the owner of the plot: other tools changed what is visible (an entry of the history) …
    void noteView(int gesture = 0);
    void amendView();   ///< … a new result did, which cannot be taken back …
    void forgetViews(); ///< … or the plot was built anew.
    /// A number for noteView(): steps of the same kind that follow closely are one gesture.
    [[nodiscard]] int gestureOf(int kind);

signals:
    void historyChanged();
    void moved(); ///< by mouse, keys, Back or Forward

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// An axis rect and the axes of it that are meant at a point.
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
    PlotHistory::State m_pressed; ///< what was visible when the drag began
    int m_kind = 0;
    int m_gesture = 0;
};

} // namespace sparkout
