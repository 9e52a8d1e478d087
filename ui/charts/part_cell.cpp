// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/part_cell.h"

#include "ui/plot/band_layer.h"
#include "ui/plot/plot_style.h"

#include <QCoreApplication>
#include <QLocale>

namespace sparkout {

namespace {
constexpr double axisBelow = 13; ///< the cell [px]
constexpr double tooth = 4;      ///< of the break line
constexpr double besideName = 5; ///< beside the name of the axis [px]
constexpr int breakAlpha = 150;
constexpr int rightMargin = 14; ///< half of a number [px]

QString cellTr(const char* text) {
    return QCoreApplication::translate("PartCell", text);
}
} // namespace

QCPAxisRect* addPartCell(QCustomPlot& plot) {
    plot.plotLayout()->clear();
    const QString background = QStringLiteral("background");
    plot.addLayer(QStringLiteral("bands"), plot.layer(background), QCustomPlot::limAbove);
    auto* const cell = new QCPAxisRect(&plot, true);
    plot.plotLayout()->addElement(0, 0, cell);
    for (QCPAxis* axis : cell->axes()) {
        style::setUpAxis(*axis);
    }
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
        cell->axis(side)->setVisible(true);
        cell->axis(side)->setTicks(false);
    }
    cell->axis(QCPAxis::atBottom)->setOffset(partAxisHeight);
    return cell;
}

void stylePartCell(QCPAxisRect& cell) {
    QCustomPlot& plot = *cell.parentPlot();
    style::applyPalette(plot, plot.palette());
    for (QCPAxis* axis : cell.axes()) {
        axis->setTickLabelFont(plot.font());
        axis->setLabelFont(plot.font());
    }
    cell.setMinimumMargins(QMargins(0, BandLayer::nameMargin(plot.font()), rightMargin, 0));
}

void namePartCell(QCPAxisRect& cell) {
    QLocale numbers;
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    cell.parentPlot()->setLocale(numbers);
    cell.axis(QCPAxis::atBottom)
        ->setLabel(cellTr(
            QT_TRANSLATE_NOOP("PartCell", "From the headstock end of the ground length, mm")));
    cell.axis(QCPAxis::atLeft)
        ->setLabel(cellTr(QT_TRANSLATE_NOOP("PartCell", "Radius from\ntarget, µm")));
}

void drawPartAxis(QCPPainter& painter, const QCPAxisRect& cell) {
    const QPalette palette = cell.parentPlot()->palette();
    const QFont font = cell.parentPlot()->font();
    const QRectF strip(cell.left(), cell.bottom() + 1.0, cell.width(), partAxisHeight);
    QColor edge = palette.color(QPalette::Text);
    edge.setAlpha(breakAlpha);
    painter.setPen(QPen(edge, 1));
    QPolygonF teeth;
    for (double at = strip.left(); at <= strip.right() + tooth; at += tooth) {
        teeth << QPointF(at, strip.top() + (teeth.size() % 2 == 0 ? 0 : tooth));
    }
    painter.drawPolyline(teeth);
    painter.setPen(QPen(edge, 1, Qt::DashDotLine));
    painter.drawLine(QPointF(strip.left(), strip.top() + axisBelow),
                     QPointF(strip.right(), strip.top() + axisBelow));
    const QString name = cellTr(QT_TRANSLATE_NOOP("PartCell", "axis of rotation"));
    const double width = QFontMetrics(font).horizontalAdvance(name) + 2 * besideName;
    const QRectF text(strip.right() - width, strip.top() + tooth + 1, width,
                      strip.height() - tooth - 1);
    painter.setFont(font);
    painter.fillRect(text, palette.color(QPalette::Base));
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(text, Qt::AlignCenter, name);
}

} // namespace sparkout
