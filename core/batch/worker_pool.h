// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>

namespace sparkout {

/// Number of threads: the requested one, or as many as the processor runs at once.
[[nodiscard]] std::size_t workerCount(int asked);

/// Calls work(worker, index) once for every index first…end−1 on this many threads, including the
/// caller's. A stop request, or work() returning false, ends it early.
void forEachIndex(std::size_t workers, std::int64_t first, std::int64_t end,
                  const std::stop_token& stop,
                  const std::function<bool(std::size_t, std::int64_t)>& work);

} // namespace sparkout
