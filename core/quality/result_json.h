// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/cycle_constraints.h"
#include "core/quality/ranges.h"
#include "core/quality/roughness.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sparkout {

/// A zone or section at the end of a cycle; what it refers to outlives it.
struct ZoneFigures {
    const Project* project = nullptr;
    const SectionResult* section = nullptr;
    const SectionAccuracy* accuracy = nullptr;
    const ZoneForm* form = nullptr;         ///< null: not a zone with several sections
    const DeviationRange* ifEven = nullptr; ///< null: the number of lobes is known
    RoughnessFactor roughness;
    FinishedSurface surface;

    /// Ra with this factor; empty also where no roughness is required.
    [[nodiscard]] std::optional<double> ra_um(double factor) const;
};
/// The zones or sections of a result with its accuracy.
[[nodiscard]] std::vector<ZoneFigures> zonesOf(const SimulationResult& result,
                                               const PartAccuracy& accuracy);

/// The outputs of a zone or section; those of its position stand before them in tables.
[[nodiscard]] std::span<const Output<ZoneFigures>> zoneOutputs();
[[nodiscard]] std::span<const Output<SectionResult>> positionOutputs();
/// Its diameters with an even number of lobes, where the number is not known.
[[nodiscard]] std::span<const Output<ZoneFigures>> evenLobesOutputs();
/// The form of a zone with several sections; the first is also one of zoneOutputs().
[[nodiscard]] std::span<const Output<ZoneFigures>> zoneFormOutputs();

/// A section of a zone with several.
struct ZoneSectionFigures {
    const SectionResult& section;
    double nominalRadius_mm;
    FinishedSurface surface;
};
[[nodiscard]] std::span<const Output<ZoneSectionFigures>> zoneSectionOutputs();

/// The form of the whole part.
struct PartFigures {
    const PartAccuracy& accuracy;
    FinishedSurface surface;
};
[[nodiscard]] std::span<const Output<PartFigures>> partOutputs();

/// The visit nearest to burning.
[[nodiscard]] std::span<const Output<BurnState>> burnOutputs();

/// A result as one JSON object: the output of `sparkout-cli simulate --json` and of the window's
/// export; its named keys are fixed. "shop" holds the shop's numbers:
///
///     { "stages": [ {…}, … ], "cycle": {…},
///       "wheel_speed_rpm", "rotation_ratio", "rotation_ratio_near_integer" }
///
/// with, for each stage and for the cycle, removal_rate_mm3_mm_s (Q'_w), equivalent_chip_um (h_eq)
/// and aggressiveness at largest_depth_um; mean_removal_rate_mm3_mm_s; overlap_ratio;
/// specific_energy_j_mm3 and specific_energy_plausible; peak_power_w, mean_power_w,
/// peak_normal_force_n; and their components: removed_volume_mm3, energy_j, grinding_time_min,
/// which is the machining time. Peaks have a …_where. Missing values are null.
[[nodiscard]] std::string resultJson(const SimulationResult& result,
                                     const std::vector<ConstraintResult>& constraints);

} // namespace sparkout
