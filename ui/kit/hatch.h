// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

class QColor;
class QPainter;
class QRectF;

namespace sparkout {

/// Lines over a coloured area, by which it is told apart without colour, too.
enum class Hatch { none, rising, falling, level, crossed, upright, squared };

/// Of several areas side by side the one at an index: the first has none; they repeat.
[[nodiscard]] Hatch hatchAt(std::size_t index);

/// In single lines and not by a pattern of the brush, which has another size on paper and is no
/// vectors in SVG.
void paintHatch(QPainter& painter, const QRectF& area, Hatch hatch, const QColor& line);

} // namespace sparkout
