// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/part_cost.h"

#include "core/project/batch.h"
#include "core/project/optimisation.h"

namespace sparkout {

std::optional<std::int64_t> partsBetweenDressings(const Project& project) {
    if (!project.optimisation || !project.optimisation->cost) {
        return std::nullopt;
    }
    const Cost& cost = *project.optimisation->cost;
    if (cost.parts_between_dressings || !project.batch || !project.batch->factors.dullness) {
        return cost.parts_between_dressings;
    }
    return project.batch->factors.dullness->parts_between_dressings;
}

double partCost(const Cost& cost, double time_s, std::optional<std::int64_t> parts) {
    constexpr double secondsPerHour = 3600;
    double charged_s = time_s + cost.handling_s, worn = 0;
    if (parts) {
        const auto count = static_cast<double>(*parts);
        charged_s += cost.dressing_s / count;
        worn = cost.dressing_cost / count;
    }
    return cost.machine_per_h / secondsPerHour * charged_s + worn;
}

std::optional<double> costPerPart(const Project& project, double time_s) {
    if (!project.optimisation || !project.optimisation->cost) {
        return std::nullopt;
    }
    return partCost(*project.optimisation->cost, time_s, partsBetweenDressings(project));
}

} // namespace sparkout
