// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/course/lab_report.h"

#include <QString>

#include <optional>
#include <span>
#include <vector>

/// The papers of the course, each described once: command line and menus go by this table. They
/// are written in the present language, in the thread of the window.
namespace sparkout::report {

enum class Paper { labReport, worksheet, worksheetKey, guide };

struct PaperRow {
    Paper paper;
    const char* key;   ///< on the command line, whose manual says what it is
    const char* menu;  ///< its menu, to be translated in the context Paper
    bool takesWork;    ///< it is made from a student's work
    bool takesLesson;  ///< from the teacher's lesson
    bool takesProject; ///< from a project alone
    bool takesStep;    ///< of a project's cycle
};

[[nodiscard]] std::span<const PaperRow> papers();
[[nodiscard]] std::vector<PaperRow> papersOfWorks();
[[nodiscard]] std::vector<PaperRow> papersOfLessons();
[[nodiscard]] const PaperRow& rowOf(Paper paper);
[[nodiscard]] std::optional<Paper> paperOf(const QString& key);
[[nodiscard]] QString menuText(Paper paper); ///< with its mnemonic

/// A paper that is made from works.
[[nodiscard]] Report makePaper(Paper paper, const Work& work, const PaperWish& wish);
/// A paper that is made from lessons; times that follow from the best are in it: withBestTimes().
[[nodiscard]] Report makePaper(Paper paper, const Lesson& lesson, const PaperWish& wish);

} // namespace sparkout::report
