// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

class QColor;
class QPainter;
class QRectF;

namespace sparkout {

/// A hatching that distinguishes coloured areas without colour.
enum class Hatch { none, rising, falling, level, crossed, upright, squared };

/// The hatching of one of several adjacent areas, by index: the first has none; they repeat.
[[nodiscard]] Hatch hatchAt(std::size_t index);

/// Draws single lines instead of a brush pattern, which would have another size on paper and not be
/// vectors in SVG.
void paintHatch(QPainter& painter, const QRectF& area, Hatch hatch, const QColor& line);

} // namespace sparkout
