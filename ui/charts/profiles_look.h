// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPalette>
#include <QPen>
#include <QString>

#include <set>

namespace sparkout {

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
