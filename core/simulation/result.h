// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// A zone of traverse grinding, or a section of plunge grinding.
enum class Zone { rz1, nz, rz2, section };

/// The steps E1…E5 of a double stroke for a zone; plunge passes have none.
enum class Step { none, e1, e2, e3, e4, e5 };

enum class RunStatus {
    completed,
    cannotReachSize, ///< no progress, and no further feed
    tooLong,         ///< more visits than maxVisits
    stopped,         ///< stopped on request
    notSolved,       ///< the balance of coupled sections did not converge, or a compliance is < 0
    groundAway,      ///< a radius of the part has reached 0
    refused,         ///< validate() finds errors in the project: nothing was run
};

/// A run ends as tooLong beyond this number of visits (one radius under the wheel once).
inline constexpr long long maxVisits = 50'000'000;

/// A place in the cycle; numbers count from 1, sections from 0.
struct Place {
    Zone zone = Zone::section;
    Step step = Step::none;
    int section = 0;    ///< plunge: index of the section
    int stage = 0;      ///< stage of the cycle
    int cycleCount = 0; ///< double stroke (traverse) or revolution (plunge)
    int revolution = 0; ///< revolution within the step (traverse)
};

/// Largest value of a quantity over the passes, and the place where it was first reached.
struct Peak {
    double value = 0;
    Place at;
};

/// Sums over the passes of one stage of the cycle, from which core/quality computes volume, energy
/// and power. A pass is one visit of one zone or section by the wheel: ℓ is the length of surface
/// that it represents (its zone, or its slice L_p/J), b its effective width, ⟨ ⟩ the mean over its
/// K radii. The free position of a gauge does not count.
struct StageSums {
    double length_mm = 0;       ///< Σℓ
    double removed_mm2 = 0;     ///< Σℓ·⟨a⟩: longitudinal section of the removed material
    double rootLength_mm15 = 0; ///< Σℓ·⟨√a⟩, for the friction term of P_z [mm^1.5];
                                ///< Σℓ·⟨v⟩ [mm] with a threshold
    Peak depth_mm;              ///< largest a, per revolution or stroke
    Peak normalForce_n;         ///< largest P_y
    Peak power_w;               ///< largest P_z·V_k
};

/// Basis of the roughness of a zone or section: the depth that the last step with infeed, a
/// revolution or double stroke, took off the radius with the largest removal, and the spark-out
/// after it. A step cut short by position control counts where it took more than the one before. A
/// surface that no step with infeed has cut has the first step without infeed here.
struct LastCut {
    double depth_mm = 0;   ///< a, taken by all passes of the step
    double overlap = 1;    ///< u, number of revolutions while the wheel passes a point in a stroke
    double pressed_mm = 0; ///< h, a plus the remaining deflection
    double step_s = 0;     ///< T, time of the step
    double sparkOut_s = 0; ///< t, of all steps after the last with infeed
    int radius = 0;        ///< k
    Place at;              ///< the first of these passes
};

/// The visit nearest to burning: the largest ratio of a to the allowed depth.
struct BurnVisit {
    double depth_mm = 0; ///< a
    double stock_mm = 0; ///< max(0, R_k after the pass − R_t): allowed depth of the damaged layer
    int radius = 0;      ///< k
    Place at;
};

/// Returns the mean of the radii outside gaps, which are not NaN.
[[nodiscard]] inline double meanOfGround(const std::vector<double>& radii_mm) {
    double sum = 0;
    std::size_t count = 0;
    for (const double radius : radii_mm) {
        const bool gap = std::isnan(radius);
        sum += gap ? 0 : radius;
        count += gap ? 0 : 1;
    }
    return sum / static_cast<double>(count);
}

/// Range of the diameters of a zone or section less the nominal one [mm].
struct DeviationRange {
    double least_mm = 0, most_mm = 0;
};

/// One zone or section at the end of the cycle.
struct SectionResult {
    Zone zone = Zone::section;
    double position_mm = 0;             ///< its middle, from the headstock end of the ground length
    double compliance_mm_per_n = 0;     ///< γ used
    std::vector<double> radii_mm;       ///< R_k, K values; not a number in a gap
    double diameterDeviationMin_mm = 0; ///< min of D_k less the nominal diameter
    double diameterDeviationMax_mm = 0; ///< max of D_k less the nominal diameter
    double radialRunout_mm = 0;         ///< R_max − R_min plus the machine's geometric runout
    double peakNormalForce_n = 0;       ///< largest P_y on any of its radii
    std::optional<LastCut> lastCut;     ///< where a roughness is required
};

/// Result of one cycle, a value that contains the inputs to which it belongs.
struct SimulationResult {
    Project project;           ///< inputs of the run, without kept runs
    std::string engineVersion; ///< version of the program that ran it
    RunStatus status = RunStatus::completed;
    double time_s = 0;
    int cycleCount = 0;             ///< double strokes or revolutions
    std::vector<int> countsByStage; ///< likewise, by stage
    std::vector<double> timeByStage_s;
    std::vector<StageSums> sumsByStage;
    std::vector<SectionResult> sections; ///< РЗ1, НЗ, РЗ2, or the sections from the headstock on
    /// Where zones have several sections: the sections zone by zone from the entry on. The zone
    /// then has the radii of its middle and the worst of all other values.
    std::vector<SectionResult> zoneSections;
    /// By zone or section, where the number of lobes printed by the machine is unknown: the
    /// diameters with two lobes. All other values assume three, which do not change diameters.
    std::vector<DeviationRange> ifEven;
    double gaugeReading_mm = 0;   ///< diameter the gauge reads at the end
    double remainingStock_mm = 0; ///< per side, from that reading; negative below target
    double peakNormalForce_n = 0;
    Place peakNormalForceAt;
    double peakPower_w = 0; ///< P_z·V_k
    Place peakPowerAt;
    std::optional<BurnVisit> burn; ///< present where a burn temperature rise is given
    long long visits = 0;
};

/// One revolution or stroke over one zone or section, with K visits, one for each radius.
struct Pass {
    Place place;
    double start_s = 0;           ///< time at which the pass begins
    double duration_s = 0;        ///< time of the pass
    double effectiveWidth_mm = 0; ///< b of the force law
    double axialFeed_mm_min = 0;  ///< S_ax of a traverse pass, 0 in plunge passes
    double radialFeed_mm = 0;     ///< programmed feed of the double stroke or revolution
    std::size_t firstVisit = 0;   ///< index of radius 0 in the visits; K follow
};

/// One radius under the wheel once.
struct Visit {
    double time_s = 0;
    double programmed_mm = 0;  ///< t_П at this radius, total
    double actual_mm = 0;      ///< a, depth of cut
    double accumulated_mm = 0; ///< Σa of this radius
    double radius_mm = 0;      ///< R_k of the part after the pass; NaN in a gap
    double normalForce_n = 0;  ///< P_y(a)
    double printed_mm = 0;     ///< c(φ_k): additional remaining stock in the machine's frame
    double wave_mm = 0;        ///< w, by which a wheel out of true stood nearer than t_П

    /// Returns whether the wheel passed a gap.
    [[nodiscard]] bool isGap() const { return std::isnan(radius_mm) && actual_mm == 0; }
};

/// Greatest number of visits that is recorded: each takes 64 bytes, and 130 more as a trace.
inline constexpr long long maxRecordedVisits = 2'000'000;

/// All passes and visits of a run; recorded only on request.
struct Trajectory {
    int radii = 0; ///< K
    std::vector<Pass> passes;
    std::vector<Visit> visits; ///< size passes · K
};

} // namespace sparkout
