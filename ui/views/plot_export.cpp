// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/plot_export.h"

#include "core/units.h"
#include "core/version.h"
#include "ui/views/svg_device.h"

#include <QBuffer>
#include <QPdfWriter>

#include <qcustomplot.h>

#include <algorithm>
#include <vector>

namespace sparkout {

namespace {

constexpr double mmPerInch = 25.4;
constexpr int margin = 8;

/// The plot is laid out for its screen; the sheet takes the same resolution.
int dotsPerInch(const PlotPicture& picture) {
    return picture.plot->logicalDpiX();
}

QFont titleFont(const QCustomPlot& plot) {
    QFont font = plot.font();
    font.setBold(true);
    return font;
}

/// A heading's lines wrapped to the width; texts of the user may be long.
std::vector<QRect> headingRects(const PlotPicture& picture, int width) {
    std::vector<QRect> rects;
    int y = margin;
    for (qsizetype i = 0; i < picture.heading.size(); ++i) {
        const QFontMetrics metrics(i == 0 ? titleFont(*picture.plot) : picture.plot->font());
        const QRect room(margin, y, width - 2 * margin, 10 * metrics.height());
        const int height =
            metrics.boundingRect(room, Qt::TextWrapAnywhere, picture.heading[i]).height();
        rects.emplace_back(margin, y, room.width(), std::min(height, 3 * metrics.height()));
        y += rects.back().height();
    }
    return rects;
}

/// Where the parts of a picture stand.
struct Sheet {
    std::vector<QRect> heading;
    LegendEntries entries;
    std::vector<QRect> legend; ///< from (0, 0)
    QPoint legendAt;
    QRect plot;
    QSize size;
};

Sheet layOut(const PlotPicture& picture) {
    Sheet sheet;
    const int width = picture.plot->width();
    sheet.heading = headingRects(picture, width);
    int y = sheet.heading.empty() ? margin : sheet.heading.back().bottom() + 1 + margin / 2;
    std::ranges::copy_if(picture.legend, std::back_inserter(sheet.entries), &LegendEntry::shown);
    sheet.legend =
        legendRects(sheet.entries, QFontMetrics(picture.plot->font()), width - 2 * margin);
    sheet.legendAt = {margin, y};
    y += legendHeight(sheet.legend) + margin / 2;
    sheet.plot = {0, y, width, picture.plot->height()};
    sheet.size = {width, y + picture.plot->height() + margin};
    return sheet;
}

void paint(QCPPainter& painter, const PlotPicture& picture, const Sheet& sheet) {
    QCustomPlot& plot = *picture.plot;
    const QColor text = plot.palette().color(QPalette::Text);
    painter.fillRect(QRect(QPoint(), sheet.size), plot.palette().color(QPalette::Base));
    painter.setPen(text);
    for (std::size_t i = 0; i < sheet.heading.size(); ++i) {
        painter.setFont(i == 0 ? titleFont(plot) : plot.font());
        painter.drawText(sheet.heading[i], Qt::AlignLeft | Qt::AlignTop | Qt::TextWrapAnywhere,
                         picture.heading[static_cast<qsizetype>(i)]);
    }
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < sheet.legend.size(); ++i) {
        drawLegendEntry(painter, sheet.entries[i], sheet.legend[i].translated(sheet.legendAt),
                        text);
    }
    painter.save();
    painter.translate(sheet.plot.topLeft());
    plot.toPainter(&painter, sheet.plot.width(), sheet.plot.height());
    painter.restore();
}

} // namespace

QSize pictureSize(const PlotPicture& picture) {
    return layOut(picture).size;
}

QImage pictureImage(const PlotPicture& picture, int scale) {
    const Sheet sheet = layOut(picture);
    scale = std::clamp(scale, 1, largestPictureScale);
    QImage image(sheet.size * scale, QImage::Format_RGB32);
    if (image.isNull()) {
        return image;
    }
    QCPPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setMode(QCPPainter::pmNonCosmetic, scale > 1);
    painter.scale(scale, scale);
    paint(painter, picture, sheet);
    painter.end();
    // Only now: it would enlarge the fonts.
    const int dotsPerMetre = qRound(dotsPerInch(picture) * scale * units::mmPerM / mmPerInch);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    return image;
}

QByteArray picturePng(const PlotPicture& picture, int scale) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    const QImage image = pictureImage(picture, scale);
    const bool written = buffer.open(QIODevice::WriteOnly) && image.save(&buffer, "PNG");
    return written ? bytes : QByteArray();
}

QByteArray pictureSvg(const PlotPicture& picture) {
    const Sheet sheet = layOut(picture);
    SvgDevice device(sheet.size, dotsPerInch(picture), picture.heading.join(QStringLiteral(" — ")));
    QCPPainter painter(&device);
    painter.setModes(QCPPainter::pmVectorized | QCPPainter::pmNoCaching
                     | QCPPainter::pmNonCosmetic);
    paint(painter, picture, sheet);
    painter.end();
    return device.document();
}

QByteArray picturePdf(const PlotPicture& picture) {
    const Sheet sheet = layOut(picture);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly)) {
        return {};
    }
    QPdfWriter writer(&buffer);
    writer.setTitle(picture.heading.value(0));
    writer.setCreator(QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version)));
    writer.setResolution(dotsPerInch(picture));
    const QSizeF inches = QSizeF(sheet.size) / dotsPerInch(picture);
    writer.setPageSize(QPageSize(inches, QPageSize::Inch, {}, QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF());
    QCPPainter painter(&writer);
    if (!painter.isActive()) {
        return {};
    }
    painter.setModes(QCPPainter::pmVectorized | QCPPainter::pmNoCaching
                     | QCPPainter::pmNonCosmetic);
    paint(painter, picture, sheet);
    painter.end();
    return bytes.contains("%%EOF") ? bytes : QByteArray();
}

} // namespace sparkout
