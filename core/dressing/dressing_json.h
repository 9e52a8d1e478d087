// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dressing/dressing_interval.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>

namespace sparkout {

/// The quickest and the cheapest interval between dressings; neither without rates of cost.
struct BestIntervals {
    std::optional<BestInterval> quickest, cheapest;
};
[[nodiscard]] BestIntervals bestIntervals(const Setup& setup, const DressingInterval& interval);

/// The part that ends an interval.
struct WornFailureOf {
    const Setup& setup;
    const WornFailure& failure;
};

[[nodiscard]] std::span<const Output<DressingInterval>> dressingOutputs();
[[nodiscard]] std::span<const Output<WornFailureOf>> wornFailureOutputs();
[[nodiscard]] std::span<const Output<BestInterval>> quickestIntervalOutputs();
[[nodiscard]] std::span<const Output<BestInterval>> cheapestIntervalOutputs();

/// The object of `dressing --json`.
[[nodiscard]] std::string dressingJson(const Setup& setup, const DressingInterval& interval);

} // namespace sparkout
