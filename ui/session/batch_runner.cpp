// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/batch_runner.h"

#include "core/batch/batch_check.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace sparkout {

BatchOutcomePtr runWholeBatch(const Project& project, const BatchOptions& options) {
    auto outcome = std::make_shared<BatchOutcome>();
    outcome->issues = checkBatch(project);
    if (outcome->ran()) {
        outcome->result = runBatch(project, options);
        outcome->summary = summarise(outcome->result);
        outcome->regressions = rankRegressions(outcome->result);
        const ScenarioSource source(outcome->result.project);
        outcome->factors = source.factors();
        for (const PartRow& row : outcome->result.statistics.rows) {
            outcome->drawn.push_back(source.values(row.part));
        }
    }
    return outcome;
}

std::int64_t partsOf(const Project& project) {
    const std::size_t factors = givenFactors(project).size();
    if (!project.batch) {
        return 0;
    }
    const bool corners = project.batch->scenarios == Scenarios::corners;
    return corners || factors == 0 ? std::int64_t{1} << factors : project.batch->parts;
}

std::int64_t partsOfIndices(const Project& project, int points) {
    return std::int64_t{points} * (static_cast<std::int64_t>(givenFactors(project).size()) + 2);
}

BatchRunner::BatchRunner(QObject* parent) : QObject(parent) {
    constexpr int tick_ms = 100;
    m_progress.setInterval(tick_ms);
    connect(&m_progress, &QTimer::timeout, this, &BatchRunner::tell);
}

void BatchRunner::start(const Project& project) {
    run(partsOf(project), [this, project](const BatchOptions& options) {
        return [this, outcome = runWholeBatch(project, options)] { emit finished(outcome); };
    });
}

void BatchRunner::startIndices(const Project& project, int points) {
    run(partsOfIndices(project, points), [this, project, points](const BatchOptions& options) {
        const auto found = sobolIndices(project, points, options);
        const auto indices = found ? std::make_shared<const SobolIndices>(*found) : nullptr;
        return [this, indices] { emit indicesFound(indices); };
    });
}

void BatchRunner::run(std::int64_t parts, Work work) {
    drop();
    m_stop = std::stop_source();
    m_done = std::make_shared<std::atomic<std::int64_t>>(0);
    m_parts = parts;
    m_took.start();
    m_progress.start();
    m_job.start([this, work = std::move(work), done = m_done,
                 wanted = m_stop](const std::stop_token& newer, const NewestJob::Post& post) {
        std::stop_source either = wanted; // the two share one state
        const std::stop_callback dropped(newer, [&either] { either.request_stop(); });
        BatchOptions options;
        options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
        options.stop = either.get_token();
        options.done = done.get();
        post([this, answer = work(options)] {
            m_progress.stop();
            answer();
        });
    });
}

void BatchRunner::stop() {
    m_stop.request_stop();
}

void BatchRunner::drop() {
    m_progress.stop();
    m_job.stop();
}

void BatchRunner::tell() {
    const std::int64_t done = m_done->load(std::memory_order_relaxed);
    const double took_s = static_cast<double>(m_took.elapsed()) / 1000;
    emit progressed(
        done, m_parts,
        done > 0 ? took_s * static_cast<double>(m_parts - done) / static_cast<double>(done) : -1);
}

} // namespace sparkout
