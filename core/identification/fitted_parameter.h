// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <optional>
#include <vector>

namespace sparkout {

/// Parameters that can be fitted to measurements [MODEL-13]. In the balance of a pass, D = a + α·a
/// + β·√a, α = γ·b·k_s and β = γ·b·k_r; the wheel's power is idle + b·k_t·V_k·a + b·μ·k_r·V_k·√a,
/// the normal force b·k_s·a + b·k_r·√a. With a threshold [MODEL-2] α is the factor of K and β that
/// of F'_0, also in the normal force, and flow stress and dullness are not fitted.
enum class FittedKind {
    alpha,          ///< factor of α only
    beta,           ///< factor of β only
    compliance,     ///< factor of γ: of α and β; of one zone or section, or of all
    flow_stress,    ///< factor of σ_i: of k_s, k_r and k_t
    dullness,       ///< factor of η: of k_r
    chip_power,     ///< factor of b·k_t·V_k
    friction_power, ///< factor of b·μ·k_r·V_k
    idle_power,     ///< [kW]
    size_offset,    ///< offset of the gauge's zero [mm of diameter]
    time_shift,     ///< beginning of the cycle in the traces [s]
    power_delay,    ///< delay of the power behind the other traces [s]
    force_delay,    ///< delay of the normal force behind the other traces [s]
    blank_runout,   ///< ΔR of the blank [mm]
    gauge_lag,      ///< time constant of the gauge, a first-order lag [s]
    gauge_drift,    ///< drift of the gauge over the time of the cycle [mm/min]
    gauge_setting,  ///< diameter at which the gauge ends the cycle [mm]; for finished parts
    count_
};

/// Prior knowledge: a mean and its standard deviation, in the unit of the parameter.
struct Prior {
    double mean = 1, deviation = 1;
    friend bool operator==(const Prior&, const Prior&) = default;
};

struct FittedParameter {
    FittedKind kind = FittedKind::alpha;
    std::optional<int> place; ///< zone or section of a compliance; not given: all
    std::optional<Prior> prior;
    friend bool operator==(const FittedParameter&, const FittedParameter&) = default;
};

/// Whether it multiplies an input: then its logarithm is fitted, it stays positive and begins at 1.
[[nodiscard]] bool isFactor(FittedKind kind);
/// Whether it is a factor on which the depths of cut depend.
[[nodiscard]] bool actsOnDepths(FittedKind kind);
/// Whether it is a property of the recorder: offset, times, lag and drift.
[[nodiscard]] bool isOfRecorder(FittedKind kind);
/// Whether it is an input of the project; the others belong to the traces.
[[nodiscard]] bool isInput(FittedKind kind);
/// The distance of a parameter from its value beyond which it counts as unknown: a ratio for a
/// factor and the runout, otherwise a difference in its unit.
[[nodiscard]] double plausibleRange(FittedKind kind);
/// The key on the command line and in JSON, "time_shift".
[[nodiscard]] const char* keyOf(FittedKind kind);

/// Whether all these parameters apply to the project, and none is given twice: compliances only of
/// places with their own, no runout of a measured blank, no α and β of a wheel contact.
[[nodiscard]] bool areApplicable(const Project& project, const std::vector<FittedParameter>& list);

} // namespace sparkout
