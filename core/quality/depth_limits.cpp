// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/depth_limits.h"

#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <algorithm>

namespace sparkout {

std::vector<DepthLimit> depthLimits(const Project& project, double b, double stock) {
    std::vector<DepthLimit> limits;
    for (const Requirement& row : requirementRows) {
        const auto depth = row.depthLimit ? row.depthLimit(project, b, stock) : std::nullopt;
        if (depth) {
            limits.push_back({row.kind, *depth});
        }
    }
    return limits;
}

std::vector<ConstraintKind> depthLimitKinds() {
    std::vector<ConstraintKind> kinds;
    for (const bool everyPass : {true, false}) {
        for (const Requirement& row : requirementRows) {
            if (row.depthLimit && row.bindsEveryPass() == everyPass) {
                kinds.push_back(row.kind);
            }
        }
    }
    return kinds;
}

bool wheelStands(const Place& place) {
    switch (place.zone) {
    case Zone::rz1:
        return place.step == Step::e1 || place.step == Step::e2 || place.step == Step::e5;
    case Zone::rz2: return place.step == Step::e2 || place.step == Step::e4;
    case Zone::nz:
    case Zone::section: break;
    }
    return false;
}

double effectiveWidth(const Project& project, const Place& place) {
    const StageFeed* const axial = project.operation->axial();
    if (!axial) {
        return project.part->length_mm;
    }
    if (wheelStands(place)) {
        const ZoneLengths lengths = zoneLengths(project);
        return plungeWidth(project, place.zone == Zone::rz1 ? lengths.rz1 : lengths.rz2);
    }
    const Stage& stage = project.cycle->stages[static_cast<std::size_t>(place.stage - 1)];
    return std::min((stage.*axial->value).value_or(0) / project.machine->work_speed_rpm,
                    project.wheel->width_mm);
}

const DepthLimit* bindingOf(const std::vector<DepthLimit>& limits) {
    const DepthLimit* least = nullptr;
    for (const DepthLimit& limit : limits) {
        if (requirementOf(limit.kind).bindsEveryPass()
            && (!least || limit.depth_mm < least->depth_mm)) {
            least = &limit;
        }
    }
    return least;
}

const char* limitBoundKey(LimitBound bound, ConstraintKind kind) {
    switch (bound) {
    case LimitBound::feed: return "machine_feed";
    case LimitBound::accuracy: return "accuracy";
    case LimitBound::requirement: return requirementOf(kind).key;
    case LimitBound::stock: break;
    }
    return "stock";
}

std::optional<double> greatestInfeed_mm(const Project& project) {
    const auto& range = project.machine->limits.*project.operation->radial().range;
    if (!range || range->size() != 3 || isCoupled(project) || wheelContact(project)
        || feedsContinuously(project)) {
        return std::nullopt;
    }
    return project.operation.infeed_mm((*range)[1], project.machine->work_speed_rpm);
}

} // namespace sparkout
