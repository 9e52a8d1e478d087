// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/plot_figure.h"

#include "ui/theme.h"

#include <QPainter>
#include <QPicture>

#include <qcustomplot.h>

namespace sparkout::report {

namespace {

constexpr int plotFontPixels = 12;
constexpr int legendGap = 6;

QSize record(QPicture& picture, QCustomPlot& plot, const LegendEntries& entries) {
    const QSize size = plot.size();
    const auto rects = legendRects(entries, QFontMetrics(plot.font()), size.width());
    const int top = legendHeight(rects) + legendGap;
    QCPPainter painter(&picture);
    painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic
                     | QCPPainter::pmVectorized);
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        drawLegendEntry(painter, entries[i], rects[i], plot.palette().color(QPalette::Text));
    }
    painter.translate(0, top);
    plot.toPainter(&painter, size.width(), size.height());
    painter.end();
    return {size.width(), size.height() + top};
}

} // namespace

void preparePlot(QCustomPlot& plot, QSize size) {
    plot.setPalette(paletteOf(Theme::light));
    QFont font = plot.font();
    font.setPixelSize(plotFontPixels); // the same on every device
    plot.setFont(font);
    plot.resize(size);
}

Figure plotFigure(QCustomPlot& plot, const LegendEntries& legend, const QString& caption,
                  const QString& told) {
    plot.replot();
    QPicture picture;
    const QSize size = record(picture, plot, legend);
    return Figure{caption, told, size,
                  [picture, dots = double(plot.logicalDpiX())](QPainter& painter) {
                      // A picture is enlarged by the device's resolution.
                      painter.scale(dots / painter.device()->logicalDpiX(),
                                    dots / painter.device()->logicalDpiY());
                      painter.drawPicture(0, 0, picture);
                  }};
}

} // namespace sparkout::report
