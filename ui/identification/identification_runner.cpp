// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/identification_runner.h"

#include <utility>

namespace sparkout {

void IdentificationRunner::start(const Project& project, const IdentificationRequest& request) {
    run(0, [this, project, request](const Means& means) {
        auto result = std::make_shared<Identification>(identify(project, request, means.stop));
        return [this, result = IdentificationPtr(std::move(result))] { emit finished(result); };
    });
}

} // namespace sparkout
