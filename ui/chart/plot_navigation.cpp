// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/plot_navigation.h"

#include "ui/chart/view_plot.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double wheelFactor = 0.85; ///< factor for a notch of the wheel
constexpr double notch = 120;        ///< angle of a notch, in eighths of a degree
constexpr double keyFactor = 0.8;
constexpr double panShare = 0.1;
constexpr qint64 sameGesture_ms = 700;

enum Gesture { wheelKind = 1, zoomKind = 2, keyKind = 1000 };

/// Moves an axis by a share of its range, to the right or up.
void panAxis(QCPAxis& axis, double share) {
    share = axis.rangeReversed() ? -share : share;
    const QCPRange range = axis.range();
    if (axis.scaleType() == QCPAxis::stLogarithmic) {
        const double factor = std::pow(range.upper / range.lower, share);
        axis.setRange(range.lower * factor, range.upper * factor);
    } else {
        axis.moveRange(range.size() * share);
    }
}

double middleOf(const QCPAxis& axis) {
    const QCPRange range = axis.range();
    return axis.scaleType() == QCPAxis::stLogarithmic ? std::sqrt(range.lower * range.upper)
                                                      : range.center();
}

/// Whether it is a navigation key, which the main window must not use as a shortcut.
bool isKey(const QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: return !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    case Qt::Key_Left:
    case Qt::Key_Right: return !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    case Qt::Key_Up:
    case Qt::Key_Down: return !(event->modifiers() & Qt::AltModifier);
    default: return false;
    }
}

} // namespace

PlotNavigation::PlotNavigation(QCustomPlot& plot, Hooks hooks, QObject* parent)
    : QObject(parent), m_plot(plot), m_hooks(std::move(hooks)) {
    plot.setInteractions((plot.interactions() | QCP::iRangeDrag)
                         & ~QCP::Interactions(QCP::iRangeZoom));
    plot.setFocusPolicy(Qt::StrongFocus);
    plot.setMouseTracking(true);
    plot.installEventFilter(this);
    connect(&plot, &QCustomPlot::mousePress, this, &PlotNavigation::onPress);
    connect(&plot, &QCustomPlot::mouseRelease, this, &PlotNavigation::onRelease);
    connect(&plot, &QCustomPlot::mouseDoubleClick, this, &PlotNavigation::fit);
    m_history.restart(state());
}

// --- gestures -----------------------------------------------------------------------------------

QList<QCPAxis*> PlotNavigation::axesOf(QCPAxisRect& rect) const {
    return m_hooks.axes ? m_hooks.axes(rect)
                        : QList<QCPAxis*>{rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft)};
}

PlotNavigation::Target PlotNavigation::targetAt(const QPointF& at) const {
    const QPoint point = at.toPoint();
    for (QCPAxisRect* rect : m_plot.axisRects()) {
        if (rect->rect().contains(point)) {
            return {rect, axesOf(*rect)};
        }
        if (!rect->outerRect().contains(point)) {
            continue;
        }
        const QCPAxis::AxisType side = point.x() < rect->left()     ? QCPAxis::atLeft
                                       : point.x() > rect->right()  ? QCPAxis::atRight
                                       : point.y() > rect->bottom() ? QCPAxis::atBottom
                                                                    : QCPAxis::atTop;
        QCPAxis* axis = rect->axisCount(side) > 0 ? rect->axis(side) : nullptr;
        const bool meant = axis && side != QCPAxis::atTop;
        return {rect, meant ? QList<QCPAxis*>{axis} : QList<QCPAxis*>{}};
    }
    return {};
}

QCPAxisRect* PlotNavigation::current() const {
    return m_current ? m_current.data() : m_plot.axisRect();
}

PlotHistory::State PlotNavigation::state() const {
    return m_hooks.state ? m_hooks.state() : rangesOf(m_plot);
}

void PlotNavigation::setState(const PlotHistory::State& state) {
    m_hooks.setState ? m_hooks.setState(state) : setRanges(m_plot, state);
}

PlotHistory::State PlotNavigation::rangesOf(const QCustomPlot& plot) {
    PlotHistory::State ranges;
    for (const QCPAxisRect* rect : plot.axisRects()) {
        for (const QCPAxis* axis : style::axesOf(*rect)) {
            ranges.insert(ranges.end(), {axis->range().lower, axis->range().upper});
        }
    }
    return ranges;
}

void PlotNavigation::setRanges(const QCustomPlot& plot, const PlotHistory::State& ranges) {
    std::size_t i = 0;
    for (const QCPAxisRect* rect : plot.axisRects()) {
        for (QCPAxis* axis : style::axesOf(*rect)) {
            if (i + 1 < ranges.size()) {
                axis->setRange(ranges[i], ranges[i + 1]);
            }
            i += 2;
        }
    }
}

// --- the history --------------------------------------------------------------------------------

int PlotNavigation::gestureOf(int kind) {
    const bool same =
        kind == m_kind && m_sinceStep.isValid() && m_sinceStep.elapsed() < sameGesture_ms;
    m_kind = kind;
    m_sinceStep.start();
    return same ? m_gesture : ++m_gesture;
}

void PlotNavigation::noteView(int gesture) {
    m_history.visit(state(), gesture);
    emit historyChanged();
}

void PlotNavigation::amendView() {
    m_history.amend(state());
}

void PlotNavigation::forgetViews() {
    m_history.restart(state());
    emit historyChanged();
}

void PlotNavigation::changed(int gesture) {
    m_plot.replot(QCustomPlot::rpQueuedReplot);
    emit moved();
    noteView(gesture);
}

void PlotNavigation::fit() {
    if (m_hooks.fit) {
        m_hooks.fit();
    } else {
        m_plot.rescaleAxes(true);
    }
    m_plot.replot(QCustomPlot::rpQueuedReplot);
    noteView();
}

void PlotNavigation::back() {
    if (m_history.canGoBack()) {
        setState(m_history.back());
        m_plot.replot(QCustomPlot::rpQueuedReplot);
        emit moved();
        emit historyChanged();
    }
}

void PlotNavigation::forward() {
    if (m_history.canGoForward()) {
        setState(m_history.forward());
        m_plot.replot(QCustomPlot::rpQueuedReplot);
        emit moved();
        emit historyChanged();
    }
}

// --- moving -------------------------------------------------------------------------------------

void PlotNavigation::zoom(double factor) {
    if (QCPAxisRect* rect = current()) {
        for (QCPAxis* axis : axesOf(*rect)) {
            axis->scaleRange(factor, middleOf(*axis));
        }
        changed(gestureOf(zoomKind));
    }
}

void PlotNavigation::pan(int right, int up, bool zoomValues) {
    QCPAxisRect* rect = current();
    if (!rect) {
        return;
    }
    if (right != 0) {
        panAxis(*rect->axis(QCPAxis::atBottom), right * panShare);
    }
    QCPAxis* values = rect->axis(QCPAxis::atLeft);
    if (up != 0 && zoomValues) {
        values->scaleRange(up > 0 ? keyFactor : 1 / keyFactor, middleOf(*values));
    } else if (up != 0) {
        panAxis(*values, up * panShare);
    }
    changed(gestureOf(keyKind + 9 * right + 3 * up + (zoomValues ? 1 : 0)));
}

void PlotNavigation::onWheel(QWheelEvent* event) {
    const Target target = targetAt(event->position());
    const QPoint delta = event->angleDelta();
    if (target.axes.isEmpty() || delta.isNull()) {
        return;
    }
    m_current = target.rect;
    const bool sideways = delta.y() == 0 || event->modifiers().testFlag(Qt::ShiftModifier);
    const double steps = (delta.y() == 0 ? delta.x() : delta.y()) / notch;
    for (QCPAxis* axis : target.axes) {
        const bool across = axis->orientation() == Qt::Horizontal;
        if (sideways && (across || target.axes.size() == 1)) {
            panAxis(*axis, -steps * panShare);
        } else if (!sideways) {
            const double at = across ? event->position().x() : event->position().y();
            axis->scaleRange(std::pow(wheelFactor, steps), axis->pixelToCoord(at));
        }
    }
    changed(gestureOf(wheelKind));
}

bool PlotNavigation::onKey(const QKeyEvent* event) {
    if (!isKey(event)) {
        return false;
    }
    const bool control = event->modifiers().testFlag(Qt::ControlModifier);
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(keyFactor); break;
    case Qt::Key_Minus: zoom(1 / keyFactor); break;
    case Qt::Key_Left: pan(-1, 0); break;
    case Qt::Key_Right: pan(1, 0); break;
    case Qt::Key_Up: pan(0, 1, control); break;
    case Qt::Key_Down: pan(0, -1, control); break;
    default: break;
    }
    return true;
}

void PlotNavigation::onPress(QMouseEvent* event) {
    const Target target = targetAt(event->pos());
    if (event->button() != Qt::LeftButton || !target.rect) {
        return;
    }
    m_current = target.rect;
    m_pressed = state();
    target.rect->setRangeDragAxes(target.axes);
    m_plot.setCursor(Qt::ClosedHandCursor);
}

void PlotNavigation::onRelease() {
    m_plot.unsetCursor();
    if (!m_pressed.empty() && state() != m_pressed) {
        emit moved();
        noteView();
    }
    m_pressed.clear();
}

bool PlotNavigation::eventFilter(QObject* watched, QEvent* event) {
    const bool moves = event->type() == QEvent::Wheel || event->type() == QEvent::KeyPress
                       || event->type() == QEvent::ShortcutOverride;
    if (moves && m_plot.axisRectCount() == 0) { // an empty plot cannot be moved
        return QObject::eventFilter(watched, event);
    }
    bool taken = false;
    switch (event->type()) {
    case QEvent::Wheel:
        onWheel(static_cast<QWheelEvent*>(event));
        taken = true;
        break;
    case QEvent::MouseMove: {
        const Target target = targetAt(static_cast<QMouseEvent*>(event)->position());
        if (target.rect) {
            m_current = target.rect;
        }
        break;
    }
    case QEvent::ShortcutOverride: taken = isKey(static_cast<QKeyEvent*>(event)); break;
    case QEvent::KeyPress: taken = onKey(static_cast<QKeyEvent*>(event)); break;
    default: break;
    }
    if (taken) {
        event->accept();
    }
    return taken || QObject::eventFilter(watched, event);
}

} // namespace sparkout
