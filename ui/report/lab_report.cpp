// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/lab_report.h"

#include "core/file/project_file.h"
#include "core/lesson/goal_check.h"
#include "core/project/cycle.h"
#include "core/quality/run_summary.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "core/study/outcome.h"
#include "core/study/run_comparison.h"
#include "ui/report/cell_text.h"
#include "ui/report/cycle_card.h"
#include "ui/report/lesson_markup.h"
#include "ui/report/operation_setup.h"
#include "ui/report/paper_writer.h"
#include "ui/report/run_figures.h"
#include "ui/report/student_view.h"
#include "ui/report/worked_step.h"
#include "ui/results/run_table.h"
#include "ui/text/goal_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sparkout::report {

namespace {

/// The results of a work, step by step: every number is computed by the engine from what was handed
/// in.
class StepResults {
    Q_DECLARE_TR_FUNCTIONS(StepResults)
public:
    StepResults(const Work& work, const StudentView& view, const std::set<HandoutView>& figures,
                const std::function<void()>& breathe);

    /// Writes the answers to a step and their results, in tables and figures.
    void write(PaperWriter& paper, std::size_t step);
    /// All predictions beside the engine's values; no rows if there are none.
    [[nodiscard]] Table predictions() const;
    /// The differences between the given project and the kept runs. No rows without runs.
    [[nodiscard]] Table keptRuns() const;
    [[nodiscard]] const GoalResult& result(std::size_t step) const { return m_results[step]; }

private:
    struct Run {
        OutcomePtr outcome;
        std::map<QString, int> figures; ///< numbers of figures by their contents
    };
    [[nodiscard]] const Project& given(std::size_t step) const;
    /// The run for a step; null if it was not possible.
    Run* runOf(std::size_t step);
    [[nodiscard]] Table changes(std::size_t step, const Project& set) const;
    void writeSetting(PaperWriter& paper, std::size_t step, Run& run) const;
    void writePrediction(PaperWriter& paper, std::size_t step) const;
    void writeCurve(PaperWriter& paper, std::size_t step) const;
    void writeOrder(PaperWriter& paper, std::size_t step) const;
    void writeChoice(PaperWriter& paper, std::size_t step) const;
    void writeFigures(PaperWriter& paper, std::size_t step, Run& run) const;

    const Work& m_work;
    const StudentView& m_view;
    const std::set<HandoutView>& m_figures;
    const std::function<void()>& m_breathe;
    std::vector<StepRecord> m_records;
    std::vector<GoalResult> m_results;
    std::vector<Setup> m_given;        ///< initial set-up of each step
    std::map<std::string, Run> m_runs; ///< by the text of the set-up and the surface
};

QString yesNo(bool yes) {
    return yes ? QCoreApplication::translate("StepResults", "yes")
               : QCoreApplication::translate("StepResults", "no");
}

QString numberOrDash(const sparkout::Figure& figure, const std::optional<double>& value) {
    return value ? GoalText::number(figure, *value) : cell({});
}

constexpr int saidDigits = 6; ///< digits of a number typed by a student

/// The differences of runs, without the inputs that a step hides.
std::vector<RunRow> shownRows(const StudentView& view, const std::vector<ComparedRun>& runs) {
    const std::vector<ComparedRow> compared = compareRuns(runs);
    const std::vector<RunRow> rows = differingRows(runs); // one for each of them
    std::vector<RunRow> shown;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].isResult || !view.hides(compared[i].path)) {
            shown.push_back(rows[i]);
        }
    }
    return shown;
}

/// A run to compare, and its data.
struct HeldRun {
    QString name;
    Project inputs;
    ReadSummary summary;
};

StepResults::StepResults(const Work& work, const StudentView& view,
                         const std::set<HandoutView>& figures, const std::function<void()>& breathe)
    : m_work(work), m_view(view), m_figures(figures), m_breathe(breathe) {
    for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
        m_records.push_back(recordOf(work, i));
        m_given.push_back(setupOf(work.lesson, i));
        m_breathe();
        m_results.push_back(checkStep(work.lesson, i, m_records[i].answer.value_or(Answer())));
    }
}

const Project& StepResults::given(std::size_t step) const {
    const auto surface = static_cast<std::size_t>(m_work.lesson.steps[step].surface) - 1;
    return m_given[step].surfaces[surface].project;
}

StepResults::Run* StepResults::runOf(std::size_t step) {
    const LessonStep& of = m_work.lesson.steps[step];
    const GoalResult& result = m_results[step];
    if (!needsRun(of.goal) || result.finding == Finding::forbidden
        || result.finding == Finding::refused) {
        return nullptr;
    }
    const auto& answer = m_records[step].answer;
    std::optional<Setup> setup = m_given[step];
    if (answer && answer->hasSetup()) {
        setup = readSetup(answer->setup.text).setup;
    }
    if (!setup) {
        return nullptr;
    }
    const std::string key = std::to_string(of.surface) + writeSetup(*setup);
    const auto found = m_runs.find(key);
    if (found != m_runs.end()) {
        return &found->second;
    }
    m_breathe();
    const WornProject worn = wornProject(*setup, static_cast<std::size_t>(of.surface) - 1);
    OutcomePtr outcome = worn.issues.empty() ? evaluate(worn.project, {}) : nullptr;
    if (!outcome || !outcome->ran()) {
        return nullptr;
    }
    return &m_runs.emplace(key, Run{std::move(outcome), {}}).first->second;
}

Table StepResults::changes(std::size_t step, const Project& set) const {
    Table table;
    table.head = {tr("Input"), tr("Unit"), tr("Given"), tr("Set")};
    table.texts = {true, true};
    Project plain = set;
    plain.runs.clear();
    const Project& before = given(step);
    for (const RunRow& row : shownRows(m_view, {{&before, nullptr}, {&plain, nullptr}})) {
        table.rows.push_back({row.what, cell(row.unit), cell(row.shown[0]), cell(row.shown[1])});
    }
    return table;
}

void StepResults::writeFigures(PaperWriter& paper, std::size_t step, Run& run) const {
    const auto add = [&](HandoutView view, Hideable hiddenWith, const auto& make) {
        if (!m_figures.contains(view) || m_view.hides(step, hiddenWith)) {
            return;
        }
        const QString key = QString::number(static_cast<int>(view));
        if (const auto drawn = run.figures.find(key); drawn != run.figures.end()) {
            paper.say(tr("The course of this cycle is in figure %1.").arg(drawn->second));
            return;
        }
        m_breathe();
        if (std::optional<Figure> figure = make()) {
            run.figures[key] = paper.figure(std::move(*figure));
        }
    };
    if (!m_view.hidesAnyOf("/cycle")) {
        add(HandoutView::cycle, Hideable::feeds, [&] { return feedsFigure(run.outcome); });
    }
    if (isMetBySetting(m_work.lesson.steps[step].goal.kind())) {
        add(HandoutView::profiles, Hideable::profiles,
            [&] { return std::optional(profilesFigure(run.outcome)); });
    }
}

void StepResults::writeSetting(PaperWriter& paper, std::size_t step, Run& run) const {
    const Outcome& outcome = *run.outcome;
    Table set = changes(step, outcome.result.project);
    if (set.rows.empty()) {
        paper.say(tr("No input was changed."));
    } else {
        paper.table(std::move(set), tr("Inputs that were set"));
    }
    if (!m_view.hidesAnyOf("/cycle")) {
        paper.table(OperationSetup::stages(outcome), tr("Stages of the cycle"));
    }
    paper.table(CycleCard::accuracy(outcome), tr("Accuracy by zone or section"));
    if (!m_view.hides(step, Hideable::verdict)) {
        paper.table(CycleCard::requirements(outcome), tr("Requirements and margins"));
    }
}

void StepResults::writePrediction(PaperWriter& paper, std::size_t step) const {
    const NumberPrediction& goal = *m_work.lesson.steps[step].goal.prediction;
    const sparkout::Figure& figure = goal.figure;
    const GoalResult& result = m_results[step];
    // A question that a student can answer again does not reveal the engine's number.
    const bool shows = !goal.after_run || result.passed();
    Table table;
    table.head = {tr("Quantity"), tr("Unit"), goal.after_run ? tr("Answer") : tr("Predicted"),
                  tr("By the engine"), tr("Allowed difference")};
    table.texts = {true, true};
    table.rows.push_back(
        {GoalText::quantity(figure, given(step)), cell(GoalText::unit(figure)),
         result.asked ? printedNumber(*result.asked, saidDigits) : cell({}),
         shows ? numberOrDash(figure, result.value) : cell({}),
         QStringLiteral("±") + Names::fixed(result.tolerance, rowOf(figure.name).digits + 1)});
    paper.table(std::move(table),
                goal.after_run ? tr("Answer and result") : tr("Prediction and result"));
}

void StepResults::writeCurve(PaperWriter& paper, std::size_t step) const {
    const CurvePrediction& goal = *m_work.lesson.steps[step].goal.curve;
    const GoalResult& result = m_results[step];
    Table table;
    const auto of = [&](const QString& text) {
        const QString unit = GoalText::unit(goal.figure);
        return unit.isEmpty() ? text : text + QStringLiteral(", ") + unit;
    };
    table.head = {GoalText::along(goal, given(step)), of(tr("Predicted")), of(tr("By the engine")),
                  of(tr("Difference")), tr("Within the allowed difference")};
    table.texts = {true, false, false, false, true};
    for (const ComparedPoint& point : result.curve) {
        table.rows.push_back(
            {GoalText::alongAt(goal, point.at, given(step)), numberOrDash(goal.figure, point.said),
             GoalText::number(goal.figure, point.value),
             point.said ? GoalText::number(goal.figure, *point.said - point.value) : cell({}),
             yesNo(point.isWithin)});
    }
    const QString name = GoalText::quantity(goal.figure, given(step));
    paper.table(std::move(table), tr("%1: predicted and computed").arg(name));
    if (!result.curve.empty()) {
        paper.figure(CurveFigure::compared(goal, given(step), result,
                                           m_records[step].answer.value_or(Answer()).curve));
    }
}

void StepResults::writeOrder(PaperWriter& paper, std::size_t step) const {
    const sparkout::Figure& asked = m_work.lesson.steps[step].goal.order->figure;
    const GoalResult& result = m_results[step];
    const auto said = m_records[step].answer.value_or(Answer()).order;
    Table table;
    table.head = {tr("Place in the order, the largest first"), tr("Predicted"),
                  tr("By the engine")};
    table.texts = {true, true, true};
    for (std::size_t i = 0; i < result.order.size(); ++i) {
        const double place = said && i < said->size() ? (*said)[i] : -1;
        const bool isPlace = place >= 0 && place < static_cast<double>(result.order.size());
        table.rows.push_back(
            {QString::number(i + 1),
             isPlace ? GoalText::place(given(step), static_cast<std::size_t>(place)) : cell({}),
             GoalText::place(given(step), result.order[i])});
    }
    paper.table(
        std::move(table),
        tr("The order by %1").arg(Names::inSentence(GoalText::quantity(asked, given(step)))));
}

void StepResults::writeChoice(PaperWriter& paper, std::size_t step) const {
    const auto& options = m_work.lesson.steps[step].goal.choice->options;
    const auto chosen = m_records[step].answer.value_or(Answer()).chosen;
    for (const double number : chosen.value_or(std::vector<double>())) {
        if (number >= 1 && number <= static_cast<double>(options.size())
            && number == std::floor(number)) {
            const auto index = static_cast<std::size_t>(number) - 1;
            paper.say(tr("Chosen: %1.")
                          .arg(LessonMarkup::inOneLine(PaperWriter::text(options[index].text))));
        }
    }
}

void StepResults::write(PaperWriter& paper, std::size_t step) {
    const LessonStep& of = m_work.lesson.steps[step];
    const StepRecord& record = m_records[step];
    const GoalResult& result = m_results[step];
    if (!record.answer) {
        paper.say(tr("No answer was handed in."));
        return;
    }
    switch (of.goal.kind()) {
    case GoalKind::prediction: writePrediction(paper, step); break;
    case GoalKind::curve: writeCurve(paper, step); break;
    case GoalKind::order: writeOrder(paper, step); break;
    case GoalKind::choice: writeChoice(paper, step); break;
    case GoalKind::text: paper.lines(record.answer->text); break;
    default: break;
    }
    Run* const run = runOf(step);
    if (run && isMetBySetting(of.goal.kind())) {
        writeSetting(paper, step, *run);
    }
    if (run) {
        writeFigures(paper, step, *run);
    }
    QStringList sentences;
    if (of.goal.kind() != GoalKind::text && of.goal.kind() != GoalKind::choice) {
        sentences << tr("Found: %1.").arg(GoalText::finding(result.finding));
    }
    if (result.time_min && isMetBySetting(of.goal.kind())) {
        sentences << tr("The cycle takes %1.").arg(Names::timeOfMinutes(*result.time_min, 4));
    }
    sentences << tr("Attempts: %1.").arg(record.attempts);
    if (!record.hints.empty()) {
        sentences << tr("Hints taken: %1.").arg(record.hints.size());
    }
    if (record.isPredictedLate) {
        sentences << tr("The prediction was handed in after the run.");
    }
    paper.say(sentences.join(u' '));
}

Table StepResults::predictions() const {
    Table table;
    table.head = {tr("Step"), tr("Quantity"), tr("Predicted"), tr("By the engine"),
                  tr("Result of the check")};
    table.texts = {true, true, true, true, true};
    for (std::size_t i = 0; i < m_results.size(); ++i) {
        const Goal& goal = m_work.lesson.steps[i].goal;
        const GoalResult& result = m_results[i];
        if (!isPrediction(goal) || !m_records[i].answer) {
            continue;
        }
        const sparkout::Figure& figure = *goal.asked();
        const QString name = GoalText::quantityAndUnit(figure, given(i));
        QString said, found;
        if (goal.prediction) {
            said = result.asked ? printedNumber(*result.asked, saidDigits) : cell({});
            found = numberOrDash(figure, result.value);
        } else if (goal.order) {
            std::vector<std::size_t> order;
            for (const double place : m_records[i].answer->order.value_or(std::vector<double>())) {
                order.push_back(static_cast<std::size_t>(std::max(0.0, place)));
            }
            said = cell(GoalText::order(given(i), order));
            found = cell(GoalText::order(given(i), result.order));
        } else {
            const auto within = std::ranges::count_if(
                result.curve, [](const ComparedPoint& p) { return p.isWithin; });
            said = tr("curve");
            found = tr("%1 of %2 points within the allowed difference")
                        .arg(within)
                        .arg(result.curve.size());
        }
        table.rows.push_back(
            {QString::number(i + 1), name, said, found, GoalText::finding(result.finding)});
    }
    return table;
}

Table StepResults::keptRuns() const {
    std::list<HeldRun> held;
    const auto hold = [&held](const QString& name, const Project& project) {
        const auto outcome = evaluate(project, {});
        if (outcome && outcome->ran()) {
            held.push_back(
                {name,
                 project,
                 {summarise(outcome->result, outcome->accuracy, outcome->constraints), {}}});
        }
    };
    std::size_t kept = 0;
    for (const WorkEntry& entry : m_work.entries) {
        const auto read = entry.run ? readProject(entry.run->inputs.text) : ReadResult();
        if (!read.project) {
            continue;
        }
        if (kept++ == 0) {
            hold(tr("As given"), given(0));
        }
        m_breathe();
        hold(cell(oneLine(entry.run->name)), *read.project);
    }
    Table table;
    if (kept == 0) {
        return table;
    }
    std::vector<ComparedRun> runs;
    table.head = {tr("Quantity"), tr("Unit")};
    for (const HeldRun& run : held) {
        runs.push_back({&run.inputs, &run.summary});
        table.head << run.name;
    }
    table.texts.assign(static_cast<std::size_t>(table.head.size()), true);
    for (const RunRow& row : shownRows(m_view, runs)) {
        QStringList cells{row.what, cell(row.unit)};
        for (const QString& shown : row.shown) {
            cells << cell(shown);
        }
        table.rows.push_back(cells);
    }
    return table;
}

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
