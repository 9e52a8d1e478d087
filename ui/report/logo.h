// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QCoreApplication>
#include <QImage>
#include <QString>

namespace sparkout::report {

/// The picture in the heads of documents: the bytes of a PNG or JPEG file. Other formats are not
/// decoded: a drawing may refer to other files, and a few bytes of it may take hours to draw.
class Logo {
    Q_DECLARE_TR_FUNCTIONS(Logo)

public:
    static constexpr qsizetype mostBytes = 1 << 20;
    static constexpr int mostSide = 4096; ///< in pixels

    /// The reason for refusing bytes as a logo, a sentence; empty for a valid or missing logo. It
    /// checks the kind and the declared size without decoding.
    [[nodiscard]] static QString fault(const QByteArray& bytes);

    /// The picture for paper; null if it is missing, refused or damaged.
    [[nodiscard]] static QImage image(const QByteArray& bytes);

    [[nodiscard]] static QString damagedText(); ///< for a picture that cannot be decoded
};

} // namespace sparkout::report
