// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace sparkout {

/// The cause of a trace's lack of fit.
enum class Unlike {
    drift, ///< the difference grows with time
    lag,   ///< proportional to the speed, or to changes of speed, of the trace
    stage, ///< misfit in one stage
    spike, ///< misfit in a few values
    other,
    count_
};

struct UnlikeCycle {
    Unlike kind = Unlike::other;
    int stage = -1; ///< index, from 0
};

/// For a trace whose residuals exceed noise, the cause that explains most of their squares; `other`
/// if none explains two fifths of the excess over the noise. `predicted`: at the same times;
/// `stageEnds_s`: in the time of the trace.
[[nodiscard]] UnlikeCycle unlikeOf(std::span<const double> time_s,
                                   std::span<const double> predicted,
                                   std::span<const double> residuals, double noiseVariance,
                                   const std::vector<double>& stageEnds_s);

} // namespace sparkout
