// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/whole_batch.h"
#include "ui/session/counted_job.h"

#include <memory>

namespace sparkout {

using SobolIndicesPtr = std::shared_ptr<const SobolIndices>;

/// Runs batches, or the parts that Sobol indices take.
class BatchRunner : public CountedJob {
    Q_OBJECT

public:
    using CountedJob::CountedJob;

    void start(const Project& project);                    ///< the project's batch
    void startIndices(const Project& project, int points); ///< of a batch that checkBatch() passes

signals:
    void finished(sparkout::BatchOutcomePtr outcome);
    void indicesFound(sparkout::SobolIndicesPtr indices); ///< null: stopped, or there are none
};

} // namespace sparkout
