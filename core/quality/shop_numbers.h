// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/simulation/result.h"

#include <optional>
#include <span>
#include <vector>

/// The figures by which a grinding shop judges a cycle, for each stage of the cycle and for the
/// whole of it [MODEL-7].
///
/// **Depth.** Q'_w, h_eq and aggressiveness are taken at the largest actual depth a of any pass,
/// per revolution (plunge) or stroke (traverse); the mean Q'_w at the mean of a over all passes,
/// weighted by their length, including passes without removal. S_ф = a·n.
///
/// **Passes.** A pass grinds the length ℓ of its zone or section at the effective width b: plunge ℓ
/// = L_p/J, b = L_p, so that J sections make one revolution; plunge passes of a reversal zone ℓ = b
/// = B − o; traverse passes ℓ = the zone's length, b = min(S_ax/n, B), because the table of MODEL-5
/// draws each zone as ground once by each stroke. It takes ℓ/b revolutions, so for the mean ⟨ ⟩
/// over the radii of a pass
///
///     volume   V = π·d·ℓ·⟨a⟩                      d nominal, as in V_d = π·d·n
///     energy   E = ∫P_z·V_k dt = ⟨P_z(a)⟩·V_k·ℓ/(b·n)
///     E/V at one depth = P_z(a)·V_k/(b·a·V_d)     b cancels: P_z is proportional to it
///
/// and a stage sums both over the same passes. V is the ring to first order: π(R0² − R1²)·ℓ differs
/// by the factor (R0 + R1)/d, half a percent for 0.15 mm of stock on 30 mm. The wheel grinds in
/// every revolution and stroke of a stage, so the grinding time is the stage's machining time, and
/// the mean power is E over it. A stroke takes the table travel/S_ax while it grinds all of L_p, B
/// − o1 − o2 more: at one depth its mean power is L_p/travel times that of a pass at b.
namespace sparkout {

/// Plausible specific energy of steel; a lower one suggests an error, a higher one a rubbing wheel
/// (as always late in a spark-out) [MODEL-7].
inline constexpr double leastSpecificEnergy_j_mm3 = 20;
inline constexpr double mostSpecificEnergy_j_mm3 = 120;

/// The figures of one stage of the cycle, or of all.
struct ShopColumn {
    int count = 0;     ///< double strokes or revolutions
    double time_s = 0; ///< time charged to the cycle: all of it is grinding
    double removedVolume_mm3 = 0;
    double energy_j = 0;
    Peak depth_mm;                      ///< largest a, at which the next three are taken
    double removalRate_mm2_s = 0;       ///< Q'_w = π·d·S_ф/60 [mm³/(mm·s)]
    double equivalentChip_um = 0;       ///< h_eq = Q'_w/V_k
    double aggressiveness = 0;          ///< 10⁶·(V_d/V_k)·√(a/D_e)
    double meanRemovalRate_mm2_s = 0;   ///< the mean Q'_w
    std::optional<double> overlap;      ///< B/s_ax, s_ax = S_ax/n; the least of a cycle's stages
    std::optional<double> energy_j_mm3; ///< specific energy E/V; empty if nothing is removed
    Peak power_w;                       ///< largest P_z·V_k of a pass
    double meanPower_w = 0;             ///< E over the time
    Peak normalForce_n;                 ///< largest P_y of a pass

    [[nodiscard]] BandSide specificEnergyBand() const;
    [[nodiscard]] BandSide overlapBand() const; ///< never above
};

/// The distance of a rotation ratio from the nearest whole number from 1 on.
[[nodiscard]] double distanceFromWhole(double rotationRatio);

struct ShopNumbers {
    std::vector<ShopColumn> stages; ///< one for each stage; zero if it did not run
    ShopColumn cycle;
    double wheelSpeed_rpm = 0;
    double rotationRatio = 0; ///< wheel rev/min : work rev/min

    /// Whether the ratio is within nearRatio of a whole number from 1 on.
    [[nodiscard]] bool ratioNearInteger() const;
};

[[nodiscard]] ShopNumbers shopNumbers(const SimulationResult& result);

/// V of the whole cycle alone [mm³].
[[nodiscard]] double removedVolume_mm3(const SimulationResult& result);

/// The outputs of a stage, or of the whole cycle.
[[nodiscard]] std::span<const Output<ShopColumn>> shopColumnOutputs();

/// The outputs common to all stages.
[[nodiscard]] std::span<const Output<ShopNumbers>> shopOutputs();

} // namespace sparkout
