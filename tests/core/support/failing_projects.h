// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/file/project_file.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/study/outcome.h"
#include "core/study/remedies.h"
#include "tests/core/support/random_project.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// Random projects whose cycles fail, for what mends them.
namespace sparkout::samples {

/// A random project, of which some four of five hold or fail for reasons other than limits of
/// practice and delays.
inline Project randomProjectOf(std::uint64_t seed) {
    Project project = readProject(randomProject(seed).dump()).project.value();
    if (seed % 5 != 0) { // with it nearly all fail, and no stage may be run over
        project.least_overlap.reset();
        project.least_overlap_last.reset();
        project.least_steps.reset();
        project.gauge->delay_s.reset();
        project.machine->feed_change_delay_s.reset();
    }
    return project;
}

/// A project about one whose cycle holds: its field, a tolerance or a drive is made narrower than
/// what comes out, so that it fails by little.
inline std::optional<Project> narrowed(std::uint64_t seed) {
    Project project = randomProjectOf(seed);
    const OutcomePtr outcome = evaluate(project);
    if (outcome->result.status != RunStatus::completed) {
        return {};
    }
    double low = 1e9, high = -1e9, runout = 0;
    for (const SectionResult& section : outcome->result.sections) {
        low = std::min(low, section.diameterDeviationMin_mm * 1e3);
        high = std::max(high, section.diameterDeviationMax_mm * 1e3);
        runout = std::max(runout, section.radialRunout_mm * 1e3);
    }
    const double width = std::max(high - low, 0.5);
    const double by = 0.02 + 0.1 * static_cast<double>(seed % 7);
    switch (seed % 4) {
    case 0: // the largest diameter is too large
        project.part->upper_deviation_um = high - by * width;
        project.part->lower_deviation_um = low - 3 * width;
        break;
    case 1: // the smallest is too small
        project.part->lower_deviation_um = low + by * width;
        project.part->upper_deviation_um = high + 3 * width;
        break;
    case 2: // the runout is too large
        project.part->lower_deviation_um = low - 3 * width;
        project.part->upper_deviation_um = high + 3 * width;
        project.part->tolerance.radial_runout_um = std::max(runout * (1 - by / 2), 0.01);
        break;
    default: // the drive is too weak
        project.part->lower_deviation_um = low - 3 * width;
        project.part->upper_deviation_um = high + 3 * width;
        project.machine->wheel_drive_kw = outcome->result.peakPower_w / 1e3 * (1 - by / 2);
        break;
    }
    if (seed % 3 == 0) { // a machine with steps
        const double n = project.machine->work_speed_rpm;
        project.machine->limits.work_speed_rpm = std::vector<double>{n - 40, n + 60, 5};
        const StageFeed& radial = project.operation->radial();
        const double feed = *(project.cycle->stages.front().*radial.value);
        project.machine->limits.*radial.range = std::vector<double>{feed / 50, feed * 5, feed / 50};
    }
    if (!project.part->target_diameter_mm) { // the size that is ground to stays
        const Part& was = *outcome->result.project.part;
        project.part->target_diameter_mm =
            was.diameter_mm + (was.upper_deviation_um + was.lower_deviation_um) / 2e3;
    }
    return project;
}

/// Random projects that fail, every other one by little.
inline std::vector<Project> failingProjects(int count) {
    std::vector<Project> found;
    for (std::uint64_t seed = 1; found.size() < static_cast<std::size_t>(count); ++seed) {
        const std::optional<Project> project =
            seed % 2 == 0 ? narrowed(seed / 2) : std::optional(randomProjectOf(seed));
        if (project && !hasErrors(validate(*project))) {
            const OutcomePtr outcome = evaluate(*project);
            if (remedyGoal(outcome->result, outcome->constraints) == RemedyGoal::holds) {
                found.push_back(*project);
            }
        }
    }
    return found;
}

/// The project with a batch whose stock, dullness, compliance and flow stress scatter as a shop's
/// do; as it is where no such batch can be run.
inline Project withUsualBatch(Project project, int seed) {
    constexpr double stock_mm = 0.02, ofStock = 0.15;
    const double around_mm = std::min(stock_mm, ofStock * project.part->stock_mm);
    const auto about = [](double value, double share) {
        Factor factor;
        factor.uniform = std::vector<double>{value * (1 - share), value * (1 + share)};
        return factor;
    };
    Project with = project;
    Batch batch;
    batch.seed = seed;
    batch.factors.stock_mm = about(project.part->stock_mm, around_mm / project.part->stock_mm);
    batch.factors.compliance = about(1, 0.05);
    batch.factors.flow_stress_mpa = about(project.material->flow_stress_mpa, 0.06);
    if (project.wheel->dullness > 0) {
        batch.factors.dullness = about(project.wheel->dullness, 0.2);
    }
    with.batch = batch;
    return checkBatch(with).empty() ? with : project;
}

} // namespace sparkout::samples
