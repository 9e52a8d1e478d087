// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>

namespace sparkout {

/// Threads to use: those asked for, or as many as the processor carries out at once.
[[nodiscard]] std::size_t workerCount(int asked);

/// Calls work(worker, index) for every index first…end−1, each once, on so many threads, one of
/// them the caller's. A stop request, or work() that returns false, ends it early.
void forEachIndex(std::size_t workers, std::int64_t first, std::int64_t end,
                  const std::stop_token& stop,
                  const std::function<bool(std::size_t, std::int64_t)>& work);

} // namespace sparkout
