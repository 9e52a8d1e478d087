// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/free_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

constexpr int squareSide = 4;  ///< side of a grid square [px]
constexpr double far_px = 1e5; ///< a curve that leaves the plot is cut there

int squaresIn(double length) {
    return std::max(1, static_cast<int>(std::ceil(length / squareSide)));
}

/// The distance of a point from a rectangle.
double distanceOf(const QPointF& from, const QRectF& to) {
    return std::hypot(std::max({to.left() - from.x(), 0.0, from.x() - to.right()}),
                      std::max({to.top() - from.y(), 0.0, from.y() - to.bottom()}));
}

QPointF boundedBy(const QPointF& point) {
    return {std::clamp(point.x(), -far_px, far_px), std::clamp(point.y(), -far_px, far_px)};
}

/// Clips a line, as shares from 0 to 1, to values of one coordinate.
void clip(double from, double to, double low, double high, double& first, double& last) {
    const double length = to - from;
    if (length == 0) {
        last = from < low || from > high ? -1 : last;
        return;
    }
    const double toLow = (low - from) / length, toHigh = (high - from) / length;
    first = std::max(first, std::min(toLow, toHigh));
    last = std::min(last, std::max(toLow, toHigh));
}

} // namespace

FreePlace::FreePlace(const QRectF& within)
    : m_within(within.normalized()) // before the layout of a plot its area is negative
    , m_columns(squaresIn(m_within.width()))
    , m_rows(squaresIn(m_within.height()))
    , m_covered(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows)) {}

void FreePlace::cover(const QPointF& at) {
    if (!m_within.contains(at)) {
        return;
    }
    const int column = static_cast<int>((at.x() - m_within.left()) / squareSide);
    const int row = static_cast<int>((at.y() - m_within.top()) / squareSide);
    if (column < m_columns && row < m_rows) {
        m_covered[static_cast<std::size_t>(row * m_columns + column)] = 1;
    }
}

void FreePlace::addCurve(const QPolygonF& points) {
    for (qsizetype i = 0; i < points.size(); ++i) {
        const QPointF from = boundedBy(points[std::max<qsizetype>(i - 1, 0)]),
                      to = boundedBy(points[i]);
        double first = 0, last = 1;
        clip(from.x(), to.x(), m_within.left(), m_within.right(), first, last);
        clip(from.y(), to.y(), m_within.top(), m_within.bottom(), first, last);
        if (last < first || !std::isfinite(from.x() + from.y() + to.x() + to.y())) {
            continue;
        }
        const QPointF begin = from + (to - from) * first, whole = (to - from) * (last - first);
        const int steps = squaresIn(2 * std::max(std::abs(whole.x()), std::abs(whole.y())));
        for (int step = 0; step <= steps; ++step) {
            cover(begin + whole * (double(step) / steps));
        }
    }
}

void FreePlace::addSpot(const QRectF& spot) {
    for (double y = spot.top(); y <= spot.bottom(); y += squareSide / 2.0) {
        for (double x = spot.left(); x <= spot.right(); x += squareSide / 2.0) {
            cover({x, y});
        }
    }
}

int FreePlace::coveredIn(const QRectF& place) const {
    const auto at = [](double pixels, int most) {
        return std::clamp(static_cast<int>(pixels / squareSide), 0, most - 1);
    };
    const QRectF inside = place.translated(-m_within.topLeft());
    int count = 0;
    for (int row = at(inside.top(), m_rows); row <= at(inside.bottom(), m_rows); ++row) {
        for (int column = at(inside.left(), m_columns); column <= at(inside.right(), m_columns);
             ++column) {
            count += m_covered[static_cast<std::size_t>(row * m_columns + column)];
        }
    }
    return count;
}

std::vector<int> FreePlace::sums() const {
    const auto width = static_cast<std::size_t>(m_columns) + 1;
    std::vector<int> sums(width * (static_cast<std::size_t>(m_rows) + 1));
    for (std::size_t row = 1; row <= static_cast<std::size_t>(m_rows); ++row) {
        int line = 0;
        for (std::size_t column = 1; column < width; ++column) {
            line += m_covered[(row - 1) * (width - 1) + column - 1];
            sums[row * width + column] = sums[(row - 1) * width + column] + line;
        }
    }
    return sums;
}

FreePlace::Found FreePlace::nearest(const QSizeF& size, const QPointF& mark) const {
    const std::vector<int> sum = sums();
    const auto covered = [&](int left, int top, int right, int bottom) {
        const auto at = [&](int row, int column) {
            return sum[static_cast<std::size_t>(row * (m_columns + 1) + column)];
        };
        return at(bottom, right) - at(top, right) - at(bottom, left) + at(top, left);
    };
    const int wide = std::min(squaresIn(size.width()) + 1, m_columns);
    const int high = std::min(squaresIn(size.height()) + 1, m_rows);
    Found best{{m_within.topLeft(), size}, std::numeric_limits<int>::max(), 0};
    for (int row = 0; row + high <= m_rows; ++row) {
        for (int column = 0; column + wide <= m_columns; ++column) {
            const int count = covered(column, row, column + wide, row + high);
            const QRectF place(m_within.topLeft() + QPointF(column, row) * squareSide, size);
            const double away = distanceOf(mark, place);
            if (count < best.covered || (count == best.covered && away < best.away)) {
                best = {place, count, away};
            }
        }
    }
    return best;
}

} // namespace sparkout
