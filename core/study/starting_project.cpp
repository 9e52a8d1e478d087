// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/starting_project.h"

#include "core/batch/usual_batch.h"
#include "core/catalogue/catalogue.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/machine_fit.h"
#include "core/project/material.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/study/starting_numbers.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
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

/// Whether a machine is an internal grinder, which has no tailstock.
bool isInternalGrinder(const MachineEntry& entry) {
    return !sourceOf(entry.sources, "stiffness_n_um/tailstock");
}

/// Whether a wheel covers the ground length or leaves a zone between the reversals, as the
/// operation needs it; where that is open, a part that is short for the wheel must be covered.
bool canGrind(const Wheel& wheel, const StartingDrawing& drawing) {
    const double width_mm = wheel.width_mm;
    const bool covers = drawing.length_mm <= width_mm;
    const double free_mm = freeOverrun_mm(width_mm, drawing.length_mm, drawing.ends);
    const bool leavesZone = drawing.length_mm > 2 * width_mm - drawing.ends.freeCount() * free_mm;
    const bool isShort = drawing.length_mm < starting::shortPart * width_mm;
    return !drawing.operation              ? covers || (leavesZone && !isShort)
           : (*drawing.operation)->travels ? leavesZone
                                           : covers;
}

/// The grain that the roughness of the work asks for [mm].
double wantedGrain_mm(const Part& part) {
    const double ra_um = workRoughness_um(part);
    const double grit = ra_um > starting::coarseRoughness    ? starting::roughGrit
                        : ra_um >= starting::middleRoughness ? starting::usualGrit
                        : ra_um > starting::finestRoughness  ? starting::fineGrit
                                                             : starting::finestGrit;
    return grainOfGrit(static_cast<int>(grit)).value_or(0);
}

/// How many letters the hardness of a wheel is away from those for a material: J…L for a hardened
/// steel and iron, L…N for another steel.
int lettersAway(char hardness, const Material& material) {
    const bool isSofter = isHardened(material) || isIron(material);
    const char softest = isSofter ? 'J' : 'L', hardest = isSofter ? 'L' : 'N';
    return std::max({softest - hardness, hardness - hardest, 0});
}

/// What speaks against a wheel on a machine, the most important first; less is better.
std::tuple<bool, bool, bool, int, double>
drawbacks(const WheelEntry& entry, const StartingDrawing& drawing, Project onMachine) {
    *onMachine.wheel = entry.value;
    const auto marking = readWheelMarking(entry.value.marking).value_or(WheelMarking());
    const Material& material = *onMachine.material;
    const bool isForIron = marking.abrasive.ends_with("С"); // silicon carbide
    const double wanted_mm = wantedGrain_mm(*onMachine.part);
    return {entry.value.diameter_mm < starting::leastShaftWheel
                || !std::ranges::all_of(machineMisfits(onMachine), isPartMisfit),
            !canGrind(entry.value, drawing), isForIron != isIron(material),
            lettersAway(marking.hardness, material),
            std::abs(std::log(entry.value.grain_mm / wanted_mm))};
}

/// A project's drawing, as far as the choice of a wheel needs it.
StartingDrawing drawingFrom(const Project& project) {
    const Part& part = *project.part;
    StartingDrawing drawing;
    drawing.operation = project.operation;
    drawing.surface = part.surface;
    drawing.diameter_mm = part.diameter_mm;
    drawing.upper_deviation_um = part.upper_deviation_um;
    drawing.lower_deviation_um = part.lower_deviation_um;
    drawing.length_mm = part.length_mm;
    drawing.tolerance = part.tolerance;
    drawing.ends = startingEnds(project);
    return drawing;
}

const WheelEntry& usualWheelOf(const Project& project) {
    return usualWheel(drawingFrom(project), *project.machine, *project.material);
}

Project withNewWheel(Project project, const WheelEntry& entry) {
    *project.wheel = Wheel();
    applyEntry(entry, project);
    return project;
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

/// The part of a drawing, without the body that bends.
Part partOf(const StartingDrawing& drawing) {
    Part part;
    part.name = drawing.name;
    part.surface = drawing.surface;
    part.blind_bore = drawing.surface == Surface::internal && !drawing.ends.freeAtHeadstock;
    part.diameter_mm = drawing.diameter_mm;
    part.upper_deviation_um = drawing.upper_deviation_um;
    part.lower_deviation_um = drawing.lower_deviation_um;
    part.length_mm = drawing.length_mm;
    part.stock_mm = drawing.stock_mm;
    part.initial_runout_mm = drawing.initial_runout_mm;
    part.tolerance = drawing.tolerance;
    return part;
}

/// Everything except the cycle; one stage serves the checks.
Project withoutCycle(const StartingDrawing& drawing, const StartingEntries& entries) {
    Project project;
    Part& part = *project.part;
    part = partOf(drawing);
    project.title = drawing.name;
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

std::optional<StartingCycle> startingCycleOf(const Project& project) {
    const StartingEnds ends = startingEnds(project);
    Project ended = withStartingEnds(project, ends);
    return hasErrors(faultsOf(ended)) ? std::nullopt
                                      : std::optional(startingCycle(std::move(ended), ends));
}

Project withStartingCycle(Project project) {
    if (std::optional<StartingCycle> start = startingCycleOf(project)) {
        return std::move(start->project);
    }
    return project;
}

bool hasPlainShaft(const Project& project) {
    const Shaft& shaft = project.part->shaft;
    return shaft.segments.size() <= 1 && shaft.steady_rests.empty() && shaft.ground_from_mm == 0;
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

const WheelEntry& usualWheel(const StartingDrawing& drawing, const Machine& machine,
                             const Material& material) {
    const std::vector<WheelEntry>& wheels = shippedEntries<WheelEntry>();
    if (drawing.surface == Surface::internal) {
        const double most_mm = std::min(
            starting::widestBoreWheel * drawing.diameter_mm,
            machine.limits.wheel_diameter_mm.value_or(std::numeric_limits<double>::infinity()));
        const auto fit_mm = [most_mm](const WheelEntry& entry) {
            const double diameter_mm = entry.value.diameter_mm;
            return diameter_mm <= most_mm ? diameter_mm : -diameter_mm;
        };
        return *std::ranges::max_element(wheels, {}, fit_mm);
    }
    Project onMachine;
    *onMachine.part = partOf(drawing);
    *onMachine.machine = machine;
    *onMachine.material = material;
    return *std::ranges::min_element(
        wheels, {}, [&](const WheelEntry& entry) { return drawbacks(entry, drawing, onMachine); });
}

Project withUsualWheel(Project project) {
    const WheelEntry& usual = usualWheelOf(project);
    return withNewWheel(std::move(project), usual);
}

Issues wheelAdvice(const Project& project) {
    const std::optional<double>& asked_um = project.part->tolerance.roughness_ra_um;
    const auto usual_um = [](const Project& of) -> std::optional<double> {
        const std::optional<StartingCycle> start = startingCycleOf(of);
        const auto Ra_mm = start ? usualRoughness(start->project) : std::nullopt;
        return Ra_mm ? std::optional(*Ra_mm * units::umPerMm) : std::nullopt;
    };
    const std::optional<double> own_um = asked_um ? usual_um(project) : std::nullopt;
    if (!own_um || *own_um <= *asked_um) {
        return {};
    }
    const WheelEntry& wheel = usualWheelOf(project);
    const Project advised = withNewWheel(project, wheel);
    const std::optional<double> other_um = usual_um(advised);
    if (!other_um || *other_um > *asked_um
        || !std::ranges::all_of(machineMisfits(advised), isPartMisfit)) {
        return {};
    }
    constexpr double digits = 100;
    return {{IssueCode::otherWheel, Severity::warning, "/wheel/marking",
             Amount{std::round(*own_um * digits) / digits, "µm"},
             Keys{{wheel.name}, Keys::Kind::choices}}};
}

Issues machineRefusals(const Project& project) {
    Issues refusals = machineMisfits(project);
    for (Issue& refusal : refusals) {
        refusal.severity = Severity::error;
    }
    if (std::ranges::none_of(refusals, isPartMisfit)) {
        return refusals;
    }
    Keys taking{{}, Keys::Kind::choices};
    for (const MachineEntry& entry : shippedEntries<MachineEntry>()) {
        const MachineLimits& limits = entry.value.limits;
        Project there = project;
        there.machine->limits = limits;
        if (limits.part_diameter_mm && limits.part_length_mm
            && isInternalGrinder(entry) == (project.part->surface == Surface::internal)
            && std::ranges::none_of(machineMisfits(there), isPartMisfit)) {
            taking.keys.push_back(entry.name);
        }
    }
    if (!taking.keys.empty()) {
        refusals.push_back({IssueCode::otherMachines, Severity::error, "/machine/name",
                            Quoted{'"' + project.machine->name + '"'}, std::move(taking)});
    }
    return refusals;
}

std::optional<StartingEntries> startingEntries(const StartingNames& names,
                                               const StartingDrawing& drawing, Issues& issues) {
    const bool isBore = drawing.surface == Surface::internal;
    const auto* const machine = chosen(
        names.machine,
        entryMeant(shippedEntries<MachineEntry>(), isBore ? usualInternalMachine : usualMachine),
        "/machine/name", issues);
    const auto* const material =
        chosen(names.material, entryMeant(shippedEntries<MaterialEntry>(), usualMaterial),
               "/material/grade", issues);
    const WheelEntry* const usual =
        machine && material ? &usualWheel(drawing, machine->value, material->value) : nullptr;
    const auto* const wheel = chosen(names.wheel, usual, "/wheel/marking", issues);
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
