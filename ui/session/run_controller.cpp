// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/run_controller.h"

#include <QElapsedTimer>

#include <memory>
#include <utility>

namespace sparkout {

RunController::RunController(QObject* parent, Runner runner)
    : QObject(parent), m_runner(std::move(runner)) {}

void RunController::request(Project project, Issues missing) {
    m_running = true;
    emit started();
    m_job.start([this, snapshot = std::move(project), missing = std::move(missing)](
                    const std::stop_token& stop, const NewestJob::Post& post) {
        QElapsedTimer clock;
        clock.start();
        const OutcomePtr outcome = outcomeOf(snapshot, missing, stop);
        const double time_ms = double(clock.nsecsElapsed()) * 1e-6;
        if (outcome) {
            post([this, outcome, time_ms] { deliver(outcome, time_ms); });
        }
    });
}

OutcomePtr RunController::outcomeOf(const Project& project, const Issues& missing,
                                    const std::stop_token& stop) const {
    if (missing.empty()) {
        return m_runner(project, stop);
    }
    auto incomplete = std::make_shared<Outcome>();
    incomplete->issues = missing;
    return incomplete;
}

void RunController::stop() {
    m_job.stop();
    m_running = false;
}

void RunController::deliver(const OutcomePtr& outcome, double time_ms) {
    m_running = false;
    m_lastRun_ms = time_ms;
    emit finished(outcome);
}

} // namespace sparkout
