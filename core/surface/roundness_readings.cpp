// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/roundness_readings.h"

#include "core/surface/harmonics.h"
#include "core/surface/roundness.h"

namespace sparkout {

RoundnessReading roundnessReading(std::span<const double> radii_mm, std::optional<int> cutoff_upr) {
    const Directions directions(radii_mm.size());
    std::vector<double> profile(radii_mm.begin(), radii_mm.end());
    if (cutoff_upr) {
        profile = gaussianFiltered(radii_mm, directions, *cutoff_upr);
    }
    RoundnessReading reading;
    reading.cutoff_upr = cutoff_upr;
    reading.leastSquares = leastSquaresCircle(profile, directions);
    reading.minimumZone = minimumZoneCircles(profile, directions, reading.leastSquares);
    reading.inscribed = maximumInscribedCircle(profile, directions);
    reading.circumscribed = minimumCircumscribedCircle(profile, directions);
    return reading;
}

std::vector<RoundnessReading> roundnessReadings(std::span<const double> radii_mm) {
    std::vector<RoundnessReading> readings{roundnessReading(radii_mm, std::nullopt)};
    for (const int cutoff : roundnessCutoffs_upr) {
        readings.push_back(roundnessReading(radii_mm, cutoff));
    }
    return readings;
}

} // namespace sparkout
