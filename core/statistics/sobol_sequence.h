// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sparkout {

/// Tabulated dimensions of the sequence: two points of sixteen factors each, needed for the
/// sensitivity indices of the largest batch.
inline constexpr int sobolDimensions = 32;

/// Coordinate of point `index` (below 2³²) of the Sobol sequence as a fraction of 2³², directions
/// of Joe and Kuo [JOEKUO2008]; in natural, not Gray-code, order.
[[nodiscard]] std::uint32_t sobolCoordinate(std::uint32_t index, int dimension);

} // namespace sparkout
