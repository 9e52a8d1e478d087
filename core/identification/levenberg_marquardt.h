// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_problem.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// The minimum of a problem's sum of squared residuals, by the Levenberg–Marquardt method of
/// Eigen's NonLinearOptimization (MINPACK).
struct LeastSquares {
    std::vector<double> q;
    double criterion = 0; ///< sum of the squares
    bool converged = false;
    int evaluations = 0;
};

/// The accuracy of a search: to the last digits, or enough to choose the best of several.
enum class SearchEffort { whole, rough };

/// Starts at given coordinates, of which `fixed` ones are constant. A stop of the problem ends it
/// early.
[[nodiscard]] LeastSquares minimise(FitProblem& problem, const std::vector<double>& start,
                                    const std::vector<bool>& fixed,
                                    SearchEffort effort = SearchEffort::whole);

/// Derivatives of the residuals by the coordinates, by central differences, column after column.
/// False if the cycle cannot be run near q.
bool derivatives(FitProblem& problem, const std::vector<double>& q,
                 const std::vector<std::size_t>& free, std::vector<double>& columns);

} // namespace sparkout
