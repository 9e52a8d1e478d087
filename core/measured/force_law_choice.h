// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

/// Which of the two force laws a recorded spark-out of a plunge supports [MODEL-2, MODEL-13].
///
/// From revolution to revolution the deflection D decreases by the cut, D_m = D_{m−1} − a_m:
///
///     sources     (1 + α)·a + β·√a = D_{m−1},  α = γ·b·k_s,  β = γ·b·k_r
///     threshold   D_m = D_∞ + (D_0 − D_∞)·r^m
///
/// and the size is s_∞ + 2·D. The first falls as 1/m in the long run, the second ends: they diverge
/// with time. With β = 0 the first is an exponential too; β/α is therefore limited to k_r/k_s of
/// the project for a dullness within its usual range. Both are fitted by least squares and compared
/// by Akaike's criterion, n·ln(RSS/n) + 2·k with n the number of independent readings, by the
/// correlation of neighbouring residuals [AKAIKE1974]. A difference of 6, one to twenty, decides.
namespace sparkout {

enum class SupportedLaw { sources, threshold, undecided };

struct SparkOutRecord {
    double revolution_s = 0;
    std::vector<double> time_s;  ///< times of the readings from the end of the infeed, rising
    std::vector<double> size_mm; ///< diameter, or its difference to another one
};

struct ForceLawChoice {
    SupportedLaw supported = SupportedLaw::undecided;
    double aicDifference = 0;                      ///< sources' law less the law with a threshold
    double sourcesRms_um = 0, thresholdRms_um = 0; ///< residuals of each law
    double timeConstant_s = 0; ///< −T/ln r of the threshold, T the time of a revolution
    int revolutions = 0;       ///< recorded ones
    std::size_t readings = 0;
    /// Undecided: this many more would decide, whichever law is true; empty: not within 500.
    std::optional<int> revolutionsMore;
};

/// Empty if fewer than 4 revolutions or 8 readings are recorded, or if the size does not change.
[[nodiscard]] std::optional<ForceLawChoice> chooseForceLaw(const Project& project,
                                                           const SparkOutRecord& record,
                                                           const std::stop_token& stop = {});

/// The spark-out of this many steps at the end of a recorded plunge, in the first trace of the size
/// at the gauge, in which the cycle begins at `begin_s`; empty if there is none.
[[nodiscard]] std::optional<SparkOutRecord>
sparkOutOf(const Project& project, const std::vector<int>& stepsByStage, double begin_s);

} // namespace sparkout
