// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/painted_layer.h"

namespace sparkout {

class LayersPlot;

/// Paints the layers of a LayersPlot, the metal below them, and the axis of rotation.
class LayerStack : public PaintedLayer {
    Q_OBJECT
public:
    explicit LayerStack(LayersPlot& plot);

protected:
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    void drawMetal(QCPPainter& painter) const;
    void drawLayers(QCPPainter& painter) const;

    const LayersPlot& m_plot;
};

} // namespace sparkout
