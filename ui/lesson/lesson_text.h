// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal.h"
#include "ui/session/lesson_run.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Lessons in the window's words.
class LessonText {
    Q_DECLARE_TR_FUNCTIONS(LessonText)
public:
    /// In the current language, or the only one.
    [[nodiscard]] static QString of(const Bilingual& text);
    /// As markup for use within other markup. A text that is invalid in a lesson, possible in an
    /// editor, shows its tags.
    [[nodiscard]] static QString tagged(const Bilingual& text);
    /// As standalone markup: formulas are set apart.
    [[nodiscard]] static QString markup(const Bilingual& text);

    [[nodiscard]] static QString points(double points);
    [[nodiscard]] static QString mark(LessonRun::Mark mark);
};

} // namespace sparkout
