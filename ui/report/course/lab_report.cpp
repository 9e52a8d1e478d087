// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/course/lab_report.h"

#include "core/study/outcome.h"
#include "ui/report/course/goal_words.h"
#include "ui/report/course/lesson_markup.h"
#include "ui/report/course/paper_writer.h"
#include "ui/report/course/step_results.h"
#include "ui/report/course/student_view.h"
#include "ui/report/handout/worked_step.h"
#include "ui/report/parts/cell_text.h"
#include "ui/report/parts/part_sketch.h"

#include <QCoreApplication>
#include <QStringList>

#include <optional>
#include <vector>

namespace sparkout::report {

namespace {

constexpr int conclusionLines = 12; ///< number of lines to be written by hand

class LabReportWriter {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
public:
    LabReportWriter(const Work& work, const PaperWish& wish)
        : m_work(work)
        , m_wish(wish)
        , m_view(work.lesson)
        , m_title(work.lesson.title)
        , m_paper(tr("Report on a laboratory work"), m_title.inFull(), wish.file, wish.date,
                  PageStyle::standard) {}

    Report write() {
        m_paper.add(titlePage());
        m_paper.add(Contents{tr("Contents")});
        m_paper.part(tr("Introduction"));
        m_paper.say(tr("Aim of the work."));
        m_paper.lesson(m_work.lesson.aim);
        m_paper.say(tr("The work was done with the program %1. The results below are computed by "
                       "it from the inputs that were handed in.")
                        .arg(m_paper.report().program));
        writeData();
        m_paper.section(tr("Theory in brief"));
        m_paper.lesson(m_work.lesson.theory);
        writeResults();
        m_paper.part(tr("Conclusion"));
        writeConclusion();
        m_paper.part(tr("List of sources used"));
        writeSources();
        Report report = m_paper.take();
        report.author = oneLine(m_work.name);
        return report;
    }

private:
    [[nodiscard]] TitlePage titlePage() const {
        const Institution& of = m_wish.institution;
        TitlePage page;
        for (const std::string& line : {of.ministry, of.university, of.faculty, of.department}) {
            if (!line.empty()) {
                page.above << QString::fromStdString(line);
            }
        }
        page.document = tr("Report");
        page.title << (m_title.number.isEmpty()
                           ? tr("on a laboratory work")
                           : tr("on laboratory work No. %1").arg(m_title.number));
        if (!of.discipline.empty()) {
            page.title << tr("in the discipline “%1”").arg(QString::fromStdString(of.discipline));
        }
        page.title << tr("“%1”").arg(m_title.name) << tr("Variant %1").arg(m_work.variant);
        const QString group = oneLine(m_work.group);
        page.people.emplace_back(group.isEmpty()
                                     ? tr("Done by the student:")
                                     : tr("Done by the student of group %1:").arg(group),
                                 signature(oneLine(m_work.name)));
        page.people.emplace_back(tr("Accepted by:"),
                                 signature(QString::fromStdString(of.accepted)));
        page.below = QStringLiteral("%1 %2")
                         .arg(QString::fromStdString(of.place), QString::number(m_wish.date.year()))
                         .trimmed();
        return page;
    }

    /// A place to sign before a name.
    static QString signature(const QString& name) {
        return QString(16, u'_') + QStringLiteral("  ") + name;
    }

    void writeData() {
        m_paper.section(tr("Data of the variant"));
        const auto& surfaces = m_work.lesson.base.surfaces;
        m_paper.say(
            tr("Variant %1. The inputs of the cycle are those of table 1.").arg(m_work.variant));
        const OutcomePtr outcome = m_view.hidesAnyOf("/part") || m_view.hidesAnyOf("/gauge")
                                       ? nullptr
                                       : evaluate(surfaces.front().project, {});
        if (outcome && outcome->ran()) {
            Figure sketch = partSketch(outcome);
            sketch.caption = tr("The part");
            m_paper.figure(std::move(sketch));
        }
        for (const GroundSurface& surface : surfaces) {
            const QString name = oneLine(surface.name);
            m_paper.table(m_view.inputs(surface.project),
                          name.isEmpty() ? tr("Inputs") : tr("Inputs of the surface %1").arg(name));
        }
    }

    void writeResults() {
        const auto unpredicted = StudentView::unpredicted(m_work);
        m_paper.section(tr("Results of the work"));
        if (!unpredicted.empty()) {
            QStringList steps;
            for (const std::size_t step : unpredicted) {
                steps << QString::number(step + 1);
            }
            m_paper.say(tr("The results are printed once every prediction is handed in; still "
                           "open: step %1.")
                            .arg(steps.join(QStringLiteral(", "))));
            return;
        }
        StepResults results(m_work, m_view, m_wish.figures, m_wish.breathe);
        for (std::size_t i = 0; i < m_work.lesson.steps.size(); ++i) {
            m_paper.subsection(tr("Step %1").arg(i + 1));
            m_paper.lesson(m_work.lesson.steps[i].task);
            if (isConclusion(i)) {
                m_paper.say(tr("The answer is the conclusion of the work."));
            } else {
                results.write(m_paper, i);
            }
        }
        if (Table table = results.predictions(); !table.rows.empty()) {
            m_paper.section(tr("Predictions and results"));
            m_paper.table(std::move(table), tr("Predictions beside results"));
        }
        if (Table table = results.keptRuns(); !table.rows.empty()) {
            m_paper.section(tr("Kept runs compared"));
            m_paper.say(tr("The runs that were kept differ in these inputs and results; the "
                           "numbers are those of the engine."));
            m_paper.table(std::move(table), tr("Kept runs"));
        }
    }

    /// Whether a step is the last one that was answered in words.
    [[nodiscard]] bool isConclusion(std::size_t step) const {
        return conclusionStep() == std::optional(step);
    }

    [[nodiscard]] std::optional<std::size_t> conclusionStep() const {
        for (std::size_t i = m_work.lesson.steps.size(); i-- > 0;) {
            if (m_work.lesson.steps[i].goal.text) {
                const auto answer = recordOf(m_work, i).answer;
                return answer && !answer->text.empty() ? std::optional(i) : std::nullopt;
            }
        }
        return std::nullopt;
    }

    void writeConclusion() {
        const auto step = conclusionStep();
        if (!step) {
            m_paper.add(Blank{conclusionLines});
            return;
        }
        m_paper.lines(recordOf(m_work, *step).answer->text);
    }

    /// The program, and the sources of its equations.
    void writeSources() {
        QStringList sources{
            tr("%1: calculation of cylindrical grinding cycles: a computer program and the "
               "description of its model")
                .arg(m_paper.report().program)};
        for (const QStringList& row : citedRows()) {
            sources << row.back();
        }
        for (qsizetype i = 0; i < sources.size(); ++i) {
            m_paper.say(QStringLiteral("%1 %2.").arg(QString::number(i + 1), sources[i]));
        }
    }

    /// Keys and texts of the sources of the deepest cut's formulas, besides the model description.
    [[nodiscard]] std::vector<QStringList> citedRows() const {
        std::vector<QStringList> rows;
        const OutcomePtr outcome = evaluate(m_work.lesson.base.surfaces.front().project, {});
        const auto step = outcome->ran() ? findStep(outcome->trajectory) : std::nullopt;
        if (step) {
            Citations citations;
            (void)WorkedStep::formulas(*outcome, *step, citations);
            rows = citations.table().rows;
            std::erase_if(rows, [](const QStringList& row) {
                return row.front().startsWith(QStringLiteral("MODEL"));
            });
        }
        return rows;
    }

    const Work& m_work;
    const PaperWish& m_wish;
    StudentView m_view;
    WorkTitle m_title;
    PaperWriter m_paper;
};

} // namespace

Report labReport(const Work& work, const PaperWish& wish) {
    return LabReportWriter(work, wish).write();
}

} // namespace sparkout::report
