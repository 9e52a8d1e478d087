// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/phase_runner.h"

#include <utility>

namespace sparkout {

void PhaseRunner::start(const Project& project, StockRange range) {
    run(1, [this, project, range](const Means& means) {
        auto outcome = std::make_shared<PhaseOutcome>();
        outcome->decision = decidePhases(project, range, means.stop);
        outcome->project = project;
        return [this, outcome = PhaseOutcomePtr(std::move(outcome))] { emit finished(outcome); };
    });
}

} // namespace sparkout
