// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/answer_fields.h"

#include "ui/charts/run_table.h"
#include "ui/report/course/curve_figure.h"
#include "ui/report/course/goal_words.h"
#include "ui/report/course/lesson_markup.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/names.h"

#include <string>
#include <variant>

namespace sparkout::report {

namespace {

constexpr int textLines = 6, notesLines = 3;
constexpr std::size_t mostRows = 16; ///< number of inputs whose values are to be written

QString toWrite() {
    return QString(10, u'_');
}

const Project& projectOf(const StudentView& view, std::size_t step, Setup& setup) {
    setup = setupOf(view.lesson(), step);
    return setup.surfaces[static_cast<std::size_t>(view.lesson().steps[step].surface) - 1].project;
}

} // namespace

Table AnswerFields::freeInputs(const StudentView& view, std::size_t step) {
    Setup setup;
    const Project& project = projectOf(view, step, setup);
    Table table;
    table.head = {tr("Input"), tr("Unit"), tr("Given"), tr("Set")};
    table.texts = {true, true};
    for (const auto& row : inputTable(project).rows) {
        const std::string path = std::get<QString>(row.back()).toStdString();
        if (accessTo(view.lesson().steps[step], path) == Access::free && !view.hides(path)) {
            table.rows.push_back({StudentView::cellOf(row[0]), StudentView::cellOf(row[2]),
                                  StudentView::cellOf(row[3]), toWrite()});
        }
    }
    if (table.rows.size() > mostRows) {
        table.rows.clear(); // a whole cycle or more: lines are given instead
    }
    return table;
}

void AnswerFields::write(PaperWriter& paper, const StudentView& view, std::size_t step) {
    Setup setup;
    const Project& project = projectOf(view, step, setup);
    const Goal& goal = view.lesson().steps[step].goal;
    paper.say(GoalWords::asked(goal, project));
    Table table;
    switch (goal.kind()) {
    case GoalKind::choice:
        for (const ChoiceOption& option : goal.choice->options) {
            paper.say(QStringLiteral("☐ ")
                      + LessonMarkup::inOneLine(PaperWriter::text(option.text)));
        }
        return;
    case GoalKind::text: paper.add(Blank{textLines}); return;
    case GoalKind::prediction:
        table.head = {tr("Quantity"), tr("Predicted"), tr("By the engine"), tr("Difference")};
        table.texts = {true};
        table.rows.push_back(
            {GoalWords::withUnit(GoalWords::quantity(goal.prediction->figure, project),
                                 goal.prediction->figure),
             toWrite(), toWrite(), toWrite()});
        break;
    case GoalKind::curve:
        table.head = {GoalWords::along(*goal.curve, project), tr("Predicted"), tr("By the engine"),
                      tr("Difference")};
        table.texts = {true};
        for (const double at : goal.curve->at) {
            table.rows.push_back(
                {GoalWords::alongAt(*goal.curve, at, project), toWrite(), toWrite(), toWrite()});
        }
        break;
    case GoalKind::order:
        table.head = {tr("Place in the order, the largest first"), tr("Predicted"),
                      tr("By the engine")};
        table.texts = {true, true, true};
        for (int i = 0; i < placeCount(project); ++i) {
            table.rows.push_back({QString::number(i + 1), toWrite(), toWrite()});
        }
        break;
    default: table = freeInputs(view, step); break;
    }
    if (isMetBySetting(goal.kind()) && table.rows.empty()) {
        paper.add(Blank{notesLines});
    }
    paper.table(std::move(table), tr("Answer to step %1").arg(step + 1));
    if (goal.curve) {
        paper.figure(CurveFigure::blank(*goal.curve, project));
    }
    if (isMetBySetting(goal.kind())) {
        paper.say(tr("Result:"));
        paper.add(Blank{2});
    }
}

} // namespace sparkout::report
