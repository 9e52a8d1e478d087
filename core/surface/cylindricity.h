// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/roundness.h"

#include <array>
#include <cstddef>
#include <span>
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

/// One section of a part: its radii and its place along the ground length.
struct SectionShape {
    double position_mm = 0;
    std::span<const double> radii_mm; ///< R_k about the centre axis, K values
};

/// A point of the surface that touches a cylinder.
struct CylinderContact {
    std::size_t section = 0;
    std::size_t radius = 0;
    bool outer = false;
};

/// Two coaxial cylinders that contain the points of all sections between them [ISO12180]. The axis
/// passes through (x, y) at `position` and leans by the slopes.
struct CylinderZone {
    double position_mm = 0; ///< the sections' mean position
    double x_mm = 0, y_mm = 0;
    double slopeX = 0, slopeY = 0; ///< mm a mm along the axis
    double inner_mm = 0, outer_mm = 0;
    double reference_mm = 0; ///< least squares: the fitted radius; otherwise the middle
    std::vector<CylinderContact> contacts; ///< minimum zone

    [[nodiscard]] double deviation() const { return outer_mm - inner_mm; }
};

/// Least-squares cylinder: axis and radius with the smallest Σ(distance − radius)², distances
/// perpendicular to the leaning axis. One section: its circle. Positions must differ.
[[nodiscard]] CylinderZone leastSquaresCylinder(std::span<const SectionShape> sections,
                                                const Directions& directions);

/// Minimum zone: the axis with the smallest outer − inner, from the least-squares cylinder on.
/// About a trial axis the distances are linear in its shift and lean up to their curvature; that
/// problem is a linear programme, solved exactly by the simplex method on six points
/// (ChebyshevFit). Then the distances are taken anew about the axis found, until the linear problem
/// promises no more than the last bits, or than the curvature of its step, e²/(2R) + R·t²/2 for a
/// shift e and a lean t. No better axis is further off than e = √2·w at an end, so none is better
/// by more than 2·(w²/R + R·(2w/L)²), once for the step not taken and once for its own curvature;
/// w the zone found, L from the first section to the last: 0.02 µm for w = 10 µm, R = 15 mm,
/// L = 50 mm, and as w²
/// below. `contacts` are the points that determine the zone, up to six; where the axis may yet lean
/// freely (one section decides) they touch to that curvature.
[[nodiscard]] CylinderZone minimumZoneCylinder(std::span<const SectionShape> sections,
                                               const Directions& directions);
[[nodiscard]] CylinderZone minimumZoneCylinder(std::span<const SectionShape> sections,
                                               const Directions& directions,
                                               const CylinderZone& leastSquares);

} // namespace sparkout
