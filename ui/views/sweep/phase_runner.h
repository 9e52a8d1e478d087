// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/project/project.h"
#include "ui/session/counted_job.h"

#include <memory>

namespace sparkout {

/// The phases of the stock of a project as the window has them: an immutable value.
struct PhaseOutcome {
    Project project;
    PhaseDecision decision;
};

using PhaseOutcomePtr = std::shared_ptr<const PhaseOutcome>;

/// Decides the phases of the stock off the window's thread.
class PhaseRunner : public CountedJob {
    Q_OBJECT

public:
    using CountedJob::CountedJob;

    void start(const Project& project, StockRange range);

signals:
    void finished(sparkout::PhaseOutcomePtr outcome); ///< undecided after a stop
};

} // namespace sparkout
