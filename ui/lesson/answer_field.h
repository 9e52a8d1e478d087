// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal.h"
#include "core/lesson/goal_check.h"
#include "core/lesson/lesson.h"

#include <QWidget>

namespace sparkout {

/// A field for a student's answer to a step, by the kind of its goal.
class AnswerField : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;

    /// For a step on a project; null if the step is answered by settings of the inputs.
    [[nodiscard]] static AnswerField* make(const LessonStep& step, const Project& project,
                                           QWidget* parent);

    virtual void show(const Answer& answer) = 0;
    virtual void put(Answer& answer) const = 0;     ///< writes its contents into an answer
    [[nodiscard]] virtual bool isWhole() const = 0; ///< whether it is complete
    virtual void lock() = 0;                        ///< called when it was handed in finally
    /// Shows the engine's result beside the prediction.
    virtual void showResult(const GoalResult&) {}
    virtual void retranslate() = 0;

signals:
    void edited();
};

} // namespace sparkout
