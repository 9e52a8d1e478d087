// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace sparkout {

struct ValueAndSlope {
    double value = 0;
    double slope = 0;
};

/// The root of a rising function between low and high, to the last bits of x: Newton's steps within
/// the bracket, bisecting where they leave it or shrink it too slowly. The function is ≤ 0 at low
/// and ≥ 0 at high, 0 ≤ low; f is not called at low. `f(x)` returns value and slope.
template <class Function>
double risingRoot(const Function& f, double low, double high) {
    constexpr int mostSteps = 200;
    constexpr int judged = 4; ///< steps within which the bracket must halve
    double x = high;
    double width = high - low;
    for (int step = 1; step <= mostSteps; ++step) {
        const auto [value, slope] = f(x);
        const double newton = x - value / slope;
        if (value == 0 || std::abs(newton - x) <= std::numeric_limits<double>::epsilon() * x) {
            break;
        }
        (value > 0 ? high : low) = x;
        bool halve = !(newton > low && newton < high);
        if (step % judged == 0) {
            halve = halve || high - low > width / 2;
            width = high - low;
        }
        const double next = halve ? low + (high - low) / 2 : newton;
        if (next == x) {
            break;
        }
        x = next;
    }
    return x;
}

} // namespace sparkout
