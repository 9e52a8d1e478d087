// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/painted_layer.h"

namespace sparkout {

class SidePlot;

/// Paints the wheel, the deflected part, its tolerance and the gauge of a SidePlot.
class SideScene : public PaintedLayer {
    Q_OBJECT
public:
    explicit SideScene(SidePlot& plot);

protected:
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    [[nodiscard]] double yOf(double radius_mm) const; ///< [px]
    [[nodiscard]] double xOf(double length_mm) const; ///< [px]
    void drawField(QCPPainter& painter) const;
    void drawBody(QCPPainter& painter) const;
    void drawWheel(QCPPainter& painter) const;
    void drawYield(QCPPainter& painter) const;
    void drawGauge(QCPPainter& painter) const;

    SidePlot& m_plot;
};

} // namespace sparkout
