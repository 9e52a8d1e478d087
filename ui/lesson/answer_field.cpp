// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/answer_field.h"

#include "ui/lesson/choice_answer.h"
#include "ui/lesson/curve_answer.h"
#include "ui/lesson/number_answer.h"
#include "ui/lesson/order_answer.h"
#include "ui/lesson/text_answer.h"

namespace sparkout {

AnswerField* AnswerField::make(const LessonStep& step, const Project& project, QWidget* parent) {
    const Goal& goal = step.goal;
    switch (goal.kind()) {
    case GoalKind::prediction: return new NumberAnswer(*goal.prediction, project, parent);
    case GoalKind::curve: return new CurveAnswer(*goal.curve, project, parent);
    case GoalKind::order: return new OrderAnswer(*goal.order, project, parent);
    case GoalKind::choice: return new ChoiceAnswer(*goal.choice, parent);
    case GoalKind::text: return new TextAnswer(*goal.text, parent);
    case GoalKind::requirements:
    case GoalKind::time:
    case GoalKind::figure: break;
    }
    return nullptr;
}

} // namespace sparkout
