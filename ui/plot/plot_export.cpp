// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include "core/units.h"
#include "core/version.h"
#include "ui/pdf/pdf_details.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/svg_device.h"
#include "ui/text/number_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QLocale>
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

/// A heading's lines wrapped to the width; the user's texts may be long.
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

/// The layout of a picture.
struct PictureSheet {
    std::vector<QRect> heading;
    LegendEntries entries;
    std::vector<QRect> legend; ///< rectangles from (0, 0)
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

struct PlotWords {
    Q_DECLARE_TR_FUNCTIONS(PlotWords)
public:
    /// The alternative text: the axes and the curves.
    static QString of(const PlotPicture& picture, const LegendEntries& entries) {
        QStringList axes, curves, all = picture.heading.mid(0, 1);
        for (const QCPAxisRect* rect : picture.plot->axisRects()) {
            for (const QCPAxis* axis : style::axesOf(*rect)) {
                if (axis->visible() && !axis->label().isEmpty()) {
                    axes << axis->label();
                }
            }
        }
        for (const LegendEntry& entry : entries) {
            curves << entry.text;
        }
        axes.removeDuplicates();
        if (!axes.isEmpty()) {
            all << tr("axes: %1").arg(axes.join(QStringLiteral("; ")));
        }
        if (!curves.isEmpty()) {
            all << tr("shown: %1").arg(curves.join(QStringLiteral("; ")));
        }
        return all.join(QStringLiteral(". "));
    }
};

void paintHeading(QCPPainter& painter, const PlotPicture& picture, const PictureSheet& sheet,
                  std::size_t line) {
    const QCustomPlot& plot = *picture.plot;
    painter.setPen(plot.palette().color(QPalette::Text));
    painter.setFont(line == 0 ? titleFont(plot) : plot.font());
    painter.drawText(sheet.heading[line], Qt::AlignLeft | Qt::AlignTop | Qt::TextWrapAnywhere,
                     picture.heading[static_cast<qsizetype>(line)]);
}

void paintPlot(QCPPainter& painter, const PlotPicture& picture, const PictureSheet& sheet) {
    QCustomPlot& plot = *picture.plot;
    painter.setFont(plot.font());
    for (std::size_t i = 0; i < sheet.legend.size(); ++i) {
        drawLegendEntry(painter, sheet.entries[i], sheet.legend[i].translated(sheet.legendAt),
                        plot.palette().color(QPalette::Text));
    }
    painter.save();
    painter.translate(sheet.plot.topLeft());
    plot.toPainter(&painter, sheet.plot.width(), sheet.plot.height());
    painter.restore();
}

/// A recorded drawing, independent of the plot, so that another thread may replay it.
struct Recording {
    struct Piece {
        QPicture drawing;
        PdfStructure::Id element;
    };
    std::vector<Piece> pieces;
    PdfStructure structure;
    QSize size;
    int dotsPerInch;
    QString title;
    QString language;
};

Recording record(const PlotPicture& picture, bool vectors) {
    const PictureSheet sheet = layOut(picture);
    Recording recording{{},
                        {},
                        sheet.size,
                        picture.plot->logicalDpiX(),
                        picture.heading.join(QStringLiteral(" — ")),
                        QLocale().bcp47Name().section(u'-', 0, 0)};
    const auto add = [&](PdfStructure::Id element, const std::function<void(QCPPainter&)>& paint) {
        recording.pieces.push_back({QPicture(), element});
        QCPPainter painter(&recording.pieces.back().drawing);
        painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
        painter.setMode(QCPPainter::pmVectorized, vectors);
        paint(painter);
        painter.end();
    };
    PdfStructure& structure = recording.structure;
    add(PdfStructure::artifact, [&](QCPPainter& painter) {
        painter.fillRect(QRect(QPoint(), sheet.size),
                         picture.plot->palette().color(QPalette::Base));
    });
    for (std::size_t i = 0; i < sheet.heading.size(); ++i) {
        add(structure.add({i == 0 ? "H1" : "P"}),
            [&](QCPPainter& painter) { paintHeading(painter, picture, sheet, i); });
    }
    const QRectF box(0, sheet.legendAt.y(), sheet.size.width(),
                     sheet.size.height() - sheet.legendAt.y());
    add(structure.add(
            {"Figure", PdfStructure::document, PlotWords::of(picture, sheet.entries), 1, box}),
        [&](QCPPainter& painter) { paintPlot(painter, picture, sheet); });
    return recording;
}

bool replay(const Recording& recording, QPaintDevice& device, int scale, bool marks = false) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    painter.scale(scale, scale);
    for (const Recording::Piece& piece : recording.pieces) {
        if (marks) {
            PdfStructure::mark(painter, piece.element);
        }
        painter.drawPicture(0, 0, piece.drawing);
    }
    return painter.end();
}

QImage rendered(const Recording& recording, int scale) {
    scale = std::clamp(scale, 1, largestPictureScale);
    QImage image(recording.size * scale, QImage::Format_RGB32);
    if (image.isNull() || !replay(recording, image, scale)) {
        return {};
    }
    // Set last, since it would enlarge the fonts.
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
    bool drawn = false;
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(recording.dotsPerInch);
        const QSizeF inches = QSizeF(recording.size) / recording.dotsPerInch;
        writer.setPageSize(QPageSize(inches, QPageSize::Inch, {}, QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF());
        drawn = replay(recording, writer, 1, true);
    }
    PdfDetails details{recording.title,
                       {},
                       {},
                       QStringLiteral("Sparkout %1").arg(QString::fromUtf8(version)),
                       recording.language,
                       documentDay(),
                       {},
                       recording.structure};
    constexpr double pointsPerInch = 72;
    details.structure.placeBoxes(pointsPerInch / recording.dotsPerInch, {});
    return drawn ? withDetails(bytes, details) : QByteArray();
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
