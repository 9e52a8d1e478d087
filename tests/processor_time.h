// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace sparkout {

/// What this process has had of the processors so far [ms]: the machine may be busy with others.
/// std::clock() is that on Linux; on Windows it goes on while others run.
inline double processorTime_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

} // namespace sparkout
