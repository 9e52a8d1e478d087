// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstdint>
#include <optional>

namespace sparkout {

struct Cost;

/// The cost of a part [GILBERT1950], in the currency of the rates:
///
///     C = C_m·(T + t_h + t_d/N) + C_d/N
///
/// C_m the rate of machine and operator, T the mean time of the cycle, t_h handling, t_d the time
/// and C_d the wheel and diamond of a dressing, N the parts between dressings; without N there is
/// no dressing.
[[nodiscard]] double partCost(const Cost& cost, double time_s, std::optional<std::int64_t> parts);

/// The number given by the rates of a project, otherwise by its batch's dullness; empty: no
/// dressing.
[[nodiscard]] std::optional<std::int64_t> partsBetweenDressings(const Project& project);

/// By the rates of a project, with its partsBetweenDressings(). N then does not depend on the
/// cycle, and the quickest cycle of a grid is the cheapest. N by the wheel's wear is in
/// dressing_interval.h, the cheapest cycle in interval_search.h.
///
/// Empty if the project has no rates.
[[nodiscard]] std::optional<double> costPerPart(const Project& project, double time_s);

} // namespace sparkout
