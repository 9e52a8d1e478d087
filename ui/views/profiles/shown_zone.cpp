// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/shown_zone.h"

namespace sparkout {

Profile shownProfile(Profile profile, ReferenceCircles circles, std::optional<int> cutoff_upr) {
    if (cutoff_upr) {
        filterProfile(profile, *cutoff_upr);
    }
    if (circles == ReferenceCircles::minimumZone) {
        addMinimumZone(profile);
    } else if (circles == ReferenceCircles::inscribed
               || circles == ReferenceCircles::circumscribed) {
        addHeldCircles(profile);
    }
    return profile;
}

const RoundnessZone* shownZone(const Profile& profile, ReferenceCircles circles) {
    const auto held = [](const std::optional<RoundnessZone>& zone) {
        return zone ? &*zone : nullptr;
    };
    switch (circles) {
    case ReferenceCircles::leastSquares: return &profile.leastSquares;
    case ReferenceCircles::minimumZone: return &profile.minimumZone;
    case ReferenceCircles::inscribed: return held(profile.inscribed);
    case ReferenceCircles::circumscribed: return held(profile.circumscribed);
    case ReferenceCircles::none: break;
    }
    return nullptr;
}

std::optional<ProfileLine> lineOf(ReferenceCircles circles) {
    switch (circles) {
    case ReferenceCircles::leastSquares: return ProfileLine::leastSquares;
    case ReferenceCircles::minimumZone: return ProfileLine::minimumZone;
    case ReferenceCircles::inscribed: return ProfileLine::inscribed;
    case ReferenceCircles::circumscribed: return ProfileLine::circumscribed;
    case ReferenceCircles::none: break;
    }
    return std::nullopt;
}

} // namespace sparkout
