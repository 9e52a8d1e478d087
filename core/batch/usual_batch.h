// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/batch.h"
#include "core/project/given_factors.h"

namespace sparkout {

/// Rounds to two significant digits.
[[nodiscard]] double toTwoDigits(double value);

/// Default range of a factor that scatters about its value, and of a dressing.
inline constexpr double leastUsualShare = 0.93, mostUsualShare = 1.07;
inline constexpr int usualPartsBetweenDressings = 25;

/// The usual scatter of a factor about the project's value, as a starting point. The stock scatters
/// as the turning before leaves it, by a quarter of IT10 of the turned diameter. The values of the
/// gauge's factors are estimates [MODEL-8]: three standard deviations in each direction for an
/// error that the machine states, an hour between settings, a part warmer or colder by 2 K
/// (standard deviation).
[[nodiscard]] Factor usualFactor(FactorKind kind, const Project& project);

/// The project with a usual batch: 50 parts whose stock, runout, dullness and compliance scatter,
/// and also the machine's form error where a runout is required, the gauge as far as its data are
/// known, and the part's temperature; only as far as every part is a valid project. 0.27 % may be
/// rejected, the share at P_pk 1: none of 50, one of 500. notCounted() lists what it leaves out.
[[nodiscard]] Project withUsualBatch(Project project);

} // namespace sparkout
