// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace sparkout {

/// A painting on a layer of a plot, besides its curves: anywhere in the plot, or within an axis
/// rect.
class PaintedLayer : public QCPLayerable {
protected:
    enum class Edges { sharp, smooth };

    PaintedLayer(QCustomPlot& plot, const QString& layer, Edges edges)
        : QCPLayerable(&plot, layer), m_edges(edges) {}
    PaintedLayer(QCPAxisRect& rect, const QString& layer, Edges edges)
        : QCPLayerable(rect.parentPlot(), layer), m_rect(&rect), m_edges(edges) {}

    void applyDefaultAntialiasingHint(QCPPainter* painter) const override {
        painter->setAntialiasing(m_edges == Edges::smooth);
    }
    [[nodiscard]] QRect clipRect() const override {
        return m_rect ? m_rect->rect() : QCPLayerable::clipRect();
    }

    QCPAxisRect* m_rect = nullptr; ///< null: the whole plot

private:
    Edges m_edges;
};

} // namespace sparkout
