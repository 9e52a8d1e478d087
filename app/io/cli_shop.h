// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/shop_numbers.h"

#include <string>

namespace sparkout::cli {

/// The shop's figures as text: a row for each quantity, a column for each stage and one for the
/// cycle. `revolutions`: revolutions are counted, not double strokes.
[[nodiscard]] std::string shopText(const ShopNumbers& shop, bool revolutions);

} // namespace sparkout::cli
