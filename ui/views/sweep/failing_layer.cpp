// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/failing_layer.h"

#include "ui/kit/hatch.h"

#include <algorithm>

namespace sparkout {

namespace {

constexpr float areaOpacity = 0.15F; ///< relative to the colour's opacity

} // namespace

FailingLayer::FailingLayer(QCPAxisRect& rect)
    : PaintedLayer(rect, QStringLiteral("bands"), Edges::smooth) {}

QColor FailingLayer::area() const {
    QColor area = m_colour;
    area.setAlphaF(area.alphaF() * areaOpacity);
    return area;
}

void FailingLayer::draw(QCPPainter* painter) {
    const QCPAxis* const axis = m_rect->axis(QCPAxis::atBottom);
    const QRectF all = m_rect->rect();
    for (const QCPRange& range : m_ranges) {
        const double from = std::max(axis->coordToPixel(range.lower), all.left() - 1);
        const double to = std::min(axis->coordToPixel(range.upper), all.right() + 1);
        if (to < from) {
            continue;
        }
        const QRectF box(from, all.top(), to - from, all.height());
        painter->setPen(Qt::NoPen);
        painter->setBrush(area());
        painter->drawRect(box);
        paintHatch(*painter, box, Hatch::rising, m_colour);
        painter->setPen(QPen(m_colour, 1));
        painter->drawLine(QLineF(from, all.top(), from, all.bottom()));
        painter->drawLine(QLineF(to, all.top(), to, all.bottom()));
    }
}

} // namespace sparkout
