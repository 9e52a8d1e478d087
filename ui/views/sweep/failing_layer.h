// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/painted_layer.h"

#include <utility>
#include <vector>

namespace sparkout {

/// Draws the failing ranges of the horizontal axis: hatched over the height of an axis rect, so
/// that they are visible without colour, too, and at least as wide as a line.
class FailingLayer : public PaintedLayer {
    Q_OBJECT
public:
    explicit FailingLayer(QCPAxisRect& rect);

    void setRanges(std::vector<QCPRange> ranges) { m_ranges = std::move(ranges); }
    [[nodiscard]] const std::vector<QCPRange>& ranges() const { return m_ranges; }
    void setColour(const QColor& colour) { m_colour = colour; } ///< colour of the lines
    [[nodiscard]] QColor area() const; ///< colour of the area behind the lines
    [[nodiscard]] const QColor& colour() const { return m_colour; }

protected:
    void draw(QCPPainter* painter) override;

private:
    std::vector<QCPRange> m_ranges;
    QColor m_colour;
};

} // namespace sparkout
