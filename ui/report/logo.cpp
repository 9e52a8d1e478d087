// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/logo.h"

#include <QBuffer>
#include <QImageReader>
#include <QLocale>
#include <QSize>

#include <algorithm>
#include <array>

namespace sparkout::report {

namespace {

constexpr qsizetype pngSignatureBytes = 8, chunkFrameBytes = 12;

unsigned byteAt(const QByteArray& bytes, qsizetype at) {
    return static_cast<unsigned char>(bytes[at]);
}

/// A big-endian number of several bytes; 0 beyond the end.
quint32 numberAt(const QByteArray& bytes, qsizetype at, int length) {
    quint32 number = 0;
    for (qsizetype i = at; i < at + length; ++i) {
        number = i < bytes.size() ? number << 8U | byteAt(bytes, i) : 0;
    }
    return number;
}

bool isPng(const QByteArray& bytes) {
    return bytes.startsWith("\x89PNG\r\n\x1a\n");
}

bool isJpeg(const QByteArray& bytes) {
    return bytes.startsWith("\xff\xd8\xff");
}

/// Whether bytes are XML, in whichever encoding, or packed as drawings in SVG are.
bool isDrawing(const QByteArray& bytes) {
    constexpr qsizetype looked = 4096;
    const QByteArray text = bytes.left(looked).replace('\0', "").toLower();
    return bytes.startsWith("\x1f\x8b") || text.contains("<svg") || text.contains("<?xml")
           || text.contains("<!doctype svg");
}

QSize sizeOf(quint32 width, quint32 height) {
    constexpr quint32 most = 0x7fffffff;
    return {static_cast<int>(std::min(width, most)), static_cast<int>(std::min(height, most))};
}

/// The first chunk of a PNG file is its header [ISO/IEC 15948, 11.2.2].
QSize declaredSizeOfPng(const QByteArray& bytes) {
    const bool hasHeader = bytes.mid(pngSignatureBytes + 4, 4) == "IHDR";
    constexpr qsizetype width = pngSignatureBytes + 8, height = width + 4;
    return hasHeader ? sizeOf(numberAt(bytes, width, 4), numberAt(bytes, height, 4)) : QSize();
}

/// Skips markers with a length up to the beginning of a frame [ITU-T T.81, B.2.2].
QSize declaredSizeOfJpeg(const QByteArray& bytes) {
    constexpr unsigned tables = 0xc4, extension = 0xc8, conditioning = 0xcc;
    qsizetype at = 2;
    while (at + 4 <= bytes.size() && byteAt(bytes, at) == 0xff) {
        const unsigned marker = byteAt(bytes, at + 1);
        if (marker == 0xff) { // a fill byte
            ++at;
            continue;
        }
        if (marker >= 0xc0 && marker <= 0xcf && marker != tables && marker != extension
            && marker != conditioning) {
            return sizeOf(numberAt(bytes, at + 7, 2), numberAt(bytes, at + 5, 2));
        }
        at += 2 + static_cast<qsizetype>(numberAt(bytes, at + 2, 2));
    }
    return {};
}

QSize declaredSize(const QByteArray& bytes) {
    return isPng(bytes) ? declaredSizeOfPng(bytes) : declaredSizeOfJpeg(bytes);
}

/// The parts of a PNG file needed for drawing, without texts and colour profiles, which unpack to a
/// thousand times their size.
QByteArray drawnChunks(const QByteArray& png) {
    constexpr std::array drawn{"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "cHRM", "sRGB"};
    QByteArray kept = png.left(pngSignatureBytes);
    for (qsizetype at = pngSignatureBytes; at + chunkFrameBytes <= png.size();) {
        const qsizetype whole = chunkFrameBytes + qsizetype{numberAt(png, at, 4)};
        const QByteArray kind = png.mid(at + 4, 4);
        if (std::ranges::any_of(drawn, [&kind](const char* each) { return kind == each; })) {
            kept += png.mid(at, whole);
        }
        at += whole;
    }
    return kept;
}

/// Each scan of a JPEG file covers all pixels, but needs only a few bytes; usual pictures have
/// about ten.
bool hasTooManyScans(const QByteArray& jpeg) {
    constexpr qsizetype most = 100;
    return jpeg.count("\xff\xda") > most;
}

} // namespace

QString Logo::damagedText() {
    return tr("This picture is damaged and cannot be shown.");
}

QString Logo::fault(const QByteArray& bytes) {
    if (bytes.isEmpty()) {
        return {};
    }
    const QString most = QLocale().toString(mostSide);
    if (!isPng(bytes) && !isJpeg(bytes)) {
        return isDrawing(bytes)
                   ? tr("An SVG drawing cannot be a logo: a logo is a PNG or JPEG picture of at "
                        "most %1 pixels a side. Open the drawing in a drawing program or a browser "
                        "and export it as PNG: in Inkscape by File › Export, on the command line "
                        "by “rsvg-convert -w 1200 -o logo.png logo.svg”.")
                         .arg(most)
                   : tr("This is not a PNG or JPEG picture. A logo has at most %1 pixels a side: "
                        "open the picture in an image program and save it as PNG.")
                         .arg(most);
    }
    if (bytes.size() > mostBytes) {
        return tr("The picture has %1 bytes; a logo has at most %2.")
            .arg(QLocale().toString(bytes.size()), QLocale().toString(mostBytes));
    }
    const QSize size = declaredSize(bytes);
    if (size.isEmpty() || (isJpeg(bytes) && hasTooManyScans(bytes))) {
        return damagedText();
    }
    if (std::max(size.width(), size.height()) > mostSide) {
        return tr("The picture has %1 × %2 pixels; a logo has at most %3 a side.")
            .arg(QLocale().toString(size.width()), QLocale().toString(size.height()), most);
    }
    return {};
}

QImage Logo::image(const QByteArray& bytes) {
    constexpr int mostOnPaper = 1200; // finer than any printer shows at that size
    if (bytes.isEmpty() || !fault(bytes).isEmpty()) {
        return {};
    }
    const bool png = isPng(bytes);
    QByteArray drawn = png ? drawnChunks(bytes) : bytes;
    QBuffer buffer(&drawn);
    QImageReader reader(&buffer, png ? "png" : "jpeg");
    reader.setDecideFormatFromContent(false);
    reader.setAutoDetectImageFormat(false);
    const QSize size = reader.size(); // as the decoder reads it
    if (size.isEmpty() || std::max(size.width(), size.height()) > mostSide) {
        return {};
    }
    if (std::max(size.width(), size.height()) > mostOnPaper) {
        reader.setScaledSize(
            size.scaled(mostOnPaper, mostOnPaper, Qt::KeepAspectRatio).expandedTo(QSize(1, 1)));
    }
    return reader.read();
}

} // namespace sparkout::report
