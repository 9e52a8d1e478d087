// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/feeds_overview.h"

#include "ui/chart/quantity_colour.h"
#include "ui/views/cycle/feeds_plot.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionFocusRect>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {
constexpr int windowEdge = 5;           ///< reach of the mouse at an edge [px]
constexpr int handleWidth = 4;          ///< width of the drawn handles
constexpr double smallestWindow = 1e-5; ///< as a share of the cycle
constexpr double wheelZoom = 0.85;
constexpr double notchOfWheel = 120;
constexpr double keyShare = 0.1; ///< step of a key press, as a share of the window
constexpr double headroom = 0.1;
} // namespace

FeedsOverview::FeedsOverview(const FeedsPlot& plot, QWidget* parent)
    : QWidget(parent), m_plot(plot) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    retranslate();
}

void FeedsOverview::retranslate() {
    setAccessibleName(tr("Overview of the whole cycle"));
    setAccessibleDescription(tr("Arrows move the visible part, with Shift its end, with Ctrl its "
                                "beginning; Home shows the whole cycle."));
    setToolTip(
        tr("Actual feed over the whole cycle. Drag the window or its edges; the wheel zooms; "
           "a double click shows the whole cycle."));
}

QSize FeedsOverview::sizeHint() const {
    return {300, fontMetrics().height() * 5 / 2};
}

void FeedsOverview::showRun() {
    m_curves = {};
    update();
}

double FeedsOverview::wholeRange() const {
    return m_plot.scale().at(m_plot.series().end_s);
}

double FeedsOverview::pixelOf(double time_s) const {
    const double whole = wholeRange();
    return whole > 0 ? m_plot.scale().at(time_s) / whole * width() : 0;
}

QRectF FeedsOverview::window() const {
    const double from = pixelOf(m_plot.visibleFrom_s()), to = pixelOf(m_plot.visibleTo_s());
    return {from, 0, std::max(to - from, 1.0), double(height())};
}

// --- drawing ------------------------------------------------------------------------------------

void FeedsOverview::drawCurves() {
    const qreal ratio = devicePixelRatioF();
    m_curves = QPixmap(size() * ratio);
    m_curves.setDevicePixelRatio(ratio);
    m_curves.fill(palette().color(QPalette::Base));
    const double whole = wholeRange();
    if (!(whole > 0)) {
        return;
    }
    QPainter painter(&m_curves);
    for (const Band& band : m_plot.feeds().stageBands()) {
        painter.fillRect(QRectF(band.from / whole * width(), 0,
                                (band.to - band.from) / whole * width(), height()),
                         band.colour(palette()));
    }
    double highest = 0;
    std::vector<std::vector<XY>> lines;
    for (int i = 0; i < m_plot.columnCount(); ++i) {
        lines.push_back(
            polyline(m_plot.source(i).strokes, Quantity::actual, Edge::mean, m_plot.scale()));
        for (const XY& p : lines.back()) {
            highest = std::max(highest, p.y);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(style::colour(style::Drawn::actualFeed, palette()), 1.2));
    const double scale = highest > 0 ? height() * (1 - headroom) / highest : 0;
    for (const std::vector<XY>& line : lines) {
        QPolygonF polygon;
        for (const XY& p : line) {
            polygon << QPointF(p.x / whole * width(), height() - 1 - p.y * scale);
        }
        painter.drawPolyline(polygon);
    }
}

void FeedsOverview::paintEvent(QPaintEvent*) {
    if (m_curves.isNull()) {
        drawCurves();
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_curves);
    const QRectF inside = window();
    QColor shade = palette().color(QPalette::Text);
    shade.setAlpha(45);
    painter.fillRect(QRectF(0, 0, inside.left(), height()), shade);
    painter.fillRect(QRectF(inside.right(), 0, width() - inside.right(), height()), shade);
    if (const std::optional<double> moment_s = m_plot.moment_s()) {
        const double x = std::clamp(pixelOf(*moment_s), 1.0, width() - 1.0);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawLine(QLineF(x, 0, x, height()));
    }
    const QColor frame = palette().color(hasFocus() ? QPalette::Highlight : QPalette::Mid);
    painter.setPen(QPen(frame, 1));
    painter.drawRect(inside.adjusted(0, 0, -1, -1));
    for (const double x : {inside.left(), inside.right() - handleWidth}) {
        painter.fillRect(QRectF(x, height() * 0.25, handleWidth, height() * 0.5),
                         palette().color(QPalette::Highlight));
    }
}

void FeedsOverview::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showRun();
}

void FeedsOverview::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        showRun();
    }
}

// --- moving the window --------------------------------------------------------------------------

void FeedsOverview::ask(double from, double to) {
    const double whole = wholeRange();
    const double size = std::clamp(to - from, whole * smallestWindow, whole);
    from = std::clamp(from, 0.0, whole - size);
    emit timesAsked(m_plot.scale().time_s(from), m_plot.scale().time_s(from + size));
}

FeedsOverview::Part FeedsOverview::partAt(double x) const {
    const QRectF inside = window();
    // In a narrow window the middle remains reachable; its edges are dragged from outside.
    const double inner = std::min<double>(windowEdge, inside.width() / 4);
    if (x >= inside.left() - windowEdge && x <= inside.left() + inner) {
        return Part::begin;
    }
    if (x >= inside.right() - inner && x <= inside.right() + windowEdge) {
        return Part::end;
    }
    return inside.contains(QPointF(x, height() / 2.0)) ? Part::middle : Part::outside;
}

void FeedsOverview::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !(wholeRange() > 0)) {
        return;
    }
    const double x = event->position().x();
    m_dragged = partAt(x);
    m_grip = x / width() * wholeRange();
    m_from = m_plot.scale().at(m_plot.visibleFrom_s());
    m_to = m_plot.scale().at(m_plot.visibleTo_s());
    if (m_dragged == Part::outside) {
        const double half = (m_to - m_from) / 2;
        ask(m_grip - half, m_grip + half);
        m_from = m_plot.scale().at(m_plot.visibleFrom_s());
        m_to = m_plot.scale().at(m_plot.visibleTo_s());
        m_dragged = Part::middle;
    }
}

void FeedsOverview::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->position().x();
    if (!(event->buttons() & Qt::LeftButton)) {
        const Part part = partAt(x);
        setCursor(part == Part::begin || part == Part::end ? Qt::SizeHorCursor
                  : part == Part::middle                   ? Qt::OpenHandCursor
                                                           : Qt::PointingHandCursor);
        return;
    }
    const double at = std::clamp(x / width(), 0.0, 1.0) * wholeRange();
    const double tiny = wholeRange() * smallestWindow;
    switch (m_dragged) {
    case Part::begin: ask(std::min(at, m_to - tiny), m_to); break;
    case Part::end: ask(m_from, std::max(at, m_from + tiny)); break;
    case Part::middle: ask(m_from + at - m_grip, m_to + at - m_grip); break;
    case Part::outside: break;
    }
}

void FeedsOverview::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        m_dragged = Part::outside;
        emit dragged();
    }
}

void FeedsOverview::mouseDoubleClickEvent(QMouseEvent*) {
    emit fitAsked();
}

void FeedsOverview::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / notchOfWheel;
    const double at = event->position().x() / width() * wholeRange();
    const double factor = std::pow(wheelZoom, steps);
    const double from = m_plot.scale().at(m_plot.visibleFrom_s());
    const double to = m_plot.scale().at(m_plot.visibleTo_s());
    // Zooms about the mouse if it is within the window, otherwise about the window's middle.
    const double fixed = at > from && at < to ? at : (from + to) / 2;
    ask(fixed - (fixed - from) * factor, fixed + (to - fixed) * factor);
    emit dragged();
    event->accept();
}

void FeedsOverview::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (event->key() == Qt::Key_Home) {
        emit fitAsked();
        return;
    }
    if (step == 0) {
        QWidget::keyPressEvent(event);
        return;
    }
    const double from = m_plot.scale().at(m_plot.visibleFrom_s());
    const double to = m_plot.scale().at(m_plot.visibleTo_s());
    const double by = step * keyShare * (to - from);
    const bool end = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool begin = event->modifiers().testFlag(Qt::ControlModifier);
    if (end) {
        ask(from, std::min(to + by, wholeRange()));
    } else if (begin) {
        ask(std::max(from + by, 0.0), to);
    } else {
        ask(from + by, to + by);
    }
    emit dragged();
}

} // namespace sparkout
