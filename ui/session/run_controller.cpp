// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/run_controller.h"

#include "core/deadline_stop.h"
#include "core/setup/worn_project.h"

#include <QElapsedTimer>

#include <chrono>
#include <memory>
#include <utility>

namespace sparkout {

namespace {

/// Time for which curves wait for the stocks, so that the verdict appears with them.
constexpr std::chrono::milliseconds together(25);

} // namespace

RunController::RunController(QObject* parent, Runner runner)
    : QObject(parent), m_runner(std::move(runner)) {}

void RunController::request(Project project) {
    request(plainSetup(std::move(project)));
}

void RunController::request(Setup upTo, Issues faults) {
    m_running = true;
    emit started();
    m_job.start([this, snapshot = std::move(upTo), faults = std::move(faults)](
                    const std::stop_token& stop, const NewestJob::Post& post) {
        QElapsedTimer clock;
        clock.start();
        const OutcomePtr outcome = outcomeOf(snapshot, faults, stop);
        const double time_ms = double(clock.nsecsElapsed()) * 1e-6;
        if (!outcome) {
            return;
        }
        std::optional<JudgedStocks> stocks;
        bool areComing = false;
        if (outcome->ran()) {
            const DeadlineStop soon(stop, together);
            stocks = judgeStocks(outcome->result, soon.token());
            areComing = !stocks && soon.token().stop_requested();
        }
        post([this, outcome, time_ms, stocks, areComing] {
            m_running = false;
            m_lastRun_ms = time_ms;
            m_stocks = stocks;
            m_areStocksComing = areComing;
            emit finished(outcome);
        });
        if (areComing) {
            post([this, later = judgeStocks(outcome->result, stop)] {
                m_stocks = later;
                m_areStocksComing = false;
                emit stocksDecided();
            });
        }
    });
}

OutcomePtr RunController::outcomeOf(const Setup& upTo, const Issues& faults,
                                    const std::stop_token& stop) const {
    auto refused = std::make_shared<Outcome>();
    refused->issues = faults;
    if (faults.empty()) {
        const std::size_t last = upTo.surfaces.size() - 1;
        WornProject worn = wornProject(upTo, last, stop, &m_removed);
        if (worn.surface == last) {
            return m_runner(worn.project, stop);
        }
        for (Issue& issue : worn.issues) {
            issue.path = surfacePath(worn.surface) + issue.path;
            refused->issues.push_back(std::move(issue));
        }
    }
    return refused;
}

void RunController::stop() {
    m_job.stop();
    m_running = false;
    m_stocks.reset();
    m_areStocksComing = false;
}

} // namespace sparkout
