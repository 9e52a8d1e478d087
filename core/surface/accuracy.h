// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/cylindricity.h"
#include "core/surface/formula.h"
#include "core/surface/roundness.h"

#include <span>
#include <vector>

namespace sparkout {

/// The form of the mean radius along the length.
enum class LongitudinalForm { straight, taper, barrel, saddle };

/// Linear and quadratic part of the mean radii along the length, least squares [MODEL-7], both over
/// the span from the first section to the last, in radius. One section has neither, two have no
/// quadratic part.
struct LongitudinalProfile {
    double taper_mm = 0; ///< last end less first end of the linear part
    double crown_mm = 0; ///< middle less ends of the quadratic part: > 0 barrel, < 0 saddle
    LongitudinalForm form = LongitudinalForm::straight; ///< the larger of the two
};

/// Both parts of a straight profile are smaller: a hundredth of a micrometre.
inline constexpr double straight_mm = 1e-5;

/// Form of one section, compared with the drawing.
struct SectionAccuracy {
    double meanRadius_mm = 0;
    double radialRunout_mm = 0; ///< R_max − R_min about the centre axis, plus the machine's own
    RoundnessZone leastSquares;
    RoundnessZone minimumZone;
};

/// A zone with several sections [ALSIGAR2021].
struct ZoneForm {
    double cylindricity_mm = 0; ///< minimum zone
    double totalRunout_mm = 0;  ///< R_max − R_min over its sections, plus the machine's own
    LongitudinalProfile profile;
};

/// A part against the drawing.
struct PartAccuracy {
    std::vector<SectionAccuracy> sections; ///< by place; of a divided zone the least round one
    std::vector<ZoneForm> zones;           ///< for zones with several sections
    CylinderZone leastSquares;
    CylinderZone minimumZone;
    double totalRunout_mm = 0; ///< R_max − R_min over all sections, plus the machine's own
    LongitudinalProfile profile;
};

/// R_max − R_min about the centre axis + the machine's geometric runout, which adds linearly
/// [MODEL-7]; of one section the radial runout, of all the total radial runout.
double runout(std::span<const SectionShape> sections, double geometricRunout_mm,
              FormulaSheet* sheet = nullptr);

[[nodiscard]] LongitudinalProfile longitudinalProfile(std::span<const double> positions_mm,
                                                      std::span<const double> meanRadii_mm);

/// Computes everything for sections with equal numbers of radii (K ≥ 4) at different positions.
[[nodiscard]] PartAccuracy partAccuracy(std::span<const SectionShape> sections,
                                        double geometricRunout_mm);

[[nodiscard]] FormulaSheet radialRunoutSheet(const SectionShape& section,
                                             double geometricRunout_mm);
[[nodiscard]] FormulaSheet totalRunoutSheet(std::span<const SectionShape> sections,
                                            double geometricRunout_mm);
[[nodiscard]] FormulaSheet roundnessSheet(const RoundnessZone& zone);
[[nodiscard]] FormulaSheet cylindricitySheet(const CylinderZone& zone);

} // namespace sparkout
