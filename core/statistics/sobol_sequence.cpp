// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/sobol_sequence.h"

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
    std::array<std::uint32_t, 6> m;
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
                                                             {6, 1, {1, 3, 3, 9, 7, 49}}}};

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
