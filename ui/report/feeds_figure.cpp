// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/figures.h"

#include "core/process/system_compliance.h"
#include "ui/theme.h"
#include "ui/views/feeds_plot.h"
#include "ui/views/legend_drawing.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPicture>

namespace sparkout::report {

namespace {

constexpr QSize plotSize(820, 420);
constexpr int plotFontPixels = 12;
constexpr int legendGap = 6;

struct FeedsFigure {
    Q_DECLARE_TR_FUNCTIONS(FeedsFigure)
};

/// The legend above the plot, on paper's white.
QSize draw(QPicture& picture, FeedsPlot& plot) {
    const LegendEntries entries = plot.legendEntries();
    const auto rects = legendRects(entries, QFontMetrics(plot.font()), plotSize.width());
    const int top = legendHeight(rects) + legendGap;
    QCPPainter painter(&picture);
    painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic
                     | QCPPainter::pmVectorized);
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        drawLegendEntry(painter, entries[i], rects[i], plot.palette().color(QPalette::Text));
    }
    painter.translate(0, top);
    plot.toPainter(&painter, plotSize.width(), plotSize.height());
    painter.end();
    return {plotSize.width(), plotSize.height() + top};
}

} // namespace

std::optional<Figure> feedsFigure(const OutcomePtr& outcome) {
    if (outcome->trajectory.passes.empty()) {
        return {};
    }
    const Project& project = outcome->result.project;
    const auto count = static_cast<int>(outcome->feeds.columns.size());
    FeedsPlot plot;
    plot.setPalette(paletteOf(Theme::light));
    QFont font = plot.font();
    font.setPixelSize(plotFontPixels); // the same on every device
    plot.setFont(font);
    plot.resize(plotSize);
    plot.setRun(
        outcome,
        shownSections(count, project.operation == Operation::plunge ? gaugeSection(project) : 0));
    plot.restyle();
    plot.showAll();
    plot.replot();
    QPicture picture;
    const QSize size = draw(picture, plot);
    const QString caption = FeedsFigure::tr("Feeds by stage over the whole cycle");
    return Figure{caption, caption, size,
                  [picture, dots = double(plot.logicalDpiX())](QPainter& painter) {
                      // A picture is enlarged by the device's resolution.
                      painter.scale(dots / painter.device()->logicalDpiX(),
                                    dots / painter.device()->logicalDpiY());
                      painter.drawPicture(0, 0, picture);
                  }};
}

} // namespace sparkout::report
