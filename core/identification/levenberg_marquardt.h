// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_problem.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// Where the sum of the squared residuals of a problem is least, by Levenberg's and Marquardt's
/// method of Eigen's NonLinearOptimization (MINPACK).
struct LeastSquares {
    std::vector<double> q;
    double criterion = 0; ///< sum of the squares
    bool converged = false;
    int evaluations = 0;
};

/// How far a search of the least squares goes: to the last digits, or until it is known which of
/// several is the best.
enum class SearchEffort { whole, rough };

/// From a start; coordinates that are `fixed` stay. A stop of the problem ends it where it is.
[[nodiscard]] LeastSquares minimise(FitProblem& problem, const std::vector<double>& start,
                                    const std::vector<bool>& fixed,
                                    SearchEffort effort = SearchEffort::whole);

/// Derivatives of the residuals by the coordinates, by central differences: a column each, one
/// behind the other. False: the cycle cannot be run beside q.
bool derivatives(FitProblem& problem, const std::vector<double>& q,
                 const std::vector<std::size_t>& free, std::vector<double>& columns);

} // namespace sparkout
