// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"
#include "ui/chart/painted_layer.h"

#include <vector>

namespace sparkout {

/// Draws the body of the part in a section through its axis, to scale: the steps of a shaft, or the
/// wall around a bore; and the centre line.
class ShaftLayer : public PaintedLayer {
    Q_OBJECT
public:
    explicit ShaftLayer(QCPAxisRect* rect);

    /// Without steps the shaft is its ground length.
    void setBody(std::vector<ShaftStep> steps, double length_mm, double radius_mm, bool bore);
    [[nodiscard]] QRectF bounds() const { return m_bounds; } ///< [mm], y upwards

protected:
    void draw(QCPPainter* painter) override;

private:
    [[nodiscard]] QRectF pixels(double from, double to, double low, double high) const;

    std::vector<ShaftStep> m_steps;
    double m_length_mm = 0;
    double m_radius_mm = 0;
    bool m_bore = false;
    QRectF m_bounds;
};

} // namespace sparkout
