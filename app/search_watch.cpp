// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/search_watch.h"

#include "app/io/cli_io.h"
#include "app/io/cli_report.h"
#include "app/io/stop_signals.h"
#include "core/units.h"

#include <utility>

namespace sparkout::cli {

namespace {

using namespace std::chrono_literals;

std::string minutesText(double time_s) {
    return fixed(time_s / units::secondsPerMinute, 4) + " min";
}

} // namespace

SearchWatch::SearchWatch(std::optional<double> timeLimit_s) : m_timeLimit_s(timeLimit_s) {
    catchStopSignals();
    m_thread = std::jthread([this](const std::stop_token& ended) { watch(ended); });
}

void SearchWatch::note(const SearchProgress& progress) {
    const std::scoped_lock lock(m_mutex);
    m_progress = progress;
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
    if (!m_progress) {
        return;
    }
    const SearchProgress progress = *std::exchange(m_progress, std::nullopt);
    std::string line = progress.best ? "best " + minutesText(progress.best->time_s)
                                     : std::string("none feasible so far");
    if (progress.bound_s > 0) {
        line += ", none quicker than " + minutesText(progress.bound_s);
    }
    if (progress.share > 0) {
        line += ", " + fixed(progress.share * 100, 1) + " % of the grid";
    }
    print(stderr, line + ", " + std::to_string(progress.evaluations) + " cycles judged\n");
}

} // namespace sparkout::cli
