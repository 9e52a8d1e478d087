// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// Parts drawn for the last test of a cycle: if none of them is bad, at most mostFailing() of all
/// are, with 95 % confidence.
inline constexpr int freshPartCount = 500;

/// The project with a batch of so many parts, drawn at random and independently; each `draw` from 1
/// on gives different parts, and none gives those of the batch itself.
[[nodiscard]] Project withFreshParts(Project project, int draw, int count = freshPartCount);

} // namespace sparkout
