// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/roundness.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Roundness readings as measuring machines report them [ISO12181, ISO16610-21].
namespace sparkout {

/// Usual cut-offs of the low-pass filter [undulations per revolution].
inline constexpr std::array<int, 3> roundnessCutoffs_upr{15, 50, 150};

/// A closed profile after one filter, about each of the four reference circles.
struct RoundnessReading {
    std::optional<int> cutoff_upr;              ///< not given: not filtered
    RoundnessZone minimumZone;                  ///< MZC
    RoundnessZone leastSquares;                 ///< LSC
    std::optional<RoundnessZone> inscribed;     ///< MIC
    std::optional<RoundnessZone> circumscribed; ///< MCC; both are undefined with wide gaps
};

[[nodiscard]] RoundnessReading roundnessReading(std::span<const double> radii_mm,
                                                std::optional<int> cutoff_upr);

/// Not filtered, then by each of the cut-offs. K ≥ 4 radii at even angles.
[[nodiscard]] std::vector<RoundnessReading> roundnessReadings(std::span<const double> radii_mm);

/// The highest number of undulations that K radii resolve: a filter with a cut-off near it or above
/// reads an undersampled form.
[[nodiscard]] inline int resolvedUndulations(std::size_t radii) {
    return static_cast<int>(radii / 2);
}

} // namespace sparkout
