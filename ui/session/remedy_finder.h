// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/remedies/remedies.h"
#include "core/study/outcome.h"
#include "ui/session/newest_job.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <stop_token>

namespace sparkout {

using RemedyResultPtr = std::shared_ptr<const RemedyResult>;

/// Looks for remedies off the window's thread, once no newer outcome has come for a moment. A newer
/// request stops the older one, whose result is dropped. Destroying it stops the work and waits for
/// it.
class RemedyFinder : public QObject {
    Q_OBJECT

public:
    explicit RemedyFinder(QObject* parent = nullptr);

    void request(OutcomePtr outcome); ///< of a project that ran
    void drop();                      ///< and its result
    void end();                       ///< what was found so far is the result
    [[nodiscard]] bool running() const { return m_running; }

signals:
    /// What was found, of this outcome; now and then also before all is tried.
    void found(sparkout::OutcomePtr outcome, sparkout::RemedyResultPtr result);

private:
    void start();
    void reportBegun(const OutcomePtr& outcome);

    OutcomePtr m_outcome; ///< that waits
    QTimer m_calm;
    std::stop_source m_end;
    bool m_running = false;
    bool m_hasReported = false;
    int m_search = 0; ///< its number
    NewestJob m_job;  ///< last: stopped before what it uses is gone
};

} // namespace sparkout
