// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/project/project.h"
#include "ui/session/counted_job.h"

#include <memory>

namespace sparkout {

using IdentificationPtr = std::shared_ptr<const Identification>;

/// Fits parameters to measurements. How many cycles it takes is not known before.
class IdentificationRunner : public CountedJob {
    Q_OBJECT

public:
    using CountedJob::CountedJob;

    void start(const Project& project, const IdentificationRequest& request);

signals:
    void finished(sparkout::IdentificationPtr result);
};

} // namespace sparkout
