// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/ierfc.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace sparkout {

namespace {

using Wide = long double;

// The difference loses a factor of about 4x² + 1: with 64 bits of mantissa 1e-17 are left at x = 5.
static_assert(std::numeric_limits<Wide>::digits >= 64, "ierfc needs an extended long double");
constexpr double largestDifference = 5;

Wide difference(Wide x) {
    return std::exp(-x * x) * std::numbers::inv_sqrtpi_v<Wide> - x * std::erfc(x);
}

// The repeated integrals of erfc obey 2n·iⁿerfc = iⁿ⁻²erfc − 2x·iⁿ⁻¹erfc, and their ratios r_n =
// iⁿerfc/iⁿ⁻¹erfc the continued fraction r_(n−1) = 1/(2x + 2n·r_n), all of it positive; from
// i⁻¹erfc = 2/√π·e^(−x²), ierfc = 2/√π·e^(−x²)·r_0·r_1.
Wide continuedFraction(Wide x) {
    constexpr int terms = 24; // 1e-19 at x = 5
    Wide r = 1 / (2 * x);
    for (int n = terms; n >= 2; --n) {
        r = 1 / (2 * x + 2 * n * r);
    }
    const Wide r0 = 1 / (2 * x + 2 * r);
    return 2 * std::numbers::inv_sqrtpi_v<Wide> * std::exp(-x * x) * r0 * r;
}

Wide wideIerfc(Wide x) {
    return x < largestDifference ? difference(x) : continuedFraction(x);
}

} // namespace

double ierfc(double x) {
    return static_cast<double>(wideIerfc(x));
}

// Newton's steps on ln ierfc(x) = ln(value). ierfc is log-concave, so from the right they approach
// the root without passing it; e^(−x²)/√π ≥ ierfc(x) gives the start.
double inverseIerfc(double value) {
    constexpr double top = std::numbers::inv_sqrtpi;
    if (value >= top) {
        return 0;
    }
    double x = std::sqrt(std::log(top / value));
    for (int step = 0; step < 100; ++step) {
        const Wide y = wideIerfc(x);
        const Wide slope = std::erfc(static_cast<Wide>(x)) / y;
        const double next = static_cast<double>(x + std::log(y / value) / slope);
        if (!(next < x) || next <= 0) {
            break;
        }
        x = next;
    }
    return x;
}

} // namespace sparkout
