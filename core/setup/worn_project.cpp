// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/worn_project.h"

#include "core/format/project_file.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/setup/setup_run.h"
#include "core/setup/shared_members.h"

#include <algorithm>

namespace sparkout {

namespace {

Project withoutRuns(const Project& project) {
    Project bare = project;
    bare.runs.clear();
    return bare;
}

Issues errorsOf(const Project& project) {
    Issues issues = validate(project);
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    return issues;
}

} // namespace

std::optional<double> RemovedVolumes::find(const Project& project) const {
    const Project bare = withoutRuns(project);
    const std::lock_guard lock(m_mutex);
    const auto found = std::ranges::find_if(
        m_known, [&bare](const auto& each) { return sameProject(each.first, bare); });
    return found == m_known.end() ? std::nullopt : std::optional(found->second);
}

void RemovedVolumes::add(const Project& project, double removed_mm3) {
    Project bare = withoutRuns(project);
    const std::lock_guard lock(m_mutex);
    if (m_known.size() >= most) {
        m_known.pop_front();
    }
    m_known.emplace_back(std::move(bare), removed_mm3);
}

WornProject wornProject(const Setup& setup, std::size_t surface, const RemovedMetal& removed) {
    WornProject made{surface, setup.surfaces[surface].project, {}};
    const bool isWorn = removed.volume_mm3 > 0 && setup.wear.isGiven();
    if (isWorn || setup.surfaces.size() > 1) { // all surfaces share the factor of the measured Ra
        if (const std::optional<double> factor = factorOfMeasuredRa(setup)) {
            made.project.wheel->roughness_factor = *factor;
        }
    }
    if (isWorn) {
        wearWheel(made.project, setup.wear, removed);
        made.issues = errorsOf(made.project);
    }
    return made;
}

WornProject wornProject(const Setup& setup, std::size_t surface, const std::stop_token& stop,
                        RemovedVolumes* known) {
    RemovedMetal removed;
    for (std::size_t i = 0; i < surface && setup.wear.isGiven() && !stop.stop_requested(); ++i) {
        WornProject before = wornProject(setup, i, removed);
        if (removed.volume_mm3 <= 0) { // in an unfinished set-up
            before.issues = errorsOf(before.project);
        }
        if (!before.issues.empty()) {
            return before;
        }
        std::optional<double> volume_mm3 = known ? known->find(before.project) : std::nullopt;
        if (!volume_mm3) {
            volume_mm3 = runSurface({}, before.project, stop).removed_mm3;
            if (known && !stop.stop_requested()) {
                known->add(before.project, *volume_mm3);
            }
        }
        removed += removedMetal(before.project, *volume_mm3);
    }
    return wornProject(setup, surface, removed);
}

} // namespace sparkout
