// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/worker_pool.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace sparkout {

std::size_t workerCount(int asked) {
    return asked > 0 ? static_cast<std::size_t>(asked)
                     : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

void forEachIndex(std::size_t workers, std::int64_t first, std::int64_t end,
                  const std::stop_token& stop,
                  const std::function<bool(std::size_t, std::int64_t)>& work) {
    constexpr std::int64_t atATime = 4;
    std::atomic<std::int64_t> next = first;
    const auto run = [&](std::size_t worker) {
        while (true) {
            const std::int64_t from = next.fetch_add(atATime);
            const std::int64_t to = std::min(from + atATime, end);
            for (std::int64_t index = from; index < to; ++index) {
                if (stop.stop_requested() || !work(worker, index)) {
                    return;
                }
            }
            if (from >= end) {
                return;
            }
        }
    };
    std::vector<std::jthread> threads; // joined by the destructor
    for (std::size_t worker = 1; worker < workers; ++worker) {
        threads.emplace_back([&run, worker] { run(worker); });
    }
    run(0);
}

} // namespace sparkout
