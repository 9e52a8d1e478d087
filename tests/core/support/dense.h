// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

/// Small dense systems for the tests. Eigen stays in the source: it takes long to compile.
namespace sparkout::dense {

using Vector = std::vector<double>;
using Matrix = std::vector<Vector>; ///< rows

Vector solved(const Matrix& A, const Vector& b);       ///< A·x = b, A square and regular
Vector leastSquares(const Matrix& A, const Vector& b); ///< least |A·x − b|
Matrix inverse(const Matrix& A);
bool isPositiveDefinite(const Matrix& A); ///< A symmetric

/// |η·d| / Σ|η| for the one direction η with G·η = 0: the least level at which the functions of G's
/// rows come to all of d (de la Vallée-Poussin); 0 if there is not exactly one such direction.
double alternation(const Matrix& G, const Vector& d);

} // namespace sparkout::dense
