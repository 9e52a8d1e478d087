// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/batch/sensitivity.h"
#include "core/issue.h"
#include "core/project/given_factors.h"
#include "ui/session/newest_job.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// All that one batch gives the window: an immutable value. With issues nothing was run.
struct BatchOutcome {
    Issues issues; ///< why the batch cannot be run
    BatchResult result;
    BatchSummary summary;
    std::vector<std::optional<RankRegression>> regressions; ///< by characteristic
    std::vector<GivenFactor> factors;
    std::vector<std::vector<double>> drawn; ///< values of the factors, by kept part

    [[nodiscard]] bool ran() const { return issues.empty(); }
};

using BatchOutcomePtr = std::shared_ptr<const BatchOutcome>;
using SobolIndicesPtr = std::shared_ptr<const SobolIndices>;

/// Checks and runs the batch of a project, in this thread.
[[nodiscard]] BatchOutcomePtr runWholeBatch(const Project& project, const BatchOptions& options);

/// How many parts the batch of a project has.
[[nodiscard]] std::int64_t partsOf(const Project& project);

/// How many parts Sobol indices take.
[[nodiscard]] std::int64_t partsOfIndices(const Project& project, int points);

/// Runs batches, or the parts that Sobol indices take, off the window's thread, one at a time: a
/// newer one drops the older. It leaves one processor to the window. Destroying it ends what runs
/// and waits for it.
class BatchRunner : public QObject {
    Q_OBJECT

public:
    explicit BatchRunner(QObject* parent = nullptr);

    void start(const Project& project);                    ///< the project's batch
    void startIndices(const Project& project, int points); ///< of a batch that checkBatch() passes
    void stop(); ///< ends it; what is done until then is the outcome
    void drop(); ///< ends it without an outcome
    [[nodiscard]] bool running() const { return m_progress.isActive(); }

signals:
    void progressed(qint64 done, qint64 parts, double left_s); ///< left_s below 0: not known yet
    void finished(sparkout::BatchOutcomePtr outcome);
    void indicesFound(sparkout::SobolIndicesPtr indices); ///< null: stopped, or there are none

private:
    /// Computes, and says what to do with it in the window's thread.
    using Work = std::function<NewestJob::Answer(const BatchOptions&)>;

    void run(std::int64_t parts, Work work);
    void tell();

    QTimer m_progress;
    QElapsedTimer m_took;
    qint64 m_parts = 0;
    std::shared_ptr<std::atomic<std::int64_t>> m_done; ///< shared with the batch that is running
    std::stop_source m_stop;
    NewestJob m_job; ///< the last member: gone before what its batch uses
};

} // namespace sparkout
