// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/part_plot.h"

#include "ui/plot/band_layer.h"
#include "ui/views/layers/layers_look.h"

namespace sparkout {

namespace {
constexpr double tooth = 4;      ///< size of the break line's teeth
constexpr double besideName = 5; ///< beside the name of the axis [px]
constexpr int breakAlpha = 150;
constexpr int rightMargin = 14; ///< half of a number [px]
constexpr int tickOut = 4;      ///< [px]
} // namespace

PartPlot::PartPlot(QWidget* parent)
    : ViewPlot(parent), m_cell(addCell()), m_bands(new BandLayer(m_cell, true)) {
    m_cell->axis(QCPAxis::atBottom)->setTickLength(0, tickOut); // the axis is named above them
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        if (style::fitValueAxes(*m_cell, font())) {
            replot(rpQueuedReplot);
        }
    });
}

void PartPlot::fillBands() {
    m_bands->setBands(LayersLook::zoneBands(zones(), palette()));
}

void PartPlot::restyle() {
    ViewPlot::restyle();
    m_cell->axis(QCPAxis::atBottom)->setOffset(stripHeight());
    m_cell->setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), rightMargin, 0));
    fillBands();
}

void PartPlot::setTexts() {
    m_cell->axis(QCPAxis::atBottom)
        ->setLabel(tr("From the headstock end of the ground length, mm"));
    m_cell->axis(QCPAxis::atLeft)->setLabel(tr("Radius from\ntarget, µm"));
    fillBands();
}

QRect PartPlot::painted() const {
    return m_cell->rect().adjusted(0, 0, 0, stripHeight());
}

int PartPlot::stripHeight() const {
    return static_cast<int>(tooth) + 1 + QFontMetrics(font()).height();
}

void PartPlot::drawPartAxis(QCPPainter& painter) const {
    const QRectF strip(m_cell->left(), m_cell->bottom() + 1.0, m_cell->width(), stripHeight());
    const double middle = strip.top() + (tooth + 1 + strip.height()) / 2;
    const QColor edge = style::thinned(palette().color(QPalette::Text), breakAlpha);
    painter.setPen(QPen(edge, 1));
    QPolygonF teeth;
    for (double at = strip.left(); at <= strip.right() + tooth; at += tooth) {
        teeth << QPointF(at, strip.top() + (teeth.size() % 2 == 0 ? 0 : tooth));
    }
    painter.drawPolyline(teeth);
    painter.setPen(QPen(edge, 1, Qt::DashDotLine));
    painter.drawLine(QPointF(strip.left(), middle), QPointF(strip.right(), middle));
    const QString name = tr("axis of rotation");
    const double width = QFontMetrics(font()).horizontalAdvance(name) + 2 * besideName;
    const QRectF text(strip.right() - width, strip.top() + tooth + 1, width,
                      strip.height() - tooth - 1);
    painter.setFont(font());
    painter.fillRect(text, palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(text, Qt::AlignCenter, name);
}

} // namespace sparkout
