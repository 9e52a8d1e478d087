// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace sparkout {

/// A stop for work that is to end with another one, or once its time is over.
class DeadlineStop {
public:
    DeadlineStop(std::stop_token stop, std::chrono::duration<double> time)
        : m_asked(std::move(stop), Ask{this}), m_timer([this, time](const std::stop_token& done) {
            std::condition_variable_any never;
            std::unique_lock lock(m_mutex);
            never.wait_for(lock, done, time, [] { return false; });
            if (!done.stop_requested()) {
                m_over.request_stop();
            }
        }) {}
    DeadlineStop(const DeadlineStop&) = delete;
    DeadlineStop& operator=(const DeadlineStop&) = delete;

    [[nodiscard]] std::stop_token token() const { return m_over.get_token(); }

private:
    struct Ask {
        DeadlineStop* deadline;
        void operator()() const { deadline->m_over.request_stop(); }
    };

    std::stop_source m_over;
    std::mutex m_mutex; ///< of the wait
    std::stop_callback<Ask> m_asked;
    std::jthread m_timer; ///< ended before what it uses
};

} // namespace sparkout
