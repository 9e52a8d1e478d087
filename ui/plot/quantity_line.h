// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/quantity_colour.h"

#include <QPen>

/// A dash pattern and width for each curve in addition to its colour, so that curves differ in
/// black and white print, too.
namespace sparkout::style {

/// A solid line of the usual width for a curve without neighbours.
[[nodiscard]] QPen line(Drawn what, const QColor& colour);
/// The line of a limit of the depth of cut, by its order; later ones repeat the last.
[[nodiscard]] QPen lineOfDepthLimit(std::size_t index, const QColor& colour);

} // namespace sparkout::style
