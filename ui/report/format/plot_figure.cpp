// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/plot_figure.h"

#include "ui/kit/theme.h"

#include <qcustomplot.h>

#include <QPicture>

namespace sparkout::report {

namespace {

constexpr int plotFontPixels = 12;
constexpr int legendGap = 6;

QSize draw(QPicture& picture, QCustomPlot& plot, const LegendEntries& legend) {
    const auto rects = legendRects(legend, QFontMetrics(plot.font()), plot.width());
    const int top = legend.empty() ? 0 : legendHeight(rects) + legendGap;
    QCPPainter painter(&picture);
    painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic
                     | QCPPainter::pmVectorized);
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < legend.size(); ++i) {
        drawLegendEntry(painter, legend[i], rects[i], plot.palette().color(QPalette::Text));
    }
    painter.translate(0, top);
    plot.toPainter(&painter, plot.width(), plot.height());
    painter.end();
    return {plot.width(), plot.height() + top};
}

} // namespace

void setUpForPaper(QCustomPlot& plot, int height) {
    plot.setPalette(paletteOf(Theme::light));
    QFont font = plot.font();
    font.setPixelSize(plotFontPixels); // the same on every device
    plot.setFont(font);
    plot.resize(figureWidth, height);
}

Figure plotFigure(QCustomPlot& plot, const LegendEntries& legend, const QString& caption,
                  const QString& description) {
    plot.replot();
    QPicture picture;
    const QSize size = draw(picture, plot, legend);
    return {caption, description, size,
            [picture, dots = double(plot.logicalDpiX())](QPainter& painter) {
                // A picture is enlarged by the device's resolution.
                painter.scale(dots / painter.device()->logicalDpiX(),
                              dots / painter.device()->logicalDpiY());
                painter.drawPicture(0, 0, picture);
            }};
}

} // namespace sparkout::report
