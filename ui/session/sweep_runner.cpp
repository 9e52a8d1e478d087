// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/sweep_runner.h"

#include <utility>

namespace sparkout {

void SweepRunner::start(const Project& project) {
    run(pointsOf(project), [this, project](const Means& means) {
        auto outcome = std::make_shared<SweepOutcome>();
        outcome->issues = checkSweep(project);
        if (outcome->ran()) {
            outcome->result = runSweep(project, {means.threads, means.stop, means.done});
        }
        return [this, outcome = SweepOutcomePtr(std::move(outcome))] { emit finished(outcome); };
    });
}

} // namespace sparkout
