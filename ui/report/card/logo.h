// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QCoreApplication>
#include <QImage>
#include <QString>

namespace sparkout::report {

/// The picture in the heads of documents: the bytes of a PNG or JPEG file. Nothing else is given to
/// a decoder: a drawing may name other files, and small bytes of it may take hours to draw.
class Logo {
    Q_DECLARE_TR_FUNCTIONS(Logo)

public:
    static constexpr qsizetype mostBytes = 1 << 20;
    static constexpr int mostSide = 4096; ///< in pixels

    /// Why bytes are refused as a logo, a sentence; empty: they are one, or there are none. It
    /// looks at kind and declared size alone and decodes nothing.
    [[nodiscard]] static QString fault(const QByteArray& bytes);

    /// The picture for paper; null: there is none, it is refused, or it is damaged.
    [[nodiscard]] static QImage image(const QByteArray& bytes);

    [[nodiscard]] static QString damagedText(); ///< of one whose picture cannot be decoded
};

} // namespace sparkout::report
