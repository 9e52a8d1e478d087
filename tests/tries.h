// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace sparkout {

/// The least of up to three tries, in ms, ended by the first within the limit. A virtual machine
/// is paused by its host for tens of milliseconds now and then, in the processor time of whatever
/// runs: such a pause does not come back, what the program does itself comes back every time.
template <typename Try>
double leastOfTries_ms(double limit_ms, Try&& measure_ms) {
    double least_ms = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3 && least_ms > limit_ms; ++i) {
        least_ms = std::min(least_ms, double(measure_ms()));
    }
    return least_ms;
}

} // namespace sparkout
