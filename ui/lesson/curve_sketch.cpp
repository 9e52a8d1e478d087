// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/curve_sketch.h"

#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme.h"
#include "ui/text/number_text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr int sketchWidth = 260, sketchHeight = 190, ticks = 5, stepsOfAxis = 100, keySteps = 50;
constexpr double roomAboveCurve = 1.08; ///< relative to the highest point

/// The next of 1, 2, 5, 10, … from a value on.
double roundTick(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double each : {1.0, 2.0, 5.0}) {
        if (each * power >= value * (1 - 1e-9)) {
            return each * power;
        }
    }
    return 10 * power;
}

double snapped(double value, double step) {
    return std::round(value / step) * step;
}

} // namespace

CurveSketch::CurveSketch(std::vector<double> at, QWidget* parent)
    : QWidget(parent), m_at(std::move(at)) {
    m_said.resize(m_at.size());
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::CrossCursor);
}

QSize CurveSketch::sizeHint() const {
    return {atFontSize(sketchWidth), atFontSize(sketchHeight)};
}

void CurveSketch::setLabels(QStringList places, QString along, QString value) {
    m_places = std::move(places);
    m_along = std::move(along);
    m_value = std::move(value);
    update();
}

void CurveSketch::setCurveNames(QString said, QString found) {
    m_saidName = std::move(said);
    m_foundName = std::move(found);
    update();
}

void CurveSketch::setSaid(const Values& values) {
    m_said = values;
    update();
}

void CurveSketch::setFound(const Values& values) {
    m_found = values;
    update();
}

void CurveSketch::setTop(double top) {
    m_top = top;
    update();
}

void CurveSketch::setEditable(bool editable) {
    m_isEditable = editable;
    setFocusPolicy(editable ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(editable ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

double CurveSketch::top() const {
    double most = m_top;
    for (const Values* values : {&m_said, &m_found}) {
        for (const auto& value : *values) {
            if (value && *value > most) {
                most = *value * roomAboveCurve;
            }
        }
    }
    return most;
}

double CurveSketch::bottom() const {
    double least = 0;
    for (const Values* values : {&m_said, &m_found}) {
        for (const auto& value : *values) {
            least = std::min(least, value.value_or(0) * roomAboveCurve);
        }
    }
    return least;
}

double CurveSketch::tick() const {
    return roundTick((top() - bottom()) / ticks);
}

/// The height of the heading with as many lines as needed.
int CurveSketch::headHeight() const {
    return fontMetrics()
        .boundingRect(QRect(0, 0, width() - metrics::tight, height()), Qt::TextWordWrap, m_value)
        .height();
}

QRectF CurveSketch::area() const {
    const QFontMetrics text = fontMetrics();
    int widest = 0;
    for (double at = std::ceil(bottom() / tick()) * tick(); at <= top(); at += tick()) {
        widest = std::max(widest, text.horizontalAdvance(printedNumber(at)));
    }
    const int line = text.height();
    return QRectF(rect()).adjusted(widest + metrics::margin, headHeight() + 1.4 * line,
                                   -metrics::wide, -2.2 * line);
}

QPointF CurveSketch::pointAt(std::size_t place, double value) const {
    const QRectF in = area();
    const double from = m_at.front(), to = m_at.back();
    const double share = to > from ? (m_at[place] - from) / (to - from) : 0.5;
    return {in.left() + share * in.width(),
            in.bottom() - (value - bottom()) / (top() - bottom()) * in.height()};
}

void CurveSketch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    drawAxes(painter);
    drawCurve(painter, m_said, false);
    drawCurve(painter, m_found, true);
    drawNames(painter);
    if (hasFocus() && m_isEditable) {
        const QPointF at = pointAt(m_current, m_said[m_current].value_or(bottom()));
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, 8, 8);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
        painter.drawLine(QPointF(at.x(), area().top()), QPointF(at.x(), area().bottom()));
    }
}

void CurveSketch::drawAxes(QPainter& painter) const {
    const QRectF in = area();
    const QColor ink = palette().color(QPalette::Text);
    QColor grid = ink;
    grid.setAlphaF(0.2F);
    const int line = fontMetrics().height();
    for (double at = std::ceil(bottom() / tick()) * tick(); at <= top() * (1 + 1e-9);
         at += tick()) {
        const double y = pointAt(0, at).y();
        painter.setPen(grid);
        painter.drawLine(QPointF(in.left(), y), QPointF(in.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(0, y - line / 2.0, in.left() - metrics::tight, line),
                         Qt::AlignRight | Qt::AlignVCenter, printedNumber(snapped(at, tick())));
    }
    painter.setPen(ink);
    painter.drawLine(in.bottomLeft(), in.bottomRight());
    painter.drawLine(in.topLeft(), in.bottomLeft());
    double free = -1;
    for (std::size_t i = 0; i < m_at.size() && qsizetype(i) < m_places.size(); ++i) {
        const double x = pointAt(i, 0).x();
        const QString& text = m_places[qsizetype(i)];
        const double half = fontMetrics().horizontalAdvance(text) / 2.0;
        painter.drawLine(QPointF(x, in.bottom()), QPointF(x, in.bottom() + 3));
        if (x - half > free) { // otherwise it would overlap the previous one
            painter.drawText(QRectF(x - half - 1, in.bottom() + 4, 2 * half + 2, line),
                             Qt::AlignCenter, text);
            free = x + half + metrics::tight;
        }
    }
    painter.drawText(QRectF(in.left(), height() - line - 1, in.width(), line), Qt::AlignCenter,
                     m_along);
    painter.drawText(QRectF(metrics::hair, 0, width() - metrics::tight, headHeight()),
                     Qt::AlignLeft | Qt::TextWordWrap, m_value);
}

/// The prediction is a solid line with discs, the result a dashed one with squares.
void CurveSketch::drawCurve(QPainter& painter, const Values& values, bool isFound) const {
    const QColor colour = tone(isFound ? Tone::vermilion : Tone::blue, palette());
    painter.setPen(QPen(colour, 2, isFound ? Qt::DashLine : Qt::SolidLine));
    std::optional<QPointF> before;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) {
            const QPointF at = pointAt(i, *values[i]);
            if (before) {
                painter.drawLine(*before, at);
            }
            before = at;
        }
    }
    painter.setPen(QPen(colour, 1));
    painter.setBrush(colour);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) {
            const QPointF at = pointAt(i, *values[i]);
            constexpr double half = 3.5;
            if (isFound) {
                painter.drawRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half));
            } else {
                painter.drawEllipse(at, half, half);
            }
        }
    }
}

void CurveSketch::drawNames(QPainter& painter) const {
    const int line = fontMetrics().height();
    const double below = headHeight() + 0.2 * line;
    double x = area().left();
    const auto name = [&](const QString& text, Tone colour, Qt::PenStyle style) {
        constexpr int sample = 22;
        painter.setPen(QPen(tone(colour, palette()), 2, style));
        const double y = below + line / 2.0;
        painter.drawLine(QPointF(x, y), QPointF(x + sample, y));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(x + sample + metrics::tight, below + fontMetrics().ascent()),
                         text);
        x += sample + metrics::wide + fontMetrics().horizontalAdvance(text);
    };
    name(m_saidName, Tone::blue, Qt::SolidLine);
    if (!m_found.empty()) {
        name(m_foundName, Tone::vermilion, Qt::DashLine);
    }
}

void CurveSketch::place(const QPointF& at) {
    if (!m_isEditable) {
        return;
    }
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < m_at.size(); ++i) {
        if (std::abs(pointAt(i, 0).x() - at.x()) < std::abs(pointAt(nearest, 0).x() - at.x())) {
            nearest = i;
        }
    }
    const QRectF in = area();
    const double share = std::clamp((in.bottom() - at.y()) / in.height(), 0.0, 1.0);
    const double step = roundTick((top() - bottom()) / stepsOfAxis);
    m_current = nearest;
    emit placed(nearest, snapped(bottom() + share * (top() - bottom()), step));
}

void CurveSketch::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        place(event->position());
    }
}

void CurveSketch::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) {
        place(event->position());
    }
}

void CurveSketch::keyPressEvent(QKeyEvent* event) {
    if (!m_isEditable) {
        QWidget::keyPressEvent(event);
        return;
    }
    const double step = roundTick((top() - bottom()) / keySteps);
    const double now = m_said[m_current].value_or(bottom());
    switch (event->key()) {
    case Qt::Key_Left: m_current -= m_current > 0 ? 1 : 0; break;
    case Qt::Key_Right: m_current += m_current + 1 < m_at.size() ? 1 : 0; break;
    case Qt::Key_Up: emit placed(m_current, snapped(now + step, step)); break;
    case Qt::Key_Down: emit placed(m_current, snapped(now - step, step)); break;
    case Qt::Key_Delete: emit placed(m_current, std::nullopt); break;
    default: QWidget::keyPressEvent(event); return;
    }
    update();
}

void CurveSketch::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void CurveSketch::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

} // namespace sparkout
