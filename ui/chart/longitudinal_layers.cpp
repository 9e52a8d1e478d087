// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/longitudinal_layers.h"

#include "ui/chart/view_plot.h"

#include <algorithm>

namespace sparkout {

namespace {
constexpr double wall = 1.35;     ///< outer radius of the wall around a bore, in bore radii
constexpr double overhang = 1.03; ///< of the centre line
} // namespace

ShaftLayer::ShaftLayer(QCPAxisRect* rect)
    : PaintedLayer(*rect, QStringLiteral("bands"), Edges::sharp) {}

void ShaftLayer::setBody(std::vector<ShaftStep> steps, double length_mm, double radius_mm,
                         bool bore) {
    m_steps = std::move(steps);
    m_length_mm = length_mm;
    m_radius_mm = radius_mm;
    m_bore = bore;
    if (m_steps.empty() && !bore) {
        m_steps = {{0, length_mm, radius_mm}};
    }
    double from = 0, to = length_mm, high = radius_mm * (bore ? wall : 1);
    for (const ShaftStep& step : m_steps) {
        from = std::min(from, step.from_mm);
        to = std::max(to, step.to_mm);
        high = std::max(high, step.radius_mm);
    }
    m_bounds = QRectF(from, -high, to - from, 2 * high);
}

QRectF ShaftLayer::pixels(double from, double to, double low, double high) const {
    const QCPAxis* x = m_rect->axis(QCPAxis::atBottom);
    const QCPAxis* y = m_rect->axis(QCPAxis::atLeft);
    return {QPointF(x->coordToPixel(from), y->coordToPixel(high)),
            QPointF(x->coordToPixel(to), y->coordToPixel(low))};
}

void ShaftLayer::draw(QCPPainter* painter) {
    const QColor text = mParentPlot->palette().color(QPalette::Text);
    const QColor body = style::thinned(text, 30);
    const QColor edge = style::thinned(text, 150);
    painter->setPen(QPen(edge, 1));
    if (m_bore) {
        QBrush hatch(edge, Qt::BDiagPattern);
        for (const double side : {1.0, -1.0}) {
            const double a = side * m_radius_mm, b = side * m_radius_mm * wall;
            const QRectF rect = pixels(0, m_length_mm, std::min(a, b), std::max(a, b));
            painter->fillRect(rect, body);
            painter->fillRect(rect, hatch);
        }
    }
    painter->setBrush(body);
    for (const ShaftStep& step : m_steps) {
        painter->drawRect(pixels(step.from_mm, step.to_mm, -step.radius_mm, step.radius_mm));
    }
    QPen axis(edge, 1, Qt::DashDotLine);
    painter->setPen(axis);
    const double more = m_bounds.width() * (overhang - 1);
    const QRectF line = pixels(m_bounds.left() - more, m_bounds.right() + more, 0, 0);
    painter->drawLine(line.topLeft(), line.topRight());
}

} // namespace sparkout
