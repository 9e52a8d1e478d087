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

inline double clockTime_ms(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// What this process has had of the processors so far [ms]: the machine may be busy with others.
/// std::clock() is that on Linux; on Windows it goes on while others run.
inline double processorTime_ms() {
    return clockTime_ms(CLOCK_PROCESS_CPUTIME_ID);
}

/// What this thread has had of them: what others do beside it does not count.
inline double threadTime_ms() {
    return clockTime_ms(CLOCK_THREAD_CPUTIME_ID);
}

} // namespace sparkout
