// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/sweep_runner.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace sparkout {

SweepRunner::SweepRunner(QObject* parent) : QObject(parent) {
    constexpr int tick_ms = 100;
    m_progress.setInterval(tick_ms);
    connect(&m_progress, &QTimer::timeout, this, &SweepRunner::tell);
}

void SweepRunner::start(const Project& project) {
    drop();
    m_stop = std::stop_source();
    m_done = std::make_shared<std::atomic<std::int64_t>>(0);
    m_points = pointsOf(project);
    m_took.start();
    m_progress.start();
    m_job.start([this, project, done = m_done, wanted = m_stop](const std::stop_token& newer,
                                                                const NewestJob::Post& post) {
        std::stop_source either = wanted; // the two share one state
        const std::stop_callback dropped(newer, [&either] { either.request_stop(); });
        SweepOptions options;
        options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
        options.stop = either.get_token();
        options.done = done.get();
        auto outcome = std::make_shared<SweepOutcome>();
        outcome->issues = checkSweep(project);
        if (outcome->ran()) {
            outcome->result = runSweep(project, options);
        }
        post([this, outcome = SweepOutcomePtr(std::move(outcome))] {
            m_progress.stop();
            emit finished(outcome);
        });
    });
}

void SweepRunner::stop() {
    m_stop.request_stop();
}

void SweepRunner::drop() {
    m_progress.stop();
    m_job.stop();
}

void SweepRunner::tell() {
    const std::int64_t done = m_done->load(std::memory_order_relaxed);
    const double took_s = static_cast<double>(m_took.elapsed()) / 1000;
    emit progressed(
        done, m_points,
        done > 0 ? took_s * static_cast<double>(m_points - done) / static_cast<double>(done) : -1);
}

} // namespace sparkout
