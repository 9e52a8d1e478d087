// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QSizeF>

#include <vector>

namespace sparkout {

/// Finds a place for a call-out that covers as little of the plot as possible. All lengths in
/// pixels.
class FreePlace {
public:
    struct Found {
        QRectF place;
        int covered = 0; ///< number of covered squares; 0: it is free
        double away = 0; ///< distance of the mark from its nearest point
    };

    explicit FreePlace(const QRectF& within);
    void addCurve(const QPolygonF& points); ///< the line through them
    void addSpot(const QRectF& spot);       ///< covers the area of a point mark
    /// Small squares of a place that something runs through.
    [[nodiscard]] int coveredIn(const QRectF& place) const;
    /// The free place of a size nearest to a mark; if none is free, the one that covers the least.
    [[nodiscard]] Found nearest(const QSizeF& size, const QPointF& mark) const;

private:
    void cover(const QPointF& at);
    [[nodiscard]] std::vector<int> sums() const; ///< covered squares above and left of each corner

    QRectF m_within;
    int m_columns, m_rows;
    std::vector<char> m_covered; ///< squares, row by row
};

} // namespace sparkout
