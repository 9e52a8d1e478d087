// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/batch_edits.h"

#include "core/batch/batch_check.h"
#include "core/batch/scenario_source.h"
#include "core/project/project_file.h"

#include <cmath>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr double leastShare = 0.93, mostShare = 1.07; ///< of a value that scatters about itself
constexpr int betweenDressings = 25;                  ///< parts

/// To two digits.
double toTwoDigits(double value) {
    if (value == 0) {
        return 0;
    }
    const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
    // Divided where the step is below 1, so that 0.14 comes out as it is written.
    return step < 1 ? std::round(value / step) / std::round(1 / step)
                    : std::round(value / step) * step;
}

std::vector<double> times(double value, std::initializer_list<double> shares) {
    std::vector<double> values;
    for (const double share : shares) {
        values.push_back(share == 1 ? value : toTwoDigits(value * share));
    }
    return values;
}

Factor uniformFactor(std::vector<double> ends) {
    Factor factor;
    factor.uniform = std::move(ends);
    return factor;
}

Factor growingFactor(std::vector<double> ends, std::optional<int> partsBetweenDressings) {
    Factor factor;
    factor.grows = std::move(ends);
    factor.parts_between_dressings = partsBetweenDressings;
    return factor;
}

Factor normalFactor(std::vector<double> normal, std::vector<double> within) {
    Factor factor;
    factor.normal = std::move(normal);
    factor.within = std::move(within);
    return factor;
}

/// What does not make a part and stays with the user's project.
void keepOwn(Project& of, Project from) {
    of.title = std::move(from.title);
    of.author = std::move(from.author);
    of.notes = std::move(from.notes);
    of.batch = std::move(from.batch);
    of.optimisation = std::move(from.optimisation);
    of.runs = std::move(from.runs);
}

Project batchOnly(Project project) {
    Project names;
    names.batch = std::move(project.batch);
    keepOwn(project, std::move(names));
    return project;
}

} // namespace

Factor usualFactor(FactorKind kind, const Project& project) {
    switch (kind) {
    case FactorKind::stock:
        return uniformFactor(times(project.part.stock_mm, {leastShare, mostShare}));
    case FactorKind::runout: {
        const double runout = project.part.initial_runout_mm;
        return runout > 0 ? normalFactor(times(runout, {1, 0.25}), times(runout, {0.25, 2}))
                          : uniformFactor({0, 0.01});
    }
    case FactorKind::dullness:
        return growingFactor(times(project.wheel.dullness, {0.75, 1.5}), betweenDressings);
    case FactorKind::wheelDiameter:
        return growingFactor(times(project.wheel.diameter_mm, {1, 0.9}), betweenDressings);
    case FactorKind::flowStress: {
        const double stress = project.material.flow_stress_mpa;
        return normalFactor(times(stress, {1, 0.05}), times(stress, {0.85, 1.15}));
    }
    case FactorKind::compliance: return uniformFactor({0.9, 1.1});
    case FactorKind::contactWidth:
        return uniformFactor(times(project.operation == Operation::traverse
                                       ? project.wheel.width_mm
                                       : project.part.length_mm,
                                   {0.96, 1}));
    }
    return {};
}

Project withUsualBatch(Project project) {
    project.batch = Batch{};
    const auto tryFactor = [&project](FactorKind kind, std::optional<Factor> Factors::*member) {
        Factors& factors = project.batch->factors;
        factors.*member = usualFactor(kind, project);
        if (!checkBatch(project).empty()) {
            (factors.*member).reset();
        }
    };
    tryFactor(FactorKind::stock, &Factors::stock_mm);
    if (project.part.initial_runout_mm > 0) {
        tryFactor(FactorKind::runout, &Factors::initial_runout_mm);
    }
    if (project.wheel.dullness > 0) {
        tryFactor(FactorKind::dullness, &Factors::dullness);
    }
    return project;
}

Project withPart(Project project, const BatchResult& batch, std::int64_t part) {
    Project made = ScenarioSource(batch.project).project(part);
    keepOwn(made, std::move(project));
    return made;
}

bool sameBatch(const Project& a, const Project& b) {
    return sameProject(batchOnly(a), batchOnly(b));
}

} // namespace sparkout
