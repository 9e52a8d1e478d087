// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "ui/session/run_controller.h"
#include "ui/session/studies.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace sparkout {

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
