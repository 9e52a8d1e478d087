// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"

#include "core/project/batch.h"
#include "core/project/conditions.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/measured.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/sweep.h"
#include "core/project/wheel.h"
#include "core/text.h"

namespace sparkout {

template class Indirect<Batch>;
template class Indirect<CardEntries>;
template class Indirect<Cycle>;
template class Indirect<Gauge>;
template class Indirect<Machine>;
template class Indirect<Material>;
template class Indirect<Optimisation>;
template class Indirect<Part>;
template class Indirect<Sweep>;
template class Indirect<Wheel>;
template class OptionalShared<Measured>;

int placeCount(const Project& project) {
    return project.operation->travels ? 3 : project.sections;
}

int zoneSectionCount(const Project& project) {
    const bool several = project.operation->travels && project.zone_sections > 1;
    return several ? placeCount(project) * project.zone_sections : 0;
}

template <>
const StructInfo& tableOf<KeptRun>() {
    static const std::array rows{
        SPARKOUT_FIELD(KeptRun, name, .label = SPARKOUT_NOOP("Input", "Name"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Name of the run.")),
        SPARKOUT_FIELD(KeptRun, when, .label = SPARKOUT_NOOP("Input", "When"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Date and time in UTC, ISO 8601.")),
        SPARKOUT_FIELD(KeptRun, engine_version, .label = SPARKOUT_NOOP("Input", "Engine version"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Version of the program that ran it.")),
        SPARKOUT_FIELD(KeptRun, inputs, .label = SPARKOUT_NOOP("Input", "Inputs"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "The project as it was run.")),
        SPARKOUT_FIELD(KeptRun, summary, .label = SPARKOUT_NOOP("Input", "Summary"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Counts, final radii and deviations.")),
    };
    static const StructInfo info = makeTable<KeptRun>(SPARKOUT_NOOP("Struct", "Kept run"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Project>() {
    static const std::array rows{
        SPARKOUT_FIELD(Project, title, .label = SPARKOUT_NOOP("Input", "Title"), .page = Page::part,
                       .usual = true, .hint = SPARKOUT_NOOP("Input", "Title of the project.")),
        SPARKOUT_FIELD(Project, author, .label = SPARKOUT_NOOP("Input", "Author"),
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Who designed the cycle.")),
        SPARKOUT_FIELD(Project, notes, .label = SPARKOUT_NOOP("Input", "Notes"), .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Anything worth knowing about the project.")),
        SPARKOUT_FIELD(Project, coolant, .label = SPARKOUT_NOOP("Input", "Coolant"), .sparse = true,
                       .page = Page::machine,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Coolant and its concentration, for the operation card.")),
        SPARKOUT_FIELD(Project, operation, .label = SPARKOUT_NOOP("Input", "Operation"),
                       .required = conditions::always, .page = Page::cycle, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Traverse: the table strokes along the part. Plunge: the wheel "
                                    "covers the ground length and is fed radially."),
                       .source = "MODEL-5"),
        SPARKOUT_FIELD(Project, part, .label = SPARKOUT_NOOP("Input", "Part"),
                       .required = conditions::always),
        SPARKOUT_FIELD(Project, material, .label = SPARKOUT_NOOP("Input", "Material"),
                       .required = conditions::always),
        SPARKOUT_FIELD(Project, wheel, .label = SPARKOUT_NOOP("Input", "Wheel"),
                       .required = conditions::always),
        SPARKOUT_FIELD(Project, machine, .label = SPARKOUT_NOOP("Input", "Machine"),
                       .required = conditions::always),
        SPARKOUT_FIELD(Project, gauge, .label = SPARKOUT_NOOP("Input", "Gauge")),
        SPARKOUT_FIELD(Project, cycle, .label = SPARKOUT_NOOP("Input", "Cycle"),
                       .required = conditions::always),
        SPARKOUT_FIELD(
            Project, sections, .label = SPARKOUT_NOOP("Input", "Sections along the length"),
            .symbol = "J", .hard = {1, 200}, .soft = {1, 50}, .relevant = conditions::sections,
            .page = Page::cycle,
            .hint = SPARKOUT_NOOP("Input", "Sections at the middles of equal slices of the ground "
                                           "length, counted from the headstock."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Project, sections_coupled, .label = SPARKOUT_NOOP("Input", "Sections coupled"),
            .relevant = conditions::sections, .page = Page::cycle,
            .hint = SPARKOUT_NOOP("Input", "Whether a force in one section deflects the others "
                                           "too; needs the compliance from stiffness and shaft."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(Project, zone_sections,
                       .label = SPARKOUT_NOOP("Input", "Sections in a zone"), .symbol = "J_z",
                       .hard = {1, 50}, .soft = {1, 20}, .relevant = conditions::zones,
                       .sparse = true, .page = Page::cycle,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Sections at the middles of equal slices of each zone. They "
                                    "all go through its steps, each with its own compliance if "
                                    "that is computed; size and form are judged in all of them."),
                       .source = "MODEL-5"),
        SPARKOUT_FIELD(
            Project, least_overlap, .label = SPARKOUT_NOOP("Input", "Minimum overlap of a stage"),
            .hard = {1, 1000}, .soft = {1, 20},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .relevant = conditions::travels,
            .page = Page::cycle,
            .hint =
                SPARKOUT_NOOP("Input", "Minimum ratio of the wheel width to the table's advance in "
                                       "one revolution; usually 1.05. Below 1 strips stay uncut."),
            .formula = "B·n/S_ax", .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Project, least_overlap_last,
            .label = SPARKOUT_NOOP("Input", "Minimum overlap of the last stage"), .hard = {1, 1000},
            .soft = {1, 20}, .nullMeaning = SPARKOUT_NOOP("Input", "same as for every stage"),
            .relevant = conditions::travels, .page = Page::cycle,
            .hint = SPARKOUT_NOOP(
                "Input", "Minimum ratio for the last stage, which leaves the surface; usually 2."),
            .formula = "B·n/S_ax", .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Project, least_steps, .label = SPARKOUT_NOOP("Input", "Minimum steps of a stage"),
            .hard = {1, 1000}, .nullMeaning = SPARKOUT_NOOP("Input", "not required"),
            .page = Page::cycle,
            .hint = SPARKOUT_NOOP(
                "Input", "Minimum number of double strokes (usually 2) or revolutions (usually 3) "
                         "of each stage with stock; a spark-out by number is not counted."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(Project, card, .label = SPARKOUT_NOOP("Input", "Operation card"),
                       .sparse = true, .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Entries in the head of the operation card "
                                                      "in addition to the inputs of the cycle.")),
        SPARKOUT_FIELD(Project, batch, .label = SPARKOUT_NOOP("Input", "Batch"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "no batch described"),
                       .page = Page::batch, .usual = true),
        SPARKOUT_FIELD(Project, optimisation, .label = SPARKOUT_NOOP("Input", "Optimisation"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "no grid described"),
                       .page = Page::search, .usual = true),
        SPARKOUT_FIELD(
            Project, sweep, .label = SPARKOUT_NOOP("Input", "Sweep"),
            .nullMeaning = SPARKOUT_NOOP("Input", "no input is varied"),
            .hint = SPARKOUT_NOOP("Input", "Inputs that the view of sweeps varies over a range.")),
        SPARKOUT_FIELD(Project, measured, .label = SPARKOUT_NOOP("Input", "Measurements"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "nothing is measured"),
                       .hint = SPARKOUT_NOOP("Input",
                                             "Measured parts and traces to compare with the "
                                             "prediction, and the inputs calibrated on them.")),
        SPARKOUT_FIELD(Project, runs, .label = SPARKOUT_NOOP("Input", "Kept runs"),
                       .hard = {0, 1000},
                       .hint = SPARKOUT_NOOP("Input", "Runs kept for comparison.")),
    };
    static const StructInfo info = makeTable<Project>(SPARKOUT_NOOP("Struct", "Project"), rows);
    return info;
}

} // namespace sparkout
