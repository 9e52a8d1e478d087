// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBuffer>
#include <QByteArray>
#include <QImage>

/// Pictures for logos, in order and not.
namespace sparkout::samples {

inline QByteArray picture(QSize size, const char* format) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(0xff2060a0);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format);
    return bytes;
}

/// CRC-32 of ISO 3309, as PNG has it behind each chunk.
inline quint32 pngChecksum(const QByteArray& bytes) {
    quint32 sum = 0xffffffff;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            sum = sum & 1U ? sum >> 1U ^ 0xedb88320U : sum >> 1U;
        }
    }
    return ~sum;
}

inline QByteArray bigEndian(quint32 number) {
    QByteArray bytes;
    for (unsigned shift = 32; shift > 0;) {
        shift -= 8;
        bytes += static_cast<char>(number >> shift & 0xffU);
    }
    return bytes;
}

inline QByteArray pngChunk(const QByteArray& kind, const QByteArray& content) {
    return bigEndian(static_cast<quint32>(content.size())) + kind + content
           + bigEndian(pngChecksum(kind + content));
}

/// A PNG file whose head is in order and whose pixels are missing.
inline QByteArray withoutPixels(const QByteArray& png) {
    constexpr qsizetype headEnd = 8 + 25;
    return png.left(headEnd) + pngChunk("IEND", {});
}

} // namespace sparkout::samples
