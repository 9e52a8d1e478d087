// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "ui/report/format/report.h"
#include "ui/report/lab_report.h"

#include <QString>

#include <optional>
#include <span>
#include <vector>

namespace sparkout::report {

/// The teaching guide of a work, from the teacher's lesson: aim, theory, data, order of the work
/// with the answers, time norm, control questions with answers, typical mistakes. Sections without
/// contents are left out.
[[nodiscard]] Report methodicalGuide(const Lesson& lesson, const PaperWish& wish);

} // namespace sparkout::report

/// The papers of the course, each described once in a table for command line and menus. They are
/// written in the current language, in the window's thread.
namespace sparkout::report {

enum class Paper { labReport, worksheet, worksheetKey, guide };

struct PaperRow {
    Paper paper;
    const char* key;   ///< key on the command line, described in the manual
    const char* menu;  ///< menu text, translated in the context Paper
    bool takesWork;    ///< made from a student's work
    bool takesLesson;  ///< made from the teacher's lesson
    bool takesProject; ///< made from a project alone
    bool takesStep;    ///< uses a step of a project's cycle
};

[[nodiscard]] std::span<const PaperRow> papers();
[[nodiscard]] std::vector<PaperRow> papersOfWorks();
[[nodiscard]] std::vector<PaperRow> papersOfLessons();
[[nodiscard]] const PaperRow& rowOf(Paper paper);
[[nodiscard]] std::optional<Paper> paperOf(const QString& key);
[[nodiscard]] QString menuText(Paper paper); ///< text with its mnemonic

/// Makes a paper from a work.
[[nodiscard]] Report makePaper(Paper paper, const Work& work, const PaperWish& wish);
/// Makes a paper from a lesson with the times that depend on the best, see withBestTimes().
[[nodiscard]] Report makePaper(Paper paper, const Lesson& lesson, const PaperWish& wish);

} // namespace sparkout::report
