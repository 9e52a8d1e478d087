// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/project/given_factors.h"

namespace sparkout {

/// To two digits, as a person would write it.
[[nodiscard]] double toTwoDigits(double value);

/// Of a value that scatters about itself, and of a dressing, where nothing else is said.
inline constexpr double leastUsualShare = 0.93, mostUsualShare = 1.07;
inline constexpr int usualPartsBetweenDressings = 25;

/// How a factor usually scatters about the project's own value of it, to start from. The numbers of
/// the gauge's factors are estimates [MODEL-8]: three standard deviations either way of an error
/// that the machine states, an hour from one setting of it to the next, a part warmer or colder by
/// 2 K (standard deviation).
[[nodiscard]] Factor usualFactor(FactorKind kind, const Project& project);

/// The project with a usual batch: 50 parts whose stock, runout, dullness and compliance scatter,
/// as do what the machine prints, where a runout is required, the gauge, as far as the machine's is
/// known, and the part's temperature at it; as far as every one of them is a valid project. 0.27 %
/// may be bad, the share of P_pk 1: none of the 50, one of 500. What it leaves out notCounted()
/// says.
[[nodiscard]] Project withUsualBatch(Project project);

} // namespace sparkout
