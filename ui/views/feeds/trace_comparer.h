// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/trace_comparison.h"
#include "core/study/outcome.h"
#include "ui/session/newest_job.h"

#include <QObject>

#include <memory>
#include <vector>

namespace sparkout {

using TraceComparisonsPtr = std::shared_ptr<const std::vector<TraceComparison>>;

/// Compares the traces of a project with its run on another thread; a newer run replaces the older
/// one.
class TraceComparer : public QObject {
    Q_OBJECT

public:
    explicit TraceComparer(QObject* parent = nullptr);

    void compare(const OutcomePtr& outcome);
    void drop(); ///< discards a running comparison
    [[nodiscard]] bool running() const { return m_running; }

signals:
    void compared(sparkout::TraceComparisonsPtr traces, sparkout::OutcomePtr of);

private:
    bool m_running = false;
    NewestJob m_job; ///< last member: stopped before the objects it reports to are destroyed
};

} // namespace sparkout
