// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/levenberg_marquardt.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace sparkout {

/// A measurement that would tell what the data do not.
enum class Advice {
    power,         ///< the wheel's power over the same cycle
    force,         ///< the normal force over the same cycle
    size,          ///< the size over the time of a cycle
    another_feed,  ///< a stage at another feed, or a spark-out, so that the deflection shows
    idle,          ///< the power before the wheel touches
    place_sizes,   ///< sizes in these zones or sections
    cycle_start,   ///< a trace that has the beginning of the cut
    several_parts, ///< the same of further parts
    count_
};

/// Parameters that the data cannot tell, or not from each other.
struct Unidentified {
    std::vector<std::size_t> parameters; ///< by their numbers; one alone, or some together
    Advice advice = Advice::several_parts;
    bool isProduct = false; ///< two factors, whose product alone is told
};

/// How well the data determine the parameters, at the best fit.
struct Identifiability {
    double condition = 1;           ///< of the derivatives, each column by its length
    std::vector<double> covariance; ///< of the coordinates, row by row; of noise 1
    std::vector<Unidentified> unidentified;
    std::vector<double> columns; ///< the derivatives of the residuals by the coordinates
};

/// The criterion rises by so much at the end of an interval of 95 % and more (2²): a parameter
/// along which it stays below over the whole plausible range is not told by the data.
inline constexpr double flatRise = 4;
/// Beyond it the derivatives depend on each other but for rounding.
inline constexpr double mostCondition = 1e7;

/// Whether the criterion stays within `flatRise` over so much of a coordinate, the others fitted.
using FlatOver = std::function<bool(std::size_t parameter, double range)>;

/// Of the derivatives of the residuals by the coordinates, a column each; only a parameter whose
/// interval is as wide as its plausible range is asked for.
[[nodiscard]] Identifiability identifiabilityOf(std::span<const double> columns, std::size_t rows,
                                                const std::vector<FittedParameter>& list,
                                                const FitData& data, const FlatOver& isFlat);

[[nodiscard]] Identifiability identifiabilityAt(FitProblem& problem, const FitData& data,
                                                const LeastSquares& best);

} // namespace sparkout
