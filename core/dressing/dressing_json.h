// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/dressing_interval.h"

#include <optional>
#include <string>

namespace sparkout {

/// After how many parts dressing is quickest and cheapest; neither without rates of cost.
struct BestIntervals {
    std::optional<BestInterval> quickest, cheapest;
};
[[nodiscard]] BestIntervals bestIntervals(const Setup& setup, const DressingInterval& interval);

/// The object of `dressing --json`.
[[nodiscard]] std::string dressingJson(const Setup& setup, const DressingInterval& interval);

} // namespace sparkout
