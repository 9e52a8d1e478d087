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
    return outcome;
}

RunController::RunController(QObject* parent, Runner runner)
    : QObject(parent), m_runner(std::move(runner)) {
    m_pool.setMaxThreadCount(1);
}

RunController::~RunController() {
    m_stop.request_stop();
    m_pool.clear();
    m_pool.waitForDone();
}

void RunController::request(Project project) {
    m_stop.request_stop();
    m_stop = std::stop_source();
    const quint64 number = ++m_newest;
    m_running = true;
    emit started();
    m_pool.start([this, number, stop = m_stop.get_token(), snapshot = std::move(project)] {
        if (stop.stop_requested()) {
            return;
        }
        QElapsedTimer clock;
        clock.start();
        OutcomePtr outcome = m_runner(snapshot, stop);
        const double time_ms = double(clock.nsecsElapsed()) * 1e-6;
        QMetaObject::invokeMethod(
            this,
            [this, number, outcome = std::move(outcome), time_ms] {
                deliver(number, outcome, time_ms);
            },
            Qt::QueuedConnection);
    });
}

void RunController::deliver(quint64 number, const OutcomePtr& outcome, double time_ms) {
    if (number != m_newest || !outcome) {
        return; // late
    }
    m_running = false;
    m_lastRun_ms = time_ms;
    emit finished(outcome);
}

} // namespace sparkout
