// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/read_curves.h"

#include <QString>

namespace sparkout {

enum class StrokeStep;

/// "E3/E1/E1 working stroke": a step of a double stroke with its code in each of the zones that are
/// ground in it; empty where it has none.
[[nodiscard]] QString strokeStepName(StrokeStep step);

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
