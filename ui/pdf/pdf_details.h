// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pdf/pdf_structure.h"

#include <QByteArray>
#include <QDate>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QPDF;

/// Details that a PDF by Qt lacks: an outline, tags, attachments, and the author and the subject
/// among its properties.
namespace sparkout {

/// A file attached to a PDF [ISO 32000-1, 7.11.4].
struct PdfAttachment {
    QString name; ///< "shaft.sparkout"
    QByteArray data;
    QString description; ///< shown by readers beside the name
};

/// The text of a project as a file of its name; without a name as project.sparkout.
[[nodiscard]] PdfAttachment projectAttachment(const QString& name, const QByteArray& text);

/// Throws the exceptions of libqpdf.
void putAttachment(QPDF& document, const PdfAttachment& attachment);

/// The first attachment of a PDF whose name has this suffix; empty if there is none, if it is
/// longer than `mostBytes`, or if the file is not a PDF.
[[nodiscard]] std::optional<PdfAttachment> attachmentOf(const QByteArray& pdf,
                                                        const QString& ending, qsizetype mostBytes);

/// An entry of the outline.
struct Bookmark {
    QString text;
    int page = 0;    ///< counted from 0
    double y_pt = 0; ///< from the top edge of the paper
};

struct PdfDetails {
    QString title, author, subject, creator; ///< empty ones are left out
    QString language;                        ///< language of the whole document: "ru"
    QDate date;
    std::vector<Bookmark> outline; ///< in the order of the pages
    PdfStructure structure = {};   ///< its marks are painted; empty: the document is not tagged
    std::optional<PdfAttachment> attachment = {};
};

/// The document with its details; equal details give equal bytes. Empty if `pdf` is not a complete
/// document, or if `goesOn`, called for each page, returns false.
[[nodiscard]] QByteArray withDetails(const QByteArray& pdf, const PdfDetails& details,
                                     const std::function<bool()>& goesOn = {});

} // namespace sparkout
