// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_run.h"
#include "ui/session/counted_job.h"

#include <memory>

namespace sparkout {

/// All that one sweep gives the window: an immutable value. With issues nothing was run.
struct SweepOutcome {
    Issues issues; ///< why the sweep cannot be run
    SweepResult result;

    [[nodiscard]] bool ran() const { return issues.empty(); }
};

using SweepOutcomePtr = std::shared_ptr<const SweepOutcome>;

/// Runs sweeps.
class SweepRunner : public CountedJob {
    Q_OBJECT

public:
    using CountedJob::CountedJob;

    void start(const Project& project); ///< the project's sweep

signals:
    void finished(sparkout::SweepOutcomePtr outcome);
};

} // namespace sparkout
