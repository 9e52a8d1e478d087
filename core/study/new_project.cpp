// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/new_project.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/study/operation.h"
#include "core/study/search_edits.h"

#include <optional>
#include <utility>

namespace sparkout {

Project newProject(Operation operation) {
    Project project;
    project.part->tolerance.radial_runout_um = 6;
    project.machine->dwell_entry_s = 0.333;
    project.machine->compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
    Stage rough;
    rough.radial_feed_mm = 0.004;
    rough.axial_feed_mm_min = 1800;
    rough.stock_mm = 0.11;
    Stage finish;
    // becomes 0.1 mm/min of plunge feed: twice as much would miss the tolerance at the stiff end
    finish.radial_feed_mm = operation == Operation::traverse ? 0.002 : 0.001;
    finish.axial_feed_mm_min = 1000;
    finish.stock_mm = 0.04;
    project.cycle->stages = {rough, finish};
    project = withPracticalLimits(std::move(project));
    if (operation == Operation::plunge) {
        project.part->length_mm = 40;
    }
    return withOperation(std::move(project), operation);
}

std::vector<std::string> drawingInputs() {
    return {"/part/diameter_mm", "/part/upper_deviation_um", "/part/lower_deviation_um",
            "/part/length_mm", "/part/stock_mm"};
}

StartingAnswer drawnProject(const StartingDrawing& drawing, const StartingEntries& entries) {
    StartingAnswer answer = startingProject(drawing, entries);
    if (!answer.start) {
        return answer;
    }
    if (Issues refusals = machineRefusals(answer.start->project); !refusals.empty()) {
        return {std::nullopt, std::move(refusals)};
    }
    answer.start->project = usualSearch(std::move(answer.start->project));
    answer.issues = validate(answer.start->project);
    for (Issue& advice : wheelAdvice(answer.start->project)) {
        answer.issues.push_back(std::move(advice));
    }
    return answer;
}

Project undrawnProject(Operation operation) {
    constexpr double never = 1.7e-7; // a value that nobody enters
    StartingDrawing drawing;
    drawing.operation = operation;
    drawing.diameter_mm = 30;
    drawing.lower_deviation_um = -13;
    drawing.length_mm = operation->travels ? 90 : 30;
    drawing.stock_mm = 0.15;
    Issues issues;
    const auto entries = startingEntries({}, drawing, issues);
    const auto answer = entries ? startingProject(drawing, *entries) : StartingAnswer();
    Project project = answer.start ? answer.start->project : newProject(operation);
    project = withPracticalLimits(std::move(project));
    project.part->diameter_mm += never;
    project.part->upper_deviation_um += never;
    project.part->lower_deviation_um -= never;
    project.part->length_mm -= never; // not added, since the wheel must cover a plunge
    project.part->stock_mm += never;
    return project;
}

Project withoutDeviations(Project project) {
    constexpr double never_um = 1.7e-7; // a value that nobody enters
    project.part->upper_deviation_um += never_um;
    project.part->lower_deviation_um -= never_um;
    return project;
}

} // namespace sparkout
