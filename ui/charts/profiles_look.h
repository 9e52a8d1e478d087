// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPalette>
#include <QPen>
#include <QString>

#include <set>

namespace sparkout {

/// What the two plots of the zone profiles draw; each can be hidden in both at once.
enum class ProfileLine {
    profile,       ///< the cross-section; along the axis its mean
    spread,        ///< smallest…largest over the radii, along the axis
    blank,         ///< before the first touch
    target,        ///< R_t
    leastSquares,  ///< least-squares circle, across the axis
    minimumZone,   ///< the two circles of the minimum zone, across the axis
    inscribed,     ///< maximum inscribed circle and the one about its centre that holds all
    circumscribed, ///< minimum circumscribed circle and the one about its centre within all
    field,         ///< tolerance band of the drawing
    gauge,         ///< where the gauge stands, along the axis
};
using ProfileLines = std::set<ProfileLine>;

/// The reference circles of the roundness that are drawn and stated.
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
