// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/hair_line.h"

#include "ui/plot/plot_style.h"

namespace sparkout {

namespace {

QString layerOf(QCustomPlot& plot) {
    if (!plot.layer(HairLine::layerName())) {
        plot.addLayer(HairLine::layerName());
        plot.layer(HairLine::layerName())->setMode(QCPLayer::lmBuffered);
    }
    return HairLine::layerName();
}

} // namespace

HairLine::HairLine(QCustomPlot& plot, Role role)
    : PaintedLayer(plot, layerOf(plot), Edges::sharp), m_role(role) {}

void HairLine::setAt(std::optional<double> x) {
    if (x != m_x) {
        m_x = x;
        layer()->replot();
    }
}

void HairLine::draw(QCPPainter* painter) {
    if (!m_x) {
        return;
    }
    const bool moment = m_role == Role::moment;
    const QColor colour =
        style::thinned(mParentPlot->palette().color(moment ? QPalette::Highlight : QPalette::Text),
                       moment ? 255 : 160);
    painter->setPen(QPen(colour, moment ? 2 : 0));
    for (const QCPAxisRect* rect : mParentPlot->axisRects()) {
        const QCPAxis* axis = rect->axis(QCPAxis::atBottom);
        if (axis && axis->range().contains(*m_x)) {
            const double x = axis->coordToPixel(*m_x);
            painter->drawLine(QLineF(x, rect->top(), x, rect->bottom()));
        }
    }
}

} // namespace sparkout
