// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <optional>

namespace sparkout {

/// A vertical line at one value of the horizontal axes, through every axis rect of a plot whose
/// range holds it. It has a layer of its own, so that following the mouse redraws no curve.
class HairLine : public QCPLayerable {
    Q_OBJECT
public:
    explicit HairLine(QCustomPlot& plot);

    void setAt(std::optional<double> x); ///< draws at once; nothing: no line
    [[nodiscard]] std::optional<double> at() const { return m_x; }

    static QString layerName() { return QStringLiteral("hairline"); }

protected:
    void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
    [[nodiscard]] QRect clipRect() const override;
    void draw(QCPPainter* painter) override;

private:
    std::optional<double> m_x;
};

} // namespace sparkout
