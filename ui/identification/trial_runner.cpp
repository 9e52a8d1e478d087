// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/trial_runner.h"

#include <utility>

namespace sparkout {

void TrialRunner::start(const Project& project, const TrialRequest& request) {
    run(0, [this, project, request](const Means& means) {
        auto design = std::make_shared<TrialDesign>(designTrial(project, request, means.stop));
        return [this, design = TrialDesignPtr(std::move(design))] { emit finished(design); };
    });
}

} // namespace sparkout
