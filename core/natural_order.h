// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace sparkout {

/// Orders names as people count: 50×… before 400×…, where letters alone would put it behind. A
/// number that begins with 0 is taken for decimals: "1.05" comes before "1.5". Less than 0: a comes
/// first; 0: they are equal. The order is that of strverscmp() in the GNU library.
[[nodiscard]] int naturalOrder(std::string_view a, std::string_view b);

} // namespace sparkout
