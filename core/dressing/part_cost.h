// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <optional>

namespace sparkout {

/// What a part costs [GILBERT1950], in the currency of the project's rates:
///
///     C = C_m·(T + t_h + t_d/N) + C_d/N
///
/// C_m the rate of machine and operator, T the cycle's time, t_h handling, t_d the time and C_d the
/// wheel and diamond of a dressing, N the parts between dressings: given, else those of the batch's
/// dullness, else there is no dressing. How long a wheel lasts is not derived from the cycle by the
/// model (MODEL-8 has dullness as an input), so N does not depend on it, C grows with T alone, and
/// of a grid the quickest cycle is the cheapest: the cost is reported, not searched.
///
/// Nothing where the project gives no rates.
[[nodiscard]] std::optional<double> costPerPart(const Project& project, double time_s);

} // namespace sparkout
