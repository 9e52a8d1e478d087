// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/shop_numbers.h"

#include <string>

namespace sparkout::cli {

/// The shop's numbers for people: a row a quantity, a column a stage and one for the cycle.
/// `revolutions`: they are counted, not double strokes.
[[nodiscard]] std::string shopText(const ShopNumbers& shop, bool revolutions);

} // namespace sparkout::cli
