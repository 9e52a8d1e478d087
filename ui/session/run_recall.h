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

/// Recomputes kept runs one after the other outside the window's thread: the summaries of all, and
/// the feeds of the wanted ones. Runs are identified by their inputs, which never change.
class RunRecall : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Sets all kept runs and those that are drawn, as the texts of their inputs.
    void setRuns(std::set<std::string> all, std::set<std::string> wanted);
    [[nodiscard]] const RecalledRun* find(const std::string& inputs) const; ///< null: not yet
    [[nodiscard]] bool busy() const { return !m_pending.empty(); }

signals:
    void recalled(const std::string& inputs); ///< one more run was recomputed

private:
    [[nodiscard]] bool isOpen(const std::string& inputs) const;
    void take(const std::string& inputs, RecalledRun run);

    std::set<std::string> m_all, m_wanted;
    std::set<std::string> m_pending; ///< runs of the running job
    std::map<std::string, RecalledRun> m_runs;
    NewestJob m_job; ///< last: stopped before the members that it reports to are destroyed
};

} // namespace sparkout
