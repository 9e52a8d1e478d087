// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/profile_series.h"
#include "ui/charts/profiles_look.h"

#include <optional>

namespace sparkout {

/// A profile with the circles that are chosen, of the profile as a filter leaves it.
[[nodiscard]] Profile shownProfile(Profile profile, ReferenceCircles circles,
                                   std::optional<int> cutoff_upr);

/// The circles chosen; null: none are, or none are held.
[[nodiscard]] const RoundnessZone* shownZone(const Profile& profile, ReferenceCircles circles);

/// The line of the legend that stands for them.
[[nodiscard]] std::optional<ProfileLine> lineOf(ReferenceCircles circles);

} // namespace sparkout
