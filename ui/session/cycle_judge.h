// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "ui/session/run_controller.h"
#include "ui/session/studies.h"

#include <QObject>
#include <QTimer>

namespace sparkout {

/// How a run stands, and what of it is still to come.
struct JudgedRun {
    OutcomePtr outcome; ///< null: none
    Judgement judgement;
    bool areStocksComing = false;
    bool hasBatch = false; ///< that may be told of
    bool isBatchComing = false;
};

/// Judges the cycle in front: with its run and its stocks at once, or with its stocks in a moment
/// where they take longer; with its batch a little after the last edit, when that is quick to run
/// or was run by its view.
class CycleJudge : public QObject {
    Q_OBJECT

public:
    CycleJudge(const RunController& runs, Studies& studies, QObject* parent = nullptr);

    /// Takes an outcome that the runs have just finished; changed() is not emitted for it.
    void setOutcome(const OutcomePtr& outcome);
    void forget(); ///< another document comes
    /// Whether batches are run and told of; in a lesson they are not.
    void judgeBatches(bool isOn);
    [[nodiscard]] const JudgedRun& judged() const { return m_judged; }
    /// Of the inputs that were run; one of which all parts were run before one that was stopped.
    /// Null: there is none.
    [[nodiscard]] BatchOutcomePtr batch() const;

signals:
    void changed(); ///< the stocks or the batch have come, or are no longer told of

private:
    void judgeAgain();
    void judgeNow();
    void runBatch();

    const RunController& m_runs;
    Studies& m_studies;
    bool m_judgesBatches = true;
    JudgedRun m_judged;
    QTimer m_calm; ///< since the last edit
};

} // namespace sparkout
