// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/roundness.h"

#include <cstddef>
#include <span>
#include <vector>

namespace sparkout {

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
