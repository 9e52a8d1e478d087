// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/painted_layer.h"
#include "ui/views/layers/surface_grid.h"

#include <vector>

namespace sparkout {

class LayersSurface;

/// Draws the surface of the layers in its box from back to front, with the scales of the box.
class SurfaceScene : public PaintedLayer {
    Q_OBJECT
public:
    explicit SurfaceScene(LayersSurface& surface);

protected:
    void draw(QCPPainter* painter) override;

private:
    struct Facet {
        QPolygonF corners;
        double nearness = 0;
        QColor colour, line;
        bool newest = false; ///< at the cursor
    };
    [[nodiscard]] std::vector<Facet> facets(const SurfaceGrid& grid) const;
    void drawFacets(QCPPainter& painter, const SurfaceGrid& grid) const;
    void drawBox(QCPPainter& painter, const SurfaceGrid& grid) const;
    /// @param along 0: length, 1: numbers, 2: feed
    void drawScale(QCPPainter& painter, const SurfaceScale& scale, int along) const;

    LayersSurface& m_surface;
};

} // namespace sparkout
