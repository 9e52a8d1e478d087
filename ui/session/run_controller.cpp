// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/run_controller.h"

#include "core/deadline_stop.h"
#include "core/measured/adequacy.h"
#include "core/project/batch.h"
#include "core/setup/worn_project.h"

#include <QElapsedTimer>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

using namespace std::chrono_literals;

/// While one types or drags outcomes follow each other faster.
constexpr auto quietBefore = 150ms;

} // namespace

bool isBatchQuick(const SimulationResult& result) {
    constexpr std::int64_t mostVisits = 100'000'000;
    return partsOf(result.project) <= mostVisits / std::max<std::int64_t>(result.visits, 1);
}

CycleJudge::CycleJudge(const RunController& runs, Studies& studies, QObject* parent)
    : QObject(parent), m_runs(runs), m_studies(studies) {
    m_calm.setSingleShot(true);
    m_calm.setInterval(quietBefore);
    connect(&m_calm, &QTimer::timeout, this, &CycleJudge::runBatch);
    connect(&m_runs, &RunController::stocksDecided, this, &CycleJudge::judgeAgain);
    for (StudyOf<BatchOutcome>* study :
         {&m_studies.batch, &m_studies.judged, &m_studies.prediction}) {
        connect(&study->job(), &Job::answered, this, &CycleJudge::judgeAgain);
    }
}

void CycleJudge::setOutcome(const OutcomePtr& outcome) {
    m_calm.stop();
    m_judged = {};
    m_judged.outcome = outcome;
    m_studies.judged.follow(outcome->ran() ? &outcome->result.project : nullptr);
    judgeNow();
    if (m_judged.isBatchComing) {
        m_calm.start();
    }
}

void CycleJudge::forget() {
    m_calm.stop();
    m_studies.judged.forget();
    m_judged = {};
}

void CycleJudge::judgeBatches(bool isOn) {
    if (std::exchange(m_judgesBatches, isOn) == isOn) {
        return;
    }
    if (!isOn) {
        m_calm.stop();
        m_studies.judged.forget();
    }
    judgeAgain();
}

/// The outcome may belong to inputs before the last edit.
void CycleJudge::judgeAgain() {
    if (!m_judged.outcome) {
        return;
    }
    judgeNow();
    if (m_judged.isBatchComing && !m_studies.judged.running() && !m_calm.isActive()) {
        m_calm.start();
    }
    emit changed();
}

void CycleJudge::judgeNow() {
    const Outcome& outcome = *m_judged.outcome;
    if (!outcome.ran()) {
        m_judged.judgement = {};
        return;
    }
    m_judged.hasBatch = m_judgesBatches && outcome.result.project.batch;
    std::optional<JudgedBatch> ofBatch;
    if (const BatchOutcomePtr found = m_judged.hasBatch ? batch() : nullptr) {
        ofBatch = judgeBatch(found->result, found->summary);
    }
    m_judged.isBatchComing = m_judged.hasBatch && !(ofBatch && ofBatch->isWhole)
                             && !m_studies.judged.refusal() && isBatchQuick(outcome.result);
    m_judged.areStocksComing = m_runs.areStocksComing();
    m_judged.judgement = judge(outcome.result, outcome.constraints, m_runs.stocks(), ofBatch,
                               measuredBias(), m_judgesBatches);
}

std::optional<MeasuredBias> CycleJudge::measuredBias() const {
    const Project& project = m_judged.outcome->result.project;
    const StudyOf<BatchOutcome>& study = m_studies.prediction;
    const bool isKnown = m_judgesBatches && project.measured && study.result()
                         && study.result()->result.status == BatchStatus::completed
                         && study.isOf(predictingProject(project));
    return isKnown ? greatestBias(project, judgeAdequacy(project, study.result()->result))
                   : std::nullopt;
}

BatchOutcomePtr CycleJudge::batch() const {
    BatchOutcomePtr found;
    if (!m_judged.outcome || !m_judged.outcome->ran()) {
        return found;
    }
    for (const StudyOf<BatchOutcome>* study : {&m_studies.batch, &m_studies.judged}) {
        if (study->isOf(m_judged.outcome->result.project)
            && (!found || found->result.status == BatchStatus::stopped)) {
            found = study->result();
        }
    }
    return found;
}

void CycleJudge::runBatch() {
    if (m_judged.outcome && m_judged.isBatchComing && !m_studies.judged.running()) {
        m_studies.runJudged(m_judged.outcome->result.project);
    }
}

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
