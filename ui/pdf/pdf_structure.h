// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

class QPainter;

/// What the pages of a document show, as a tree in the order of reading: what a reader for the
/// blind goes by [ISO 32000-1, 14.7 and 14.8]. Qt 6.4 writes none, and its painter has no word for
/// where an element begins: a mark is painted there, far off the page, and what makes the tree
/// takes it out again (pdf_tags.h).
namespace sparkout {

class PdfStructure {
public:
    using Id = std::size_t;
    static constexpr Id artifact = 0;   ///< of no element: rules, grounds
    static constexpr Id pagination = 1; ///< of no element: what every page repeats
    static constexpr Id document = 2;   ///< the root

    struct Element {
        QByteArray type; ///< "H1", "P", "Table", "TR", "TH", "TD", "L", "Figure", …
        Id parent = document;
        QString alt = {}; ///< in words, of what is drawn
        int span = 1;     ///< columns that a cell takes
        /// Of a figure: from the top left corner of the paper [pt], once it is placed.
        std::optional<QRectF> box = {};
    };

    /// A new element, the last one of its parent.
    Id add(const Element& element) {
        m_elements.push_back(element);
        return document + m_elements.size();
    }
    /// By their numbers, from that of the root on.
    [[nodiscard]] const Element& at(Id id) const { return m_elements.at(id - document - 1); }
    [[nodiscard]] Id end() const { return document + 1 + m_elements.size(); }
    [[nodiscard]] bool isEmpty() const { return m_elements.empty(); }

    /// From the units of a page to points: what the boxes were given in.
    void placeBoxes(double scale, const QPointF& origin_pt);

    /// What is painted from here on is of the element.
    static void mark(QPainter& painter, Id id);
    /// The element of a mark that is met in a page: the rectangle's place.
    static std::optional<Id> marked(double x, double y);

private:
    std::vector<Element> m_elements;
};

} // namespace sparkout
