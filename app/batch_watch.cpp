// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch_watch.h"

#include "app/console.h"
#include "app/stop_signals.h"

#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>

namespace sparkout::cli {

BatchWatch::BatchWatch(std::int64_t parts, bool tells, const char* what)
    : m_parts(parts)
    , m_terminal(isTerminal(stderr))
    , m_tells((tells || m_terminal) && parts != uncounted)
    , m_what(what) {
    catchStopSignals();
    m_thread = std::jthread([this](const std::stop_token& over) { watch(over); });
}

BatchWatch::~BatchWatch() {
    m_thread.request_stop();
    m_thread.join();
    if (m_terminal) {
        printOverLine(stderr, {});
    }
}

void BatchWatch::watch(const std::stop_token& over) {
    constexpr auto look = std::chrono::milliseconds(20);
    constexpr int looksPerLine = 25; // the progress is checked twice a second
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    for (int looks = 1; !over.stop_requested(); ++looks) {
        wake.wait_for(lock, over, look, [] { return false; });
        if (caughtSignal() != 0) {
            m_stop.request_stop();
        }
        if (m_tells && looks % looksPerLine == 0) {
            tell();
        }
    }
}

void BatchWatch::tell() {
    const std::int64_t done = m_done.load(std::memory_order_relaxed);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - m_began;
    std::string text = std::to_string(done) + " of " + std::to_string(m_parts) + ' ' + m_what;
    if (done > 0) {
        const double left =
            took.count() * static_cast<double>(m_parts - done) / static_cast<double>(done);
        text += ", " + std::to_string(std::llround(left)) + " s left";
    }
    if (m_terminal) {
        printOverLine(stderr, text);
    } else {
        printText(stderr, text + '\n');
    }
}

} // namespace sparkout::cli
