// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

/// Phases of the stock that are sampled, not decided: under position control, or in addition to a
/// decision.

namespace sparkout {

/// Result of a trial of a project's cycle.
struct CycleTrial {
    bool holds = false; ///< it ends by itself and meets every requirement
    double leastMargin =
        -std::numeric_limits<double>::infinity(); ///< relative margin; −∞: the cycle does not end
    double removed_mm3 = 0;                       ///< removed volume, if the cycle ends
};

/// Tries the cycle of a valid project; returns nullopt after a stop.
[[nodiscard]] std::optional<CycleTrial> tried(const Project& project, const std::stop_token& stop);

/// Returns the project with stocks distributed evenly over one infeed of each stage around its own
/// stock, `phases` for each stage, starting at a share `from` of a phase: the size depends on where
/// the last step falls, which corners alone do not cover.
[[nodiscard]] std::vector<Project> stockPhases(const Project& project, int phases = 16,
                                               double from = 0);

/// Number of phases drawn for the last test of an answer.
inline constexpr int freshPhaseCount = 500;

/// Returns the largest share of failing phases, with 95 % confidence, of the k-th cycle that was
/// tried on `phases` phases drawn independently for it and failed in none. A cycle with a share p
/// of failing phases passes with a probability of (1 − p)ⁿ ≤ e^(−p·n), but trying cycle after cycle
/// until one passes gives each bad one a chance. With p_k = ln(k·(k + 1)/0.05)/n the k-th has
/// 0.05/(k·(k + 1)), and Σ 1/(k·(k + 1)) = 1: all of them together, however many, have at most 5 %,
/// and each may be chosen by the results of those before it.
[[nodiscard]] inline double mostFailing(int phases, int candidate) {
    constexpr double risk = 0.05;
    const double k = candidate;
    return std::min(std::log(k * (k + 1) / risk) / phases, 1.0);
}

/// Returns the worst of the failing phases among `count` phases; nullopt if none fails. The phases
/// are independent and uniform over one infeed of each stage around the stock, and differ with
/// `draw`. After a stop it returns the worst found; nullopt then does not mean that the cycle is
/// fit in all.
[[nodiscard]] std::optional<Project> failingPhase(const Project& best, std::uint32_t draw,
                                                  const std::stop_token& stop = {},
                                                  int count = freshPhaseCount);

} // namespace sparkout
