// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"

#include <vector>

/// Lines of a run's profile along the axis, over the ground length.
namespace sparkout {

/// The value drawn over the length.
enum class LengthQuantity {
    radius_um,   ///< R − R_t
    diameter_um, ///< D − d, from nominal
    radius_mm,   ///< R itself, for the shaft drawn to scale
};

/// A line over the length.
enum class LengthLine { lowerLimit, upperLimit, target, blankMin, blankMax, min, max, mean };
inline constexpr LengthLine lengthLines[] = {
    LengthLine::lowerLimit, LengthLine::upperLimit, LengthLine::target, LengthLine::blankMin,
    LengthLine::blankMax,   LengthLine::min,        LengthLine::max,    LengthLine::mean};

/// Smallest, mean and largest over the radii, or the diameters, of one cross-section.
struct LengthSpread {
    double min = 0, mean = 0, max = 0;
};
[[nodiscard]] LengthSpread spreadOf(const std::vector<double>& radii_mm,
                                    const ProfileSeries& series, LengthQuantity quantity);

/// Returns the profiles along the part: those of the series, or at the end of the cycle the
/// sections of zones with several sections.
[[nodiscard]] const std::vector<Profile>& alongThePart(const ProfileSeries& series);

/// Returns the value of a line at a zone or section.
[[nodiscard]] double lengthValue(const ProfileSeries& series, const Profile& profile,
                                 LengthLine line, LengthQuantity quantity);

/// Returns the points of a line. Limits, target and blank run over the whole ground length.
/// Traverse: a zone's value holds over the zone, with a step to the next. Plunge: the sections'
/// values at their middles, joined by straight lines. x never falls.
[[nodiscard]] std::vector<ProfilePoint> lengthLine(const ProfileSeries& series, LengthLine line,
                                                   LengthQuantity quantity);

/// Returns the index of the profile at a place along the ground length, that of the containing zone
/// or the nearest section; −1 without profiles.
[[nodiscard]] int profileAt(const ProfileSeries& series, double position_mm);

/// One step of the shaft, from the headstock end of the ground length on.
struct ShaftStep {
    double from_mm = 0;
    double to_mm = 0;
    double radius_mm = 0;
};

/// Returns the given steps of the shaft; none in internal grinding.
[[nodiscard]] std::vector<ShaftStep> shaftSteps(const Project& project);

} // namespace sparkout
