// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/philox.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace sparkout {

namespace {

constexpr int sobolBits = 32;

/// A row of new-joe-kuo-6.21201: degree s, inner coefficients a, first direction numbers m.
struct JoeKuoRow {
    int s;
    std::uint32_t a;
    std::array<std::uint32_t, 7> m;
};

constexpr std::array<JoeKuoRow, sobolDimensions - 1> joeKuo{{{1, 0, {1}},
                                                             {2, 1, {1, 3}},
                                                             {3, 1, {1, 3, 1}},
                                                             {3, 2, {1, 1, 1}},
                                                             {4, 1, {1, 1, 3, 3}},
                                                             {4, 4, {1, 3, 5, 13}},
                                                             {5, 2, {1, 1, 5, 5, 17}},
                                                             {5, 4, {1, 1, 5, 5, 5}},
                                                             {5, 7, {1, 1, 7, 11, 19}},
                                                             {5, 11, {1, 1, 5, 1, 1}},
                                                             {5, 13, {1, 1, 1, 3, 11}},
                                                             {5, 14, {1, 3, 5, 5, 31}},
                                                             {6, 1, {1, 3, 3, 9, 7, 49}},
                                                             {6, 13, {1, 1, 1, 15, 21, 21}},
                                                             {6, 16, {1, 3, 1, 13, 27, 49}},
                                                             {6, 19, {1, 1, 1, 15, 7, 5}},
                                                             {6, 22, {1, 3, 1, 15, 13, 25}},
                                                             {6, 25, {1, 1, 5, 5, 19, 61}},
                                                             {7, 1, {1, 3, 7, 11, 23, 15, 103}},
                                                             {7, 4, {1, 3, 7, 13, 13, 15, 69}},
                                                             {7, 7, {1, 1, 3, 13, 7, 35, 63}},
                                                             {7, 8, {1, 3, 5, 9, 1, 25, 53}},
                                                             {7, 14, {1, 3, 1, 13, 9, 35, 107}},
                                                             {7, 19, {1, 3, 1, 5, 27, 61, 31}},
                                                             {7, 21, {1, 1, 5, 11, 19, 41, 61}},
                                                             {7, 28, {1, 3, 5, 3, 3, 13, 69}},
                                                             {7, 31, {1, 1, 7, 13, 1, 19, 1}},
                                                             {7, 32, {1, 3, 7, 5, 13, 19, 59}},
                                                             {7, 37, {1, 1, 3, 9, 25, 29, 41}},
                                                             {7, 41, {1, 3, 5, 13, 23, 1, 55}},
                                                             {7, 42, {1, 3, 7, 3, 13, 59, 17}}}};

using Directions32 = std::array<std::uint32_t, sobolBits>;

/// V_i = m_i·2^(32−i); m beyond the table by the recurrence of its polynomial.
constexpr Directions32 directionsOf(const JoeKuoRow& row) {
    Directions32 v{};
    for (int i = 0; i < sobolBits; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (i < row.s) {
            v[at] = row.m[at] << (sobolBits - 1 - i);
            continue;
        }
        const std::uint32_t oldest = v[static_cast<std::size_t>(i - row.s)];
        v[at] = oldest ^ (oldest >> row.s);
        for (int k = 1; k < row.s; ++k) {
            if ((row.a >> (row.s - 1 - k)) & 1U) {
                v[at] ^= v[static_cast<std::size_t>(i - k)];
            }
        }
    }
    return v;
}

constexpr auto sobolTable = [] {
    std::array<Directions32, sobolDimensions> table{};
    for (std::size_t i = 0; i < sobolBits; ++i) {
        table[0][i] = std::uint32_t{1} << (sobolBits - 1 - i);
    }
    for (std::size_t d = 1; d < sobolDimensions; ++d) {
        table[d] = directionsOf(joeKuo[d - 1]);
    }
    return table;
}();

} // namespace

std::uint32_t sobolCoordinate(std::uint32_t index, int dimension) {
    assert(dimension >= 0 && dimension < sobolDimensions);
    const Directions32& v = sobolTable[static_cast<std::size_t>(dimension)];
    std::uint32_t x = 0;
    for (std::size_t bit = 0; index != 0; ++bit, index >>= 1) {
        if (index & 1U) {
            x ^= v[bit];
        }
    }
    return x;
}

} // namespace sparkout
