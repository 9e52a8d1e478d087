// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/worksheet.h"

#include "core/project/member.h"
#include "core/setup/worn_project.h"
#include "core/study/outcome.h"
#include "ui/report/cell_text.h"
#include "ui/report/exercises.h"
#include "ui/report/lesson_markup.h"
#include "ui/report/operation_setup.h"
#include "ui/report/paper_writer.h"
#include "ui/report/run_figures.h"
#include "ui/report/student_view.h"
#include "ui/report/worked_step.h"
#include "ui/results/run_table.h"
#include "ui/text/example_texts.h"
#include "ui/text/goal_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>

namespace sparkout::report {

namespace {

struct AnswerFields {
    Q_DECLARE_TR_FUNCTIONS(AnswerFields)
};

constexpr int textLines = 6, notesLines = 3;
constexpr std::size_t mostRows = 16; ///< number of inputs whose values are to be written

QString toWrite() {
    return QString(10, u'_');
}

const Project& projectOf(const StudentView& view, std::size_t step, Setup& setup) {
    setup = setupOf(view.lesson(), step);
    return setup.surfaces[static_cast<std::size_t>(view.lesson().steps[step].surface) - 1].project;
}

Table freeInputsTable(const StudentView& view, std::size_t step) {
    Setup setup;
    const Project& project = projectOf(view, step, setup);
    Table table;
    table.head = {AnswerFields::tr("Input"), AnswerFields::tr("Unit"), AnswerFields::tr("Given"),
                  AnswerFields::tr("Set")};
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

/// Places on paper for the answer to a step of a lesson.
void writeAnswerFields(PaperWriter& paper, const StudentView& view, std::size_t step) {
    Setup setup;
    const Project& project = projectOf(view, step, setup);
    const Goal& goal = view.lesson().steps[step].goal;
    paper.say(GoalText::asked(goal, project));
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
        table.head = {AnswerFields::tr("Quantity"), AnswerFields::tr("Predicted"),
                      AnswerFields::tr("By the engine"), AnswerFields::tr("Difference")};
        table.texts = {true};
        table.rows.push_back({GoalText::quantityAndUnit(goal.prediction->figure, project),
                              toWrite(), toWrite(), toWrite()});
        break;
    case GoalKind::curve:
        table.head = {GoalText::along(*goal.curve, project), AnswerFields::tr("Predicted"),
                      AnswerFields::tr("By the engine"), AnswerFields::tr("Difference")};
        table.texts = {true};
        for (const double at : goal.curve->at) {
            table.rows.push_back(
                {GoalText::alongAt(*goal.curve, at, project), toWrite(), toWrite(), toWrite()});
        }
        break;
    case GoalKind::order:
        table.head = {AnswerFields::tr("Place in the order, the largest first"),
                      AnswerFields::tr("Predicted"), AnswerFields::tr("By the engine")};
        table.texts = {true, true, true};
        for (int i = 0; i < placeCount(project); ++i) {
            table.rows.push_back({QString::number(i + 1), toWrite(), toWrite()});
        }
        break;
    default: table = freeInputsTable(view, step); break;
    }
    if (isMetBySetting(goal.kind()) && table.rows.empty()) {
        paper.add(Blank{notesLines});
    }
    paper.table(std::move(table), AnswerFields::tr("Answer to step %1").arg(step + 1));
    if (goal.curve) {
        paper.figure(CurveFigure::blank(*goal.curve, project));
    }
    if (isMetBySetting(goal.kind())) {
        paper.say(AnswerFields::tr("Result:"));
        paper.add(Blank{2});
    }
}

constexpr int answerLines = 3;
constexpr auto compliancePath = "/machine/compliance_mm_per_n";

/// The subject of a worksheet.
struct Exam {
    OutcomePtr outcome;             ///< null: the project cannot be run
    const Lesson* lesson = nullptr; ///< null: a project alone
    QString title, student, group, variant;
    StepWish step;
};

/// Writes the worksheet, or the key with the same numbers of formulas, tables and questions.
class WorksheetWriter {
    Q_DECLARE_TR_FUNCTIONS(Worksheet)
public:
    WorksheetWriter(const Exam& exam, const PaperWish& wish, bool isKey)
        : m_exam(exam)
        , m_wish(wish)
        , m_isKey(isKey)
        , m_paper(isKey ? tr("Key to the worksheet") : tr("Worksheet"), exam.title, wish.file,
                  wish.date, PageStyle::sheet) {
        if (exam.lesson) {
            m_view.emplace(*exam.lesson);
        }
    }

    Report write() {
        m_paper.add(Facts{{{tr("Student"), orLine(m_exam.student)},
                           {tr("Group"), orLine(m_exam.group)},
                           {tr("Variant"), orLine(m_exam.variant)},
                           {tr("Date"), QString(lineSigns, u'_')}}});
        if (m_isKey) {
            m_paper.say(tr("For the teacher only. Numbers of formulas and questions are those of "
                           "the worksheet."));
        }
        writeTask();
        if (m_exam.outcome && m_exam.outcome->ran()) {
            writeStep();
            writeQuestions();
        }
        return m_paper.take();
    }

private:
    static constexpr int lineSigns = 16;

    static QString orLine(const QString& text) {
        return text.isEmpty() ? QString(lineSigns, u'_') : text;
    }
    void heading(const QString& text) { m_paper.add(Heading{text}); }

    void writeTask() {
        if (!m_exam.lesson) {
            if (!m_isKey) {
                heading(tr("The task"));
                m_paper.say(HandoutTask::part(m_exam.outcome->result.project) + u' '
                            + tr("Follow one step of the cycle, formula by formula, and find what "
                                 "limits the feed there."));
            }
            return;
        }
        const Lesson& lesson = *m_exam.lesson;
        heading(tr("The task"));
        m_paper.lesson(lesson.aim);
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            m_wish.breathe();
            heading(tr("Step %1, points: %2")
                        .arg(QString::number(i + 1), printedNumber(lesson.steps[i].points)));
            m_paper.lesson(lesson.steps[i].task);
            if (m_isKey) {
                StepKey::write(m_paper, lesson, i);
            } else {
                writeAnswerFields(m_paper, *m_view, i);
            }
        }
    }

    [[nodiscard]] bool hides(std::string_view path) const {
        return m_view && !m_isKey && m_view->hides(path);
    }
    [[nodiscard]] bool hidesAnyOf(std::string_view group) const {
        return m_view && !m_isKey && m_view->hidesAnyOf(group);
    }

    /// Symbols whose numbers a worksheet leaves out; empty in the key.
    [[nodiscard]] WorkedStep::Hidden hiddenSymbols() const {
        if (m_isKey) {
            return {};
        }
        QSet<QString> symbols;
        const Project& project = m_exam.outcome->result.project;
        for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
            if (*leaf.field->symbol && hides(leaf.path)) {
                symbols.insert(QString::fromUtf8(leaf.field->symbol));
            }
        }
        if (hides(compliancePath) || hidesAnyOf("/machine/stiffness_n_um")) {
            symbols.insert(QStringLiteral("γ"));
        }
        return symbols;
    }

    void writeStep() {
        const Outcome& outcome = *m_exam.outcome;
        std::optional<HandoutStep> step = findStep(outcome.trajectory, m_exam.step);
        if (!step) {
            step = findStep(outcome.trajectory, usualStep());
        }
        m_step = step ? step : findStep(outcome.trajectory);
        heading(tr("The cycle"));
        if (!m_isKey && !hidesAnyOf("/part") && !hidesAnyOf("/gauge")) {
            m_paper.add(partSketch(m_exam.outcome));
        }
        if (!hidesAnyOf("/cycle")) {
            m_paper.add(OperationSetup::stages(outcome, m_isKey));
        }
        if (!m_step) {
            return;
        }
        Citations citations;
        const StepBlocks worked =
            WorkedStep::formulas(outcome, *m_step, citations, hiddenSymbols());
        if (!m_isKey) {
            heading(tr("Inputs of the formulas"));
            m_paper.add(HandoutTask::inputs(
                outcome, m_step, worked.symbols, citations, [this](std::string_view path) {
                    return hides(path)
                           || (path == compliancePath && hidesAnyOf("/machine/stiffness_n_um"));
                }));
        }
        heading(tr("The step to work out"));
        m_paper.add(WorkedStep::facts(outcome, *m_step, m_isKey));
        if (!m_isKey) {
            m_paper.say(tr("Every formula is printed in symbols, then with the given numbers. Fill "
                           "in the missing ones: insert a computed number wherever it occurs in "
                           "the next equations."));
        }
        m_paper.add(worked.blocks);
        if (!m_isKey) {
            heading(tr("Sources"));
            m_paper.add(citations.table());
        }
    }

    /// For a lesson, no input of its questions may be hidden.
    void writeQuestions() {
        const bool isHidden = hides("/wheel/dullness") || hides(compliancePath)
                              || hidesAnyOf("/cycle") || hides("/part/initial_runout_mm")
                              || hides("/part/stock_mm") || hidesAnyOf("/machine/stiffness_n_um");
        const std::vector<Exercise> exercises =
            isHidden ? std::vector<Exercise>()
                     : makeExercises(*m_exam.outcome, m_step, m_wish.breathe);
        if (exercises.empty()) {
            return;
        }
        if (m_isKey) {
            heading(tr("Answers to the questions"));
            m_paper.add(exerciseAnswers(exercises, m_exam.outcome->result.project.operation));
            return;
        }
        heading(tr("Questions"));
        for (const Block& question : exerciseQuestions(exercises)) {
            m_paper.add(question);
            m_paper.add(Blank{answerLines});
        }
    }

    const Exam& m_exam;
    const PaperWish& m_wish;
    bool m_isKey;
    std::optional<StudentView> m_view;
    std::optional<HandoutStep> m_step;
    PaperWriter m_paper;
};

/// The first moment shown by the lesson in the given cycle.
StepWish stepOf(const Lesson& lesson) {
    for (const LessonStep& step : lesson.steps) {
        if (!step.moment || !step.moment->count || step.surface != 1) {
            continue;
        }
        StepWish wish;
        if (step.moment->place.zone) {
            wish.zone = static_cast<Zone>(*step.moment->place.zone);
        }
        wish.section = step.moment->place.section;
        wish.stage = step.moment->stage;
        wish.count = step.moment->count;
        if (step.moment->step != Step::none) {
            wish.step = static_cast<int>(step.moment->step);
        }
        return wish;
    }
    return usualStep();
}

Exam examOf(const Lesson& lesson) {
    Exam exam;
    const WornProject worn = wornProject(lesson.base, 0);
    exam.outcome = worn.issues.empty() ? evaluate(worn.project, {}) : nullptr;
    exam.lesson = &lesson;
    exam.title = WorkTitle(lesson.title).inFull();
    exam.step = stepOf(lesson);
    return exam;
}

Exam examOf(const OutcomePtr& outcome, const StepWish& step) {
    Exam exam;
    exam.outcome = outcome;
    exam.title = manyLines(exampleTitle(outcome->result.project.title)).simplified();
    exam.step = step;
    return exam;
}

} // namespace

Report worksheet(const OutcomePtr& outcome, const StepWish& step, const PaperWish& wish) {
    return WorksheetWriter(examOf(outcome, step), wish, false).write();
}

Report worksheetKey(const OutcomePtr& outcome, const StepWish& step, const PaperWish& wish) {
    return WorksheetWriter(examOf(outcome, step), wish, true).write();
}

Report worksheet(const Lesson& lesson, const PaperWish& wish) {
    const Lesson plain = forStudents(lesson);
    return WorksheetWriter(examOf(plain), wish, false).write();
}

Report worksheet(const Work& work, const PaperWish& wish) {
    const Lesson plain = forStudents(work.lesson);
    Exam exam = examOf(plain);
    exam.student = oneLine(work.name);
    exam.group = oneLine(work.group);
    exam.variant = QString::number(work.variant);
    return WorksheetWriter(exam, wish, false).write();
}

Report worksheetKey(const Lesson& lesson, const PaperWish& wish) {
    return WorksheetWriter(examOf(lesson), wish, true).write();
}

} // namespace sparkout::report
