// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace sparkout {

/// The influence function of sections G [mm/N], J×J, symmetric, in time proportional to J where its
/// form allows. Right of a force the shape of a bent shaft is a combination of a few functions,
/// whatever the force's position: a line and the shape under a moment; each rest adds one. So G is
/// semiseparable: with a few numbers for each section
///
///     G_jl = row_j·column_l     for l < j.
///
/// The exactness of its products is checked; a matrix of another form, or of few sections, is
/// handled in the usual way.
class SectionInfluence {
public:
    SectionInfluence(std::vector<double> influence_mm_n, std::size_t sections);

    [[nodiscard]] double own(std::size_t j) const { return m_matrix[j * m_size + j]; }    ///< G_jj
    [[nodiscard]] const double* of(std::size_t j) const { return &m_matrix[j * m_size]; } ///< G_j·

    /// G·f [mm]. The arrays must not overlap.
    void multiply(const double* f_n, double* product_mm) const;
    /// The solution of (D + G)·x = b over the sections in `free`, in rising order; x is 0
    /// elsewhere. D > 0 is added to the diagonal, of all J sections; `x` holds b and receives the
    /// solution.
    void solve(const double* added, const std::vector<std::ptrdiff_t>& free, double* x);

    [[nodiscard]] bool isShort() const { return m_rank > 0; } ///< in time proportional to J
    /// The number of values of a section: 3, 4 or `mostRank`; 0 if the matrix is not semiseparable.
    [[nodiscard]] std::size_t rank() const { return m_rank; }
    [[nodiscard]] const std::vector<double>& rows() const { return m_rows; } ///< values by section
    [[nodiscard]] const std::vector<double>& columns() const { return m_columns; }

    static constexpr std::size_t mostRank = 8;
    static constexpr std::size_t fewestSections = 8; ///< not quicker for fewer
    /// Greatest error of a product, relative to the product of absolute values.
    static constexpr double mostError = 1e-14;

private:
    void findFactors();
    [[nodiscard]] bool isExact() const;
    template <int rank>
    void multiplyShort(const double* f, double* product) const;
    template <int rank>
    void solveShort(const double* added, const std::vector<std::ptrdiff_t>& free, double* x);
    void solveUsually(const double* added, const std::vector<std::ptrdiff_t>& free, double* x);

    std::size_t m_size;
    std::vector<double> m_matrix;
    std::size_t m_rank = 0;                ///< number of values of a section; 0: the usual way
    std::vector<double> m_rows, m_columns; ///< section by section
    std::vector<double> m_block, m_side;   ///< work space of solveUsually()
    std::vector<double> m_gains, m_pivots; ///< work space of solveShort()
};

} // namespace sparkout
