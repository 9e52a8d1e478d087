// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/feed_curves.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QCPCurve;
class QCPGraph;

/// Curves as the two cursors of a plot read them: the value of what is drawn at a place.
namespace sparkout {

/// How the numbers of a curve are stated: as the view states its others.
enum class Digits { hundredths, signedHundredths, thousandths, tenThousandths, significant };

/// A curve that can be read. Curves of one name stand in one row of the cursors' table, those of
/// one group in its columns.
struct ReadCurve {
    QString group; ///< zone, section or run; empty: there is but one
    QString name;  ///< with its unit
    Digits digits = Digits::hundredths;
    std::function<std::optional<double>(double x)> at; ///< nothing: not drawn there
};
using ReadCurves = std::vector<ReadCurve>;

/// The value of a line at a place; where it steps, the value it steps to.
[[nodiscard]] std::optional<double> valueAt(const std::vector<XY>& line, double x);
/// The same of what is drawn, straight from point to point on the axis it is drawn on.
[[nodiscard]] std::optional<double> valueAt(const QCPGraph& graph, double x);
/// Where a curve passes a place more than once, its last value there.
[[nodiscard]] std::optional<double> valueAt(const QCPCurve& curve, double x);

[[nodiscard]] QString stated(double value, Digits digits);
/// With its sign; as far as the value it is a difference of is stated.
[[nodiscard]] QString statedDifference(double value, Digits digits, double beside);

/// A place on the axis with no more digits than a double holds for sure.
[[nodiscard]] double plainPlace(double x);
[[nodiscard]] QString statedPlace(double x);

} // namespace sparkout
