// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/fit_problem.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace sparkout {

/// A measurement that would determine the undetermined parameters.
enum class Advice {
    power,         ///< the wheel's power over the same cycle
    force,         ///< the normal force over the same cycle
    size,          ///< the size over the time of a cycle
    another_feed,  ///< a stage at another feed, or a spark-out, to show the deflection
    idle,          ///< the power before the wheel touches
    place_sizes,   ///< sizes in these zones or sections
    cycle_start,   ///< a trace with the beginning of the cut
    several_parts, ///< the same data for further parts
    count_
};

/// Parameters that the data leave undetermined, alone or relative to each other.
struct Unidentified {
    std::vector<std::size_t> parameters; ///< indices; one alone, or several together
    Advice advice = Advice::several_parts;
    bool isProduct = false; ///< two factors of which only the product is determined
};

/// How well the data determine the parameters at the best fit.
struct Identifiability {
    double condition = 1;           ///< of the derivatives with normalised columns
    std::vector<double> covariance; ///< covariance of the coordinates, row by row, for noise 1
    std::vector<Unidentified> unidentified;
    std::vector<double> columns; ///< derivatives of the residuals by the coordinates
};

/// The rise of the criterion at the end of an interval of slightly more than 95 % (2²): a parameter
/// with a smaller rise over its whole plausible range is undetermined.
inline constexpr double flatRise = 4;
/// Above it the derivatives are linearly dependent up to rounding.
inline constexpr double mostCondition = 1e7;

/// Whether the criterion stays within `flatRise` over a range of a coordinate, with the others
/// fitted.
using FlatOver = std::function<bool(std::size_t parameter, double range)>;

/// Uses the derivatives of the residuals by the coordinates, a column each; calls `flat` only for a
/// parameter whose interval is as wide as its plausible range.
[[nodiscard]] Identifiability identifiabilityOf(std::span<const double> columns, std::size_t rows,
                                                const std::vector<FittedParameter>& list,
                                                const FitData& data, const FlatOver& isFlat);

[[nodiscard]] Identifiability identifiabilityAt(FitProblem& problem, const FitData& data,
                                                const LeastSquares& best);

} // namespace sparkout
