// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

class QPainter;

/// The contents of a document's pages as a tree in reading order, used by screen readers [ISO
/// 32000-1, 14.7 and 14.8]. Qt 6.4 writes none, and its painter cannot mark the beginning of an
/// element: a mark is painted far off the page instead, and removed when the tree is made
/// (pdf_details.cpp).
namespace sparkout {

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

} // namespace sparkout
