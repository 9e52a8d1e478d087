// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/bilingual.h"
#include "core/lesson/goal.h"
#include "core/lesson/hideable.h"
#include "core/lesson/input_value.h"
#include "core/lesson/teaching_guide.h"
#include "core/lesson/variant_rules.h"
#include "core/setup/setup.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// A laboratory work: texts, steps and questions for a student.
namespace sparkout {

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
