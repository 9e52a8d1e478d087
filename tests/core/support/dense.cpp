// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/dense.h"

#include <Eigen/Dense>

namespace sparkout::dense {

namespace {

Eigen::MatrixXd taken(const Matrix& rows) {
    Eigen::MatrixXd A(rows.size(), rows.at(0).size());
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        for (Eigen::Index j = 0; j < A.cols(); ++j) {
            A(i, j) = rows[std::size_t(i)].at(std::size_t(j));
        }
    }
    return A;
}

Eigen::VectorXd taken(const Vector& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size()));
}

Vector given(const Eigen::VectorXd& x) {
    return Vector(x.begin(), x.end());
}

} // namespace

Vector solved(const Matrix& A, const Vector& b) {
    return given(taken(A).fullPivLu().solve(taken(b)));
}

Vector leastSquares(const Matrix& A, const Vector& b) {
    return given(taken(A).colPivHouseholderQr().solve(taken(b)));
}

Matrix inverse(const Matrix& A) {
    const Eigen::MatrixXd found = taken(A).fullPivLu().inverse();
    Matrix rows;
    for (Eigen::Index i = 0; i < found.rows(); ++i) {
        rows.push_back(given(found.row(i)));
    }
    return rows;
}

bool isPositiveDefinite(const Matrix& A) {
    return taken(A).llt().info() == Eigen::Success;
}

double alternation(const Matrix& G, const Vector& d) {
    const auto lu = taken(G).fullPivLu();
    if (lu.dimensionOfKernel() != 1) {
        return 0;
    }
    const Eigen::VectorXd eta = lu.kernel().col(0);
    return std::abs(eta.dot(taken(d))) / eta.lpNorm<1>();
}

} // namespace sparkout::dense
