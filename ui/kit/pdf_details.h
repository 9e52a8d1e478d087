// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDate>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

class QPainter;
class QPDF;

/// Details that a PDF by Qt lacks: an outline, tags, attachments, and the author and the subject
/// among its properties.

namespace sparkout {

/// The contents of a document's pages as a tree in reading order, used by screen readers [ISO
/// 32000-1, 14.7 and 14.8]. Qt 6.4 writes none, and its painter cannot mark the beginning of an
/// element: a mark is painted far off the page instead, and removed when the tree is made.
class PdfStructure {
public:
    using Id = std::size_t;
    static constexpr Id artifact = 0;   ///< not part of an element: rules, backgrounds
    static constexpr Id pagination = 1; ///< not part of an element: repeated on every page
    static constexpr Id document = 2;   ///< the root

    struct Element {
        QByteArray type; ///< "H1", "P", "Table", "TR", "TH", "TD", "L", "Figure", …
        Id parent = document;
        QString alt = {}; ///< alternative text of a drawing
        int span = 1;     ///< number of columns of a cell
        /// For a figure: from the top left corner of the paper [pt], once placed.
        std::optional<QRectF> box = {};
    };

    /// Adds an element as the last one of its parent.
    Id add(const Element& element) {
        m_elements.push_back(element);
        return document + m_elements.size();
    }
    /// The element with this number; the root has the lowest.
    [[nodiscard]] const Element& at(Id id) const { return m_elements.at(id - document - 1); }
    [[nodiscard]] Id end() const { return document + 1 + m_elements.size(); }
    [[nodiscard]] bool isEmpty() const { return m_elements.empty(); }

    /// Converts the boxes from the units of a page to points.
    void placeBoxes(double scale, const QPointF& origin_pt);

    /// Assigns everything painted from here on to the element.
    static void mark(QPainter& painter, Id id);
    /// The element of a mark that is met in a page: the rectangle's place.
    static std::optional<Id> marked(double x, double y);

private:
    std::vector<Element> m_elements;
};

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
