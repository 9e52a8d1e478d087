// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/judgement.h"
#include "core/setup/setup.h"
#include "core/setup/worn_project.h"
#include "core/study/outcome.h"
#include "ui/session/job.h"
#include "ui/session/studies.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>
#include <stop_token>

namespace sparkout {

/// Runs projects outside the window's thread. A project is taken by value and its outcome is
/// returned by a signal in the thread of the controller; a newer request stops the older one, whose
/// result is discarded. The destructor stops the run and waits for it. The cycle is decided for
/// every stock within one infeed together with the run where that is quick, otherwise afterwards.
class RunController : public QObject {
    Q_OBJECT

public:
    using Runner = std::function<OutcomePtr(const Project&, const std::stop_token&)>;

    explicit RunController(QObject* parent = nullptr, Runner runner = evaluate);

    /// Runs the last of these surfaces, with the wheel in the state left by the earlier ones. With
    /// faults, as missing numbers, the project is not run, and they are the issues of the outcome.
    void request(Setup upTo, Issues faults = {});
    void request(Project project); ///< runs the project of a single surface
    void stop();                   ///< stops the run and discards its outcome
    /// Returns the outcome of request(), computed in the calling thread.
    [[nodiscard]] OutcomePtr outcomeOf(const Setup& upTo, const Issues& faults,
                                       const std::stop_token& stop = {}) const;
    [[nodiscard]] const Runner& runner() const { return m_runner; }
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] double lastRun_ms() const { return m_lastRun_ms; }
    /// Returns the decision on the stocks of the last finished outcome; empty if it is not decided,
    /// or not yet.
    [[nodiscard]] const std::optional<JudgedStocks>& stocks() const { return m_stocks; }
    [[nodiscard]] bool areStocksComing() const { return m_areStocksComing; }

signals:
    void started();
    void finished(sparkout::OutcomePtr outcome);
    void stocksDecided(); ///< emitted after finished()

private:
    Runner m_runner;
    bool m_running = false;
    double m_lastRun_ms = 0;
    std::optional<JudgedStocks> m_stocks;
    bool m_areStocksComing = false;
    mutable RemovedVolumes
        m_removed;   ///< volumes of the earlier surfaces, which an edit seldom affects
    NewestJob m_job; ///< last: stopped before the members that it uses are destroyed
};

/// Returns whether the batch of a run is quick enough to be run by itself: about a second of one
/// processor.
[[nodiscard]] bool isBatchQuick(const SimulationResult& result);

/// Judgement of a run, with the parts of it that are still being computed.
struct JudgedRun {
    OutcomePtr outcome; ///< may be null
    Judgement judgement;
    bool areStocksComing = false;
    bool hasBatch = false; ///< the batch may be reported
    bool isBatchComing = false;
};

/// Judges the current cycle: by its run and its stocks at once, or by its stocks somewhat later
/// where they take longer; by its batch shortly after the last edit, when the batch is quick to run
/// or was run by its view; by measured parts once their view has run the batch that predicts them.
class CycleJudge : public QObject {
    Q_OBJECT

public:
    CycleJudge(const RunController& runs, Studies& studies, QObject* parent = nullptr);

    /// Judges an outcome that the runs have just finished; changed() is not emitted for it.
    void setOutcome(const OutcomePtr& outcome);
    void forget(); ///< clears the judgement before another document is shown
    /// Sets whether batches are run and reported; in a lesson they are not.
    void judgeBatches(bool isOn);
    [[nodiscard]] const JudgedRun& judged() const { return m_judged; }
    /// Returns the batch of the inputs that were run, preferably one with all parts run; null if
    /// there is none.
    [[nodiscard]] BatchOutcomePtr batch() const;

signals:
    void changed(); ///< the stocks or the batch were decided, or are no longer reported

private:
    void judgeAgain();
    void judgeNow();
    void runBatch();
    [[nodiscard]] std::optional<MeasuredBias> measuredBias() const;

    const RunController& m_runs;
    Studies& m_studies;
    bool m_judgesBatches = true;
    JudgedRun m_judged;
    QTimer m_calm; ///< delay after the last edit
};

} // namespace sparkout
