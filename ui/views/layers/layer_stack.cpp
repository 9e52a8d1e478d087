// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layer_stack.h"

#include "core/units.h"
#include "ui/plot/plot_style.h"
#include "ui/views/layers/layers_look.h"
#include "ui/views/layers/layers_plot.h"

#include <algorithm>

namespace sparkout {

namespace {
constexpr int bodyAlpha = 30, edgeAlpha = 150;
constexpr double outlined = 4; ///< layers lower than this have no outline [px]
} // namespace

LayerStack::LayerStack(LayersPlot& plot)
    : PaintedLayer(plot.cell(), QStringLiteral("bands"), Edges::sharp), m_plot(plot) {}

QRect LayerStack::clipRect() const {
    return m_plot.painted();
}

void LayerStack::draw(QCPPainter* painter) {
    if (m_plot.series().columns.empty()) {
        return;
    }
    drawMetal(*painter);
    drawLayers(*painter);
    m_plot.drawPartAxis(*painter);
}

/// Draws the finished part, and the stock still to be removed.
void LayerStack::drawMetal(QCPPainter& painter) const {
    const LayerSeries& series = m_plot.series();
    const QPalette palette = mParentPlot->palette();
    const QCPAxis* const x = m_rect->axis(QCPAxis::atBottom);
    const QCPAxis* const y = m_rect->axis(QCPAxis::atLeft);
    const bool bore = series.removalSign < 0;
    const auto pixel = [&](double radius_mm) {
        return y->coordToPixel((radius_mm - series.target_mm) * units::umPerMm);
    };
    for (std::size_t j = 0; j < series.columns.size(); ++j) {
        const LayerColumn& column = series.columns[j];
        const double left = x->coordToPixel(column.stretch.from_mm);
        const double right = x->coordToPixel(column.stretch.to_mm);
        const auto fill = [&](double from, double to, const QColor& colour) {
            painter.fillRect(
                QRectF(QPointF(left, std::min(from, to)), QPointF(right, std::max(from, to))),
                colour);
        };
        const double last = pixel(series.radiusAfter_mm(column, series.spans.size()));
        const double foot = bore ? m_rect->top() : m_rect->bottom() + 1.0;
        if (bore ? last > foot : last < foot) {
            fill(last, foot, style::thinned(palette.color(QPalette::Text), bodyAlpha));
        }
        fill(pixel(m_plot.radiusAfter_mm(j, m_plot.done().count)), last,
             LayersLook::uncut(palette));
    }
}

void LayerStack::drawLayers(QCPPainter& painter) const {
    const LayerSeries& series = m_plot.series();
    const QPalette palette = mParentPlot->palette();
    const std::size_t done = m_plot.done().count;
    const QPen edge(style::thinned(palette.color(QPalette::Text), edgeAlpha), 0);
    const QPen newestEdge(style::thinned(palette.color(QPalette::Text), 255), 2);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < done; ++i) {
        const QColor colour =
            style::dimmed(LayersLook::layer(series, i, palette), m_plot.isDimmed());
        const bool newest = i + 1 == done && i + 1 < series.spans.size();
        painter.setPen(newest ? newestEdge : edge);
        for (std::size_t j = 0; j < series.columns.size(); ++j) {
            const QRectF rect = m_plot.layerRect(j, i);
            if (rect.isEmpty()) {
                continue;
            }
            painter.fillRect(rect, colour);
            if (newest || rect.height() >= outlined) {
                painter.drawRect(rect);
            }
        }
    }
}

} // namespace sparkout
