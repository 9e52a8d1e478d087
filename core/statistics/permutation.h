// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/statistics/philox.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace sparkout {

/// The image of `value` under a random permutation of 0…count−1, without a table: a Feistel network
/// of four Philox rounds over the next even power of two, iterated until it falls into the range.
[[nodiscard]] constexpr std::uint64_t permuted(std::uint64_t value, std::uint64_t count,
                                               std::uint32_t seed, std::uint32_t which) {
    const int half =
        (static_cast<int>(std::bit_width(count > 1 ? count - 1 : std::uint64_t{1})) + 1) / 2;
    const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
    do {
        std::uint64_t left = value >> half, right = value & mask;
        for (std::uint32_t round = 0; round < 4; ++round) {
            const std::uint64_t mixed =
                randomBits(seed, RandomStream::permutation, right, which * 4 + round);
            left ^= mixed & mask;
            std::swap(left, right);
        }
        value = left << half | right;
    } while (value >= count);
    return value;
}

} // namespace sparkout
