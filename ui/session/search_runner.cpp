// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/search_runner.h"

#include <utility>

namespace sparkout {

SearchRunner::SearchRunner(QObject* parent) : QObject(parent) {
    constexpr int tick_ms = 100;
    m_progress.setInterval(tick_ms);
    connect(&m_progress, &QTimer::timeout, this, &SearchRunner::tell);
}

void SearchRunner::start(const Project& project, SearchWish wish) {
    drop();
    m_stop = std::stop_source();
    m_shared = std::make_shared<Shared>();
    m_took.start();
    m_progress.start();
    m_job.start([this, project, wish, shared = m_shared,
                 wanted = m_stop](const std::stop_token& newer, const NewestJob::Post& post) {
        std::stop_source either = wanted; // the two share one state
        const std::stop_callback dropped(newer, [&either] { either.request_stop(); });
        SearchOutcomePtr outcome = search(project, wish, either.get_token(),
                                          {.note =
                                               [&shared](const SearchState& state) {
                                                   const std::lock_guard lock(shared->mutex);
                                                   shared->state = state;
                                               },
                                           .answer =
                                               [this, &post](const SearchOutcomePtr& answer) {
                                                   post([this, answer] { emit answered(answer); });
                                               }});
        post([this, outcome = std::move(outcome)] {
            m_progress.stop();
            emit finished(outcome);
        });
    });
}

void SearchRunner::stop() {
    m_stop.request_stop();
}

void SearchRunner::drop() {
    m_progress.stop();
    m_job.stop();
}

void SearchRunner::tell() {
    SearchState state;
    {
        const std::lock_guard lock(m_shared->mutex);
        state = m_shared->state;
    }
    state.took_s = static_cast<double>(m_took.elapsed()) / 1000;
    emit progressed(state);
}

} // namespace sparkout
