// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sparkout {

/// Dimensions the sequence is tabulated for: two points of sixteen factors each, as the sensitivity
/// indices of a batch with as many as there may be need them.
inline constexpr int sobolDimensions = 32;

/// Coordinate of point `index` (below 2³²) of the Sobol sequence as a fraction of 2³², directions
/// of Joe and Kuo [JOEKUO2008]; in natural, not Gray-code, order.
[[nodiscard]] std::uint32_t sobolCoordinate(std::uint32_t index, int dimension);

} // namespace sparkout
