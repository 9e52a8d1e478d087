// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_drawing.h"

#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr int usualDrawingWidth = 200, leastDrawingWidth = 120, usualDrawingHeight = 46;
constexpr double thinLine = 1, boldLine = 3;

} // namespace

PartDrawing::PartDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void PartDrawing::setOutline(PartOutline outline) {
    m_outline = std::move(outline);
    update();
}

void PartDrawing::setPresent(std::optional<std::size_t> surface) {
    m_present = surface;
    update();
}

void PartDrawing::setChosenStep(std::optional<std::size_t> step) {
    m_step = step;
    update();
}

void PartDrawing::setTips(QStringList tips) {
    m_tips = std::move(tips);
}

QSize PartDrawing::sizeHint() const {
    return {atFontSize(usualDrawingWidth), atFontSize(usualDrawingHeight)};
}

QSize PartDrawing::minimumSizeHint() const {
    return {leastDrawingWidth, atFontSize(usualDrawingHeight)};
}

/// The same along the part and across it; the numbers are above.
double PartDrawing::scale() const {
    const double width = std::max(1, this->width() - 2 * metrics::tight);
    const double height = std::max(1, this->height() - fontMetrics().height() - metrics::tight);
    return std::min(width / std::max(m_outline.length_mm, 1e-9),
                    height / std::max(m_outline.diameter_mm, 1e-9));
}

double PartDrawing::xOf(double place_mm) const {
    const double drawn = scale() * m_outline.length_mm;
    return (width() - drawn) / 2 + scale() * place_mm;
}

double PartDrawing::placeAt(double x) const {
    return (x - xOf(0)) / scale();
}

QRectF PartDrawing::box(const PartOutline::Step& step) const {
    const double axis =
        fontMetrics().height() + (height() - fontMetrics().height() - metrics::hair) / 2.0;
    const double across = scale() * step.diameter_mm;
    return {xOf(step.from_mm), axis - across / 2, scale() * step.length_mm, across};
}

void PartDrawing::drawBody(QPainter& painter) const {
    QColor line = palette().color(QPalette::WindowText);
    painter.setPen(QPen(line, thinLine));
    for (std::size_t i = 0; i < m_outline.steps.size(); ++i) {
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlphaF(0.35F);
        painter.setBrush(m_step == i ? QBrush(fill) : QBrush(palette().color(QPalette::Base)));
        painter.drawRect(box(m_outline.steps[i]));
    }
    line.setAlphaF(0.6F);
    painter.setPen(QPen(line, thinLine, Qt::DashDotLine));
    const double axis = box(m_outline.steps.front()).center().y();
    painter.drawLine(QPointF(xOf(0) - metrics::tight, axis),
                     QPointF(xOf(m_outline.length_mm) + metrics::tight, axis));
}

void PartDrawing::drawSurface(QPainter& painter, std::size_t surface) const {
    const QRectF place = box(m_outline.surfaces[surface]);
    if (m_present == surface) {
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlphaF(0.45F);
        painter.fillRect(place, fill);
    }
    painter.setPen(
        QPen(palette().color(m_present == surface ? QPalette::Highlight : QPalette::WindowText),
             boldLine, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(place.topLeft(), place.topRight());
    painter.drawLine(place.bottomLeft(), place.bottomRight());
}

/// Leaves out numbers that do not fit; the list beside the drawing has them all.
void PartDrawing::drawNumbers(QPainter& painter) const {
    const double body = scale() * m_outline.diameter_mm;
    const double axis = box(m_outline.steps.front()).center().y();
    const double top = std::max(0.0, axis - body / 2 - fontMetrics().height() - metrics::hair);
    std::vector<QRectF> taken;
    const auto draw = [&](std::size_t surface) {
        const QString number = QString::number(surface + 1);
        const QRectF place = box(m_outline.surfaces[surface]);
        const double width = fontMetrics().horizontalAdvance(number) + metrics::hair;
        const QRectF label(place.center().x() - width / 2, top, width, fontMetrics().height());
        if (std::ranges::any_of(taken,
                                [&](const QRectF& other) { return other.intersects(label); })) {
            return;
        }
        taken.push_back(label);
        QFont font = this->font();
        font.setBold(m_present == surface);
        painter.setFont(font);
        painter.drawText(label, Qt::AlignCenter | Qt::TextDontClip, number);
    };
    painter.setPen(palette().color(QPalette::WindowText));
    if (m_present) {
        draw(*m_present);
    }
    for (std::size_t i = 0; i < m_outline.surfaces.size(); ++i) {
        if (m_present != i) {
            draw(i);
        }
    }
}

void PartDrawing::paintEvent(QPaintEvent*) {
    if (m_outline.steps.empty()) {
        return;
    }
    QPainter painter(this);
    drawBody(painter);
    for (std::size_t i = 0; i < m_outline.surfaces.size(); ++i) {
        drawSurface(painter, i);
    }
    drawNumbers(painter);
}

void PartDrawing::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    const double place_mm = placeAt(event->position().x());
    if (const auto step = m_outline.stepAt(place_mm)) {
        emit stepClicked(*step);
    }
    if (const auto surface = m_outline.surfaceAt(place_mm)) {
        emit surfaceClicked(*surface);
    }
}

void PartDrawing::mouseDoubleClickEvent(QMouseEvent* event) {
    const auto step = m_outline.stepAt(placeAt(event->position().x()));
    if (event->button() == Qt::LeftButton && m_outline.hasSteps && step
        && m_outline.isFree(*step)) {
        emit freeStepEntered(*step);
    } else {
        mousePressEvent(event);
    }
}

bool PartDrawing::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto surface = m_outline.surfaceAt(placeAt(help->pos().x()));
        const QString tip = surface ? m_tips.value(static_cast<qsizetype>(*surface)) : QString();
        tip.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), tip, this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace sparkout
