// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pdf/pdf_attachment.h"
#include "ui/pdf/pdf_structure.h"

#include <QByteArray>
#include <QDate>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

/// Details that a PDF by Qt lacks: an outline, tags, and the author and the subject among its
/// properties.
namespace sparkout {

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
