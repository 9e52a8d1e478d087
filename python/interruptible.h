// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <stop_token>
#include <thread>
#include <utility>

namespace sparkout::python {

/// Runs `work(stop)` in a thread of its own, without Python's lock. Ctrl+C asks it to stop, waits
/// for it and raises KeyboardInterrupt.
template <class Work>
auto interruptible(Work work) {
    constexpr std::chrono::milliseconds tick(50);
    std::stop_source stop;
    std::packaged_task task([&] { return work(stop.get_token()); });
    auto result = task.get_future();
    const std::jthread thread(std::move(task));
    while (true) {
        {
            const pybind11::gil_scoped_release released;
            if (result.wait_for(tick) == std::future_status::ready) {
                break;
            }
        }
        if (PyErr_CheckSignals() != 0) {
            stop.request_stop();
            const pybind11::gil_scoped_release released;
            result.wait();
            break;
        }
    }
    if (PyErr_Occurred()) {
        throw pybind11::error_already_set();
    }
    return result.get();
}

} // namespace sparkout::python
