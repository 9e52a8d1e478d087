// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/search_watch.h"

#include "app/console.h"
#include "app/stop_signals.h"
#include "words/search_words.h"

#include <utility>

namespace sparkout::cli {

namespace {

using namespace std::chrono_literals;

} // namespace

SearchWatch::SearchWatch(std::optional<double> timeLimit_s, Text text)
    : m_timeLimit_s(timeLimit_s), m_text(std::move(text)) {
    catchStopSignals();
    m_thread = std::jthread([this](const std::stop_token& ended) { watch(ended); });
}

void SearchWatch::note(SearchState state) {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - m_begin;
    state.took_s = took.count();
    const std::scoped_lock lock(m_mutex);
    m_state = state;
}

void SearchWatch::watch(const std::stop_token& ended) {
    auto next = m_begin + 1s;
    std::unique_lock lock(m_mutex);
    while (!m_wake.wait_for(lock, ended, 20ms, [] { return false; }) && !ended.stop_requested()) {
        const auto now = std::chrono::steady_clock::now();
        const bool late =
            m_timeLimit_s && std::chrono::duration<double>(now - m_begin).count() > *m_timeLimit_s;
        if (caughtSignal() != 0 || late) {
            m_search.request_stop();
        }
        if (now >= next) {
            printProgress();
            next = now + 1s;
        }
    }
}

void SearchWatch::printProgress() {
    if (m_state) {
        const SearchState state = *std::exchange(m_state, std::nullopt);
        printText(stderr, (m_text ? m_text(state) : SearchWording().state(state)) + '\n');
    }
}

} // namespace sparkout::cli
