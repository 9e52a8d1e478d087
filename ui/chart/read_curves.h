// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QCPGraph;

/// Curves that the two cursors of a plot can read.
namespace sparkout {

/// The number format of a curve's values, that of the view.
enum class Digits { hundredths, signedHundredths, thousandths, tenThousandths, significant };

/// A readable curve. Curves of one name share a row of the cursors' table, those of one group a
/// column.
struct ReadCurve {
    QString group; ///< zone, section or run; empty if there is only one
    QString name;  ///< with the unit
    Digits digits = Digits::hundredths;
    std::function<std::optional<double>(double x)> at; ///< empty: not drawn there
};
using ReadCurves = std::vector<ReadCurve>;

/// The value of a line at a place, interpolated along a straight line on its axes; at a step, the
/// value after it.
[[nodiscard]] std::optional<double> valueAt(const std::vector<XY>& line, double x,
                                            bool isLogarithmic = false);
/// If a path passes a place more than once, its last value there.
[[nodiscard]] std::optional<double> lastValueAt(const std::vector<XY>& path, double x,
                                                bool isLogarithmic = false);
/// The value of a drawn graph, interpolated along a straight line on its axes.
[[nodiscard]] std::optional<double> valueAt(const QCPGraph& graph, double x);

[[nodiscard]] QString stated(double value, Digits digits);
/// A signed difference with the decimals of its operands.
[[nodiscard]] QString statedDifference(double value, Digits digits, double beside);

/// A place on the axis with the digits that a double has safely.
[[nodiscard]] double plainPlace(double x);
[[nodiscard]] QString statedPlace(double x);

} // namespace sparkout
