// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

/// What the reference simulation reads from a project, and carries from pass to pass.
namespace sparkout::reference {

using Real = long double;

inline constexpr Real pi = std::numbers::pi_v<Real>;

enum class StageEnd { Threshold, Count, Size }; // Count and Size are spark-out stages

/// A stage as the cycle runs it.
struct Stage {
    Real radial_feed = 0; // traverse: mm per double stroke; plunge: mm/min; spark-out: 0
    Real axial_feed = 0;  // mm/min, traverse only
    Real continuous = 0;  // S_c [mm/min], traverse only
    Real stock = 0;       // Π_z [mm]
    StageEnd end = StageEnd::Threshold;
    int count = 0; // length of a spark-out by count
};

/// A zone or a section: all it carries from pass to pass is its radii.
struct Body {
    Real gamma = 0;           // γ [mm/N]
    std::vector<Real> radius; // R_k [mm]
    bool reported = true;     // false: the extra section of a gauge in a free position
    Real length = 0;          // of the surface it stands for [mm]
    Real middle = 0;          // from the entry end, traverse only [mm]
    bool counted = true;      // false: the middle of a zone that holds several sections
    int zone = 0;             // that it is in, traverse only
};

/// What a stage adds up to; energy in N·m, time in min.
struct Sums {
    Real volume = 0, energy = 0, time = 0, ground = 0;
    Real a = 0, P_y = 0, P_z = 0; // the largest
};

/// What the gauge read after a pass.
struct Reading {
    Real time = 0;  // when the pass ended [min]
    Real stock = 0; // Π_rem [mm]
};

/// The inputs of a cycle, and how far it has come.
struct Cycle {
    // the inputs
    bool traverse = false;
    bool internal = false;
    Real d = 0, R_t = 0;                    // nominal diameter, target radius [mm]
    Real R_max0 = 0, R_min0 = 0;            // largest and smallest radius of the blank [mm]
    int K = 0;                              // radii per section
    std::vector<bool> gap;                  // of the radii: no surface is there
    Real length = 0, B = 0, o1 = 0, o2 = 0; // [mm]
    Real n = 0;                             // [rev/min]
    Real S_rad = 0;                         // plunge-in feed [mm/min]
    Real V_k = 0;                           // [m/s]
    bool threshold = false;                 // of the force
    Real k_s = 0, k_r = 0;    // normal force [N/mm², N/mm^1.5]; with a threshold K and F'_0 [N/mm]
    Real z_s = 0, z_r = 0;    // tangential force, the same way
    long long N1 = 0, N2 = 0; // dwells [rev]
    int zone_sections = 1;
    Real entry_share = 1; // of S_t that is fed at the entry, the rest at the exit
    bool position_control = false;
    Real wear = 0; // of the wheel's radius, which the position control does not know of [mm]
    Real e = 0, L = 1, n_k = 0, psi_0 = 0;          // the wheel's runout [mm, -, rev/min, rad]
    Real speed_variation = 0, variation_period = 0; // of the work speed [-, min]
    std::string rule;
    Real geometric_runout_um = 0;
    std::vector<Stage> stages;
    std::size_t gauge = 0;                          // the body that carries the gauge
    Real gauge_delay = 0, feed_change_delay = 0;    // [s]
    Real least_overlap = 0, least_overlap_last = 0; // 0: not required
    long long least_steps = 0;                      // 0: not required

    // the state
    std::vector<Body> bodies;
    Real t_P = 0;      // accumulated programmed infeed [mm]
    std::size_t z = 0; // the stage
    int passes_in_stage = 0;
    Real largest_removal = 0; // since the pass (double stroke or revolution) began [mm]
    int idle_revolutions = 0;
    long long visits = 0;
    Real peak_P_y = 0, peak_P_z = 0; // [N]
    Real time = 0;                   // [min]
    Real clock = 0;                  // the same, also within a double stroke [min]
    std::vector<Sums> sums;          // stage by stage
    std::vector<Reading> readings;   // pass by pass
};

/// The cycle of a project before its first pass.
Cycle readCycle(const nlohmann::json& project);

} // namespace sparkout::reference
