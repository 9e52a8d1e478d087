// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/run_controller.h"

#include <QObject>
#include <QTimer>

namespace sparkout {

class KeptRuns;
class NoticeBar;

/// The window's command to keep the current run, and its reports on kept runs.
class RunKeeper : public QObject {
    Q_OBJECT

public:
    RunKeeper(KeptRuns& kept, const RunController& runs, const Studies& studies, NoticeBar& notices,
              QObject* parent);

    void keep();        ///< keeps the run of the current inputs, now or when it is computed
    void keepAwaited(); ///< after the studies have received an outcome
    /// Runs other inputs in the background, keeps the run under a name and requests the comparison.
    /// A notice shows a long run and can stop it.
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
    const Studies& m_studies;
    NoticeBar& m_notices;
    bool m_waiting = false;  ///< whether the run to be kept is awaited
    bool m_reported = false; ///< whether differences in kept runs of this project were reported
    QString m_asideName;     ///< name of the background run; may be empty
    QTimer m_patience;       ///< a short run needs no notice
    RunController m_aside; ///< last member: stopped before the objects it reports to are destroyed
};

} // namespace sparkout
