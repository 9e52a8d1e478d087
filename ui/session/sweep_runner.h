// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_run.h"
#include "ui/session/newest_job.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <memory>
#include <stop_token>

namespace sparkout {

/// All that one sweep gives the window: an immutable value. With issues nothing was run.
struct SweepOutcome {
    Issues issues; ///< why the sweep cannot be run
    SweepResult result;

    [[nodiscard]] bool ran() const { return issues.empty(); }
};

using SweepOutcomePtr = std::shared_ptr<const SweepOutcome>;

/// Runs sweeps off the window's thread, one at a time: a newer one drops the older. It leaves one
/// processor to the window. Destroying it ends what runs and waits for it.
class SweepRunner : public QObject {
    Q_OBJECT

public:
    explicit SweepRunner(QObject* parent = nullptr);

    void start(const Project& project); ///< the project's sweep
    void stop();                        ///< ends it; what is done until then is the outcome
    void drop();                        ///< ends it without an outcome
    [[nodiscard]] bool running() const { return m_progress.isActive(); }

signals:
    void progressed(qint64 done, qint64 points, double left_s); ///< left_s below 0: not known yet
    void finished(sparkout::SweepOutcomePtr outcome);

private:
    void tell();

    QTimer m_progress;
    QElapsedTimer m_took;
    qint64 m_points = 0;
    std::shared_ptr<std::atomic<std::int64_t>> m_done; ///< shared with the sweep that is running
    std::stop_source m_stop;
    NewestJob m_job; ///< the last member: gone before what its sweep uses
};

} // namespace sparkout
