// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson.h"

#include "core/project/conditions.h"
#include "core/project/measured.h"
#include "core/project/member.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace sparkout {

namespace {

/// Whether a path is another one or lies below it.
bool isBelow(std::string_view path, std::string_view above) {
    return path.starts_with(above) && (path.size() == above.size() || path[above.size()] == '/');
}

/// Whether it is an entry of the file that is not an input of the cycle.
bool isNobodys(std::string_view path) {
    constexpr std::array beside{"/title", "/author", "/notes", "/runs", "/measured"};
    return std::any_of(beside.begin(), beside.end(),
                       [path](const char* each) { return isBelow(path, each); });
}

std::map<std::string, Leaf> leavesByPath(const Project& project) {
    std::map<std::string, Leaf> leaves;
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        if (!isNobodys(leaf.path)) {
            leaves.emplace(leaf.path, leaf);
        }
    }
    return leaves;
}

bool isSameLeaf(const Leaf& a, const Leaf& b) {
    const Field& field = *a.field;
    if (field.kind == Kind::objectList) {
        return field.size(a.owner) == field.size(b.owner);
    }
    if (field.nested) { // not given in at least one of the two
        return (field.objectIn(a.owner) == nullptr) == (field.objectIn(b.owner) == nullptr);
    }
    return field.same(a.owner, b.owner);
}

/// The paths of inputs that differ between two projects.
std::vector<std::string> changedInputs(const Project& from, const Project& to) {
    const std::map<std::string, Leaf> before = leavesByPath(from), after = leavesByPath(to);
    std::set<std::string> changed;
    for (const auto& [path, leaf] : before) {
        const auto found = after.find(path);
        if (found == after.end() || !isSameLeaf(leaf, found->second)) {
            changed.insert(path);
        }
    }
    for (const auto& [path, leaf] : after) {
        if (!before.contains(path)) {
            changed.insert(path);
        }
    }
    return {changed.begin(), changed.end()};
}

} // namespace

bool isView(Hideable thing) {
    return thing < Hideable::verdict;
}

std::optional<Hideable> viewNamed(std::string_view key) {
    const auto choices = choicesOf<Hideable>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (key == choices[i].key && isView(static_cast<Hideable>(i))) {
            return static_cast<Hideable>(i);
        }
    }
    return std::nullopt;
}

template <>
std::span<const Choice> choicesOf<Hideable>() {
    static constexpr std::array choices{
        Choice{"overview", SPARKOUT_NOOP("Choice", "Overview")},
        Choice{"feeds", SPARKOUT_NOOP("Choice", "Feeds by stage")},
        Choice{"profiles", SPARKOUT_NOOP("Choice", "Profiles")},
        Choice{"constraints", SPARKOUT_NOOP("Choice", "Constraints")},
        Choice{"compliance", SPARKOUT_NOOP("Choice", "Compliance")},
        Choice{"layers", SPARKOUT_NOOP("Choice", "Layers")},
        Choice{"batch", SPARKOUT_NOOP("Choice", "Batch")},
        Choice{"sweep", SPARKOUT_NOOP("Choice", "Sweep")},
        Choice{"optimise", SPARKOUT_NOOP("Choice", "Optimise")},
        Choice{"compare", SPARKOUT_NOOP("Choice", "Compare")},
        Choice{"measured", SPARKOUT_NOOP("Choice", "Measurements")},
        Choice{"verdict", SPARKOUT_NOOP("Choice", "Verdict")},
        Choice{"remedies", SPARKOUT_NOOP("Choice", "Remedies")},
        Choice{"formulas", SPARKOUT_NOOP("Choice", "Formulas of the step")},
        Choice{"messages", SPARKOUT_NOOP("Choice", "Messages")},
        Choice{"kept_runs", SPARKOUT_NOOP("Choice", "Kept runs")},
        Choice{"calibrate", SPARKOUT_NOOP("Choice", "Calibrate from measurements")},
        Choice{"examples", SPARKOUT_NOOP("Choice", "Examples")},
        Choice{"reports", SPARKOUT_NOOP("Choice", "Reports")},
        Choice{"export_results", SPARKOUT_NOOP("Choice", "Export results")},
        Choice{"batch_indices", SPARKOUT_NOOP("Choice", "Interval and indices of the batch")},
    };
    static_assert(choices.size() == static_cast<std::size_t>(Hideable::count_));
    return choices;
}

template <>
const StructInfo& tableOf<HiddenThing>() {
    static const std::array rows{
        SPARKOUT_FIELD(HiddenThing, name, .label = SPARKOUT_NOOP("Input", "Name"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP(
                           "Input", "A view by its name for `--view`, or a panel or command.")),
    };
    static const StructInfo info =
        makeTable<HiddenThing>(SPARKOUT_NOOP("Struct", "Hidden parts"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ControlQuestion>() {
    static const std::array rows{
        SPARKOUT_FIELD(ControlQuestion, question, .label = SPARKOUT_NOOP("Input", "Question")),
        SPARKOUT_FIELD(ControlQuestion, answer, .label = SPARKOUT_NOOP("Input", "Answer")),
    };
    static const StructInfo info =
        makeTable<ControlQuestion>(SPARKOUT_NOOP("Struct", "Control question"), rows);
    return info;
}

template <>
const StructInfo& tableOf<TypicalMistake>() {
    static const std::array rows{
        SPARKOUT_FIELD(TypicalMistake, text, .label = SPARKOUT_NOOP("Input", "Text"),
                       .hint = SPARKOUT_NOOP(
                           "Input", "Frequent mistakes of students, and how to respond to them.")),
    };
    static const StructInfo info =
        makeTable<TypicalMistake>(SPARKOUT_NOOP("Struct", "Typical mistake"), rows);
    return info;
}

template <>
const StructInfo& tableOf<TeachingGuide>() {
    static const std::array rows{
        SPARKOUT_FIELD(TeachingGuide, minutes, .label = SPARKOUT_NOOP("Input", "Time norm"),
                       .unit = "min", .hard = {1, 10000},
                       .hint = SPARKOUT_NOOP("Input", "Time of a student for the whole work.")),
        SPARKOUT_FIELD(TeachingGuide, questions,
                       .label = SPARKOUT_NOOP("Input", "Control questions"), .hard = {0, 100},
                       .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "For the defence of the work.")),
        SPARKOUT_FIELD(TeachingGuide, mistakes, .label = SPARKOUT_NOOP("Input", "Typical mistakes"),
                       .hard = {0, 100}, .sparse = true),
    };
    static const StructInfo info =
        makeTable<TeachingGuide>(SPARKOUT_NOOP("Struct", "Guide for the teacher"), rows);
    return info;
}

double Lesson::points() const {
    double sum = 0;
    for (const LessonStep& step : steps) {
        sum += step.points;
    }
    return sum;
}

Lesson forStudents(Lesson lesson) {
    lesson.variants.reset();
    lesson.guide.reset();
    for (LessonStep& step : lesson.steps) {
        if (step.goal.choice) {
            for (ChoiceOption& option : step.goal.choice->options) {
                option.right = false;
            }
        }
    }
    for (GroundSurface& surface : lesson.base.surfaces) {
        surface.project.runs.clear();
        surface.project.measured.reset();
    }
    return lesson;
}

const Project& projectOf(const Lesson& lesson, std::size_t step) {
    return lesson.base.surfaces[static_cast<std::size_t>(lesson.steps[step].surface) - 1].project;
}

Setup setupOf(const Lesson& lesson, std::size_t step) {
    Setup setup = lesson.base;
    const LessonStep& of = lesson.steps[step];
    for (const InputValue& value : of.values) {
        (void)putInput(setup, static_cast<std::size_t>(of.surface) - 1, value);
    }
    return setup;
}

Access accessTo(const LessonStep& step, std::string_view path) {
    const InputAccess* nearest = nullptr;
    for (const InputAccess& each : step.inputs) {
        if (isBelow(path, each.path) && (!nearest || each.path.size() > nearest->path.size())) {
            nearest = &each;
        }
    }
    return nearest ? nearest->access : step.others;
}

std::vector<std::string> forbiddenChanges(const Lesson& lesson, std::size_t step,
                                          const Setup& submitted) {
    const Setup before = setupOf(lesson, step);
    std::vector<std::string> forbidden;
    if (submitted.surfaces.size() != before.surfaces.size()) {
        return {"/surfaces"};
    }
    if (submitted.times != before.times) {
        forbidden.emplace_back("/times");
    }
    if (submitted.wear != before.wear) {
        forbidden.emplace_back("/wear");
    }
    const auto isFree = [&](std::size_t surface, const std::string& path) {
        return std::any_of(lesson.steps.begin(),
                           lesson.steps.begin() + static_cast<std::ptrdiff_t>(step) + 1,
                           [&](const LessonStep& each) {
                               return static_cast<std::size_t>(each.surface) == surface + 1
                                      && accessTo(each, path) == Access::free;
                           });
    };
    for (std::size_t i = 0; i < before.surfaces.size(); ++i) {
        for (std::string& path :
             changedInputs(before.surfaces[i].project, submitted.surfaces[i].project)) {
            if (!isFree(i, path)) {
                forbidden.push_back(before.surfaces.size() > 1 ? surfacePath(i) + path
                                                               : std::move(path));
            }
        }
    }
    return forbidden;
}

template <>
std::span<const Choice> choicesOf<Access>() {
    static constexpr std::array choices{
        Choice{"locked", SPARKOUT_NOOP("Choice", "shown, not changed")},
        Choice{"free", SPARKOUT_NOOP("Choice", "changed by the student")},
        Choice{"hidden", SPARKOUT_NOOP("Choice", "not shown")}};
    return choices;
}

template <>
const StructInfo& tableOf<InputAccess>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            InputAccess, path, .label = SPARKOUT_NOOP("Input", "Input"),
            .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input",
                                  "Path of an input, or of all below it, as `/wheel/dullness` or "
                                  "`/cycle`. Of several that name an input the longest applies.")),
        SPARKOUT_FIELD(InputAccess, access, .label = SPARKOUT_NOOP("Input", "Access"),
                       .required = conditions::always),
    };
    static const StructInfo info =
        makeTable<InputAccess>(SPARKOUT_NOOP("Struct", "Access to an input"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Hint>() {
    static const std::array rows{
        SPARKOUT_FIELD(Hint, text, .label = SPARKOUT_NOOP("Input", "Text")),
        SPARKOUT_FIELD(
            Hint, price, .label = SPARKOUT_NOOP("Input", "Price"),
            .unit = SPARKOUT_NOOP("Unit", "points"), .hard = {0, 1000},
            .hint = SPARKOUT_NOOP("Input", "Points of the step that a student loses by using it.")),
    };
    static const StructInfo info = makeTable<Hint>(SPARKOUT_NOOP("Struct", "Hint"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ShownMoment>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            ShownMoment, view, .label = SPARKOUT_NOOP("Input", "View"), .sparse = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Name of the view as for `--view`; not given: the current view stays.")),
        SPARKOUT_FIELD(ShownMoment, place, .label = SPARKOUT_NOOP("Input", "Zone or section"),
                       .hard = {0, 100000}, .nullMeaning = SPARKOUT_NOOP("Input", "as it is")),
        SPARKOUT_FIELD(ShownMoment, stage, .label = SPARKOUT_NOOP("Input", "Stage"),
                       .hard = {1, 100}, .nullMeaning = SPARKOUT_NOOP("Input", "as it is")),
        SPARKOUT_FIELD(ShownMoment, count,
                       .label = SPARKOUT_NOOP("Input", "Double stroke or revolution"),
                       .hard = {1, 10000000}, .nullMeaning = SPARKOUT_NOOP("Input", "as it is")),
        SPARKOUT_FIELD(ShownMoment, step,
                       .label = SPARKOUT_NOOP("Input", "Step of the double stroke"),
                       .sparse = true),
    };
    static const StructInfo info =
        makeTable<ShownMoment>(SPARKOUT_NOOP("Struct", "Moment shown"), rows);
    return info;
}

template <>
const StructInfo& tableOf<LessonStep>() {
    static const std::array rows{
        SPARKOUT_FIELD(LessonStep, task, .label = SPARKOUT_NOOP("Input", "Task")),
        SPARKOUT_FIELD(LessonStep, surface, .label = SPARKOUT_NOOP("Input", "Surface"),
                       .hard = {1, 20}, .sparse = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Number of the surface that the step is about, from 1.")),
        SPARKOUT_FIELD(
            LessonStep, values, .label = SPARKOUT_NOOP("Input", "Values"), .hard = {0, 100},
            .sparse = true,
            .hint = SPARKOUT_NOOP("Input", "Values put into the project when the step begins.")),
        SPARKOUT_FIELD(
            LessonStep, others, .label = SPARKOUT_NOOP("Input", "Other inputs"),
            .hint = SPARKOUT_NOOP("Input", "The access of students to inputs that are not named.")),
        SPARKOUT_FIELD(LessonStep, inputs, .label = SPARKOUT_NOOP("Input", "Inputs"),
                       .hard = {0, 1000}),
        SPARKOUT_FIELD(LessonStep, hidden, .label = SPARKOUT_NOOP("Input", "Hidden"),
                       .hard = {0, 100}, .sparse = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Views, panels and commands that are hidden in this step.")),
        SPARKOUT_FIELD(LessonStep, goal, .label = SPARKOUT_NOOP("Input", "Goal"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Exactly one kind.")),
        SPARKOUT_FIELD(LessonStep, points, .label = SPARKOUT_NOOP("Input", "Points"),
                       .hard = {0, 1000}),
        SPARKOUT_FIELD(LessonStep, hints, .label = SPARKOUT_NOOP("Input", "Hints"), .hard = {0, 20},
                       .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "In the order in which they may be taken.")),
        SPARKOUT_FIELD(LessonStep, moment, .label = SPARKOUT_NOOP("Input", "Moment shown"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "the window stays as it is")),
    };
    static const StructInfo info = makeTable<LessonStep>(SPARKOUT_NOOP("Struct", "Step"), rows);
    return info;
}

template <>
const StructInfo& tableOf<LessonSheet>() {
    static const std::array rows{
        SPARKOUT_FIELD(LessonSheet, title, .label = SPARKOUT_NOOP("Input", "Title")),
        SPARKOUT_FIELD(LessonSheet, aim, .label = SPARKOUT_NOOP("Input", "Aim")),
        SPARKOUT_FIELD(LessonSheet, theory, .label = SPARKOUT_NOOP("Input", "Theory")),
        SPARKOUT_FIELD(LessonSheet, steps, .label = SPARKOUT_NOOP("Input", "Steps"),
                       .hard = {1, 100}, .required = conditions::always),
        SPARKOUT_FIELD(LessonSheet, variants, .label = SPARKOUT_NOOP("Input", "Variants"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "all students have the same project"),
                       .hint = SPARKOUT_NOOP("Input", "Only in the teacher's file.")),
        SPARKOUT_FIELD(LessonSheet, guide, .label = SPARKOUT_NOOP("Input", "Guide for the teacher"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "none is printed"),
                       .hint = SPARKOUT_NOOP("Input", "Only in the teacher's file.")),
    };
    static const StructInfo info = makeTable<LessonSheet>(SPARKOUT_NOOP("Struct", "Lesson"), rows);
    return info;
}

} // namespace sparkout
