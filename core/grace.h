// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <stop_token>
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

} // namespace sparkout
