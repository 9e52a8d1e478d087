// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/run_controller.h"

#include <QObject>
#include <QTimer>

namespace sparkout {

class KeptRuns;
class NoticeBar;

/// The window's command to keep the present run, and what it reports of kept runs.
class RunKeeper : public QObject {
    Q_OBJECT

public:
    RunKeeper(KeptRuns& kept, const RunController& runs, NoticeBar& notices, QObject* parent);

    void keep(); ///< the run of the present inputs: at once, or when it is computed
    void setOutcome(OutcomePtr outcome);
    /// Runs other inputs aside, keeps them under a name and asks for the view that compares. A
    /// notice shows a run that takes its time, and stops it.
    void keepAside(Project project, const QString& name);

signals:
    void kept(const sparkout::KeptRun& run);
    void reported(const QString& text); ///< for the status bar
    void compareWanted();               ///< the user asks for the view of compared runs

private:
    void keepNow();
    void keepOutcome(const Outcome& outcome, const QString& name = {});
    void reportChanged();
    void showAside();
    void endAside();

    KeptRuns& m_kept;
    const RunController& m_runs;
    NoticeBar& m_notices;
    OutcomePtr m_outcome;
    bool m_waiting = false;  ///< for the run of the inputs to be kept
    bool m_reported = false; ///< that kept runs of this project come out differently
    QString m_asideName;     ///< of the run aside that is wanted; empty: none
    QTimer m_patience;       ///< a short run needs no notice
    RunController m_aside;   ///< last: stopped before what it reports to is gone
};

} // namespace sparkout
