// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

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
    notSolved,       ///< the balance of coupled sections did not converge
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

/// One zone or section at the end of the cycle.
struct SectionResult {
    Zone zone = Zone::section;
    double position_mm = 0;             ///< its middle, from the headstock end of the ground length
    double compliance_mm_per_n = 0;     ///< γ used
    std::vector<double> radii_mm;       ///< R_k, K values
    double diameterDeviationMin_mm = 0; ///< min of D_k less the nominal diameter
    double diameterDeviationMax_mm = 0; ///< max of D_k less the nominal diameter
    double radialRunout_mm = 0;         ///< R_max − R_min plus the machine's geometric runout
    double peakNormalForce_n = 0;       ///< largest P_y any of its radii saw
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
    std::vector<SectionResult> sections; ///< РЗ1, НЗ, РЗ2, or the sections from the headstock on
    double gaugeReading_mm = 0;          ///< diameter the gauge reads at the end
    double remainingStock_mm = 0;        ///< per side, from that reading; negative below target
    double peakNormalForce_n = 0;
    Place peakNormalForceAt;
    double peakPower_w = 0; ///< P_z·V_k
    Place peakPowerAt;
    long long visits = 0;
};

} // namespace sparkout
