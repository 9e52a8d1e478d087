// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/run_controller.h"

#include "core/project/validate.h"
#include "core/quality/remarks.h"
#include "core/simulation/simulate.h"

#include <QElapsedTimer>

namespace sparkout {

OutcomePtr runProject(const Project& project, const std::stop_token& stop) {
    auto outcome = std::make_shared<Outcome>();
    outcome->issues = validate(project);
    if (hasErrors(outcome->issues)) {
        return outcome;
    }
    // Once to learn how much there is to record, then again to record it: a run is short, and a
    // trajectory of the longest ones would not fit into memory.
    outcome->result = simulate(project, nullptr, stop);
    if (!stop.stop_requested() && outcome->result.visits <= maxRecordedVisits) {
        outcome->trajectory.visits.reserve(static_cast<std::size_t>(outcome->result.visits));
        outcome->result = simulate(project, &outcome->trajectory, stop);
    }
    if (stop.stop_requested() || outcome->result.status == RunStatus::stopped) {
        return nullptr;
    }
    outcome->accuracy = accuracyOf(outcome->result);
    outcome->constraints = evaluateConstraints(outcome->result, outcome->accuracy);
    outcome->limits = makeLimitSeries(outcome->result, outcome->trajectory);
    outcome->shop = shopNumbers(outcome->result);
    const Issues remarks = remarksOn(outcome->result);
    outcome->issues.insert(outcome->issues.end(), remarks.begin(), remarks.end());
    outcome->feeds = makeFeedSeries(outcome->result, outcome->trajectory);
    outcome->layers = makeLayerSeries(outcome->result, outcome->trajectory);
    return outcome;
}

RunController::RunController(QObject* parent, Runner runner)
    : QObject(parent), m_runner(std::move(runner)) {}

void RunController::request(Project project) {
    m_running = true;
    emit started();
    m_job.start([this, snapshot = std::move(project)](const std::stop_token& stop,
                                                      const NewestJob::Post& post) {
        QElapsedTimer clock;
        clock.start();
        OutcomePtr outcome = m_runner(snapshot, stop);
        const double time_ms = double(clock.nsecsElapsed()) * 1e-6;
        if (outcome) {
            post([this, outcome = std::move(outcome), time_ms] { deliver(outcome, time_ms); });
        }
    });
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
