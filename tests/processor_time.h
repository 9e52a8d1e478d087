// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace sparkout {

/// A test that watches a time fails at this many times its target: the machine may do other things,
/// and under the sanitizers (clang++) all takes five times as long.
#ifdef __clang__
inline constexpr double busy = 4, under_sanitizers = 5;
#else
inline constexpr double busy = 4, under_sanitizers = 1;
#endif

/// What this process has had of the processors so far [ms]: the machine may be busy with others.
/// std::clock() is that on Linux; on Windows it goes on while others run.
inline double processorTime_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

} // namespace sparkout
