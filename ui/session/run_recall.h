// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/recalled_run.h"
#include "ui/session/newest_job.h"

#include <QObject>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace sparkout {

/// Computes kept runs again, one after the other, off the window's thread: all for their summaries,
/// the wanted ones for their feeds too. Runs are told apart by their inputs, which never change.
class RunRecall : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// All kept runs, and which of them are drawn, as the texts of their inputs.
    void setRuns(std::set<std::string> all, std::set<std::string> wanted);
    [[nodiscard]] const RecalledRun* find(const std::string& inputs) const; ///< null: not yet
    [[nodiscard]] bool busy() const { return !m_pending.empty(); }

signals:
    void recalled(const std::string& inputs); ///< one more

private:
    [[nodiscard]] bool isOpen(const std::string& inputs) const;
    void take(const std::string& inputs, RecalledRun run);

    std::set<std::string> m_all, m_wanted;
    std::set<std::string> m_pending; ///< of the job that runs
    std::map<std::string, RecalledRun> m_runs;
    NewestJob m_job; ///< last: stopped before what it reports to is gone
};

} // namespace sparkout
