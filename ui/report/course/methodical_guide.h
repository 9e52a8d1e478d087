// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "ui/report/course/lab_report.h"
#include "ui/report/format/report.h"

namespace sparkout::report {

/// The teaching guide of a work, from the teacher's lesson: aim, theory, data, order of the work
/// with the answers, time norm, control questions with answers, typical mistakes. Sections without
/// contents are left out.
[[nodiscard]] Report methodicalGuide(const Lesson& lesson, const PaperWish& wish);

} // namespace sparkout::report
