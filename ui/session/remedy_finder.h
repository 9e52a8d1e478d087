// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "core/study/remedies.h"
#include "ui/session/job.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <stop_token>

namespace sparkout {

using RemedyResultPtr = std::shared_ptr<const RemedyResult>;

/// Searches for remedies outside the window's thread, shortly after the newest outcome. A newer
/// request stops the older one, whose result is discarded. The destructor stops the work and waits
/// for it.
class RemedyFinder : public QObject {
    Q_OBJECT

public:
    explicit RemedyFinder(QObject* parent = nullptr);

    void request(OutcomePtr outcome); ///< of a project that was run
    void drop();                      ///< stops the search and discards its result
    void end();                       ///< ends the search with the result found so far
    [[nodiscard]] bool running() const { return m_running; }

signals:
    /// Remedies found for this outcome; also emitted at intervals before all are tried.
    void found(sparkout::OutcomePtr outcome, sparkout::RemedyResultPtr result);

private:
    void start();
    void reportBegun(const OutcomePtr& outcome);

    OutcomePtr m_outcome; ///< outcome that waits
    QTimer m_calm;
    std::stop_source m_end;
    bool m_running = false;
    bool m_hasReported = false;
    int m_search = 0; ///< number of the search
    NewestJob m_job;  ///< last: stopped before the members that it uses are destroyed
};

} // namespace sparkout
