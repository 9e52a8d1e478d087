// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace sparkout {

/// A sum of doubles without rounding: a fixed-point number of 448 bits. Any order and any grouping
/// of the terms gives the same bits, so sums of threads and shards join exactly [KULISCH2008].
///
/// A term is cut to a multiple of 2⁻²²⁴ and must be below 2¹⁹⁰ in size; there may be 2³⁰ of them.
class ExactSum {
public:
    static constexpr int limbs = 14;
    using Limbs = std::array<std::int64_t, limbs>;

    void add(double term);
    void add(const ExactSum& other);
    /// The sum, rounded once to within two units in its last place.
    [[nodiscard]] double value() const;

    /// Digits to the base 2³², the lowest first, each but the last in 0…2³²−1: equal sums have
    /// equal digits.
    [[nodiscard]] Limbs digits() const;
    static ExactSum ofDigits(const Limbs& digits);

    friend bool operator==(const ExactSum& a, const ExactSum& b) {
        return a.digits() == b.digits();
    }

private:
    Limbs m_limbs{}; ///< delayed carries: 2³⁰ terms do not fill 63 bits
};

} // namespace sparkout
