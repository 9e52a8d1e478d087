// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/cost.h"

#include "core/project/batch.h"
#include "core/project/optimisation.h"

namespace sparkout {

namespace {

std::optional<int> partsBetweenDressings(const Project& project) {
    const Cost& cost = *project.optimisation->cost;
    if (cost.parts_between_dressings || !project.batch || !project.batch->factors.dullness) {
        return cost.parts_between_dressings;
    }
    return project.batch->factors.dullness->parts_between_dressings;
}

} // namespace

std::optional<double> costPerPart(const Project& project, double time_s) {
    if (!project.optimisation || !project.optimisation->cost) {
        return std::nullopt;
    }
    constexpr double secondsPerHour = 3600;
    const Cost& cost = *project.optimisation->cost;
    double charged_s = time_s + cost.handling_s, worn = 0;
    if (const std::optional<int> parts = partsBetweenDressings(project)) {
        charged_s += cost.dressing_s / *parts;
        worn = cost.dressing_cost / *parts;
    }
    return cost.machine_per_h / secondsPerHour * charged_s + worn;
}

} // namespace sparkout
