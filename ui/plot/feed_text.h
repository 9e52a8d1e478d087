// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/read_curves.h"

#include <QString>

namespace sparkout {

/// What a curve of the view is called in its legend.
[[nodiscard]] QString quantityName(Quantity quantity);

/// The same with its unit: "actual feed, µm".
[[nodiscard]] QString quantityWithUnit(Quantity quantity);

/// How its values are stated.
[[nodiscard]] Digits quantityDigits(Quantity quantity);

/// The values at a time as two lines of plain text: where in the cycle, and the numbers. Empty when
/// the zone has no point there.
[[nodiscard]] QString feedText(const FeedPoints& points, double time_s, const FeedSeries& series,
                               bool wholeStrokes);

} // namespace sparkout
