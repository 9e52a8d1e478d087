// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/long_project.h"
#include "tests/whole_project.h"

#include "core/file/project_file.h"
#include "core/study/new_project.h"
#include "core/study/operation.h"

#include <chrono>

namespace sparkout {

Project longProject(int sections) {
    Project project = withSections(newProject(Operation::plunge), sections);
    project.part->radii_per_section = 360;
    project.part->stock_mm = 0.2;
    project.part->initial_runout_mm = 0.05;
    project.part->profile = ProfileForm::ellipse;
    project.wheel->dullness = 0.04;
    project.machine->work_speed_rpm = 500;
    project.gauge->control = Control::position;
    project.cycle->stages.resize(1);
    Stage& stage = project.cycle->stages.front();
    stage.radial_feed_mm_min = 0.04;
    stage.stock_mm = project.part->stock_mm;
    stage.spark_out = {};
    return project;
}

Project projectOfPages(Project project, int pages) {
    constexpr int valuesOfPage = 300; // some 250 go on one
    project.batch->parts = 24;
    project.batch->factors = {};
    auto& values = project.batch->factors.stock_mm.emplace().measured.emplace();
    for (int i = 0; i < pages * valuesOfPage; ++i) {
        values.push_back(0.14 + 1e-8 * i);
    }
    return project;
}

Project projectOfRuns(Project project, int runs) {
    project.runs.clear();
    const std::string inputs = writeProject(project);
    for (int i = 0; i < runs; ++i) {
        project.runs.push_back({"run " + std::to_string(i), "", "", {inputs}, {"{}"}});
    }
    return project;
}

OutcomePtr runForSeconds(const Project& project, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const bool once = project.operation == Operation::traverse || project.sections < 10;
    const Clock::time_point end = Clock::now() + std::chrono::seconds(once ? 0 : 3);
    OutcomePtr outcome;
    do {
        outcome = evaluate(project, stop);
    } while (outcome && Clock::now() < end);
    return outcome;
}

} // namespace sparkout
