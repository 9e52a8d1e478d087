// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/read_curves.h"

#include <QString>

namespace sparkout {

enum class StrokeStep;

/// "E3/E1/E1 working stroke": a step of a double stroke with its code in each of the zones ground
/// in it; empty if it has none.
[[nodiscard]] QString strokeStepName(StrokeStep step);

/// The name of a curve in the legend.
[[nodiscard]] QString quantityName(Quantity quantity);

/// The name with the unit: "actual feed, µm".
[[nodiscard]] QString quantityWithUnit(Quantity quantity);

/// The number format of its values.
[[nodiscard]] Digits quantityDigits(Quantity quantity);

/// The values at a time as two lines of plain text: the place in the cycle, and the numbers. Empty
/// if the zone has no point there.
[[nodiscard]] QString feedText(const FeedPoints& points, double time_s, const FeedSeries& series,
                               bool wholeStrokes);

} // namespace sparkout
