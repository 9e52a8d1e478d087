// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace sparkout {

/// A stop for work with a time limit: requested by another stop, or when the time is up.
class DeadlineStop {
public:
    using Duration = std::chrono::duration<double>;

    /// Without a time, or with one of years, only the other stop applies.
    DeadlineStop(std::stop_token stop, std::optional<Duration> time)
        : m_asked(std::move(stop), Ask{this}), m_timer([this, time](const std::stop_token& done) {
            constexpr Duration longest(1e9);
            if (time && *time < longest) {
                wait(done, *time);
            }
        }) {
        if (time && *time <= Duration(0)) { // whatever the timer's thread waits for
            m_over.request_stop();
        }
    }
    DeadlineStop(const DeadlineStop&) = delete;
    DeadlineStop& operator=(const DeadlineStop&) = delete;

    [[nodiscard]] std::stop_token token() const { return m_over.get_token(); }

private:
    struct Ask {
        DeadlineStop* deadline;
        void operator()() const { deadline->m_over.request_stop(); }
    };

    void wait(const std::stop_token& done, Duration time) {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any never;
        never.wait_for(lock, done, time, [] { return false; });
        if (!done.stop_requested()) {
            m_over.request_stop();
        }
    }

    std::stop_source m_over;
    std::stop_callback<Ask> m_asked;
    std::jthread m_timer; ///< last member: ends before what it uses
};

} // namespace sparkout
