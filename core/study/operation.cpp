// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/operation.h"

#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/member.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/study/search_edits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sparkout {

namespace {

constexpr double usualCompliance_mm_per_n = 1.5e-4;

/// mm/min of plunge feed for one mm per double stroke: a usual pair is 0.4 and 0.004.
constexpr double plungePerTraverseFeed = 100;

/// Cut to six significant digits, as people enter numbers.
double rounded(double value) {
    if (value == 0) {
        return 0;
    }
    const double scale = std::pow(10.0, 5 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

/// Interpolates the compliance at a share 0…1 of the ground length between the zones' values.
double between(const ZoneCompliance& zones, double share) {
    return share < 0.5 ? zones.rz1 + (zones.nz - zones.rz1) * 2 * share
                       : zones.nz + (zones.rz2 - zones.nz) * (2 * share - 1);
}

/// Interpolates the listed compliance at a share of the ground length.
double between(const std::vector<double>& sections, double share) {
    const double at =
        std::clamp(share * double(sections.size()) - 0.5, 0.0, double(sections.size() - 1));
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, sections.size() - 1);
    return sections[low] + (sections[high] - sections[low]) * (at - double(low));
}

/// Compliance along the part, from the headstock: zones may be entered from the other side.
double complianceAt(const Project& project, double share) {
    const GivenCompliance& given = project.machine->compliance_mm_per_n;
    if (const auto* zones = std::get_if<ZoneCompliance>(&given)) {
        const bool turned = project.machine->entry_side == EntrySide::tailstock;
        return between(*zones, turned ? 1 - share : share);
    }
    const auto* sections = std::get_if<std::vector<double>>(&given);
    return sections && !sections->empty() ? between(*sections, share) : usualCompliance_mm_per_n;
}

/// The compliance of sections on the first `reach_mm` of the ground length.
std::vector<double> sectionCompliance(const Project& project, int count, double reach_mm) {
    const double share = reach_mm / project.part->length_mm;
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int j = 0; j < count; ++j) {
        values.push_back(rounded(complianceAt(project, share * (j + 0.5) / count)));
    }
    return values;
}

ZoneCompliance zoneCompliance(const Project& project) {
    const bool turned = project.machine->entry_side == EntrySide::tailstock;
    return {rounded(complianceAt(project, turned ? 1 : 0)), rounded(complianceAt(project, 0.5)),
            rounded(complianceAt(project, turned ? 0 : 1))};
}

/// The compliance in the form of an operation: a value for each zone, or for each section on the
/// first `reach_mm`.
GivenCompliance givenCompliance(const Project& project, const Operation& operation,
                                double reach_mm) {
    if (operation->travels) {
        return zoneCompliance(project);
    }
    return sectionCompliance(project, project.sections, reach_mm);
}

void makePlunge(Project& project) {
    for (Stage& stage : project.cycle->stages) {
        if (stage.radial_feed_mm && stage.feeds()) {
            stage.radial_feed_mm_min =
                rounded(std::clamp(*stage.radial_feed_mm * plungePerTraverseFeed, 0.02, 5.0));
        }
        stage.radial_feed_mm.reset();
        stage.axial_feed_mm_min.reset();
        stage.continuous_feed_mm_min.reset();
    }
    project = fitted(std::move(project), Operation::plunge);
}

/// Keeps the wheel from passing the wall of a blind bore; no other overrun is negative.
void keepOffTheWall(Project& project) {
    Machine& machine = *project.machine;
    const bool wall = project.part->surface == Surface::internal && project.part->blind_bore;
    const bool atEntry = machine.entry_side == EntrySide::headstock;
    const auto kept = [wall](double overrun, bool atHeadstock) {
        return wall && atHeadstock ? std::min(overrun, 0.0) : std::max(overrun, 0.0);
    };
    machine.overrun_entry_mm = kept(machine.overrun_entry_mm, atEntry);
    machine.overrun_exit_mm = kept(machine.overrun_exit_mm, !atEntry);
}

/// Sets overruns that leave a zone between the reversals, L_p > (B − o1) + (B − o2), each bracket
/// above zero: a third or half of the wheel, where the current ones do not. The wheel is unchanged;
/// if neither leaves one, the length is refused.
void fitZones(Project& project) {
    const double width = project.wheel->width_mm;
    Machine& machine = *project.machine;
    keepOffTheWall(project);
    const auto fits = [&] {
        return machine.overrun_entry_mm < width && machine.overrun_exit_mm < width
               && 2 * width - machine.overrun_entry_mm - machine.overrun_exit_mm
                      < project.part->length_mm;
    };
    for (const double share : {1.0 / 3, 1.0 / 2}) {
        if (!fits()) {
            machine.overrun_entry_mm = machine.overrun_exit_mm = rounded(share * width);
            keepOffTheWall(project);
        }
    }
}

void makeTraverse(Project& project) {
    auto& stages = project.cycle->stages;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        Stage& stage = stages[i];
        if (stage.radial_feed_mm_min && stage.feeds()) {
            stage.radial_feed_mm = rounded(
                std::clamp(*stage.radial_feed_mm_min / plungePerTraverseFeed, 0.0005, 0.02));
        }
        stage.radial_feed_mm_min.reset();
        if (!stage.axial_feed_mm_min) {
            const bool roughing = i + 1 < stages.size();
            stage.axial_feed_mm_min = roughing ? 1800 : 300;
        }
    }
    project.gauge->section.reset();
    project.gauge->position_mm.reset();
    project.gauge->compliance_mm_per_n.reset();
    project = fitted(std::move(project), Operation::traverse);
}

/// Drops values of single zones or sections, which do not apply to the new ones.
void forgetZones(Project& project) {
    project.part->zone_stock_mm.reset();
    project.part->zone_runout_mm.reset();
    project.machine->zone_compliance.reset();
    if (project.machine->form) {
        project.machine->form->roundness_um.reset();
        project.machine->form->runout_um.reset();
    }
    if (project.batch) {
        project.batch->zone_stock_mm.reset();
        project.batch->zone_runout_mm.reset();
        project.batch->zone_compliance.reset();
    }
}

/// A plain shaft: the ground length with an overhang at both ends.
void giveUsualShaft(Part& part) {
    const double overhang = std::clamp(rounded(part.diameter_mm), 20.0, 100.0);
    double length = part.length_mm + 2 * overhang;
    for (const SteadyRest& rest : part.shaft.steady_rests) {
        length = std::max(length, rest.position_mm);
    }
    part.shaft.ground_from_mm = overhang;
    part.shaft.segments = {{length, part.diameter_mm}};
}

/// A quill that reaches through the bore behind a wheel thicker than itself.
Quill usualQuill(const Project& project) {
    Quill quill;
    quill.length_mm = std::min(rounded(project.part->length_mm + 20), 2000.0);
    quill.diameter_mm =
        rounded(std::min(project.wheel->diameter_mm, project.part->diameter_mm) * 0.6);
    return quill;
}

/// Restores a member's value from `last` unless it was edited after the switch.
template <class T>
void giveBack(T& made, const T& now, const T& thence, const T& last) {
    if (now == thence) {
        made = last;
    }
}

bool sameFeeds(const Stage& a, const Stage& b) {
    return a.radial_feed_mm == b.radial_feed_mm && a.radial_feed_mm_min == b.radial_feed_mm_min
           && a.feeds() == b.feeds();
}

/// The stage of the last project that corresponds to stage i: the same number or, if stages were
/// added or removed, the one with the feeds that the switch made; null if there is none.
const Stage* stageOfLastTime(std::size_t i, const Project& now, const Project& thence,
                             const Project& last) {
    const auto& stages = last.cycle->stages;
    if (stages.size() == now.cycle->stages.size()) {
        return &stages[i];
    }
    for (std::size_t j = 0; j < stages.size(); ++j) {
        if (sameFeeds(thence.cycle->stages[j], now.cycle->stages[i])) {
            return &stages[j];
        }
    }
    return nullptr;
}

/// Feeds belong to one operation: they are restored whatever was edited under the other.
void giveBackFeeds(Project& made, const Project& now, const Project& thence, const Project& last) {
    for (std::size_t i = 0; i < made.cycle->stages.size(); ++i) {
        Stage& stage = made.cycle->stages[i];
        const Stage* was = stageOfLastTime(i, now, thence, last);
        if (!was) {
            continue;
        }
        stage.axial_feed_mm_min = was->axial_feed_mm_min;
        if (stage.feeds() == was->feeds()) {
            stage.radial_feed_mm = was->radial_feed_mm;
            stage.radial_feed_mm_min = was->radial_feed_mm_min;
            stage.continuous_feed_mm_min = was->continuous_feed_mm_min;
        }
    }
}

void giveBackGauge(Gauge& made, const Gauge& now, const Gauge& thence, const Gauge& last) {
    giveBack(made.section, now.section, thence.section, last.section);
    giveBack(made.position_mm, now.position_mm, thence.position_mm, last.position_mm);
    giveBack(made.compliance_mm_per_n, now.compliance_mm_per_n, thence.compliance_mm_per_n,
             last.compliance_mm_per_n);
}

/// Removes what the switch added to the search.
void giveBackLevels(Project& made, const Project& now, const Project& thence, const Project& last) {
    if (!made.optimisation || !now.optimisation || !thence.optimisation || !last.optimisation) {
        return;
    }
    for (const auto levels : {&Optimisation::radial_feed_mm, &Optimisation::axial_feed_mm_min,
                              &Optimisation::radial_feed_mm_min}) {
        giveBack((*made.optimisation).*levels, (*now.optimisation).*levels,
                 (*thence.optimisation).*levels, (*last.optimisation).*levels);
    }
}

/// Restores values of single zones or sections that the switch to another operation dropped.
void giveBackZones(Project& made, const Project& last) {
    made.part->zone_stock_mm = last.part->zone_stock_mm;
    made.part->zone_runout_mm = last.part->zone_runout_mm;
    made.machine->zone_compliance = last.machine->zone_compliance;
    if (made.machine->form && last.machine->form) {
        made.machine->form->roundness_um = last.machine->form->roundness_um;
        made.machine->form->runout_um = last.machine->form->runout_um;
    }
    if (made.batch && last.batch) {
        made.batch->zone_stock_mm = last.batch->zone_stock_mm;
        made.batch->zone_runout_mm = last.batch->zone_runout_mm;
        made.batch->zone_compliance = last.batch->zone_compliance;
    }
}

} // namespace

Project fitted(Project project, Operation operation) {
    operation.match([&](Traverse) { fitZones(project); },
                    [&](Plunge) { // grinds the length that the current wheel covers
                        Part& part = *project.part;
                        part.length_mm = std::min(part.length_mm, project.wheel->width_mm);
                    });
    return project;
}

Project withOperation(Project project, Operation operation) {
    if (project.operation == operation) {
        return project;
    }
    if (!std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n)) {
        const Project reached = fitted(project, operation);
        project.machine->compliance_mm_per_n =
            givenCompliance(project, operation, reached.part->length_mm);
    }
    if (project.least_steps == project.operation->usualLeastSteps) {
        project.least_steps = operation->usualLeastSteps;
    }
    forgetZones(project);
    operation.match([&](Traverse) { makeTraverse(project); }, [&](Plunge) { makePlunge(project); });
    project.operation = operation;
    return withSearchFor(std::move(project));
}

Project withSections(Project project, int sections) {
    auto& given = project.machine->compliance_mm_per_n;
    const auto* list = std::get_if<std::vector<double>>(&given);
    if (list && list->size() != static_cast<std::size_t>(sections)) {
        given = sectionCompliance(project, sections, project.part->length_mm);
    }
    if (project.gauge->section && *project.gauge->section >= sections) {
        project.gauge->section.reset();
    }
    if (sections != project.sections && !project.operation->travels) {
        forgetZones(project);
    }
    project.sections = sections;
    return project;
}

Project withGivenCompliance(Project project, bool given) {
    auto& compliance = project.machine->compliance_mm_per_n;
    if (!given) {
        compliance = std::monostate{};
        project = withComputable(std::move(project));
    } else {
        compliance = givenCompliance(project, project.operation, project.part->length_mm);
    }
    return project;
}

Project withComputable(Project project) {
    if (!std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n)) {
        return project;
    }
    if (!project.machine->stiffness_n_um) {
        project.machine->stiffness_n_um.emplace();
    }
    Shaft& shaft = project.part->shaft;
    if (project.part->surface == Surface::internal) {
        shaft.quill = shaft.quill ? shaft.quill : usualQuill(project);
    } else if (shaft.segments.empty()) {
        giveUsualShaft(*project.part);
    }
    return project;
}

Project withRadii(Project project, std::vector<double> radii_um) {
    project.part->radii_per_section = static_cast<int>(radii_um.size());
    project.part->radii_um = std::move(radii_um);
    project.part->profile = ProfileForm::measured;
    return project;
}

Project withOperation(const Project& project, Operation operation, const Project* last) {
    Project made = withOperation(project, operation);
    if (!last || last->operation != operation || project.operation == operation) {
        return made;
    }
    const Project thence = withOperation(*last, project.operation);
    giveBackFeeds(made, project, thence, *last);
    giveBackGauge(*made.gauge, *project.gauge, *thence.gauge, *last->gauge);
    giveBack(made.part->length_mm, project.part->length_mm, thence.part->length_mm,
             last->part->length_mm);
    giveBack(made.least_steps, project.least_steps, thence.least_steps, last->least_steps);
    giveBackLevels(made, project, thence, *last);
    Machine& machine = *made.machine;
    const Machine& now = *project.machine;
    giveBack(machine.overrun_entry_mm, now.overrun_entry_mm, thence.machine->overrun_entry_mm,
             last->machine->overrun_entry_mm);
    giveBack(machine.overrun_exit_mm, now.overrun_exit_mm, thence.machine->overrun_exit_mm,
             last->machine->overrun_exit_mm);
    if (made.sections == last->sections) {
        giveBack(machine.compliance_mm_per_n, now.compliance_mm_per_n,
                 thence.machine->compliance_mm_per_n, last->machine->compliance_mm_per_n);
        giveBackZones(made, *last);
    }
    return fitted(std::move(made), operation);
}

} // namespace sparkout
