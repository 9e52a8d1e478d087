// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

class QPDF;

namespace sparkout {

/// A file attached to a PDF [ISO 32000-1, 7.11.4].
struct PdfAttachment {
    QString name; ///< "shaft.sparkout"
    QByteArray data;
    QString description; ///< shown by readers beside the name
};

/// Throws the exceptions of libqpdf.
void putAttachment(QPDF& document, const PdfAttachment& attachment);

/// The first attachment of a PDF whose name has this suffix; empty if there is none, if it is
/// longer than `mostBytes`, or if the file is not a PDF.
[[nodiscard]] std::optional<PdfAttachment> attachmentOf(const QByteArray& pdf,
                                                        const QString& ending, qsizetype mostBytes);

} // namespace sparkout
