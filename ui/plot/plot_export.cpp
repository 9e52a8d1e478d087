// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include "core/units.h"
#include "core/version.h"
#include "ui/plot/svg_device.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QPicture>

#include <qcustomplot.h>

#include <algorithm>
#include <vector>

namespace sparkout {

namespace {

constexpr double mmPerInch = 25.4;
constexpr int margin = 8;

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
struct PictureSheet {
    std::vector<QRect> heading;
    LegendEntries entries;
    std::vector<QRect> legend; ///< from (0, 0)
    QPoint legendAt;
    QRect plot;
    QSize size;
};

PictureSheet layOut(const PlotPicture& picture) {
    PictureSheet sheet;
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

void paint(QCPPainter& painter, const PlotPicture& picture, const PictureSheet& sheet) {
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

/// What was drawn, apart from the plot: another thread may draw it again.
struct Recording {
    QPicture drawing;
    QSize size;
    int dotsPerInch;
    QString title;
};

Recording record(const PlotPicture& picture, bool vectors) {
    const PictureSheet sheet = layOut(picture);
    Recording recording{QPicture(), sheet.size, picture.plot->logicalDpiX(),
                        picture.heading.join(QStringLiteral(" — "))};
    QCPPainter painter(&recording.drawing);
    painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
    painter.setMode(QCPPainter::pmVectorized, vectors);
    paint(painter, picture, sheet);
    painter.end();
    return recording;
}

bool replay(const Recording& recording, QPaintDevice& device, int scale) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    painter.scale(scale, scale);
    painter.drawPicture(0, 0, recording.drawing);
    return painter.end();
}

QImage rendered(const Recording& recording, int scale) {
    scale = std::clamp(scale, 1, largestPictureScale);
    QImage image(recording.size * scale, QImage::Format_RGB32);
    if (image.isNull() || !replay(recording, image, scale)) {
        return {};
    }
    // Only now: it would enlarge the fonts.
    const int dotsPerMetre = qRound(recording.dotsPerInch * scale * units::mmPerM / mmPerInch);
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);
    return image;
}

QByteArray pdf(const Recording& recording) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly)) {
        return {};
    }
    QPdfWriter writer(&buffer);
    writer.setTitle(recording.title);
    writer.setCreator(QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version)));
    writer.setResolution(recording.dotsPerInch);
    const QSizeF inches = QSizeF(recording.size) / recording.dotsPerInch;
    writer.setPageSize(QPageSize(inches, QPageSize::Inch, {}, QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF());
    const bool drawn = replay(recording, writer, 1);
    return drawn && bytes.contains("%%EOF") ? bytes : QByteArray();
}

} // namespace

QSize pictureSize(const PlotPicture& picture) {
    return layOut(picture).size;
}

QImage pictureImage(const PlotPicture& picture, int scale) {
    return rendered(record(picture, false), scale);
}

PictureWork pngWork(const PlotPicture& picture, int scale) {
    return [recording = record(picture, false), scale] {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        const QImage image = rendered(recording, scale);
        const bool written = buffer.open(QIODevice::WriteOnly) && image.save(&buffer, "PNG");
        return written ? bytes : QByteArray();
    };
}

PictureWork svgWork(const PlotPicture& picture) {
    return [recording = record(picture, true)] {
        SvgDevice device(recording.size, recording.dotsPerInch, recording.title);
        return replay(recording, device, 1) ? device.document() : QByteArray();
    };
}

PictureWork pdfWork(const PlotPicture& picture) {
    return [recording = record(picture, true)] { return pdf(recording); };
}

} // namespace sparkout
