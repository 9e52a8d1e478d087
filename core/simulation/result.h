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

/// The steps E1…E5 of a double stroke as a zone sees them; plunge passes have none.
enum class Step { none, e1, e2, e3, e4, e5 };

enum class RunStatus {
    completed,
    cannotReachSize, ///< no progress, and nothing more to come
    tooLong,         ///< more visits than maxVisits
    stopped,         ///< by a stop request
    notSolved,       ///< coupled sections: the balance did not converge; else: a compliance is < 0
    groundAway,      ///< a radius of the part has come to 0: nothing of it is left
    refused,         ///< validate() finds errors in the project: nothing was run
};

/// A run ends as tooLong beyond this number of visits (one radius under the wheel once).
inline constexpr long long maxVisits = 50'000'000;

/// Where in the cycle something happened; numbers count from 1, sections from 0.
struct Place {
    Zone zone = Zone::section;
    Step step = Step::none;
    int section = 0;    ///< plunge: index of the section
    int stage = 0;      ///< stage of the cycle
    int cycleCount = 0; ///< double stroke (traverse) or revolution (plunge)
    int revolution = 0; ///< revolution within the step (traverse)
};

/// The largest value of something over the passes, and where it was first reached.
struct Peak {
    double value = 0;
    Place at;
};

/// What the passes of one stage of the cycle add up to, from which core/quality makes volume,
/// energy and power. A pass is one zone or section under the wheel once: ℓ the length of surface it
/// stands for (its zone, or its slice L_p/J), b its effective width, ⟨ ⟩ the mean over its K radii.
/// A gauge's free position counts for nothing.
struct StageSums {
    double length_mm = 0;       ///< Σℓ
    double removed_mm2 = 0;     ///< Σℓ·⟨a⟩: longitudinal section of what is removed
    double rootLength_mm15 = 0; ///< Σℓ·⟨√a⟩, for the friction term of P_z [mm^1.5];
                                ///< Σℓ·⟨v⟩ [mm] with a threshold
    Peak depth_mm;              ///< largest a, per revolution or stroke
    Peak normalForce_n;         ///< largest P_y
    Peak power_w;               ///< largest P_z·V_k
};

/// What the roughness of a zone or section comes from: what the last step with infeed, a revolution
/// or double stroke, took off the radius that lost most by it, and the spark-out after it. A step
/// that position control cuts short counts where it took more than the one before. What no step
/// with infeed has cut has its first step without one here.
struct LastCut {
    double depth_mm = 0;   ///< a, taken by all passes of the step
    double overlap = 1;    ///< u, revolutions that the wheel takes over a point in a stroke
    double pressed_mm = 0; ///< h, what the step had to take: a and the deflection that it left
    double step_s = 0;     ///< T, time of the step
    double sparkOut_s = 0; ///< t, of all steps after the last with infeed
    int radius = 0;        ///< k
    Place at;              ///< the first of these passes
};

/// The visit nearest to burning: the largest a over the depth that is just allowed.
struct BurnVisit {
    double depth_mm = 0; ///< a
    double stock_mm = 0; ///< max(0, R_k after the pass − R_t): what the damaged layer may reach
    int radius = 0;      ///< k
    Place at;
};

/// Mean of the radii that are numbers: those in gaps are none.
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

/// Diameters of a zone or section less the nominal one [mm].
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
    double radialRunout_mm = 0;         ///< R_max − R_min and what the machine adds as a number
    double peakNormalForce_n = 0;       ///< largest P_y any of its radii saw
    std::optional<LastCut> lastCut;     ///< where a roughness is required
};

/// What came out of one cycle. A value; it says which inputs it belongs to.
struct SimulationResult {
    Project project;           ///< the inputs as run, without kept runs
    std::string engineVersion; ///< of the program that ran it
    RunStatus status = RunStatus::completed;
    double time_s = 0;
    int cycleCount = 0;             ///< double strokes or revolutions
    std::vector<int> countsByStage; ///< the same, by stage
    std::vector<double> timeByStage_s;
    std::vector<StageSums> sumsByStage;
    std::vector<SectionResult> sections; ///< РЗ1, НЗ, РЗ2, or the sections from the headstock on
    /// Where a zone holds several, its sections zone by zone from the entry on. The zone itself
    /// then has the radii of its middle and of all else the worst.
    std::vector<SectionResult> zoneSections;
    /// Of each zone or section, where the number of the lobes that the machine prints is not known:
    /// the diameters with two of them. All else is of three, which leave diameters as they are.
    std::vector<DeviationRange> ifEven;
    double gaugeReading_mm = 0;   ///< diameter the gauge reads at the end
    double remainingStock_mm = 0; ///< per side, from that reading; negative below target
    double peakNormalForce_n = 0;
    Place peakNormalForceAt;
    double peakPower_w = 0; ///< P_z·V_k
    Place peakPowerAt;
    std::optional<BurnVisit> burn; ///< where a rise that burns is given
    long long visits = 0;
};

} // namespace sparkout
