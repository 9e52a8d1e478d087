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

/// Every corner must be a project that can be run; returns the faults of the first that is not. For
/// the zones' own values the two ends of all together suffice: each value increases its zone's
/// stock, runout or compliance, so any value that is too small or too large is so at one of these
/// ends.
Issues faultsOfExtremes(Project project) {
    project.batch->scenarios = Scenarios::corners;
    const ScenarioSource corners(std::move(project));
    const std::size_t all = corneredCount(corners.factors());
    const auto ofPart =
        static_cast<std::size_t>(std::ranges::count_if(corners.factors(), [](const GivenFactor& f) {
            return f.place < 0 && !isOfReading(f.kind);
        }));
    const std::int64_t zones = ((std::int64_t{1} << all) - 1) >> ofPart << ofPart;
    for (std::int64_t part = 0; part < std::int64_t{1} << ofPart; ++part) {
        for (const std::int64_t corner : {part, part | zones}) {
            Issues issues = errorsOf(validate(corners.project(corner)));
            if (!issues.empty()) {
                return issues;
            }
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
