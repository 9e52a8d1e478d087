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

enum class RobustLoss { none, huber, tukey };
[[nodiscard]] const char* keyOf(RobustLoss loss); ///< "huber"

/// Roots of the weights ψ(u)/u of residuals in units of their noise, by which the residuals are
/// multiplied in the next step of reweighted least squares: Huber's with 1.345, Tukey's with 4.685,
/// both 95 % efficient for normal noise [HUBER1981].
[[nodiscard]] std::vector<double> robustWeights(const std::vector<double>& residuals,
                                                RobustLoss loss);

} // namespace sparkout
