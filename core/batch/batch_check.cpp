// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_check.h"

#include "core/batch/scenario_source.h"
#include "core/project/batch.h"
#include "core/project/batch_rules.h"
#include "core/project/validate.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace sparkout {

namespace {

Issues errorsOf(Issues issues) {
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    return issues;
}

/// Every corner must be a project that can be run; the faults of the first that is not are given.
Issues faultsOfExtremes(Project project) {
    project.batch->scenarios = Scenarios::corners;
    const ScenarioSource corners(std::move(project));
    for (std::int64_t part = 0; part < corners.parts(); ++part) {
        Issues issues = errorsOf(validate(corners.project(part)));
        if (!issues.empty()) {
            return issues;
        }
    }
    return {};
}

} // namespace

Issues checkBatch(const Project& project) {
    if (!project.batch) {
        return {{IssueCode::missingKey, Severity::error, "/batch", {}, Phrase::anObject}};
    }
    Issues issues = errorsOf(validate(project));
    Issues faults = batchFaults(project);
    issues.insert(issues.end(), faults.begin(), faults.end());
    return issues.empty() ? faultsOfExtremes(project) : issues;
}

} // namespace sparkout
