// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/part.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"
#include "core/surface/accuracy.h"
#include "core/surface/roundness.h"

#include <optional>
#include <vector>

/// The cross-sections of a run at any moment of its cycle.

namespace sparkout {

struct ProfilePoint {
    double x = 0, y = 0;
};

/// A circle of a cross-section; its centre is relative to the axis of rotation.
struct FittedCircle {
    double x_mm = 0;
    double y_mm = 0;
    double radius_mm = 0;
};

/// One zone or section at one moment of the cycle.
struct Profile {
    Zone zone = Zone::section;
    int section = 0;
    bool gauge = false;           ///< it has the gauge or is nearest to it
    double position_mm = 0;       ///< its middle, from the headstock end of the ground length
    double from_mm = 0;           ///< beginning of its part of the ground length
    double to_mm = 0;             ///< its end, from < to
    std::vector<double> radii_mm; ///< R_k, K values; not a number in a gap
    std::vector<double> blank_mm; ///< radii of its own blank; empty: those of the part
    double diameterMin_mm = 0;    ///< min of D_k less the nominal diameter
    double diameterMax_mm = 0;    ///< max of D_k less the nominal diameter
    double radialRunout_mm = 0;   ///< R_max − R_min plus the machine's geometric runout
    double mean_mm = 0;           ///< mean of the radii
    RoundnessZone leastSquares;
    RoundnessZone minimumZone; ///< after addMinimumZone()
    /// After addHeldCircles(); not given if the circle does not exist beside a wide gap.
    std::optional<RoundnessZone> inscribed, circumscribed;
};

/// All profiles of a run at one moment of its cycle.
struct ProfileSeries {
    Operation operation;
    Surface surface = Surface::external;
    double nominal_mm = 0;        ///< d
    double target_mm = 0;         ///< R_t
    double lowerLimit_mm = 0;     ///< radius at the lower deviation of the diameter
    double upperLimit_mm = 0;     ///< radius at the upper deviation
    double length_mm = 0;         ///< L_p
    double gauge_mm = 0;          ///< position of the gauge along the ground length
    std::vector<double> blank_mm; ///< the K radii of the part before the first touch
    std::vector<Profile> profiles;
    std::vector<Profile>
        zoneSections;                ///< at the end of the cycle, where zones have several sections
    std::vector<ZoneForm> zoneForms; ///< forms of those zones; empty: not computed
    int stroke = 0;         ///< number of the last double stroke or revolution; 0: the blank
    int strokeCount = 0;    ///< number of strokes of the whole cycle
    bool strokeDone = true; ///< false: the moment is within that stroke
    int stage = 0;          ///< stage of that stroke; 0: the blank, or not known
    double time_s = 0;      ///< from the start of the cycle
    /// Whether the machine's own runout, roundness and eccentricity are included.
    bool knowsRunout = true, knowsRoundness = true, knowsEccentricity = true;
    bool isWhole = true; ///< false: strips stay uncut, so the surface has no size and form

    /// Returns the K radii of a profile before the first touch.
    [[nodiscard]] const std::vector<double>& blankOf(const Profile& profile) const {
        return profile.blank_mm.empty() ? blank_mm : profile.blank_mm;
    }
    [[nodiscard]] int radii() const { return static_cast<int>(blank_mm.size()); }
    [[nodiscard]] bool atEnd() const { return stroke == strokeCount && strokeDone; }
};

/// Returns the profiles at a moment of the cycle; without one, or without a trajectory, at its end.
[[nodiscard]] ProfileSeries makeProfileSeries(const SimulationResult& result,
                                              const Trajectory& trajectory,
                                              const std::optional<Progress>& moment = {});

/// Finds the circles of the minimum zone by a search.
void addMinimumZone(Profile& profile);

/// Finds the maximum inscribed and the minimum circumscribed circle, each by a search.
void addHeldCircles(Profile& profile);

/// Replaces the radii of a profile by those after the Gaussian filter of roundness machines, and
/// recomputes its mean and least-squares circle; its diameters and its runout stay those of the
/// surface.
void filterProfile(Profile& profile, int cutoff_upr);

/// Returns a measured profile of K ≥ 4 radii at even angles.
[[nodiscard]] Profile measuredProfile(const ProfileSeries& series, std::vector<double> radii_mm);

/// Returns the index of the zone or section that has the gauge or is nearest to it.
[[nodiscard]] int gaugeProfile(const SimulationResult& result);

/// Returns whether a diameter of the profile is outside the drawing's tolerance by more than 1e-9
/// mm.
[[nodiscard]] bool outOfField(const ProfileSeries& series, const Profile& profile);

/// Returns the distance from the axis at which the ray at an angle meets a circle that contains the
/// axis, for e = (x, y): x·cos φ + y·sin φ + √(r² − (x·sin φ − y·cos φ)²) [mm].
[[nodiscard]] double radiusOf(const FittedCircle& circle, double angle);

[[nodiscard]] double angleOf(int k, int radii);           ///< φ_k = 2πk/K [rad]
[[nodiscard]] int nearestRadius(double angle, int radii); ///< k whose φ_k is nearest; any angle
[[nodiscard]] double diameterAt(const Profile& profile, int k); ///< R_k + R_{k+K/2} [mm]

// Lines of a run's profile along the axis, over the ground length.

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
