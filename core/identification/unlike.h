// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace sparkout {

/// What a trace has that the cycle that was run has not.
enum class Unlike {
    drift, ///< the difference grows with time
    lag,   ///< it follows how fast, or how suddenly, the trace changes
    stage, ///< it lies in one stage
    spike, ///< it lies in a few values
    other,
    count_
};

struct UnlikeCycle {
    Unlike kind = Unlike::other;
    int stage = -1; ///< its number, from 0
};

/// Of the residuals of a trace that leave more than noise, the one cause that takes away most of
/// their squares; `other` where none takes away two fifths of what is more than the noise.
/// `predicted`: at the same times; `stageEnds_s`: in the time of the trace.
[[nodiscard]] UnlikeCycle unlikeOf(std::span<const double> time_s,
                                   std::span<const double> predicted,
                                   std::span<const double> residuals, double noiseVariance,
                                   const std::vector<double>& stageEnds_s);

} // namespace sparkout
