// SPDX-License-Identifier: GPL-3.0-or-later
// Goals against the engine: figures are those of the run, a goal passes up to its tolerance and not
// beyond, and what is not free stays as it was given.
#include "core/batch/judgement.h"
#include "core/lesson/goal_check.h"
#include "core/quality/run_summary.h"
#include "core/setup/setup_file.h"
#include "core/simulation/simulate.h"
#include "core/units.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/registry.h"
#include "tests/two_stage_projects.h"
#include "tests/whole_project.h"

#include <cmath>

namespace sparkout::test_goal_check {

Figure figureOf(FigureName name, PlaceName place = {}, std::optional<int> stage = {},
                std::optional<int> count = {}, Step step = Step::none) {
    return {name, place, stage, count, step};
}

Answer answerWith(const Setup& setup) {
    Answer answer;
    answer.setup.text = writeSetup(setup);
    return answer;
}

/// The whole of a goal, of one kind.
template <class Kind>
Goal goalOf(std::optional<Kind> Goal::*member, Kind kind) {
    Goal goal;
    goal.*member = std::move(kind);
    return goal;
}

class TestGoalCheck : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_lesson = samples::lesson();
        m_project = m_lesson.base.surfaces.front().project;
        m_run = studyRun(m_project, true);
        QVERIFY(m_run.isCompleted());
    }

    void everyFigureOfThisRunIsFinite() {
        for (int i = 0; i < static_cast<int>(FigureName::count_); ++i) {
            const auto name = static_cast<FigureName>(i);
            const FigureScope scope = rowOf(name).scope;
            if (scope == FigureScope::batch || scope == FigureScope::batchPlace) {
                continue; // this project has no batch; test_figure_value has one
            }
            const auto value =
                figureValue(figureOf(name, PlaceName::ofWord(1), 1, 10), m_run.figures());
            QVERIFY2(value && std::isfinite(*value), rowOf(name).choice.key);
        }
    }

    /// What a zone loses is the sum of the actual feeds of its double strokes: the mean radius of
    /// the blank less that of the part.
    void actualFeedsAddUpToTheStock() {
        for (std::size_t zone = 0; zone < 3; ++zone) {
            const PlaceName place = PlaceName::ofWord(zone);
            double sum_um = 0;
            for (int count = 1; count <= m_run.result.cycleCount; ++count) {
                sum_um += *figureValue(figureOf(FigureName::actualFeed, place, {}, count),
                                       m_run.figures());
            }
            const double accumulated_um =
                *figureValue(figureOf(FigureName::accumulatedFeed, place), m_run.figures());
            QVERIFY(std::abs(sum_um - accumulated_um) < 1e-6);
            const double left_um =
                *figureValue(figureOf(FigureName::stockLeft, place), m_run.figures());
            const SectionResult& section = m_run.result.sections[zone];
            const double target_mm = m_project.part->diameter_mm / 2 - 0.004; // middle of 0/−16
            QVERIFY(std::abs(left_um - (meanOfGround(section.radii_mm) - target_mm) * 1000) < 1e-6);
        }
    }

    void stepsOfADoubleStrokeAddUpToIt() {
        for (const FigureName name : {FigureName::actualFeed, FigureName::programmedFeed}) {
            double sum = 0;
            for (int step = 1; step <= 5; ++step) {
                sum += *figureValue(
                    figureOf(name, PlaceName::ofWord(0), {}, 12, static_cast<Step>(step)),
                    m_run.figures());
            }
            const double whole =
                *figureValue(figureOf(name, PlaceName::ofWord(0), {}, 12), m_run.figures());
            QVERIFY2(std::abs(sum - whole) < 1e-9, rowOf(name).choice.key);
        }
    }

    void theProgrammedFeedIsTheStages() {
        const double fed_um = *figureValue(
            figureOf(FigureName::programmedFeed, PlaceName::ofWord(1), 1, 12), m_run.figures());
        QVERIFY(std::abs(fed_um - *m_project.cycle->stages[0].radial_feed_mm * 1000) < 1e-9);
    }

    /// Once the deflection is steady all that is fed is cut.
    void aSteadyActualFeedIsTheProgrammedOne() {
        const double cut_um = *figureValue(
            figureOf(FigureName::actualFeed, PlaceName::ofWord(1), 1, 25), m_run.figures());
        QVERIFY(std::abs(cut_um - *m_project.cycle->stages[0].radial_feed_mm * 1000) < 1e-3);
    }

    void withoutACountTheLastOneOfTheStageIsMeant() {
        const int last = m_run.result.countsByStage[0];
        const PlaceName nz = PlaceName::ofWord(1);
        QCOMPARE(figureValue(figureOf(FigureName::actualFeed, nz, 1), m_run.figures()),
                 figureValue(figureOf(FigureName::actualFeed, nz, 1, last), m_run.figures()));
        QCOMPARE(figureValue(figureOf(FigureName::actualFeed, nz), m_run.figures()),
                 figureValue(figureOf(FigureName::actualFeed, nz, {}, m_run.result.cycleCount),
                             m_run.figures()));
    }

    void whatARunDoesNotHaveIsNoFigure() {
        const FigureSource run = m_run.figures();
        const PlaceName nz = PlaceName::ofWord(1);
        QVERIFY(!figureValue(figureOf(FigureName::actualFeed, nz, {}, 10'000), run));
        QVERIFY(!figureValue(figureOf(FigureName::actualFeed, nz, 2, 1), run));
        QVERIFY(!figureValue(figureOf(FigureName::actualFeed, nz, {}, 5, Step::e5), run));
        QVERIFY(!figureValue(figureOf(FigureName::actualFeed, PlaceName::ofNumber(0), {}, 5), run));
        QVERIFY(!figureValue(figureOf(FigureName::stageTime, {}, 3), run));
        QVERIFY(!figureValue(figureOf(FigureName::roundness), run));
        const StudiedRun notRecorded = studyRun(m_project, false);
        QVERIFY(!figureValue(figureOf(FigureName::actualFeed, nz, {}, 5), notRecorded.figures()));
        QVERIFY(figureValue(figureOf(FigureName::roundness, nz), notRecorded.figures()));
    }

    /// Where strips stay uncut nothing is said of the surface, but of time and force.
    void strippedSurfacesHaveNoSize() {
        Project stripped = m_project;
        stripped.cycle->stages[1].axial_feed_mm_min = 5000 * 1.9; // above B·n
        stripped.machine->limits.axial_feed_mm_min.reset();
        stripped.machine->work_speed_rpm = 180;
        const StudiedRun run = studyRun(stripped, false);
        QVERIFY(run.isCompleted());
        QVERIFY(!figureValue(figureOf(FigureName::diameterSpread), run.figures()));
        QVERIFY(!figureValue(figureOf(FigureName::roundness, PlaceName::ofWord(0)), run.figures()));
        QVERIFY(figureValue(figureOf(FigureName::cycleTime), run.figures()));
    }

    // --- goals --------------------------------------------------------------------------------

    void timePassesUpToItsLimit() {
        const double time_min = m_run.result.time_s / 60;
        const auto finding = [&](double below_min) {
            return checkGoal(goalOf(&Goal::time, TimeGoal{below_min, {}, false}), m_run.figures(),
                             {})
                .finding;
        };
        QVERIFY(finding(time_min) == Finding::passed);
        QVERIFY(finding(time_min * 1.01) == Finding::passed);
        QVERIFY(finding(time_min * 0.999) == Finding::failed);
    }

    void requirementsAreThoseOfTheVerdict() {
        const GoalResult holds =
            checkGoal(goalOf(&Goal::requirements, RequirementsGoal{}), m_run.figures(), {});
        QVERIFY(holds.passed());
        const double margin = *holds.value;
        const auto withMargin = [&](double percent) {
            return checkGoal(goalOf(&Goal::requirements, RequirementsGoal{percent}),
                             m_run.figures(), {})
                .finding;
        };
        QVERIFY(withMargin(std::floor(margin)) == Finding::passed);
        QVERIFY(withMargin(std::ceil(margin)) == Finding::failed);
        Project strict = m_project;
        strict.part->tolerance.radial_runout_um = 0.5;
        const StudiedRun run = studyRun(strict, false);
        const GoalResult fails =
            checkGoal(goalOf(&Goal::requirements, RequirementsGoal{}), run.figures(), {});
        QVERIFY(fails.finding == Finding::failed);
        QVERIFY(fails.failing == std::vector{ConstraintKind::radialRunout});
        const GoalResult timed =
            checkGoal(goalOf(&Goal::time, TimeGoal{100, {}, true}), run.figures(), {});
        QVERIFY(timed.finding == Finding::failed);
    }

    /// A cycle that suits the part that is run, and others of its batch not.
    void aGoalForEveryStockIsJudgedByThePhases() {
        bool differs = false;
        for (double field_um = 16; field_um >= 1; field_um *= 0.8) {
            Project project = fixtures::plungeProject(3);
            project.part->upper_deviation_um = field_um / 2;
            project.part->lower_deviation_um = -field_um / 2;
            const StudiedRun run = studyRun(project, false);
            const GoalResult one =
                checkGoal(goalOf(&Goal::requirements, RequirementsGoal{}), run.figures(), {});
            const GoalResult all = checkGoal(goalOf(&Goal::requirements, RequirementsGoal{0, true}),
                                             run.figures(), {});
            const bool holds = judgeStocks(run.result)->holds;
            QCOMPARE(all.passed(), one.passed() && holds);
            QCOMPARE(all.failingStocks_percent.has_value(), one.passed() && !holds);
            QVERIFY(*all.value <= *one.value);
            differs = differs || one.passed() != all.passed();
        }
        QVERIFY(differs);
    }

    void aFigurePassesWithinItsTolerance() {
        const Figure figure = figureOf(FigureName::diameterSpread);
        const double value = *figureValue(figure, m_run.figures());
        const auto finding = [&](double asked) {
            return checkGoal(goalOf(&Goal::figure, FigureGoal{figure, asked, 0.1}), m_run.figures(),
                             {})
                .finding;
        };
        QVERIFY(finding(value) == Finding::passed);
        QVERIFY(finding(value + 0.099) == Finding::passed);
        QVERIFY(finding(value - 0.101) == Finding::failed);
    }

    void aPredictionPassesWithinTheGreaterTolerance() {
        const Figure figure = figureOf(FigureName::cycleTime);
        const double value = *figureValue(figure, m_run.figures());
        const auto finding = [&](std::optional<double> said, double tolerance, double percent) {
            Answer answer;
            answer.number = said;
            return checkGoal(
                       goalOf(&Goal::prediction, NumberPrediction{figure, tolerance, percent}),
                       m_run.figures(), answer)
                .finding;
        };
        QVERIFY(finding(value * 1.09, 0, 10) == Finding::passed);
        QVERIFY(finding(value * 1.11, 0, 10) == Finding::failed);
        QVERIFY(finding(value * 1.11, value, 10) == Finding::passed);
        QVERIFY(finding(value, 0, 0) == Finding::passed);
        QVERIFY(finding({}, 1, 1) == Finding::notAnswered);
    }

    void aCurveIsComparedAlongItsPoints() {
        CurvePrediction curve;
        curve.figure = figureOf(FigureName::actualFeed, PlaceName::ofWord(1));
        curve.at = {2, 5, 10, 20};
        curve.tolerance = 0.3;
        const auto value = [&](int count) {
            return *figureValue(figureOf(FigureName::actualFeed, PlaceName::ofWord(1), {}, count),
                                m_run.figures());
        };
        const auto finding = [&](const NumberRows& rows) {
            Answer answer;
            answer.curve = rows;
            return checkGoal(goalOf(&Goal::curve, CurvePrediction(curve)), m_run.figures(), answer);
        };
        const NumberRows right{{{2, value(2)}, {5, value(5)}, {10, value(10)}, {20, value(20)}}};
        QVERIFY(finding(right).passed());
        QCOMPARE(finding(right).curve.size(), std::size_t{4});
        NumberRows wrong = right;
        (*wrong)[1][1] += 1;
        QVERIFY(finding(wrong).finding == Finding::failed);
        QCOMPARE(*finding(wrong).value, 75.0);
        curve.least_share_percent = 75;
        QVERIFY(finding(wrong).passed());
        QCOMPARE(*finding({{{5, value(5)}, {20, value(20)}}}).value > 0, true);
        QVERIFY(!finding({{{5, value(5)}, {20, value(20)}}}).curve[0].said); // begins later
        QVERIFY(finding({{{5, 1}, {5, 2}}}).finding == Finding::notAnswered);
        QVERIFY(finding({}).finding == Finding::notAnswered);
    }

    void anOrderIsThatOfTheFigures() {
        const auto finding = [&](std::optional<std::vector<double>> order, double alike) {
            Answer answer;
            answer.order = std::move(order);
            return checkGoal(goalOf(&Goal::order,
                                    OrderPrediction{figureOf(FigureName::deviationMean), alike}),
                             m_run.figures(), answer)
                .finding;
        };
        // НЗ carries the gauge; РЗ2 and РЗ1 see more passes.
        QVERIFY(finding({{1, 2, 0}}, 0.1) == Finding::passed);
        QVERIFY(finding({{2, 1, 0}}, 0.1) == Finding::failed);
        QVERIFY(finding({{2, 1, 0}}, 1.5) == Finding::passed); // 1.2 µm apart
        QVERIFY(finding({{1, 2}}, 0.1) == Finding::notAnswered);
        QVERIFY(finding({{1, 1, 0}}, 0.1) == Finding::notAnswered);
        QVERIFY(finding({{1, 2, 3}}, 0.1) == Finding::notAnswered);
        QVERIFY(finding({}, 0.1) == Finding::notAnswered);
    }

    void choicesAndWords() {
        Answer answer;
        QVERIFY(checkStep(m_lesson, 0, answer).finding == Finding::notAnswered);
        answer.chosen = {{1}};
        QVERIFY(checkStep(m_lesson, 0, answer).passed());
        answer.chosen = {{1, 3}};
        QVERIFY(checkStep(m_lesson, 0, answer).finding == Finding::failed);
        QVERIFY(checkStep(forStudents(m_lesson), 0, answer).finding == Finding::forTeacher);
        Answer words;
        words.text = "коротко";
        QVERIFY(checkStep(m_lesson, 7, words).finding == Finding::notAnswered);
        for (int i = 0; i < 5; ++i) {
            words.text += " больше проходов, больше снято";
        }
        QVERIFY(checkStep(m_lesson, 7, words).finding == Finding::forTeacher);
    }

    // --- what is free -------------------------------------------------------------------------

    void theLongestPathSaysWhatIsFree() {
        LessonStep step;
        step.inputs = {{"/cycle", Access::free},
                       {"/cycle/stages/0", Access::locked},
                       {"/cycle/stages/0/stock_mm", Access::hidden}};
        QVERIFY(accessTo(step, "/cycle/stages/1/stock_mm") == Access::free);
        QVERIFY(accessTo(step, "/cycle/stages/0/radial_feed_mm") == Access::locked);
        QVERIFY(accessTo(step, "/cycle/stages/0/stock_mm") == Access::hidden);
        QVERIFY(accessTo(step, "/cyclex") == Access::locked);
        step.others = Access::free;
        QVERIFY(accessTo(step, "/wheel/dullness") == Access::free);
    }

    void lockedInputsAreNamed() {
        Setup setup = m_lesson.base;
        Project& project = setup.surfaces.front().project;
        project.cycle->stages[1].radial_feed_mm = 0.001;
        project.title = "my own";
        project.notes = "what I thought";
        QVERIFY(forbiddenChanges(m_lesson, 5, setup).empty());
        QVERIFY(checkStep(m_lesson, 5, answerWith(setup)).finding == Finding::passed);
        // Free in a step before: it stays as the student has set it.
        QVERIFY(forbiddenChanges(m_lesson, 7, setup).empty());
        QCOMPARE(forbiddenChanges(m_lesson, 4, setup).size(), std::size_t{1});
        project.wheel->dullness = 0.001;
        const GoalResult result = checkStep(m_lesson, 5, answerWith(setup));
        QVERIFY(result.finding == Finding::forbidden);
        QVERIFY(result.forbidden == std::vector<std::string>{"/wheel/dullness"});
    }

    void stagesAreAddedWhereTheCycleIsFree() {
        Setup setup = m_lesson.base;
        auto& stages = setup.surfaces.front().project.cycle->stages;
        stages.insert(stages.begin() + 1, stages[1]);
        QVERIFY(forbiddenChanges(m_lesson, 6, setup).empty());
        QVERIFY(!forbiddenChanges(m_lesson, 5, setup).empty());
    }

    void whatCannotBeRunIsRefused() {
        Answer answer;
        answer.setup.text = "{}";
        QVERIFY(checkStep(m_lesson, 6, answer).finding == Finding::notAnswered);
        answer.setup.text = R"({"format": "sparkout-project"})";
        const GoalResult result = checkStep(m_lesson, 6, answer);
        QVERIFY(result.finding == Finding::refused);
        QVERIFY(!result.issues.empty());
    }

    /// A step may put values into the project: what a student predicts is then of these.
    void valuesOfAStepAreInItsProject() {
        Lesson lesson = m_lesson;
        lesson.steps[1].values = {{"/wheel/dullness", 0.06, {}}};
        QCOMPARE(setupOf(lesson, 1).surfaces.front().project.wheel->dullness, 0.06);
        QCOMPARE(setupOf(lesson, 0).surfaces.front().project.wheel->dullness,
                 m_project.wheel->dullness);
        Figure figure = figureOf(FigureName::peakForce);
        lesson.steps[1].goal = goalOf(&Goal::prediction, NumberPrediction{figure, 1, 0});
        Project dull = m_project;
        dull.wheel->dullness = 0.06;
        QCOMPARE(*checkStep(lesson, 1, {}).value, simulate(dull).peakNormalForce_n);
    }

private:
    Lesson m_lesson;
    Project m_project;
    StudiedRun m_run;
};

} // namespace sparkout::test_goal_check

SPARKOUT_TEST(test_goal_check, TestGoalCheck)
#include "test_goal_check.moc"
