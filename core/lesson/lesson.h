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

/// A laboratory work: what a student reads, does step by step and is asked.
namespace sparkout {

/// What a student may do with an input.
enum class Access { locked, free, hidden };

/// The access to an input, or to all inputs below a path: "/cycle" names all of the cycle. Of
/// several that name an input the longest path holds.
struct InputAccess {
    std::string path;
    Access access = Access::free;
};

/// What helps, for a price in points.
struct Hint {
    Bilingual text;
    double price = 0;
};

/// What is shown when a step begins.
struct ShownMoment {
    std::string view; ///< by its name for `--view`; empty: the one in front
    PlaceName place;
    std::optional<int> stage; ///< from 1
    std::optional<int> count; ///< double stroke or revolution from 1
    Step step = Step::none;
};

struct LessonStep {
    Bilingual task;
    int surface = 1;                ///< that it is about, from 1
    std::vector<InputValue> values; ///< put into the project as the step begins
    Access others = Access::locked; ///< inputs that are not named
    std::vector<InputAccess> inputs;
    std::vector<HiddenThing> hidden;
    Goal goal;
    double points = 1;
    std::vector<Hint> hints; ///< in the order in which they may be taken
    std::optional<ShownMoment> moment;
};

/// All of a lesson but its project.
struct LessonSheet {
    Bilingual title;
    Bilingual aim;
    Bilingual theory;
    std::vector<LessonStep> steps;
    std::optional<VariantRules> variants;
    std::optional<TeachingGuide> guide;
};

struct Lesson : LessonSheet {
    Setup base; ///< the project that it begins with

    [[nodiscard]] double points() const; ///< of all steps
};

/// The lesson as a student may have it: without the rules of the variants and the guide for the
/// teacher, without what says which options are right, and without kept runs and measurements,
/// which may show an answer.
[[nodiscard]] Lesson forStudents(Lesson lesson);

/// The set-up that a step begins with.
[[nodiscard]] Setup setupOf(const Lesson& lesson, std::size_t step);

/// What a student may do with an input in a step.
[[nodiscard]] Access accessTo(const LessonStep& step, std::string_view path);

/// Inputs of the submitted set-up that differ from those a step begins with and are free neither in
/// it nor in a step before it, by their paths in a file. Titles, notes, kept runs and measurements
/// are nobody's.
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
