// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/part_plot.h"

#include "ui/plot/painted_layer.h"
#include "ui/views/layers/layers_look.h"

namespace sparkout {

namespace {
constexpr double tooth = 4;      ///< size of the break line's teeth
constexpr double besideName = 5; ///< beside the name of the axis [px]
constexpr int breakAlpha = 150;
constexpr int rightMargin = 14; ///< half of a number [px]
constexpr int tickOut = 4;      ///< [px]
} // namespace

PartPlot::PartPlot(QWidget* parent) : ChartPlot(parent), m_bands(new BandLayer(&cell(), true)) {}

LineChart PartPlot::partChart() {
    LineChart chart;
    chart.isFramed = true;
    chart.across.label = tr("From the headstock end of the ground length, mm");
    chart.up.label = tr("Radius from\ntarget, µm");
    chart.across.room = chart.up.room = 0;
    return chart;
}

void PartPlot::fillBands() {
    m_bands->setBands(LayersLook::zoneBands(zones(), palette()));
}

void PartPlot::restyle() {
    ChartPlot::restyle();
    across().setOffset(stripHeight());
    cell().setMinimumMargins(QMargins(0, BandLayer::nameMargin(font()), rightMargin, 0));
    fillBands();
}

void PartPlot::setTexts() {
    ChartPlot::setTexts();
    across().setTickLength(0, tickOut); // the axis is named above them
    fillBands();
}

QRect PartPlot::painted() const {
    return cell().rect().adjusted(0, 0, 0, stripHeight());
}

int PartPlot::stripHeight() const {
    return static_cast<int>(tooth) + 1 + QFontMetrics(font()).height();
}

void PartPlot::drawPartAxis(QCPPainter& painter) const {
    const QRectF strip(cell().left(), cell().bottom() + 1.0, cell().width(), stripHeight());
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
