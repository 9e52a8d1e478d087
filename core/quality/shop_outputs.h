// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/shop_numbers.h"
#include "core/result.h"

#include <span>

namespace sparkout {

/// The outputs of a stage, or of the whole cycle.
[[nodiscard]] std::span<const Output<ShopColumn>> shopColumnOutputs();

/// The outputs common to all stages.
[[nodiscard]] std::span<const Output<ShopNumbers>> shopOutputs();

} // namespace sparkout
