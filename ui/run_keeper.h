// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/outcome.h"

#include <QObject>

namespace sparkout {

class KeptRuns;
class NoticeBar;
class RunController;

/// The window's command to keep the present run, and what it tells of kept runs.
class RunKeeper : public QObject {
    Q_OBJECT

public:
    RunKeeper(KeptRuns& kept, const RunController& runs, NoticeBar& notices, QObject* parent);

    void keep(); ///< the run of the present inputs: at once, or when it is computed
    void setOutcome(OutcomePtr outcome);

signals:
    void told(const QString& text); ///< for the status bar
    void compareWanted();           ///< the user asks for the view of compared runs

private:
    void keepNow();
    void tellChanged();

    KeptRuns& m_kept;
    const RunController& m_runs;
    NoticeBar& m_notices;
    OutcomePtr m_outcome;
    bool m_waiting = false; ///< for the run of the inputs to be kept
    bool m_told = false;    ///< that kept runs of this project come out differently
};

} // namespace sparkout
