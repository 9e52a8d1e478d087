// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/quantity_colour.h"

#include <QPen>

/// One dash and weight for each curve, beside its colour, so that curves of one plot are told apart
/// in black and white print, too.
namespace sparkout::style {

/// Solid and of the usual weight where nothing else stands beside it.
[[nodiscard]] QPen line(Drawn what, const QColor& colour);
/// Of the limits of a depth of cut, in their order; those beyond look like the last.
[[nodiscard]] QPen lineOfDepthLimit(std::size_t index, const QColor& colour);

} // namespace sparkout::style
