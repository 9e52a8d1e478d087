// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>

namespace sparkout {

enum class Control { gauge, position };
enum class GaugeRule { min, mean, max };

/// The event that ends a stage: a command of the in-process gauge, or the wheel head's position.
struct Gauge {
    Control control = Control::gauge;
    GaugeRule rule = GaugeRule::min;
    std::optional<int> section;        ///< 0-based plunge section; not given: the middle one
    std::optional<double> position_mm; ///< free position along the ground length [mm]
    std::optional<double> compliance_mm_per_n; ///< γ at the free position [mm/N]
    std::optional<double> datum_mm; ///< R − R_t from which the feed counts, position control [mm]
    bool spans_gaps = true;         ///< reads across the gaps of an interrupted surface
    int commands = 5;               ///< stages the gauge can switch
    std::optional<double> delay_s;  ///< not given: that of the machine's gauge, gaugeDelay_s() [s]
    double error_um = 0;            ///< e_g, error of the gauge: reading less true diameter [µm]
    double part_warmer_k = 0;       ///< ΔT, part at the gauge above its setting temperature [K]
};

/// τ_g, the delay from the gauge's reading to its command [s]: as given, else that of the machine's
/// gauge, else 0.
[[nodiscard]] double gaugeDelay_s(const Project& project);
/// The excess of the gauge's reading over the true diameter [mm]: e_g + α·d·ΔT [MODEL-7].
[[nodiscard]] double readsTooLarge_mm(const Project& project);
/// How much deeper than the target the radii are when the gauge reads the size [mm]: half the
/// excess of the reading, negative in a bore.
[[nodiscard]] double deeperAtSize_mm(const Project& project);

template <>
std::span<const Choice> choicesOf<Control>();
template <>
std::span<const Choice> choicesOf<GaugeRule>();
template <>
const StructInfo& tableOf<Gauge>();

} // namespace sparkout
