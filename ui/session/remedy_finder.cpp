// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/remedy_finder.h"

#include "core/study/remedy_setting.h"

#include <chrono>
#include <utility>

namespace sparkout {

namespace {

using namespace std::chrono_literals;

/// While a slider is dragged outcomes follow each other faster.
constexpr auto calm = 60ms;
/// A search with slow cycles is incomplete.
constexpr auto longestSearch = 30s;
constexpr auto betweenReports = 150ms;

} // namespace

RemedyFinder::RemedyFinder(QObject* parent) : QObject(parent) {
    m_calm.setSingleShot(true);
    m_calm.setInterval(calm);
    connect(&m_calm, &QTimer::timeout, this, &RemedyFinder::start);
}

void RemedyFinder::request(OutcomePtr outcome) {
    drop();
    m_outcome = std::move(outcome);
    m_running = true;
    m_calm.start();
}

void RemedyFinder::drop() {
    m_calm.stop();
    m_job.stop();
    m_outcome.reset();
    m_running = false;
}

void RemedyFinder::end() {
    m_end.request_stop();
}

/// Reports the beginning, since the first setting of a slow cycle takes long.
void RemedyFinder::reportBegun(const OutcomePtr& outcome) {
    const RemedyGoal goal = remedyGoal(outcome->result, outcome->constraints);
    if (goal == RemedyGoal::none) {
        return; // stocks and batch are checked first
    }
    QTimer::singleShot(betweenReports, this, [this, outcome, goal, search = m_search] {
        if (m_running && !m_hasReported && search == m_search) {
            RemedyResult none;
            none.goal = goal;
            none.settings = remedySettings(outcome->result.project).size();
            emit found(outcome, std::make_shared<const RemedyResult>(std::move(none)));
        }
    });
}

void RemedyFinder::start() {
    m_end = std::stop_source();
    m_hasReported = false;
    ++m_search;
    reportBegun(m_outcome);
    m_job.start([this, outcome = std::exchange(m_outcome, nullptr),
                 ended = m_end](const std::stop_token& stop, const NewestJob::Post& post) {
        std::stop_source either;
        const auto ask = [&either] { either.request_stop(); };
        const std::stop_callback onStop(stop, ask), onEnd(ended.get_token(), ask);
        const auto report = [&](const RemedyResult& result, bool isLast) {
            post([this, outcome, isLast, result = std::make_shared<const RemedyResult>(result)] {
                m_running = !isLast;
                m_hasReported = true;
                emit found(outcome, result);
            });
        };
        RemedyOptions options;
        options.stop = either.get_token();
        options.budget = longestSearch;
        auto reported = std::chrono::steady_clock::now();
        options.progress = [&](const RemedyResult& result) {
            const auto now = std::chrono::steady_clock::now();
            if (now - reported >= betweenReports && !result.isComplete()) {
                reported = now;
                report(result, false);
            }
        };
        report(findRemedies(outcome->result, outcome->constraints, options), true);
    });
}

} // namespace sparkout
