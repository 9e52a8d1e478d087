// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

/// Phases of the stock that are tried, not decided: under position control, or beside what is.
namespace sparkout {

/// The project with stocks spread evenly over one infeed of each stage of its cycle around its own,
/// `phases` a stage, from a share of a phase on: where the last step falls decides on the size, and
/// corners alone miss it.
[[nodiscard]] std::vector<Project> stockPhases(const Project& project, int phases = 16,
                                               double from = 0);

/// Phases drawn for the last test of an answer.
inline constexpr int freshPhaseCount = 500;

/// The largest share of failing phases, with 95 % confidence, of the k-th cycle that was tried on
/// so many drawn independently for it, and failed in none. One with a share p of them meets none
/// with a chance of (1 − p)ⁿ ≤ e^(−p·n), but who tries cycle after cycle until one meets none gives
/// the bad ones a chance each. With p_k = ln(k·(k + 1)/0.05)/n the k-th has 0.05/(k·(k + 1)), and
/// Σ 1/(k·(k + 1)) = 1: all of them together, however many, have no more than 5 %, and each may be
/// chosen by what became of those before it.
[[nodiscard]] inline double mostFailing(int phases, int candidate) {
    constexpr double risk = 0.05;
    const double k = candidate;
    return std::min(std::log(k * (k + 1) / risk) / phases, 1.0);
}

/// One of `count` phases in which the project's cycle fails, the one by most; nothing: none. The
/// phases are independent and even over one infeed of each stage around the stock; other ones for
/// every draw. A stop ends it with what it has: nothing then does not mean that it holds in all.
[[nodiscard]] std::optional<Project> failingPhase(const Project& best, std::uint32_t draw,
                                                  const std::stop_token& stop = {},
                                                  int count = freshPhaseCount);

} // namespace sparkout
