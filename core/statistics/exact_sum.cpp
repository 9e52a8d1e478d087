// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/exact_sum.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace sparkout {

namespace {

constexpr int limbBits = 32;
constexpr int lowestBit = -224;
constexpr std::uint64_t limbMask = 0xFFFFFFFF;

} // namespace

// |term| = m·2^e with m < 2⁵³, laid over up to three limbs.
void ExactSum::add(double term) {
    assert(std::isfinite(term) && std::abs(term) < 0x1p190);
    int e = 0;
    auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(term), &e), 53));
    int shift = e - 53 - lowestBit;
    if (shift < 0) {
        m = shift <= -53 ? 0 : m >> -shift;
        shift = 0;
    }
    const std::int64_t sign = term < 0 ? -1 : 1;
    const auto at = static_cast<std::size_t>(shift / limbBits);
    const std::uint64_t low = (m & limbMask) << (shift % limbBits);
    const std::uint64_t high = (m >> limbBits) << (shift % limbBits);
    m_limbs[at] += sign * static_cast<std::int64_t>(low & limbMask);
    m_limbs[at + 1] += sign * static_cast<std::int64_t>((low >> limbBits) + (high & limbMask));
    m_limbs[at + 2] += sign * static_cast<std::int64_t>(high >> limbBits);
}

void ExactSum::add(const ExactSum& other) {
    for (std::size_t i = 0; i < m_limbs.size(); ++i) {
        m_limbs[i] += other.m_limbs[i];
    }
}

ExactSum::Limbs ExactSum::digits() const {
    Limbs digits = m_limbs;
    for (std::size_t i = 0; i + 1 < digits.size(); ++i) {
        const std::int64_t carry = digits[i] >> limbBits; // rounds down, also below zero
        digits[i] &= static_cast<std::int64_t>(limbMask);
        digits[i + 1] += carry;
    }
    return digits;
}

ExactSum ExactSum::ofDigits(const Limbs& digits) {
    ExactSum sum;
    sum.m_limbs = digits;
    return sum;
}

// The digits of a negative sum are those of its complement, so its opposite is evaluated.
double ExactSum::value() const {
    Limbs digits = this->digits();
    const bool negative = digits.back() < 0;
    if (negative) {
        ExactSum opposite;
        for (std::size_t i = 0; i < digits.size(); ++i) {
            opposite.m_limbs[i] = -digits[i];
        }
        digits = opposite.digits();
    }
    double sum = 0;
    for (std::size_t i = digits.size(); i-- > 0;) {
        sum +=
            std::ldexp(static_cast<double>(digits[i]), lowestBit + limbBits * static_cast<int>(i));
    }
    return negative ? -sum : sum;
}

} // namespace sparkout
