// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/course_handout.h"

#include "ui/report/handout/citations.h"
#include "ui/report/handout/exercise_sheet.h"
#include "ui/report/handout/exercises.h"
#include "ui/report/handout/handout_figures.h"
#include "ui/report/handout/handout_task.h"
#include "ui/report/handout/state_grid_sheet.h"
#include "ui/report/handout/worked_step.h"
#include "ui/report/parts/begun_report.h"
#include "ui/report/parts/operation_setup.h"
#include "ui/report/parts/part_sketch.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace sparkout::report {

namespace {

class HandoutWriter {
    Q_DECLARE_TR_FUNCTIONS(CourseHandout)
public:
    HandoutWriter(const OutcomePtr& outcome, const HandoutOptions& options,
                  const std::function<void()>& breathe)
        : m_outcome(outcome), m_options(options), m_breathe(breathe) {}

    Report write(const QString& file, const QDate& date) {
        const Project& project = m_outcome->result.project;
        m_report = begunReport(tr("Course hand-out"), project, file, date);
        std::optional<HandoutStep> step = findStep(m_outcome->trajectory, m_options.step);
        if (!step) {
            step = findStep(m_outcome->trajectory); // roughing ended before it began
        }
        const std::vector<Exercise> exercises = makeExercises(*m_outcome, step, m_breathe);
        add(HandoutTask::header(project, file, date));
        heading(tr("The task"));
        add(Paragraph{HandoutTask::task(*m_outcome)});
        add(partSketch(m_outcome));
        heading(tr("Stages of the cycle"));
        add(OperationSetup::stages(*m_outcome));
        Citations citations;
        const StepBlocks worked =
            step ? WorkedStep::formulas(*m_outcome, *step, citations) : StepBlocks();
        Table inputs = HandoutTask::inputs(*m_outcome, step, worked.symbols, citations);
        heading(tr("Sources"));
        add(citations.table());
        heading(tr("Inputs of the formulas"));
        add(std::move(inputs));
        addStep(step, worked.blocks);
        addFigures(step);
        if (m_options.views.contains(HandoutView::grid)) {
            heading(tr("Dynamic programming"));
            add(StateGridSheet::blocks(m_outcome, m_breathe));
        }
        if (!exercises.empty()) {
            heading(tr("Questions"));
            add(ExerciseSheet::questions(exercises));
        }
        if (m_options.answers && !exercises.empty()) {
            add(PageBreak{});
            heading(tr("Answers"));
            add(ExerciseSheet::answers(exercises, project.operation));
        }
        return std::move(m_report);
    }

private:
    void heading(const QString& text) { m_report.blocks.emplace_back(Heading{text}); }
    void add(Block block) { m_report.blocks.push_back(std::move(block)); }
    void add(std::vector<Block> blocks) {
        std::ranges::move(blocks, std::back_inserter(m_report.blocks));
    }

    void addStep(const std::optional<HandoutStep>& step, const std::vector<Block>& formulas) {
        heading(tr("The step worked out"));
        if (!step) {
            add(Paragraph{
                tr("The cycle is too long to be recorded, so no step of it can be worked out.")});
            return;
        }
        add(WorkedStep::facts(*m_outcome, *step));
        add(Paragraph{
            tr("Every formula stands in symbols, then with its numbers, then with its result. "
               "Numbers are put in with as many digits as the printed result needs.")});
        add(formulas);
    }

    void addFigures(const std::optional<HandoutStep>& step) {
        auto figures = HandoutFigures::figures(m_outcome, step, m_options.views, m_breathe);
        if (!figures.empty()) {
            heading(tr("Charts"));
            add(std::move(figures));
        }
    }

    const OutcomePtr& m_outcome;
    const HandoutOptions& m_options;
    const std::function<void()>& m_breathe;
    Report m_report;
};

} // namespace

Report courseHandout(const OutcomePtr& outcome, const QString& file, const QDate& date,
                     const HandoutOptions& options, const std::function<void()>& breathe) {
    return HandoutWriter(outcome, options, breathe).write(file, date);
}

} // namespace sparkout::report
