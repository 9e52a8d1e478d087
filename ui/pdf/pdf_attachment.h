// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

class QPDF;

namespace sparkout {

/// A file that a PDF carries with it [ISO 32000-1, 7.11.4].
struct PdfAttachment {
    QString name; ///< "shaft.sparkout"
    QByteArray data;
    QString description; ///< what readers say beside the name
};

/// Throws what libqpdf throws.
void putAttachment(QPDF& document, const PdfAttachment& attachment);

/// The first attachment of a PDF whose name ends so; nothing where there is none, where it is
/// longer than `mostBytes`, and where the file is no PDF.
[[nodiscard]] std::optional<PdfAttachment> attachmentOf(const QByteArray& pdf,
                                                        const QString& ending, qsizetype mostBytes);

} // namespace sparkout
