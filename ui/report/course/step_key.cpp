// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/step_key.h"

#include "core/lesson/goal_check.h"
#include "ui/report/course/goal_words.h"
#include "ui/report/course/lesson_markup.h"
#include "ui/text/names.h"

namespace sparkout::report {

void StepKey::write(PaperWriter& paper, const Lesson& lesson, std::size_t step) {
    const Goal& goal = lesson.steps[step].goal;
    const auto surface = static_cast<std::size_t>(lesson.steps[step].surface) - 1;
    const Setup setup = setupOf(lesson, step);
    const Project& project = setup.surfaces[surface].project;
    if (goal.choice) {
        for (const ChoiceOption& option : goal.choice->options) {
            if (option.right) {
                paper.say(
                    tr("Right: %1.").arg(LessonMarkup::inOneLine(PaperWriter::text(option.text))));
            }
        }
        return;
    }
    if (!isAnsweredByEngine(goal.kind())) {
        paper.say(GoalWords::asked(goal, project));
        return;
    }
    const GoalResult result = checkStep(lesson, step, {});
    const sparkout::Figure& figure = *goal.asked();
    const QString name = GoalWords::quantity(figure, project);
    if (goal.prediction && result.value) {
        paper.say(tr("%1: %2; ± %3 is accepted.")
                      .arg(GoalWords::withUnit(name, figure),
                           GoalWords::number(figure, *result.value),
                           Names::fixed(result.tolerance, rowOf(figure.name).digits + 1)));
    } else if (goal.order && !result.order.empty()) {
        paper.say(
            tr("%1, the largest first: %2.").arg(name, GoalWords::order(project, result.order)));
    } else if (goal.curve && !result.curve.empty()) {
        Table table;
        table.head = {GoalWords::along(*goal.curve, project), GoalWords::withUnit(name, figure)};
        table.texts = {true};
        for (const ComparedPoint& point : result.curve) {
            table.rows.push_back({GoalWords::alongAt(*goal.curve, point.at, project),
                                  GoalWords::number(figure, point.value)});
        }
        paper.table(std::move(table), tr("By the engine"));
    } else {
        paper.say(GoalWords::finding(result.finding));
    }
}

} // namespace sparkout::report
