// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card/logo.h"

#include <QBuffer>
#include <QImageReader>

#include <algorithm>

namespace sparkout::report {

QImage logoImage(const QByteArray& bytes) {
    constexpr int mostPixels = 1200; // finer than any printer shows at that size
    if (bytes.isEmpty() || bytes.size() > mostLogoBytes) {
        return {};
    }
    QByteArray copy = bytes;
    QBuffer buffer(&copy);
    QImageReader reader(&buffer);
    const QByteArray format = reader.format();
    const QSize size = reader.size();
    if ((format != "png" && format != "svg") || size.isEmpty()) {
        return {};
    }
    if (format == "svg" || std::max(size.width(), size.height()) > mostPixels) {
        reader.setScaledSize(size.scaled(mostPixels, mostPixels, Qt::KeepAspectRatio));
    }
    return reader.read();
}

} // namespace sparkout::report
