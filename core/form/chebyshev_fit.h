// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace sparkout {

/// The points of a part's surface relative to a trial axis, section by section: distance d and its
/// gradient −(nx, ny) for a shift, −ζ·(nx, ny) for a lean, ζ that of the section.
struct AxisView {
    AxisView(std::size_t sectionCount, std::size_t radiiPerSection)
        : sections(sectionCount)
        , K(radiiPerSection)
        , d(sections * K)
        , nx(sections * K)
        , ny(sections * K)
        , zeta(sections) {}

    [[nodiscard]] double zetaOf(std::size_t point) const { return zeta[point / K]; }

    std::size_t sections, K;
    std::vector<double> d, nx, ny; ///< point j·K + k
    std::vector<double> zeta;      ///< section j
};

/// d ≈ r + nx·(x + ζ·u) + ny·(y + ζ·v), no point off by more than level.
struct AxisFit {
    double r = 0, x = 0, y = 0, u = 0, v = 0;
    double level = 0; ///< ≥ 0
};

/// Best uniform approximation of the distances by {1, nx, ny, nx·ζ, ny·ζ}: the linear programme min
/// level with |d_i − fit_i| ≤ level, by the simplex method on its dual,
///
///     max Σ y_i·s_i·d_i,   Σ y_i·s_i·g_i = 0,  Σ y_i = 1,  y ≥ 0,   g = (1, nx, ny, nx·ζ, ny·ζ)
///
/// A basis is six points with signs s; any six points of full rank have signs that make it
/// feasible. The point with the largest excess enters; where weights are zero and the level stalls,
/// Bland's rule is used, so the method terminates. Only points that once had the largest excess in
/// their section are considered, until no point at all has an excess.
class ChebyshevFit {
public:
    struct Point {
        std::size_t index = 0; ///< into the view
        double sign = 1;       ///< +1 touches from outside
    };
    static constexpr std::size_t size = 6;

    /// Starts with three points each of two sections.
    ChebyshevFit(const AxisView& view, std::size_t firstSection, std::size_t lastSection);

    /// Of several best fits returns one with a small shift and lean.
    AxisFit run(const AxisView& view, double tolerance);

    /// The points that carry the level, weights above zero.
    [[nodiscard]] std::vector<Point> contacts() const;

private:
    struct Entering {
        Point point;
        double excess = 0;
    };
    [[nodiscard]] AxisFit solve(const AxisView& view);
    [[nodiscard]] AxisFit nearest(const AxisView& view, const AxisFit& fit, double tolerance) const;
    void makeFeasible(const AxisView& view);
    [[nodiscard]] Entering choose(const AxisView& view, const AxisFit& fit, double tolerance,
                                  bool bland) const;
    bool pivot(const AxisView& view, const Point& entering, bool bland);
    void takeResiduals(const AxisView& view, const AxisFit& fit, std::size_t section);
    AxisFit runOnCandidates(const AxisView& view, double tolerance);
    bool addCandidates(const AxisView& view, const AxisFit& fit, double tolerance);

    std::array<Point, size> m_basis;
    std::array<double, size> m_weights{};
    std::vector<std::size_t> m_candidates;
    std::vector<double> m_residuals; ///< residuals of one section
};

} // namespace sparkout
