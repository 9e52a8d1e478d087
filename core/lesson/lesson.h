// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/lesson/goal.h"
#include "core/lesson/variant_rules.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A laboratory work: texts, steps and questions for a student.
namespace sparkout {

/// The elements of the window that a step may hide. The keys of the views are those of `--view`; a
/// test of the window compares them with its views.
enum class Hideable {
    overview,
    feeds,
    profiles,
    constraints,
    compliance,
    layers,
    batch,
    sweep,
    optimise,
    compare,
    measured,
    // panels and commands
    verdict,
    remedies,
    formulas,
    messages,
    keptRuns,
    calibrate,
    examples,
    reports,
    exportResults,
    batchIndices, ///< parts of a view: interval of the mean, Pp and Ppk
    count_
};

/// Whether it is a view; otherwise it is a panel or a command.
[[nodiscard]] bool isView(Hideable thing);
/// The view with a name of `--view`; empty if there is none.
[[nodiscard]] std::optional<Hideable> viewNamed(std::string_view key);

/// A view, panel or command that a step hides.
struct HiddenThing {
    Hideable name = Hideable::optimise;
    friend bool operator==(const HiddenThing&, const HiddenThing&) = default;
};

template <>
std::span<const Choice> choicesOf<Hideable>();
template <>
const StructInfo& tableOf<HiddenThing>();

// A teacher's material besides the tasks, from which the teaching guide is printed. Only the
// teacher's file contains it.

/// A question for the defence of the work.
struct ControlQuestion {
    Bilingual question;
    Bilingual answer;
};

/// A frequent mistake of students, and a reply to it.
struct TypicalMistake {
    Bilingual text;
};

struct TeachingGuide {
    int minutes = 90; ///< time norm of the whole work [min]
    std::vector<ControlQuestion> questions;
    std::vector<TypicalMistake> mistakes;
};

template <>
const StructInfo& tableOf<ControlQuestion>();
template <>
const StructInfo& tableOf<TypicalMistake>();
template <>
const StructInfo& tableOf<TeachingGuide>();

/// A student's access to an input.
enum class Access { locked, free, hidden };

/// The access to an input, or to all inputs below a path: "/cycle" names all of the cycle. The
/// longest of several matching paths applies.
struct InputAccess {
    std::string path;
    Access access = Access::free;
};

/// A hint, for a price in points.
struct Hint {
    Bilingual text;
    double price = 0;
};

/// The place shown when a step begins.
struct ShownMoment {
    std::string view; ///< name for `--view`; empty: the current view
    PlaceName place;
    std::optional<int> stage; ///< counted from 1
    std::optional<int> count; ///< double stroke or revolution from 1
    Step step = Step::none;
};

struct LessonStep {
    Bilingual task;
    int surface = 1;                ///< surface of the step, from 1
    std::vector<InputValue> values; ///< set in the project as the step begins
    Access others = Access::locked; ///< inputs that are not named
    std::vector<InputAccess> inputs;
    std::vector<HiddenThing> hidden;
    Goal goal;
    double points = 1;
    std::vector<Hint> hints; ///< in the order in which they may be used
    std::optional<ShownMoment> moment;
};

/// A lesson without its project.
struct LessonSheet {
    Bilingual title;
    Bilingual aim;
    Bilingual theory;
    std::vector<LessonStep> steps;
    std::optional<VariantRules> variants;
    std::optional<TeachingGuide> guide;
};

struct Lesson : LessonSheet {
    Setup base; ///< initial project

    [[nodiscard]] double points() const; ///< sum of all steps
};

/// The lesson as given to students: without the rules of the variants, the guide for the teacher,
/// the right options, and kept runs and measurements, which may show an answer.
[[nodiscard]] Lesson forStudents(Lesson lesson);

/// The lesson's own project of the surface that a step is about.
[[nodiscard]] const Project& projectOf(const Lesson& lesson, std::size_t step);

/// The initial set-up of a step.
[[nodiscard]] Setup setupOf(const Lesson& lesson, std::size_t step);

/// A student's access to an input in a step.
[[nodiscard]] Access accessTo(const LessonStep& step, std::string_view path);

/// Inputs of the submitted set-up that differ from those at the beginning of a step and are free
/// neither in it nor in a step before it, by their paths in a file. Titles, notes, kept runs and
/// measurements are ignored.
[[nodiscard]] std::vector<std::string> forbiddenChanges(const Lesson& lesson, std::size_t step,
                                                        const Setup& submitted);

template <>
std::span<const Choice> choicesOf<Access>();
template <>
const StructInfo& tableOf<InputAccess>();
template <>
const StructInfo& tableOf<Hint>();
template <>
const StructInfo& tableOf<ShownMoment>();
template <>
const StructInfo& tableOf<LessonStep>();
template <>
const StructInfo& tableOf<LessonSheet>();

} // namespace sparkout
