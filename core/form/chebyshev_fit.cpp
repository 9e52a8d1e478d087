// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/form/chebyshev_fit.h"

#include "core/form/value_range.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr int n = static_cast<int>(ChebyshevFit::size);
using Matrix = Eigen::Matrix<double, n, n>;
using Vector = Eigen::Matrix<double, n, 1>;

/// (s·g; 1) of a point.
Vector column(const AxisView& view, const ChebyshevFit::Point& point) {
    const std::size_t i = point.index;
    const double s = point.sign, nx = view.nx[i], ny = view.ny[i], zeta = view.zetaOf(i);
    return Vector{{s, s * nx, s * ny, s * nx * zeta, s * ny * zeta, 1}};
}

Matrix basisMatrix(const AxisView& view,
                   const std::array<ChebyshevFit::Point, ChebyshevFit::size>& basis) {
    Matrix M;
    for (int m = 0; m < n; ++m) {
        M.col(m) = column(view, basis[static_cast<std::size_t>(m)]);
    }
    return M;
}

/// An orthonormal basis of the added vectors, by Gram–Schmidt with reorthogonalisation.
class Span {
public:
    /// The part of v outside the span, 0 if it is rounding.
    [[nodiscard]] Vector outside(const Vector& v) const {
        Vector rest = v;
        for (int pass = 0; pass < 2; ++pass) {
            for (int m = 0; m < m_count; ++m) {
                rest -= rest.dot(m_unit.col(m)) * m_unit.col(m);
            }
        }
        return rest.norm() > 1e-11 * v.norm() ? rest : Vector(Vector::Zero());
    }
    void take(const Vector& v) {
        const Vector rest = outside(v);
        if (const double norm = rest.norm(); norm > 0) {
            m_unit.col(m_count++) = rest / norm;
        }
    }

private:
    Matrix m_unit;
    int m_count = 0;
};

double residual(const AxisView& view, const AxisFit& fit, std::size_t i) {
    const double zeta = view.zetaOf(i);
    return view.d[i] - fit.r - view.nx[i] * (fit.x + zeta * fit.u)
           - view.ny[i] * (fit.y + zeta * fit.v);
}

} // namespace

ChebyshevFit::ChebyshevFit(const AxisView& view, std::size_t firstSection, std::size_t lastSection)
    : m_residuals(view.K) {
    for (std::size_t m = 0; m < size; ++m) {
        const std::size_t section = m < size / 2 ? firstSection : lastSection;
        m_basis[m].index = section * view.K + m % 3 * view.K / 3;
        m_candidates.push_back(m_basis[m].index);
    }
}

AxisFit ChebyshevFit::run(const AxisView& view, double tolerance) {
    makeFeasible(view);
    AxisFit fit = runOnCandidates(view, tolerance);
    while (addCandidates(view, fit, tolerance)) {
        fit = runOnCandidates(view, tolerance);
    }
    return nearest(view, fit, tolerance);
}

// With fewer than six contacts there are many best fits. Moves from the smallest shift and lean
// that keep the contacts towards the simplex method's fit, as far as the other points require:
// their excess falls linearly on the way. The radius is free, so the contacts fix shift and lean
// only by their differences: the smallest fit that keeps them is the part within the span of these
// differences.
AxisFit ChebyshevFit::nearest(const AxisView& view, const AxisFit& fit, double tolerance) const {
    const std::vector<Point> touching = contacts();
    if (touching.empty()) { // NaN weights
        return fit;
    }
    const auto direction = [&](const Point& point) {
        const double nx = view.nx[point.index], ny = view.ny[point.index];
        const double zeta = view.zetaOf(point.index);
        return Vector{{nx, ny, nx * zeta, ny * zeta, 0, 0}};
    };
    Span differences;
    for (const Point& point : touching) {
        differences.take(direction(point) - direction(touching.front()));
    }
    const Vector own{{fit.x, fit.y, fit.u, fit.v, 0, 0}};
    const Vector spare = differences.outside(own);
    const Vector p = own - spare;
    const AxisFit near{
        fit.r + direction(touching.front()).dot(spare), p[0], p[1], p[2], p[3], fit.level};
    double share = 0;
    for (std::size_t i = 0; i < view.d.size(); ++i) {
        const double from = residual(view, near, i);
        const double excess = std::abs(from) - fit.level - tolerance;
        if (excess > 0) {
            const double to = residual(view, fit, i);
            share = std::max(share, excess / (std::abs(from) - (from < 0 ? -to : to)));
        }
    }
    share = std::min(share, 1.0);
    return {near.r + share * (fit.r - near.r), near.x + share * (fit.x - near.x),
            near.y + share * (fit.y - near.y), near.u + share * (fit.u - near.u),
            near.v + share * (fit.v - near.v), fit.level};
}

std::vector<ChebyshevFit::Point> ChebyshevFit::contacts() const {
    constexpr double carries = 1e-9;
    std::vector<Point> found;
    for (std::size_t m = 0; m < size; ++m) {
        if (m_weights[m] > carries) {
            found.push_back(m_basis[m]);
        }
    }
    return found;
}

// Six points have one vector η with Σ η_i·g_i = 0; its signs are those of the basis.
void ChebyshevFit::makeFeasible(const AxisView& view) {
    for (Point& point : m_basis) {
        point.sign = 1;
    }
    const Matrix M = basisMatrix(view, m_basis);
    Span rows;
    for (int row = 0; row < n - 1; ++row) {
        rows.take(M.row(row));
    }
    Vector eta = Vector::Zero();
    for (int m = 0; m < n; ++m) {
        const Vector rest = rows.outside(Vector::Unit(m));
        if (rest.norm() > eta.norm()) {
            eta = rest;
        }
    }
    for (std::size_t m = 0; m < size; ++m) {
        m_basis[m].sign = eta[static_cast<int>(m)] < 0 ? -1 : 1;
    }
}

// Weights from M·y = e₆ and the fit from Mᵀ·(fit; level) = s·d, M the basis.
AxisFit ChebyshevFit::solve(const AxisView& view) {
    const Eigen::PartialPivLU<Matrix> lu(basisMatrix(view, m_basis));
    Vector d;
    for (int m = 0; m < n; ++m) {
        const Point& point = m_basis[static_cast<std::size_t>(m)];
        d[m] = point.sign * view.d[point.index];
    }
    const Vector x = lu.transpose().solve(d);
    const Vector y = lu.solve(Vector::Unit(n - 1));
    for (std::size_t m = 0; m < size; ++m) {
        m_weights[m] = std::max(y[static_cast<int>(m)], 0.0);
    }
    return {x[0], x[1], x[2], x[3], x[4], x[5]};
}

ChebyshevFit::Entering ChebyshevFit::choose(const AxisView& view, const AxisFit& fit,
                                            double tolerance, bool bland) const {
    Entering found{{}, tolerance};
    for (const std::size_t i : m_candidates) {
        const double off = residual(view, fit, i);
        const double excess = std::abs(off) - fit.level;
        if (excess > found.excess) {
            found = {{i, off < 0 ? -1.0 : 1.0}, excess};
            if (bland) {
                break;
            }
        }
    }
    return found;
}

// The weights along the entering column: the point with θ = min y_m/z_m over z_m > 0 leaves the
// basis. Ties are broken by the largest z, which keeps the basis well-conditioned, or by Bland's
// rule, by the first point.
bool ChebyshevFit::pivot(const AxisView& view, const Point& entering, bool bland) {
    const Vector z =
        Eigen::PartialPivLU<Matrix>(basisMatrix(view, m_basis)).solve(column(view, entering));
    constexpr double least = 1e-11;
    constexpr double equal = 1e-13;
    std::size_t leaving = size;
    double best = 0;
    for (std::size_t m = 0; m < size; ++m) {
        const double zm = z[static_cast<int>(m)];
        if (zm <= least) {
            continue;
        }
        const double ratio = m_weights[m] / zm;
        const bool tie = leaving < size && std::abs(ratio - best) <= equal;
        const bool better = leaving == size
                            || (tie ? (bland ? m_basis[m].index < m_basis[leaving].index
                                             : zm > z[static_cast<int>(leaving)])
                                    : ratio < best);
        if (better) {
            leaving = m;
            best = ratio;
        }
    }
    if (leaving == size) {
        return false;
    }
    m_basis[leaving] = entering;
    return true;
}

AxisFit ChebyshevFit::runOnCandidates(const AxisView& view, double tolerance) {
    constexpr int mostPivots = 5000;
    constexpr int patience = 12; ///< pivots without a gain before Bland's rule
    std::sort(m_candidates.begin(), m_candidates.end());
    AxisFit fit = solve(view);
    int stalled = 0;
    for (int step = 0; step < mostPivots; ++step) {
        const bool bland = stalled > patience;
        const Entering entering = choose(view, fit, tolerance, bland);
        if (entering.excess <= tolerance || !pivot(view, entering.point, bland)) {
            break;
        }
        const AxisFit next = solve(view);
        stalled = next.level > fit.level + tolerance / 16 ? 0 : stalled + 1;
        fit = next;
    }
    return fit;
}

// Vectorised: with 200 sections of 360 radii this takes most of the time.
void ChebyshevFit::takeResiduals(const AxisView& view, const AxisFit& fit, std::size_t section) {
    const std::size_t K = view.K;
    const double* __restrict d = view.d.data() + section * K;
    const double* __restrict nx = view.nx.data() + section * K;
    const double* __restrict ny = view.ny.data() + section * K;
    double* __restrict off = m_residuals.data();
    const double r = fit.r;
    const double x = fit.x + view.zeta[section] * fit.u;
    const double y = fit.y + view.zeta[section] * fit.v;
#pragma omp simd
    for (std::size_t k = 0; k < K; ++k) {
        off[k] = d[k] - r - nx[k] * x - ny[k] * y;
    }
}

/// Adds the furthest points of each section with an excess, on either side.
bool ChebyshevFit::addCandidates(const AxisView& view, const AxisFit& fit, double tolerance) {
    const std::size_t before = m_candidates.size();
    const auto isCandidate = [&](std::size_t i) { // the earlier ones are sorted
        return std::binary_search(m_candidates.begin(),
                                  m_candidates.begin() + static_cast<std::ptrdiff_t>(before), i);
    };
    for (std::size_t j = 0; j < view.sections; ++j) {
        const std::size_t first = j * view.K;
        takeResiduals(view, fit, j);
        const ValueRange range = rangeOf(m_residuals);
        for (const double extreme : {range.low, range.high}) {
            if (!(std::abs(extreme) > fit.level + tolerance)) { // also for NaN
                continue;
            }
            const auto found = std::find(m_residuals.begin(), m_residuals.end(), extreme);
            const std::size_t i = first + static_cast<std::size_t>(found - m_residuals.begin());
            if (!isCandidate(i)) {
                m_candidates.push_back(i);
            }
        }
    }
    return m_candidates.size() > before;
}

} // namespace sparkout
