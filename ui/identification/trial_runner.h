// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/trial_design.h"
#include "core/project/project.h"
#include "ui/session/counted_job.h"

#include <memory>

namespace sparkout {

using TrialDesignPtr = std::shared_ptr<const TrialDesign>;

/// Proposes trials and sorts them by what they tell.
class TrialRunner : public CountedJob {
    Q_OBJECT

public:
    using CountedJob::CountedJob;

    void start(const Project& project, const TrialRequest& request);

signals:
    void finished(sparkout::TrialDesignPtr design);
};

} // namespace sparkout
