// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/starting/starting_project.h"

#include "core/batch/usual_batch.h"
#include "core/catalogue/shipped_catalogue.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/starting/starting_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr const char* usualMachine = "3М151";
constexpr const char* usualInternalMachine = "3К227";
constexpr const char* usualMaterial = "40Х";

/// The kind of operation with or without a wheel travelling along the part.
Operation operationThat(bool travels) {
    const std::size_t kinds = choicesOf<Operation>().size();
    for (std::size_t i = 0; i < kinds; ++i) {
        const Operation operation = Operation::ofIndex(i);
        if (operation->travels == travels) {
            return operation;
        }
    }
    return {};
}

/// The widest wheel that fits into a bore, otherwise the smallest; for a shaft the first.
const WheelEntry* usualWheel(const std::vector<WheelEntry>& wheels,
                             const StartingDrawing& drawing) {
    if (wheels.empty()) {
        return nullptr;
    }
    if (drawing.surface == Surface::external) {
        return &wheels.front();
    }
    const double most_mm = starting::widestBoreWheel * drawing.diameter_mm;
    const auto fit_mm = [most_mm](const WheelEntry& entry) {
        const double diameter_mm = entry.value.diameter_mm;
        return diameter_mm <= most_mm ? diameter_mm : -diameter_mm;
    };
    return &*std::ranges::max_element(wheels, {}, fit_mm);
}

/// The named entry, or the usual one without a name; the names that match if there are several, all
/// known names if none matches.
template <class Entry>
const Entry* chosen(const std::string& name, const Entry* usual, const char* path, Issues& issues) {
    const std::vector<Entry>& entries = shippedEntries<Entry>();
    const std::vector<const Entry*> meant =
        name.empty() ? std::vector{usual} : entriesMeant(entries, name);
    if (meant.size() == 1) {
        return meant.front();
    }
    Keys known{{}, Keys::Kind::choices};
    for (const Entry& each : entries) {
        if (meant.empty() || std::ranges::count(meant, &each) > 0) {
            known.keys.push_back(each.name);
        }
    }
    issues.push_back({meant.empty() ? IssueCode::notOneOf : IssueCode::severalFit, Severity::error,
                      path, Quoted{'"' + name + '"'}, std::move(known)});
    return nullptr;
}

/// A cylinder without steps, ground along its whole length.
Shaft plainCylinder(const Project& project) {
    Shaft shaft;
    shaft.segments = {{project.part->length_mm, project.part->diameter_mm}};
    return shaft;
}

/// A bore in a chuck, with a quill that reaches through it behind the wheel.
Shaft boreWithQuill(const Project& project) {
    Shaft shaft;
    shaft.mounting = Mounting::chuck;
    shaft.quill = Quill{std::round(project.part->length_mm + starting::quillBeyond),
                        std::round(starting::quillShare * project.wheel->diameter_mm)};
    return shaft;
}

/// Everything except the cycle; one stage serves the checks.
Project withoutCycle(const StartingDrawing& drawing, const StartingEntries& entries) {
    Project project;
    Part& part = *project.part;
    project.title = part.name = drawing.name;
    part.surface = drawing.surface;
    part.blind_bore = drawing.surface == Surface::internal && !drawing.ends.freeAtHeadstock;
    part.diameter_mm = drawing.diameter_mm;
    part.upper_deviation_um = drawing.upper_deviation_um;
    part.lower_deviation_um = drawing.lower_deviation_um;
    part.length_mm = drawing.length_mm;
    part.stock_mm = drawing.stock_mm;
    part.initial_runout_mm = drawing.initial_runout_mm;
    part.tolerance = drawing.tolerance;
    project.machine->geometric_runout_um = starting::machineRunout;
    applyEntry(entries.material, project);
    applyEntry(entries.wheel, project);
    applyEntry(entries.machine, project);
    const std::optional<double>& driven = project.machine->limits.wheel_speed_m_s;
    if (const auto& stood = project.wheel->max_speed_m_s; driven && stood) {
        project.machine->wheel_speed_m_s = std::min(*driven, *stood);
    }
    if (!project.machine->stiffness_n_um) {
        project.machine->stiffness_n_um.emplace();
    }
    const bool isCovered = part.length_mm <= project.wheel->width_mm;
    project.operation = drawing.operation.value_or(operationThat(!isCovered));
    part.shaft = drawing.shaft                          ? *drawing.shaft
                 : drawing.surface == Surface::internal ? boreWithQuill(project)
                                                        : plainCylinder(project);
    return project;
}

/// The faults that prevent grinding the drawing with any cycle.
Issues faultsOf(Project project) {
    Stage stage;
    stage.stock_mm = project.part->stock_mm;
    for (const StageFeed& feed : project.operation->feeds) {
        stage.*feed.value = tableOf<Stage>().find(feed.key)->soft.high;
    }
    project.cycle->stages = {std::move(stage)};
    return validate(project);
}

} // namespace

StartingEnds startingEnds(const Project& project) {
    const Part& part = *project.part;
    if (part.surface == Surface::internal) {
        return {.freeAtHeadstock = !part.blind_bore, .freeAtTailstock = true};
    }
    constexpr double same_mm = 1e-6;
    StartingEnds ends;
    double from_mm = 0;
    const double begin_mm = part.shaft.ground_from_mm, end_mm = begin_mm + part.length_mm;
    for (const ShaftSegment& segment : part.shaft.segments) {
        const double to_mm = from_mm + segment.length_mm;
        const bool isThicker = segment.diameter_mm > part.diameter_mm + same_mm;
        if (isThicker && std::abs(to_mm - begin_mm) < same_mm) {
            ends.freeAtHeadstock = false;
        }
        if (isThicker && std::abs(from_mm - end_mm) < same_mm) {
            ends.freeAtTailstock = false;
        }
        from_mm = to_mm;
    }
    return ends;
}

Project withStartingCycle(Project project) {
    const StartingEnds ends = startingEnds(project);
    Project ended = withStartingEnds(project, ends);
    return hasErrors(faultsOf(ended)) ? project : startingCycle(std::move(ended), ends).project;
}

bool hasPlainShaft(const Project& project) {
    const Shaft& shaft = project.part->shaft;
    return project.part->surface == Surface::internal
               ? shaft.segments.empty() && shaft.steady_rests.empty()
               : shaft.segments.size() <= 1 && shaft.steady_rests.empty()
                     && shaft.ground_from_mm == 0;
}

Project withPlainShaft(Project project) {
    project.part->shaft = project.part->surface == Surface::internal ? boreWithQuill(project)
                                                                     : plainCylinder(project);
    return project;
}

std::optional<StartingDrawing> drawingOf(const SizeDesignation& designation) {
    const auto deviations = sizeDeviations(designation);
    if (!deviations) {
        return std::nullopt;
    }
    StartingDrawing drawing;
    drawing.surface = designation.isHole() ? Surface::internal : Surface::external;
    drawing.diameter_mm = designation.nominal_mm;
    drawing.upper_deviation_um = deviations->upper_um;
    drawing.lower_deviation_um = deviations->lower_um;
    return drawing;
}

std::optional<StartingEntries> startingEntries(const StartingNames& names,
                                               const StartingDrawing& drawing, Issues& issues) {
    const bool isBore = drawing.surface == Surface::internal;
    const auto* const machine = chosen(
        names.machine,
        entryMeant(shippedEntries<MachineEntry>(), isBore ? usualInternalMachine : usualMachine),
        "/machine/name", issues);
    const auto* const wheel = chosen(names.wheel, usualWheel(shippedEntries<WheelEntry>(), drawing),
                                     "/wheel/marking", issues);
    const auto* const material =
        chosen(names.material, entryMeant(shippedEntries<MaterialEntry>(), usualMaterial),
               "/material/grade", issues);
    if (!machine || !wheel || !material) {
        return std::nullopt;
    }
    return StartingEntries{*machine, *wheel, *material};
}

StartingAnswer startingProject(const StartingDrawing& drawing, const StartingEntries& entries) {
    Project project = withStartingEnds(withoutCycle(drawing, entries), drawing.ends);
    StartingAnswer answer{std::nullopt, faultsOf(project)};
    if (hasErrors(answer.issues)) {
        return answer;
    }
    StartingCycle start = startingCycle(std::move(project), drawing.ends);
    answer.issues = validate(start.project);
    if (!hasErrors(answer.issues)) {
        start.project = withUsualBatch(std::move(start.project));
        answer.start = std::move(start);
    }
    return answer;
}

} // namespace sparkout
