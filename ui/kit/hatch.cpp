// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/hatch.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace sparkout {

namespace {

constexpr double hatchSpacing = 6; ///< distance of the lines along the axes
constexpr double hatchWidth = 1.2;
constexpr std::array hatchOrder{Hatch::none,    Hatch::rising,  Hatch::falling, Hatch::level,
                                Hatch::crossed, Hatch::upright, Hatch::squared};

/// Draws lines x + y = c or x − y = c, one through the origin, so that the hatching of adjacent
/// areas matches.
void paintSlanting(QPainter& painter, const QRectF& area, bool rising) {
    const double sign = rising ? 1 : -1; // y grows downwards
    const double low = std::min(area.top() * sign, area.bottom() * sign) + area.left();
    const double high = std::max(area.top() * sign, area.bottom() * sign) + area.right();
    for (double c = std::ceil(low / hatchSpacing) * hatchSpacing; c <= high; c += hatchSpacing) {
        const double atTop = c - sign * area.top(), atBottom = c - sign * area.bottom();
        const double from = std::max(area.left(), std::min(atTop, atBottom));
        const double to = std::min(area.right(), std::max(atTop, atBottom));
        if (from < to) {
            painter.drawLine(QLineF(from, sign * (c - from), to, sign * (c - to)));
        }
    }
}

void paintStraight(QPainter& painter, const QRectF& area, bool level) {
    const double low = level ? area.top() : area.left(),
                 high = low + (level ? area.height() : area.width());
    for (double at = std::ceil(low / hatchSpacing) * hatchSpacing; at < high; at += hatchSpacing) {
        painter.drawLine(level ? QLineF(area.left(), at, area.right(), at)
                               : QLineF(at, area.top(), at, area.bottom()));
    }
}

} // namespace

Hatch hatchAt(std::size_t index) {
    return hatchOrder[index % hatchOrder.size()];
}

void paintHatch(QPainter& painter, const QRectF& area, Hatch hatch, const QColor& line) {
    if (hatch == Hatch::none || area.isEmpty()) {
        return;
    }
    painter.save();
    painter.setPen(QPen(line, hatchWidth, Qt::SolidLine, Qt::FlatCap));
    if (hatch == Hatch::rising || hatch == Hatch::crossed) {
        paintSlanting(painter, area, true);
    }
    if (hatch == Hatch::falling || hatch == Hatch::crossed) {
        paintSlanting(painter, area, false);
    }
    if (hatch == Hatch::level || hatch == Hatch::squared) {
        paintStraight(painter, area, true);
    }
    if (hatch == Hatch::upright || hatch == Hatch::squared) {
        paintStraight(painter, area, false);
    }
    painter.restore();
}

} // namespace sparkout
