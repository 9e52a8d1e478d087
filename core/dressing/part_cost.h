// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstdint>
#include <optional>

namespace sparkout {

struct Cost;

/// What a part costs [GILBERT1950], in the currency of the rates:
///
///     C = C_m·(T + t_h + t_d/N) + C_d/N
///
/// C_m the rate of machine and operator, T the mean time of the cycle, t_h handling, t_d the time
/// and C_d the wheel and diamond of a dressing, N the parts between dressings; without N there is
/// no dressing.
[[nodiscard]] double partCost(const Cost& cost, double time_s, std::optional<std::int64_t> parts);

/// Those that the rates of a project give, else those of its batch's dullness; nothing: no
/// dressing.
[[nodiscard]] std::optional<std::int64_t> partsBetweenDressings(const Project& project);

/// By the rates of a project, with its partsBetweenDressings(). N then does not depend on the
/// cycle, and of a grid the quickest cycle is the cheapest. What the wear of a wheel makes of N is
/// in dressing_interval.h, and of the cheapest cycle in interval_search.h.
///
/// Nothing where the project gives no rates.
[[nodiscard]] std::optional<double> costPerPart(const Project& project, double time_s);

} // namespace sparkout
