// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace allocations {

/// How often memory was allocated so far: allocation_counter.cpp replaces the global operator new
/// by one that counts.
extern std::atomic<long long> count;

} // namespace allocations
