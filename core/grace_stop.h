// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace sparkout {

/// A stop for computations about an answer after its search: allows them a short time, enough for
/// most. The time counts from its construction.
class Grace {
public:
    explicit Grace(std::stop_token stop) : m_stop(std::move(stop)) {}

    static constexpr std::chrono::milliseconds moment{30};

    [[nodiscard]] bool isOver() const {
        return m_stop.stop_requested() && std::chrono::steady_clock::now() - m_begin > moment;
    }

private:
    std::stop_token m_stop;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

/// A Grace for work that takes a token, requested with the stop, but not before that time is over.
/// Shared by all computations about one answer.
class GraceStop {
public:
    explicit GraceStop(std::stop_token stop)
        : m_stop(std::move(stop))
        , m_timer([this](const std::stop_token& done) { wait(done); })
        , m_asked(m_stop, Ask{this}) {}
    GraceStop(const GraceStop&) = delete;
    GraceStop& operator=(const GraceStop&) = delete;

    [[nodiscard]] std::stop_token token() const { return m_over.get_token(); }

private:
    struct Ask {
        GraceStop* grace;
        void operator()() const {
            const std::scoped_lock lock(grace->m_mutex);
            if (grace->m_momentIsOver) {
                grace->m_over.request_stop();
            }
        }
    };

    void wait(const std::stop_token& done) {
        std::condition_variable_any never;
        std::unique_lock lock(m_mutex);
        never.wait_for(lock, done, Grace::moment, [] { return false; });
        if (!done.stop_requested()) {
            m_momentIsOver = true;
            if (m_stop.stop_requested()) {
                m_over.request_stop();
            }
        }
    }

    std::stop_token m_stop;
    std::stop_source m_over;
    std::mutex m_mutex; ///< guards the following members
    bool m_momentIsOver = false;
    std::jthread m_timer; ///< last member: ends before what it uses
    std::stop_callback<Ask> m_asked;
};

} // namespace sparkout
