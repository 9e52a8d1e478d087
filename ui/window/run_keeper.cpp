// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/run_keeper.h"

#include "ui/dialogs/notice_bar.h"
#include "ui/session/kept_runs.h"
#include "ui/text/example_texts.h"
#include "ui/text/texts.h"

#include <QStringList>

#include <utility>

namespace sparkout {

namespace {

const QString keepKey = QStringLiteral("keep-run");
const QString changedKey = QStringLiteral("changed-runs");
const QString asideKey = QStringLiteral("run-aside");
constexpr int patience_ms = 300;

} // namespace

RunKeeper::RunKeeper(KeptRuns& kept, const RunController& runs, const Studies& studies,
                     NoticeBar& notices, QObject* parent)
    : QObject(parent)
    , m_kept(kept)
    , m_runs(runs)
    , m_studies(studies)
    , m_notices(notices)
    , m_aside(nullptr, runs.runner()) {
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience_ms);
    connect(&m_patience, &QTimer::timeout, this, &RunKeeper::showAside);
    connect(&kept, &KeptRuns::replaced, this, [this] {
        m_waiting = false;
        m_reported = false;
        m_aside.stop(); // the run belongs to another document
        endAside();
        m_notices.remove(keepKey);
        m_notices.remove(changedKey);
    });
    connect(&runs, &RunController::started, this, [this] {
        if (std::exchange(m_waiting, false)) {
            emit reported(
                tr("The run was not kept: the inputs were changed before it was computed."));
        }
    });
    connect(&kept, &KeptRuns::runRecalled, this, &RunKeeper::reportChanged);
    connect(&m_aside, &RunController::finished, this, [this](const OutcomePtr& outcome) {
        const QString name = m_asideName;
        endAside();
        keepOutcome(*outcome, name);
    });
}

void RunKeeper::keep() {
    m_waiting = m_runs.running();
    if (!m_waiting && m_studies.outcome) {
        keepNow();
    }
}

void RunKeeper::keepAwaited() {
    if (std::exchange(m_waiting, false)) {
        keepNow();
    }
}

void RunKeeper::keepAside(Project project, const QString& name) {
    endAside();
    m_asideName = name;
    m_aside.request(std::move(project));
    m_patience.start();
}

void RunKeeper::showAside() {
    m_notices.add(
        {asideKey,
         Mark::none,
         [name = m_asideName] {
             return tr("“%1” is being computed and will be kept.").arg(runName(name.toStdString()));
         },
         {{[] { return tr("Stop"); },
           [this] {
               m_aside.stop();
               endAside();
               emit reported(tr("Stopped; nothing was kept."));
           }}}});
}

void RunKeeper::endAside() {
    m_patience.stop();
    m_asideName.clear();
    m_notices.remove(asideKey);
}

void RunKeeper::keepNow() {
    keepOutcome(*m_studies.outcome);
}

void RunKeeper::keepOutcome(const Outcome& outcome, const QString& name) {
    m_notices.remove(keepKey);
    const KeptRuns::Kept kept = m_kept.keep(outcome, name);
    if (kept == KeptRuns::Kept::yes) {
        emit this->kept(m_kept.all().back());
        if (!name.isEmpty()) {
            emit compareWanted();
        }
        emit reported(tr("Kept as “%1”; the view Compare draws it over the current run.")
                          .arg(runName(m_kept.all().back().name)));
        return;
    }
    const bool full = kept == KeptRuns::Kept::full;
    m_notices.add({keepKey,
                   Mark::warning,
                   [full] {
                       return full ? tr("The run was not kept: the project file would grow too "
                                        "large. Delete kept runs that are no longer needed.")
                                   : tr("There is no run to keep: the inputs are refused.");
                   },
                   {}});
}

/// Reports changed runs once per project, when all of them are recomputed.
void RunKeeper::reportChanged() {
    QStringList names;
    for (int run = 0; run < m_kept.count(); ++run) {
        if (m_kept.isChanged(run)) {
            names << runName(m_kept.all()[static_cast<std::size_t>(run)].name);
        }
    }
    if (m_kept.busy() || m_reported || names.isEmpty()) {
        return;
    }
    m_reported = true;
    const int count = static_cast<int>(names.size());
    m_notices.add(
        {changedKey,
         Mark::warning,
         [count, names] {
             return tr("%n kept runs give other results with this version of the program: %1.",
                       nullptr, count)
                 .arg(printableText(names.mid(0, 3).join(QStringLiteral(", ")))
                      + (count > 3 ? QStringLiteral(", …") : QString()));
         },
         {{[] { return tr("Show the differences"); }, [this] { emit compareWanted(); }}}});
}

} // namespace sparkout
