// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/painted_layer.h"

#include <optional>

namespace sparkout {

/// A vertical line at one value of the horizontal axes, through every axis rect of a plot whose
/// range contains it: under the mouse, or at the moment of the cycle that the views share. On its
/// own layer, so that moving it redraws no curve.
class HairLine : public PaintedLayer {
    Q_OBJECT
public:
    enum class Role { mouse, moment };
    explicit HairLine(QCustomPlot& plot, Role role = Role::mouse);

    void setAt(std::optional<double> x); ///< draws at once; empty: no line
    [[nodiscard]] std::optional<double> at() const { return m_x; }
    [[nodiscard]] Role role() const { return m_role; }

    static QString layerName() { return QStringLiteral("hairline"); }

protected:
    void draw(QCPPainter* painter) override;

private:
    Role m_role;
    std::optional<double> m_x;
};

} // namespace sparkout
