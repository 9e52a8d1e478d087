// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"
#include "ui/charts/profiles_look.h"

#include <optional>

namespace sparkout {

/// A filtered profile with the chosen circles.
[[nodiscard]] Profile shownProfile(Profile profile, ReferenceCircles circles,
                                   std::optional<int> cutoff_upr);

/// The chosen circles; null if none are chosen or none are fitted.
[[nodiscard]] const RoundnessZone* shownZone(const Profile& profile, ReferenceCircles circles);

/// The circles' line in the legend.
[[nodiscard]] std::optional<ProfileLine> lineOf(ReferenceCircles circles);

} // namespace sparkout
