// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace sparkout {

/// Tabulated dimensions of the sequence: two points of sixteen factors each, needed for the
/// sensitivity indices of the largest batch.
inline constexpr int sobolDimensions = 32;

/// Coordinate of point `index` (below 2³²) of the Sobol sequence as a fraction of 2³², directions
/// of Joe and Kuo [JOEKUO2008]; in natural, not Gray-code, order.
[[nodiscard]] std::uint32_t sobolCoordinate(std::uint32_t index, int dimension);

/// Philox4x32-10, a random function of a counter and a key [SALMON2011]: the values of a part
/// depend on its number alone, never on earlier draws.
using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

[[nodiscard]] constexpr PhiloxCounter philox(PhiloxCounter c, PhiloxKey key) {
    constexpr std::uint64_t m0 = 0xD2511F53, m1 = 0xCD9E8D57;
    constexpr std::uint32_t w0 = 0x9E3779B9, w1 = 0xBB67AE85;
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t p0 = m0 * c[0], p1 = m1 * c[2];
        c = {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(p1),
             static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(p0)};
        key = {key[0] + w0, key[1] + w1};
    }
    return c;
}

/// The purpose of random numbers, so that no two purposes share them.
enum class RandomStream : std::uint32_t { plain, jitter, permutation, shift, variant };

/// 64 random bits of a batch's seed for a purpose, a part and a factor.
[[nodiscard]] constexpr std::uint64_t randomBits(std::uint32_t seed, RandomStream stream,
                                                 std::uint64_t part, std::uint32_t factor) {
    const PhiloxCounter bits = philox(
        {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(part >> 32), factor, 0},
        {seed, static_cast<std::uint32_t>(stream)});
    return std::uint64_t{bits[0]} << 32 | bits[1];
}

/// The middle of one of 2⁵² equal cells of (0, 1): never 0, never 1.
[[nodiscard]] constexpr double openUnit(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

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
