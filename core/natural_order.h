// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace sparkout {

/// Orders names numerically: 50×… before 400×…, unlike the order of characters. A number that
/// begins with 0 is treated as decimals: "1.05" comes before "1.5". Negative: a comes first; 0:
/// they are equal. The order is that of strverscmp() in the GNU library.
[[nodiscard]] int naturalOrder(std::string_view a, std::string_view b);

} // namespace sparkout
