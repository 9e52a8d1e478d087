// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/variant.h"
#include "core/lesson/answer.h"
#include "core/lesson/lesson.h"
#include "core/project/project.h"

#include <optional>
#include <string>
#include <vector>

/// A student's work: the lesson with his variant, and all that he handed in, in its order.
namespace sparkout {

namespace limits {
inline constexpr std::size_t workEntries = 2000;
} // namespace limits

/// What an entry of a work records.
enum class WorkEvent {
    prediction, ///< said before the run
    attempt,    ///< handed in as the answer to a step
    hint,       ///< a hint was taken
    run,        ///< a run was kept
};

/// One entry; never changed again. Its seal covers it and, by the seal before, all before it.
struct WorkEntry {
    WorkEvent event = WorkEvent::attempt;
    int step = 1;            ///< from 1
    std::string when;        ///< ISO 8601, UTC, of the student's machine
    Answer answer;           ///< of a prediction or an attempt
    std::optional<int> hint; ///< which was taken, from 1
    std::optional<KeptRun> run;
    std::string sha256;
};

/// All of a work but its lesson.
struct WorkSheet {
    std::string name;  ///< of the student
    std::string group; ///< he is in
    int variant = 0;   ///< its number, from 1
    /// Level of each input that is varied, from 0; none where all have the same project.
    std::vector<double> levels;
    std::string lesson_sha256; ///< of the lesson it was made from, as students may have it
    std::string sha256;        ///< the seal of all of this and of `lesson`
    std::vector<WorkEntry> entries;
};

struct Work : WorkSheet {
    Lesson lesson; ///< with the variant, as students may have it

    [[nodiscard]] VariantLevels variantLevels() const;
};

/// A work as it is given out: for a student, with his variant, sealed and without entries.
[[nodiscard]] Work newWork(const Lesson& lesson, const VariantLevels& levels,
                           const std::optional<double>& best_min, int variant, std::string name,
                           std::string group);

/// What a student may see of a work: the answer that counts for a step, hints and attempts.
struct StepRecord {
    std::optional<Answer> answer; ///< of predictions the first, else the last
    std::string when;             ///< it was handed in
    int attempts = 0;
    std::vector<int> hints;       ///< taken, from 1, each once
    bool isPredictedLate = false; ///< after an attempt at the step, or a run kept in it
};
[[nodiscard]] StepRecord recordOf(const Work& work, std::size_t step);

/// What the hints taken cost.
[[nodiscard]] double priceOf(const LessonStep& step, const StepRecord& record);

template <>
std::span<const Choice> choicesOf<WorkEvent>();
template <>
const StructInfo& tableOf<WorkEntry>();
template <>
const StructInfo& tableOf<WorkSheet>();

} // namespace sparkout
