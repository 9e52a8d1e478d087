// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace sparkout::cli {

/// Watches a search from another thread: prints its progress to the standard error once a second,
/// and stops it on Ctrl+C, SIGTERM or when its time is up. A second Ctrl+C ends the program.
class SearchWatch {
public:
    using Text = std::function<std::string(const SearchState&)>;

    /// `text` describes the progress [in English].
    explicit SearchWatch(std::optional<double> timeLimit_s, Text text = {});
    SearchWatch(const SearchWatch&) = delete;
    SearchWatch& operator=(const SearchWatch&) = delete;

    [[nodiscard]] std::stop_token token() const { return m_search.get_token(); }
    /// Called by the search.
    void note(SearchState state);

private:
    void watch(const std::stop_token& ended);
    void printProgress();

    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::optional<double> m_timeLimit_s;
    Text m_text;
    std::stop_source m_search;
    std::mutex m_mutex; ///< guards the state
    std::optional<SearchState> m_state;
    std::condition_variable_any m_wake;
    std::jthread m_thread; ///< the last member: it uses the others
};

} // namespace sparkout::cli
