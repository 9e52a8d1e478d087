// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// The second, deliberately plain implementation of the grinding cycle, for tests only: it shares
/// no code with core/, finds every depth of cut by bisection in long double and visits every radius
/// one after the other. Where the engine and this code differ, one of them misreads the process
/// model.
namespace sparkout::reference {

/// The state of one zone (traverse) or one section (plunge) when the cycle ended.
struct Place {
    std::vector<long double> radii_um;    ///< R_k less the nominal radius, none in a gap [µm]
    double diameter_deviation_min_um = 0; ///< smallest diameter less the nominal one [µm]
    double diameter_deviation_max_um = 0; ///< largest diameter less the nominal one [µm]
    double radial_runout_um = 0; ///< R_max − R_min plus the machine's geometric runout [µm]
};

/// What the passes of one stage of the cycle come to, added up visit by visit: each visit lasts its
/// share 1/K of the revolutions its pass takes.
struct StageSums {
    double volume_mm3 = 0; ///< Σ of (π·d/K)·a·(length of the zone, or of the section's slice)
    double energy_j = 0;   ///< Σ of P_z·V_k·(time of the visit)
    double grinding_min = 0;        ///< of its double strokes or revolutions
    double ground_mm = 0;           ///< Σ of the lengths of the passes
    double largest_depth_mm = 0;    ///< largest a
    double peak_normal_force_n = 0; ///< largest P_y
    double peak_power_w = 0;        ///< largest P_z·V_k
};

/// A limit of practice that a stage of the cycle is held against.
struct Practice {
    std::string name;
    int stage = 0; ///< from 1
    double least = 0, value = 0;
    bool holds = false;
};

struct Result {
    std::string status;   ///< "completed", "cannot_reach_size" or "too_long"
    long long passes = 0; ///< double strokes (traverse) or revolutions (plunge) [–]
    std::vector<long long> passes_by_stage; ///< the same, stage by stage [–]
    double time_min = 0;                    ///< cycle time [min]
    std::vector<StageSums> stages;          ///< one a stage of the cycle
    std::vector<Place> places; ///< traverse: РЗ1, НЗ, РЗ2; plunge: the sections from the headstock
    double peak_normal_force_n = 0; ///< largest P_y of a reported place [N]
    double peak_power_w = 0;        ///< largest P_z·V_k of a reported place [W]
    std::vector<Practice> practice; ///< overlaps stage by stage, then the steps of a stage
};

/// The depth of cut a [mm] with a + γ·b·(k_s·a + k_r·√a) = h, by bisection; 0 when h ≤ 0.
/// @param h programmed infeed less what is removed already [mm]
/// @param gamma compliance γ [mm/N]
/// @param b width of cut [mm]
/// @param k_s shear term [N/mm²]
/// @param k_r friction term [N/mm^1.5]
long double depthOfCut(long double h, long double gamma, long double b, long double k_s,
                       long double k_r);

/// Runs the cycle of a valid project in the form of the project file, compliances given in it.
/// Missing and null keys take the file's defaults.
Result simulate(const nlohmann::json& project);

} // namespace sparkout::reference
