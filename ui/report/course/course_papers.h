// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <span>

/// The papers of the course, each described once: the command line goes by this table. A menu calls
/// their functions: labReport(), worksheet(), worksheetKey(), methodicalGuide(). They are written
/// in the present language, in the thread of the window.
namespace sparkout::report {

enum class Paper { labReport, worksheet, worksheetKey, guide };

struct PaperRow {
    Paper paper;
    const char* key;   ///< on the command line, whose manual says what it is
    bool takesWork;    ///< it is made from a student's work
    bool takesLesson;  ///< from the teacher's lesson
    bool takesProject; ///< from a project alone
    bool takesStep;    ///< of a project's cycle
};

[[nodiscard]] std::span<const PaperRow> papers();
[[nodiscard]] const PaperRow& rowOf(Paper paper);
[[nodiscard]] std::optional<Paper> paperOf(const QString& key);

} // namespace sparkout::report
