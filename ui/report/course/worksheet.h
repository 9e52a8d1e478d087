// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"
#include "core/lesson/lesson.h"
#include "core/study/outcome.h"
#include "ui/report/course/lab_report.h"
#include "ui/report/format/report.h"
#include "ui/report/handout/handout_step.h"

#include <QString>

namespace sparkout::report {

/// The worksheet of a project: a step of its cycle in symbols and numbers, with places to write the
/// results, and questions. Of an outcome that ran; `step` as of the hand-out.
[[nodiscard]] Report worksheet(const OutcomePtr& outcome, const StepWish& step,
                               const PaperWish& wish);
/// Its results and answers, apart.
[[nodiscard]] Report worksheetKey(const OutcomePtr& outcome, const StepWish& step,
                                  const PaperWish& wish);

/// The worksheet of a lesson, with the teacher's tasks and places for the answers: nothing that
/// forStudents() takes out of a lesson, and no number of an input that a step hides. The step
/// worked out is the first that the lesson shows.
[[nodiscard]] Report worksheet(const Lesson& lesson, const PaperWish& wish);
/// The same of a student's variant, with his name.
[[nodiscard]] Report worksheet(const Work& work, const PaperWish& wish);
/// Its key, of the teacher's lesson: for the teacher alone.
[[nodiscard]] Report worksheetKey(const Lesson& lesson, const PaperWish& wish);

} // namespace sparkout::report
