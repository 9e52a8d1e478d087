// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sparkout {

/// Dimensions the sequence is tabulated for: two points of seven factors each, as the sensitivity
/// indices need them.
inline constexpr int sobolDimensions = 14;

/// Coordinate of point `index` (below 2³²) of the Sobol sequence as a fraction of 2³², directions
/// of Joe and Kuo [JOEKUO2008]; in natural, not Gray-code, order.
[[nodiscard]] std::uint32_t sobolCoordinate(std::uint32_t index, int dimension);

} // namespace sparkout
