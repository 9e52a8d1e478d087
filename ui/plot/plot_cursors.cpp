// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_cursors.h"

#include "ui/kit/keyboard.h"
#include "ui/kit/theme.h"
#include "ui/kit/theme_icon.h"

#include <QAction>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double mouseReach = 5; ///< reach of the mouse, in pixels
constexpr double stepShare = 0.01;
constexpr double firstPlaces[] = {0.25, 0.75};
constexpr int tagPadding = 2;

QString cursorsLayer(QCustomPlot& plot) {
    const QString name = QStringLiteral("cursors");
    plot.addLayer(name);
    plot.layer(name)->setMode(QCPLayer::lmBuffered); // moving them redraws no curve
    return name;
}

/// The cursor moved by a key; empty for any other key.
std::optional<std::size_t> cursorOf(const QKeyEvent& event) {
    const bool arrow = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
    const auto modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (arrow && modifiers == Qt::ShiftModifier) {
        return 0;
    }
    return arrow && modifiers == (Qt::ShiftModifier | Qt::ControlModifier)
               ? std::optional<std::size_t>(1)
               : std::nullopt;
}

} // namespace

PlotCursors::PlotCursors(QCustomPlot& plot, CursorSubject subject)
    : PaintedLayer(plot, cursorsLayer(plot), Edges::sharp)
    , toggle(new QAction(&plot))
    , m_subject(std::move(subject)) {
    toggle->setObjectName(QStringLiteral("cursors"));
    toggle->setCheckable(true);
    toggle->setIcon(themeIcon(u"cursors"));
    toggle->setShortcut(Qt::Key_C);
    toggle->setShortcutContext(Qt::WidgetShortcut);
    plot.addAction(toggle);
    plot.installEventFilter(this); // installed after the navigation, so called before it
    connect(toggle, &QAction::toggled, this, &PlotCursors::showThem);
    retranslate();
}

void PlotCursors::retranslate() {
    toggle->setText(tr("Cursors"));
    toggle->setToolTip(
        tr("Two cursors: the curves' values at A and at B, and their differences. Drag them, type "
           "their places, or move A with Shift and arrows, B with Ctrl+Shift and arrows."));
    nameShortcut(*toggle);
}

QString PlotCursors::letter(std::size_t cursor) {
    return cursor == 0 ? QStringLiteral("A") : QStringLiteral("B");
}

std::optional<double> PlotCursors::at(std::size_t cursor) const {
    const std::optional<double>& kept = m_kept.at(cursor);
    return kept && m_subject.place ? m_subject.place(*kept) : kept;
}

void PlotCursors::moveTo(std::size_t cursor, double x) {
    m_kept.at(cursor) = m_subject.keep ? m_subject.keep(x) : x;
    layer()->replot();
    emit moved();
}

/// The first time within the visible range.
void PlotCursors::showThem(bool on) {
    const std::vector<QCPAxisRect*> all = rects();
    const bool first = on && !m_kept.front() && !all.empty();
    if (first) {
        const QCPRange visible = all.front()->axis(QCPAxis::atBottom)->range();
        const QCPRange span = m_subject.span();
        const double low = std::max(visible.lower, span.lower);
        const double high = std::max(std::min(visible.upper, span.upper), low);
        for (std::size_t cursor = 0; cursor < count; ++cursor) {
            moveTo(cursor, rounded(low + firstPlaces[cursor] * (high - low)));
        }
    }
    layer()->replot();
    emit shownChanged();
}

// --- drawing ------------------------------------------------------------------------------------

std::vector<QCPAxisRect*> PlotCursors::rects() const {
    std::vector<QCPAxisRect*> all;
    for (QCPAxisRect* rect : mParentPlot->axisRects()) {
        if (rect->axisCount(QCPAxis::atBottom) > 0) {
            all.push_back(rect);
        }
    }
    return all;
}

void PlotCursors::draw(QCPPainter* painter) {
    if (!toggle->isChecked()) {
        return;
    }
    const QColor colour = mParentPlot->palette().color(QPalette::Text);
    const std::vector<QCPAxisRect*> all = rects();
    for (const QCPAxisRect* rect : all) {
        const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
        const bool top = std::ranges::none_of(all, [rect](const QCPAxisRect* other) {
            return other->left() == rect->left() && other->top() < rect->top();
        });
        for (std::size_t cursor = 0; cursor < count; ++cursor) {
            const std::optional<double> place = at(cursor);
            if (!place || !axis->range().contains(*place)) {
                continue;
            }
            const double x = axis->coordToPixel(*place);
            painter->setPen(QPen(colour, 1, cursor == 0 ? Qt::SolidLine : Qt::DashLine));
            painter->drawLine(QLineF(x, rect->top(), x, rect->bottom()));
            if (top) {
                drawTag(*painter, *rect, cursor, x);
            }
        }
    }
}

/// A's letter is left of its line and B's right, so that both are legible when they meet.
void PlotCursors::drawTag(QCPPainter& painter, const QCPAxisRect& rect, std::size_t cursor,
                          double x) const {
    const QFontMetricsF metrics(mParentPlot->font());
    const QString text = letter(cursor);
    const QSizeF size(metrics.horizontalAdvance(text) + 2 * tagPadding, metrics.height());
    double left = cursor == 0 ? x - size.width() : x;
    left = std::clamp(left, double(rect.left()),
                      std::max(rect.right() - size.width(), double(rect.left())));
    const QRectF box(QPointF(left, rect.top()), size);
    const QPalette palette = mParentPlot->palette();
    painter.setPen(QPen(palette.color(QPalette::Text), 0));
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawRect(box);
    painter.setBrush(Qt::NoBrush);
    painter.setFont(mParentPlot->font());
    painter.drawText(box, Qt::AlignCenter, text);
}

// --- mouse and keys -----------------------------------------------------------------------------

/// The nearest within reach; of two at one place the one the mouse is on the side of.
std::optional<std::size_t> PlotCursors::cursorAt(const QPointF& at) const {
    std::optional<std::size_t> nearest;
    double least = mouseReach;
    for (const QCPAxisRect* rect : rects()) {
        if (!rect->rect().contains(at.toPoint())) {
            continue;
        }
        for (std::size_t cursor = 0; cursor < count; ++cursor) {
            if (const std::optional<double> place = this->at(cursor)) {
                const double away = at.x() - rect->axis(QCPAxis::atBottom)->coordToPixel(*place);
                if (std::abs(away) < least || (std::abs(away) == least && away > 0)) {
                    least = std::abs(away);
                    nearest = cursor;
                }
            }
        }
    }
    return nearest;
}

double PlotCursors::rounded(double x) const {
    const std::vector<QCPAxisRect*> all = rects();
    const QCPAxisRect* rect = m_pressedIn ? m_pressedIn : all.empty() ? nullptr : all.front();
    if (!rect) {
        return x;
    }
    const double pixel = rect->axis(QCPAxis::atBottom)->range().size() / std::max(rect->width(), 1);
    if (!(pixel > 0) || !std::isfinite(pixel)) {
        return x;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(pixel)));
    return plainPlace(std::round(x / unit) * unit);
}

void PlotCursors::dragTo(const QPointF& at) {
    const QCPRange span = m_subject.span();
    const double x = m_pressedIn->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
    moveTo(*m_dragged, std::clamp(rounded(x), span.lower, span.upper));
}

/// Whether the event was for a cursor.
bool PlotCursors::onMouse(QMouseEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        if (event.button() == Qt::LeftButton) {
            m_dragged = cursorAt(event.position());
            m_pressedIn = mParentPlot->axisRectAt(event.position());
        }
        return m_dragged && event.button() == Qt::LeftButton;
    case QEvent::MouseMove: {
        if (m_dragged) {
            dragTo(event.position());
            return true;
        }
        const bool over = event.buttons() == Qt::NoButton && cursorAt(event.position());
        if (over != m_pointing) {
            m_pointing = over;
            over ? mParentPlot->setCursor(Qt::SplitHCursor) : mParentPlot->unsetCursor();
        }
        return false; // the values under the mouse remain visible
    }
    case QEvent::MouseButtonRelease:
        if (m_dragged && event.button() == Qt::LeftButton) {
            m_dragged.reset();
            m_pressedIn = nullptr;
            return true;
        }
        return false;
    default: return false;
    }
}

bool PlotCursors::onKey(const QKeyEvent& event) {
    const std::optional<std::size_t> cursor = cursorOf(event);
    if (cursor) {
        step(*cursor, event.key() == Qt::Key_Right ? 1 : -1);
    }
    return cursor.has_value();
}

/// Steps towards the right of the screen; from outside the visible range to its edge.
void PlotCursors::step(std::size_t cursor, int steps) {
    const std::vector<QCPAxisRect*> all = rects();
    if (all.empty() || !at(cursor)) {
        return;
    }
    const QCPAxis* axis = all.front()->axis(QCPAxis::atBottom);
    const QCPRange visible = axis->range(), span = m_subject.span();
    const double side = axis->rangeReversed() ? -steps : steps;
    const double x = std::clamp(*at(cursor), visible.lower, visible.upper);
    moveTo(cursor,
           std::clamp(rounded(x + side * stepShare * visible.size()), span.lower, span.upper));
}

bool PlotCursors::takes(QEvent& event) {
    switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: return onMouse(static_cast<QMouseEvent&>(event));
    case QEvent::ShortcutOverride: return cursorOf(static_cast<QKeyEvent&>(event)).has_value();
    case QEvent::KeyPress: return onKey(static_cast<QKeyEvent&>(event));
    default: return false;
    }
}

bool PlotCursors::eventFilter(QObject* watched, QEvent* event) {
    if (shown() && takes(*event)) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) {
        emit shownChanged();
    }
    return PaintedLayer::eventFilter(watched, event);
}

} // namespace sparkout
