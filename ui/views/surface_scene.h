// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <vector>

namespace sparkout {

class LayersSurface;

/// Paints the surface of the layers, from the back to the front, and the box with its numbers.
class SurfaceScene : public QCPLayerable {
    Q_OBJECT
public:
    explicit SurfaceScene(LayersSurface& surface);

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    /// A piece of the surface.
    struct Facet {
        QPolygonF corners;
        double nearness = 0;
        QColor colour;
        bool edge = false; ///< where the cursor stands
    };
    [[nodiscard]] std::vector<Facet> facets() const;
    void drawBox(QCPPainter& painter) const;
    void drawScale(QCPPainter& painter, int along) const; ///< 0: length, 1: numbers, 2: feed

    LayersSurface& m_surface;
};

} // namespace sparkout
