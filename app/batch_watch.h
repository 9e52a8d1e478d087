// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stop_token>
#include <thread>

namespace sparkout::cli {

/// Watches long work from its own thread: prints its progress to stderr and turns Ctrl+C or SIGTERM
/// into a stop request. A second Ctrl+C ends the program at once.
class BatchWatch {
public:
    static constexpr std::int64_t uncounted = 0; ///< number of parts for work without progress
    /// `parts` is the final value of `done`; `tells`: prints even if stderr is not a terminal;
    /// `what` names the parts.
    BatchWatch(std::int64_t parts, bool tells, const char* what = "parts");
    ~BatchWatch();
    BatchWatch(const BatchWatch&) = delete;
    BatchWatch& operator=(const BatchWatch&) = delete;

    [[nodiscard]] std::stop_token stop() const { return m_stop.get_token(); }
    [[nodiscard]] std::atomic<std::int64_t>* done() { return &m_done; }

private:
    void watch(const std::stop_token& over);
    void tell();

    std::int64_t m_parts;
    bool m_terminal, m_tells;
    const char* m_what;
    std::chrono::steady_clock::time_point m_began = std::chrono::steady_clock::now();
    std::stop_source m_stop;
    std::atomic<std::int64_t> m_done = 0;
    std::jthread m_thread; ///< the last member: it uses the others
};

} // namespace sparkout::cli
