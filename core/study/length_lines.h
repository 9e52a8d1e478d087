// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"

#include <vector>

/// The profile of a run along the axis: its lines over the ground length.
namespace sparkout {

/// The value drawn over the length.
enum class LengthQuantity {
    radius_um,   ///< R − R_t
    diameter_um, ///< D − d, from nominal
    radius_mm,   ///< R itself, for the shaft drawn to scale
};

/// One line over the length.
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

/// What lines along the part go through: the profiles, or at the end of the cycle the sections of
/// zones that hold several.
[[nodiscard]] const std::vector<Profile>& alongThePart(const ProfileSeries& series);

/// Height of a line at a zone or section.
[[nodiscard]] double lengthValue(const ProfileSeries& series, const Profile& profile,
                                 LengthLine line, LengthQuantity quantity);

/// Limits, target and blank run over the whole ground length. Traverse: a zone's value is held over
/// the zone, with a step to the next. Plunge: the sections' values at their middles, joined by
/// straight lines. x never falls.
[[nodiscard]] std::vector<ProfilePoint> lengthLine(const ProfileSeries& series, LengthLine line,
                                                   LengthQuantity quantity);

/// The profile at a place along the ground length, −1 without any: the zone that holds it, the
/// nearest section.
[[nodiscard]] int profileAt(const ProfileSeries& series, double position_mm);

/// One step of the shaft, from the headstock end of the ground length on.
struct ShaftStep {
    double from_mm = 0;
    double to_mm = 0;
    double radius_mm = 0;
};

/// The segments of the shaft as far as they are given; none in internal grinding.
[[nodiscard]] std::vector<ShaftStep> shaftSteps(const Project& project);

} // namespace sparkout
