// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/section_influence.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <int rank>
using Few = Eigen::Matrix<double, rank, 1>;

/// The numbers of section j.
template <int rank>
Eigen::Map<const Few<rank>> numbers(const std::vector<double>& all, std::size_t j) {
    return Eigen::Map<const Few<rank>>(&all[j * rank]);
}

Eigen::Map<const MatrixXd> square(const std::vector<double>& matrix, std::size_t size) {
    return {matrix.data(), static_cast<Index>(size), static_cast<Index>(size)};
}

} // namespace

SectionInfluence::SectionInfluence(std::vector<double> influence_mm_n, std::size_t sections)
    : m_size(sections), m_matrix(std::move(influence_mm_n)) {
    if (m_size >= fewestSections) {
        findFactors();
    }
    if (isShort()) {
        m_gains.resize(m_rows.size());
        m_pivots.resize(m_size);
    } else {
        m_block.resize(m_matrix.size());
        m_side.resize(m_size);
    }
}

// Finds the factors from the block below the middle and left of it: an orthonormal basis of its
// rows and columns gives the columns to its left, and these the rows above. A column right of the
// middle follows from the rows below it.
void SectionInfluence::findFactors() {
    constexpr double cutOff = 1e-13;
    const auto G = square(m_matrix, m_size);
    const Index count = G.rows();
    const Index middle = count / 2;
    const auto block = G.bottomLeftCorner(count - middle, middle);
    const Eigen::ColPivHouseholderQR<MatrixXd> factors(block);
    Index rank = 0;
    while (rank < middle && std::abs(factors.matrixR()(rank, rank)) > cutOff * factors.maxPivot()) {
        ++rank;
    }
    if (rank > static_cast<Index>(mostRank)) {
        return;
    }
    m_rank = rank <= 3 ? 3 : rank <= 4 ? 4 : mostRank; // the ranks that are compiled
    const auto kept = static_cast<Index>(m_rank);
    m_rows.assign(m_rank * m_size, 0.0);
    m_columns.assign(m_rank * m_size, 0.0);
    if (rank == 0) { // no coupling: each section deflects alone, or not at all
        m_rank = isExact() ? m_rank : 0;
        return;
    }
    auto rows = Eigen::Map<MatrixXd>(m_rows.data(), kept, count).topRows(rank);
    auto columns = Eigen::Map<MatrixXd>(m_columns.data(), kept, count).topRows(rank);
    const MatrixXd basis = factors.householderQ() * MatrixXd::Identity(count - middle, rank);
    rows.rightCols(count - middle) = basis.transpose();
    columns.leftCols(middle) = basis.transpose() * block;
    Eigen::ColPivHouseholderQR<MatrixXd> known;
    known.setThreshold(cutOff);
    for (Index j = 1; j < middle; ++j) {
        known.compute(columns.leftCols(j).transpose());
        rows.col(j) = known.solve(G.row(j).head(j).transpose());
    }
    for (Index l = middle; l + 1 < count; ++l) {
        const Index below = count - l - 1;
        known.compute(rows.rightCols(below).transpose());
        columns.col(l) = known.solve(G.col(l).tail(below));
    }
    m_rank = isExact() ? m_rank : 0;
}

// Whether products are as exact as the usual ones, for forces that are alike and for some that are
// not.
bool SectionInfluence::isExact() const {
    const auto G = square(m_matrix, m_size);
    VectorXd forces = VectorXd::Ones(G.rows());
    VectorXd product(G.rows());
    for (int trial = 0; trial < 4; ++trial) {
        multiply(forces.data(), product.data());
        const VectorXd usual = G * forces;
        const double scale = (G.cwiseAbs() * forces.cwiseAbs()).maxCoeff();
        if (!((product - usual).cwiseAbs().maxCoeff() <= mostError * scale)) {
            return false;
        }
        for (Index i = 0; i < forces.size(); ++i) {
            forces[i] = std::cos(static_cast<double>((i + 1) * (trial + 1) * (trial + 1)));
        }
    }
    return true;
}

void SectionInfluence::multiply(const double* f_n, double* product_mm) const {
    switch (m_rank) {
    case 3: return multiplyShort<3>(f_n, product_mm);
    case 4: return multiplyShort<4>(f_n, product_mm);
    case mostRank: return multiplyShort<mostRank>(f_n, product_mm);
    default: break;
    }
    const auto G = square(m_matrix, m_size);
    Eigen::Map<VectorXd>(product_mm, G.rows()).noalias() =
        G * Eigen::Map<const VectorXd>(f_n, G.rows());
}

void SectionInfluence::solve(const double* added, const std::vector<std::ptrdiff_t>& free,
                             double* x) {
    switch (m_rank) {
    case 3: return solveShort<3>(added, free, x);
    case 4: return solveShort<4>(added, free, x);
    case mostRank: return solveShort<mostRank>(added, free, x);
    default: solveUsually(added, free, x);
    }
}

template <int rank>
void SectionInfluence::multiplyShort(const double* f, double* product) const {
    Few<rank> left = Few<rank>::Zero();  // sum of the forces left of a section
    Few<rank> right = Few<rank>::Zero(); // sum of those right of it, for the mirrored block
    for (std::size_t j = 0; j < m_size; ++j) {
        product[j] = own(j) * f[j];
    }
    for (std::size_t i = 0; i < m_size; ++i) {
        const std::size_t j = m_size - 1 - i;
        product[i] += numbers<rank>(m_rows, i).dot(left);
        product[j] += numbers<rank>(m_columns, j).dot(right);
        left += numbers<rank>(m_columns, i) * f[i];
        right += numbers<rank>(m_rows, j) * f[j];
    }
}

// Factors the matrix as L·Δ·Lᵀ with L of the same form: L_jl = row_j·gain_l.
template <int rank>
void SectionInfluence::solveShort(const double* added, const std::vector<std::ptrdiff_t>& free,
                                  double* x) {
    Eigen::Matrix<double, rank, rank> carried; // Σ pivot·gain·gainᵀ
    carried.setZero();
    Few<rank> sum = Few<rank>::Zero();
    std::size_t next = 0;
    for (const std::ptrdiff_t each : free) {
        const auto j = static_cast<std::size_t>(each);
        std::fill(x + next, x + j, 0.0);
        next = j + 1;
        const auto row = numbers<rank>(m_rows, j);
        const Few<rank> shared = carried * row;
        const Few<rank> rest = numbers<rank>(m_columns, j) - shared;
        m_pivots[j] = added[j] + own(j) - row.dot(shared);
        const Few<rank> gain = rest / m_pivots[j];
        carried += rest * gain.transpose();
        x[j] -= row.dot(sum);
        sum += gain * x[j];
        std::copy(gain.begin(), gain.end(), m_gains.begin() + each * rank);
    }
    std::fill(x + next, x + m_size, 0.0);
    sum.setZero();
    for (std::size_t i = free.size(); i-- > 0;) {
        const auto j = static_cast<std::size_t>(free[i]);
        x[j] = x[j] / m_pivots[j] - numbers<rank>(m_gains, j).dot(sum);
        sum += numbers<rank>(m_rows, j) * x[j];
    }
}

void SectionInfluence::solveUsually(const double* added, const std::vector<std::ptrdiff_t>& free,
                                    double* x) {
    const auto count = static_cast<Index>(free.size());
    Eigen::Map<MatrixXd> block(m_block.data(), count, count);
    Eigen::Map<VectorXd> side(m_side.data(), count);
    for (Index i = 0; i < count; ++i) {
        const std::ptrdiff_t j = free[static_cast<std::size_t>(i)];
        for (Index k = i; k < count; ++k) {
            block(k, i) = m_matrix[static_cast<std::size_t>(j) * m_size
                                   + static_cast<std::size_t>(free[static_cast<std::size_t>(k)])];
        }
        block(i, i) += added[j];
        side[i] = x[j];
    }
    Eigen::LLT<Eigen::Ref<MatrixXd>>(block).solveInPlace(side);
    std::fill(x, x + m_size, 0.0);
    for (Index i = 0; i < count; ++i) {
        x[free[static_cast<std::size_t>(i)]] = side[i];
    }
}

} // namespace sparkout
