// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"

#include <QCoreApplication>
#include <QPalette>
#include <QPen>
#include <QString>

#include <set>
#include <vector>

/// The magnified drawing of cross-sections.
namespace sparkout {

/// The radius from which the deviations of a profile are counted.
enum class RadiusReference { target, mean };

/// A circle of radius `reference` is drawn with radius `base`, deviations from it are magnified.
/// Base is R_t, so a magnification of 1 is the true shape.
struct PolarScale {
    double base_mm = 1;
    double reference_mm = 1;
    double magnification = 1;
    [[nodiscard]] double at(double radius_mm) const {
        return base_mm + magnification * (radius_mm - reference_mm);
    }
    [[nodiscard]] double radiusAt(double drawn) const {
        return reference_mm + (drawn - base_mm) / magnification;
    }
};

[[nodiscard]] PolarScale polarScale(const ProfileSeries& series, const Profile& profile,
                                    RadiusReference reference, double magnification);

/// The samples joined by straight chords and closed: K + 1 points, nothing between the samples.
[[nodiscard]] std::vector<ProfilePoint> closedLine(const std::vector<double>& radii_mm,
                                                   const PolarScale& scale);

/// A circle about its own centre, as deformed by the magnified drawing.
[[nodiscard]] std::vector<ProfilePoint> circleLine(const FittedCircle& circle,
                                                   const PolarScale& scale, int points = 180);

/// Its centre in the magnified drawing.
[[nodiscard]] ProfilePoint centrePoint(const RoundnessZone& zone, const PolarScale& scale);

/// Greatest deviations inwards and outwards from the reference, both ≥ 0.
struct Reach {
    double inward_mm = 0;
    double outward_mm = 0;
    void include(double deviation_mm);
};

/// Reach of the profiles with these indices.
[[nodiscard]] Reach reachOf(const ProfileSeries& series, const std::vector<int>& shown,
                            RadiusReference reference, bool withBlank);

/// The largest 1-2-5 number not above a positive one.
[[nodiscard]] double roundDown125(double value);
[[nodiscard]] double roundUp125(double value); ///< the smallest one not below

/// The largest 1-2-5 number with which all stays within 0.4…2 of the base circle, at most 10⁶.
[[nodiscard]] double suitableMagnification(const Reach& reach, double base_mm);

/// The 1-2-5 numbers from 1 on with which no sample is drawn through the centre.
[[nodiscard]] std::vector<double> possibleMagnifications(const Reach& reach, double base_mm);

/// The lines of the two plots of zone profiles; hiding one hides it in both.
enum class ProfileLine {
    profile,       ///< the cross-section; along the axis its mean
    spread,        ///< smallest…largest over the radii, along the axis
    blank,         ///< before the first touch
    target,        ///< R_t
    leastSquares,  ///< least-squares circle, in cross-sections
    minimumZone,   ///< two circles of the minimum zone, in cross-sections
    inscribed,     ///< maximum inscribed circle and the smallest one around the profile about its
                   ///< centre
    circumscribed, ///< minimum circumscribed circle and the largest one within the profile about
                   ///< its centre
    field,         ///< tolerance of the drawing
    gauge,         ///< position of the gauge along the axis
};
using ProfileLines = std::set<ProfileLine>;

/// The reference circles of the drawn and stated roundness.
enum class ReferenceCircles { leastSquares, minimumZone, inscribed, circumscribed, none };

/// Colours, dashes and names of those lines.
class ProfileLook {
    Q_DECLARE_TR_FUNCTIONS(ProfileLook)
public:
    static QPen pen(ProfileLine line, const QPalette& palette, bool dim = false);
    static QColor fill(ProfileLine line, const QPalette& palette, bool dim = false);
    static QString name(ProfileLine line);
};

} // namespace sparkout
