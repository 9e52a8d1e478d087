// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "core/lesson/work.h"
#include "core/study/outcome.h"
#include "ui/report/course_handout.h"
#include "ui/report/format/report.h"
#include "ui/report/lab_report.h"

#include <QString>

namespace sparkout::report {

/// The worksheet of a project: a step of its cycle in symbols and numbers, with places to write the
/// results, and questions. Requires a valid run; `step` as for the hand-out.
[[nodiscard]] Report worksheet(const OutcomePtr& outcome, const StepWish& step,
                               const PaperWish& wish);
/// Its results and answers, separately.
[[nodiscard]] Report worksheetKey(const OutcomePtr& outcome, const StepWish& step,
                                  const PaperWish& wish);

/// The worksheet of a lesson, with the teacher's tasks and places for the answers: only with the
/// contents of forStudents(), and without values of inputs that a step hides. It works out the
/// first step that the lesson shows.
[[nodiscard]] Report worksheet(const Lesson& lesson, const PaperWish& wish);
/// The worksheet of a student's variant, with the student's name.
[[nodiscard]] Report worksheet(const Work& work, const PaperWish& wish);
/// Its key from the teacher's lesson, for teachers only.
[[nodiscard]] Report worksheetKey(const Lesson& lesson, const PaperWish& wish);

} // namespace sparkout::report
