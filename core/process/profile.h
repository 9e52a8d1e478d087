// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// A part of the ground length, from its headstock end.
struct Stretch {
    double from_mm = 0; ///< end nearer to the headstock [mm]
    double to_mm = 0;   ///< the other one [mm]
};

/// The stretches of the zones РЗ1, НЗ, РЗ2 or of the sections, in this order, without the relief
/// before the wall of a blind bore. With the entry at the tailstock the zones are counted from that
/// end.
[[nodiscard]] std::vector<Stretch> groundStretches(const Project& project);

struct Part;

/// A depth beyond any infeed: the radii in the gaps of an interrupted surface.
inline constexpr double beyondReach_mm = 1000;

/// The blank's geometry [MODEL-4]. Radii are followed as depths below first touch: external
/// R_k = R_first − depth_k, internal R_k = R_first + depth_k, with R_first the largest radius
/// (external) or the smallest (internal).
struct Blank {
    double targetRadius_mm = 0;     ///< R_t, middle of the tolerance unless set
    double firstTouchRadius_mm = 0; ///< R_max0 external, R_min0 internal
    double totalInfeed_mm = 0;      ///< |R_first − R_t| = Π + ΔR, the greatest of all zones
    /// Whether a radius lies in a gap and is not ground.
    [[nodiscard]] bool isGap(std::size_t k) const { return depth_mm[k] >= beyondReach_mm; }

    std::vector<double> depth_mm; ///< depths of the K radii, ≥ 0; beyondReach_mm in a gap
    /// Depths of each zone or section, where they have a stock or runout of their own.
    std::vector<std::vector<double>> placeDepth_mm;
    [[nodiscard]] const std::vector<double>& depthAt(std::size_t place) const {
        return place < placeDepth_mm.size() ? placeDepth_mm[place] : depth_mm;
    }
};

/// R_t [mm]: half the target diameter, else the middle of the tolerance band.
[[nodiscard]] double targetRadius(const Part& part);

/// ΔR [mm]: given, or max − min of a measured profile.
[[nodiscard]] double initialRunout(const Part& part);

/// The K radii R_k [mm] of a blank with the given largest radius, at φ_k = 2πk/K.
/// Ellipse: p = R_max, q = R_max − ΔR, R = pq/√((q·cos φ)² + (p·sin φ)²).
/// Eccentric circle: radius r = R_max − ΔR/2 about e = ΔR/2, R = e·cos φ + √(r² − (e·sin φ)²).
/// Lobes: R = R_max − ΔR/2·(1 − cos nφ). Measured: R = R_max + deviation from the largest.
[[nodiscard]] std::vector<double> profileRadii(const Part& part, double largestRadius_mm);

/// Zones or sections with a stock or runout of their own, Π + δΠ and ΔR + δ(ΔR), have the same
/// form; all depths count from the first touch of the whole blank. A measured profile is stretched.
[[nodiscard]] Blank makeBlank(const Part& part);

/// The largest ΔR of the zones or sections [mm].
[[nodiscard]] double largestRunout(const Part& part);

} // namespace sparkout
