// SPDX-License-Identifier: GPL-3.0-or-later
// The ten works that are shipped, tried as a student tries them: who reads what the program shows
// gets all points, who does not gets none; and each is a lesson, with its guide for the teacher.
#include "core/lesson/grading.h"
#include "core/lesson/make_variants.h"
#include "core/quality/constraints.h"
#include "tests/core/lesson/class_samples.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

#include <cmath>
#include <numeric>
#include <set>

namespace sparkout::test_practicum {

enum class Pupil { reads, guesses };

/// A number as it is read off the window: to the decimals of its figure.
double asRead(double value, FigureName name) {
    const double scale = std::pow(10.0, rowOf(name).digits);
    return std::round(value * scale) / scale;
}

Answer withSetup(const Setup& setup) {
    Answer answer;
    answer.setup.text = writeSetup(setup);
    return answer;
}

/// The options that are right, or all that are not.
std::vector<double> chosen(const ChoiceGoal& goal, bool isRight) {
    std::vector<double> options;
    for (std::size_t i = 0; i < goal.options.size(); ++i) {
        if (goal.options[i].right == isRight) {
            options.push_back(static_cast<double>(i + 1));
        }
    }
    return options;
}

/// What a student hands in for a step of the teacher's lesson with his variant in place.
Answer answerTo(const Lesson& given, std::size_t step, const std::optional<BestAnswer>& best,
                Pupil pupil) {
    const Goal& goal = given.steps[step].goal;
    const bool reads = pupil == Pupil::reads;
    Answer answer;
    if (goal.choice) {
        answer.chosen = chosen(*goal.choice, reads);
    } else if (goal.text) {
        answer.text = reads ? std::string(300, 'x') : std::string("x");
    } else if (goal.figure) {
        const auto setup = reads ? attainingSetup(given, step) : setupOf(given, step);
        return setup ? withSetup(*setup) : Answer();
    } else if (isMetBySetting(goal.kind())) {
        Setup setup = setupOf(given, step);
        if (reads && best) {
            setup.surfaces.front().project.cycle = samples::solving(best->project, goal).cycle;
        }
        return withSetup(setup);
    } else {
        const GoalResult engine = checkStep(given, step, {});
        if (goal.prediction) {
            const double value = engine.value.value_or(0);
            answer.number = reads ? asRead(value, goal.prediction->figure.name) : 2 * value + 7;
        }
        if (goal.curve) {
            answer.curve.emplace();
            for (const ComparedPoint& point : engine.curve) {
                answer.curve->push_back(
                    {point.at,
                     reads ? asRead(point.value, goal.curve->figure.name) : 2 * point.value + 20});
            }
        }
        if (goal.order) {
            answer.order.emplace(engine.order.begin(), engine.order.end());
            if (!reads) {
                std::reverse(answer.order->begin(), answer.order->end());
            }
        }
    }
    return answer;
}

/// What the right options of a work say of its variants, as the engine finds it.
class Claims {
public:
    explicit Claims(Lesson given) : m_given(std::move(given)) {}

    [[nodiscard]] bool hold(int work) const {
        switch (work) {
        case 1: return dullingDoublesTheFlats() && lagIsTheDeflection();
        case 3: return zonesWithoutDwellsAreAlike();
        case 4: return aDullWheelKeepsSeveralTimesTheLag();
        case 5: return anEccentricBlankFadesAlike();
        case 6: return theLayerIsDeeperThanTheStock();
        case 7: return aStiffPlaceOfTheGaugeMakesAllLarger();
        case 8: return theLastFeedSpreadsTheZones();
        default: return aLargerLastFeedScattersMore();
        }
    }

private:
    /// Of the project that a step begins with, from 1.
    [[nodiscard]] Project projectOf(std::size_t step) const {
        return setupOf(m_given, step - 1).surfaces.front().project;
    }
    static double valueOf(const Project& project, const Figure& figure) {
        return figureValue(figure, studyRun(project, needsTrajectory(figure)).figures()).value();
    }
    static Figure of(FigureName name, PlaceName place = {}, std::optional<int> stage = {},
                     std::optional<int> count = {}, Step step = Step::none) {
        return {name, place, stage, count, step};
    }
    static PlaceName zone(std::size_t index) { return PlaceName::ofWord(index); }
    static PlaceName section(int index) { return PlaceName::ofNumber(index); }

    [[nodiscard]] bool dullingDoublesTheFlats() const {
        Project dull = projectOf(1);
        const double ks = valueOf(dull, of(FigureName::shearCoefficient));
        const double kr = valueOf(dull, of(FigureName::flatCoefficient));
        dull.wheel->dullness *= 2;
        return valueOf(dull, of(FigureName::shearCoefficient)) == ks
               && std::abs(valueOf(dull, of(FigureName::flatCoefficient)) - 2 * kr) < 1e-9 * kr;
    }
    [[nodiscard]] bool lagIsTheDeflection() const {
        const Project project = projectOf(9);
        const double lag_um = valueOf(project, of(FigureName::lag, zone(1), 1, 5));
        const double force_n = valueOf(project, of(FigureName::force, zone(1), 1, 5, Step::e2));
        const double gamma = valueOf(project, of(FigureName::compliance, zone(1)));
        return std::abs(lag_um - 1000 * gamma * force_n) < 0.005 * lag_um;
    }
    [[nodiscard]] bool zonesWithoutDwellsAreAlike() const {
        const Project project = projectOf(7);
        const auto deviation = [&](std::size_t place) {
            return valueOf(project, of(FigureName::deviationMean, zone(place)));
        };
        return std::abs(deviation(1) - deviation(2)) < 0.005 && deviation(1) - deviation(0) > 0.05;
    }
    [[nodiscard]] bool aDullWheelKeepsSeveralTimesTheLag() const {
        const Figure lag = of(FigureName::lag, section(0), 2, 60);
        return valueOf(projectOf(6), lag) > 2.5 * valueOf(projectOf(5), lag);
    }
    [[nodiscard]] bool anEccentricBlankFadesAlike() const {
        const Figure runout = of(FigureName::runoutAfter, section(0), {}, 10);
        const double oval_um = valueOf(projectOf(4), runout);
        const Project project = projectOf(1);
        const double fed_um = 10 * *project.cycle->stages.front().radial_feed_mm_min
                              / project.machine->work_speed_rpm * 1000;
        return std::abs(valueOf(projectOf(7), runout) - oval_um) < 0.05 * oval_um
               && fed_um > 1000 * project.part->initial_runout_mm; // of a rigid system, step 2
    }
    [[nodiscard]] bool theLayerIsDeeperThanTheStock() const {
        const Project project = projectOf(5);
        const Figure limit = of(FigureName::burnLimit, section(0), 1);
        const Figure depth = of(FigureName::actualFeed, section(0), 1);
        const Figure layer = of(FigureName::damagedLayer, section(0), 1);
        const Figure stock = of(FigureName::stockLeft, section(0), 1);
        const Figure free = of(FigureName::burnFreeFeed);
        return valueOf(project, depth) > valueOf(project, limit)
               && valueOf(project, layer) > valueOf(project, stock)
               && valueOf(projectOf(6), free) < valueOf(project, free);
    }
    [[nodiscard]] bool aStiffPlaceOfTheGaugeMakesAllLarger() const {
        for (int i = 0; i < 5; ++i) {
            const Figure mean = of(FigureName::deviationMean, section(i));
            if (valueOf(projectOf(4), mean) < valueOf(projectOf(3), mean) + 0.5) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] bool theLastFeedSpreadsTheZones() const {
        Project project = projectOf(5);
        const Figure spread = of(FigureName::diameterSpread);
        const double before_um = valueOf(project, spread);
        project.cycle->stages.back().radial_feed_mm = 0.006;
        project.cycle->stages.back().axial_feed_mm_min = 2500;
        const StudiedRun run = studyRun(project, false);
        return *figureValue(spread, run.figures()) > before_um + 2
               && std::none_of(run.constraints.begin(), run.constraints.end(),
                               [](const ConstraintResult& each) {
                                   return each.kind == ConstraintKind::wheelPower && !each.holds;
                               });
    }
    [[nodiscard]] bool aLargerLastFeedScattersMore() const {
        const Figure s = of(FigureName::batchDeviation, zone(1));
        const Figure mean = of(FigureName::batchMean, zone(1));
        return valueOf(projectOf(7), s) > 1.2 * valueOf(projectOf(6), s)
               && valueOf(projectOf(6), mean) < -8.5;
    }

    Lesson m_given;
};

std::set<GoalKind> kindsOf(const Lesson& lesson) {
    std::set<GoalKind> kinds;
    for (const LessonStep& step : lesson.steps) {
        kinds.insert(step.goal.kind());
    }
    return kinds;
}

bool hasSetting(const Lesson& lesson) {
    return std::any_of(lesson.steps.begin(), lesson.steps.end(),
                       [](const LessonStep& step) { return isMetBySetting(step.goal.kind()); });
}

void lessonRows() {
    QTest::addColumn<QString>("file");
    for (const auto& file : samples::lessonFiles()) {
        QTest::newRow(file.filename().string().c_str()) << QString::fromStdString(file.string());
    }
}

Lesson lessonIn(const QString& file) {
    return readLesson(samples::readText(file.toStdString())).lesson.value();
}

class TestPracticum : public QObject {
    Q_OBJECT

private slots:
    void thereAreTenWorksInTheirOrder() {
        const auto files = samples::lessonFiles();
        QCOMPARE(files.size(), std::size_t{10});
        int minutes = 0;
        for (std::size_t i = 0; i < files.size(); ++i) {
            const Lesson lesson = lessonIn(QString::fromStdString(files[i].string()));
            const std::string number = std::to_string(i + 1);
            QVERIFY(lesson.title.ru.starts_with("Работа " + number + ". "));
            QVERIFY(lesson.title.en.starts_with("Work " + number + ". "));
            minutes += lesson.guide->minutes;
        }
        // Each within a double lesson of 90 minutes, ten of them in two terms.
        QVERIFY(minutes > 600 && minutes <= 10 * 90);
        for (const char* page : {"resources/help/en/cli.html", "resources/help/ru/cli.html"}) {
            const std::string text = samples::readText(samples::sourcePath(page));
            QVERIFY2(text.find(std::to_string(minutes)) != std::string::npos, page);
        }
    }

    void eachIsALesson_data() { lessonRows(); }
    void eachIsALesson() {
        QFETCH(QString, file);
        const Lesson lesson = lessonIn(file);
        QVERIFY(lesson.steps.size() >= 6 && lesson.steps.size() <= 12);
        QVERIFY(lesson.theory.en.find("class=\"formula\"") != std::string::npos);
        QVERIFY(!lesson.aim.empty());
        QVERIFY(hasSetting(lesson));
        QVERIFY(kindsOf(lesson).contains(GoalKind::choice));
        QVERIFY(std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& step) {
            return isAnsweredByEngine(step.goal.kind());
        }));
        QVERIFY(lesson.steps.back().goal.text); // a conclusion in words
        QVERIFY(lesson.variants && lesson.variants->inputs.size() >= 3);
        QVERIFY(lesson.guide && lesson.guide->questions.size() >= 3
                && lesson.guide->mistakes.size() >= 2);
        QVERIFY(lesson.guide->minutes >= 45 && lesson.guide->minutes <= 90);
        const std::size_t hints = std::accumulate(
            lesson.steps.begin(), lesson.steps.end(), std::size_t{0},
            [](std::size_t sum, const LessonStep& step) { return sum + step.hints.size(); });
        QVERIFY(hints >= 5);
    }

    /// What may be asked to no more digits than can be read.
    void tolerancesAreNoFinerThanWhatIsRead_data() { lessonRows(); }
    void tolerancesAreNoFinerThanWhatIsRead() {
        QFETCH(QString, file);
        const Lesson lesson = lessonIn(file);
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const Goal& goal = lesson.steps[i].goal;
            const Figure* const figure = goal.asked();
            if (!figure) {
                continue;
            }
            const double digit = std::pow(10.0, -rowOf(figure->name).digits);
            const double tolerance = goal.figure       ? goal.figure->tolerance
                                     : goal.prediction ? goal.prediction->tolerance
                                     : goal.curve      ? goal.curve->tolerance
                                                       : digit;
            QVERIFY2(tolerance >= digit / 2, std::to_string(i + 1).c_str());
        }
    }

    void whoReadsGetsAllAndWhoGuessesNothing_data() { lessonRows(); }
    void whoReadsGetsAllAndWhoGuessesNothing() {
        QFETCH(QString, file);
        const Lesson lesson = lessonIn(file);
        const auto count = static_cast<std::size_t>(samples::sized(2, 1, 10));
        const samples::GivenOut out = samples::giveOut(lesson, count, 20261126);
        QCOMPARE(out.works.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            checkStudents(out, i);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }

    /// The choices say what becomes of a variant: the engine says the same of each.
    void whatChoicesClaimIsSo_data() {
        QTest::addColumn<int>("work");
        for (const int work : {1, 3, 4, 5, 6, 7, 8, 9}) {
            QTest::addRow("work %d", work) << work;
        }
    }
    void whatChoicesClaimIsSo() {
        QFETCH(int, work);
        const auto file = samples::lessonFiles()[static_cast<std::size_t>(work) - 1];
        const Lesson lesson = lessonIn(QString::fromStdString(file.string()));
        const auto count = static_cast<std::size_t>(samples::sized(3, 1, 10));
        const MadeVariants made = makeVariants(lesson, count, 77);
        QCOMPARE(made.variants.size(), count);
        for (const MadeVariant& variant : made.variants) {
            const Claims claims(withVariant(lesson, variant.levels, {}));
            QVERIFY2(claims.hold(work), std::to_string(variant.levels.front()).c_str());
        }
    }

    /// Places that are to be put in an order differ by more than the last digit that is read.
    void ordersCanBeRead_data() { lessonRows(); }
    void ordersCanBeRead() {
        QFETCH(QString, file);
        const Lesson lesson = lessonIn(file);
        for (const MadeVariant& variant :
             makeVariants(lesson, static_cast<std::size_t>(samples::sized(2, 1, 10)), 3).variants) {
            const Lesson given = withVariant(lesson, variant.levels, {});
            for (std::size_t i = 0; i < given.steps.size(); ++i) {
                const Goal& goal = given.steps[i].goal;
                if (!goal.order) {
                    continue;
                }
                const StudiedRun run =
                    studyRun(setupOf(given, i).surfaces.front().project, needsRecordedRun(goal));
                const GoalResult engine = checkStep(given, i, {});
                for (std::size_t k = 1; k < engine.order.size(); ++k) {
                    const double apart = valueAt(goal, run, engine.order[k - 1])
                                         - valueAt(goal, run, engine.order[k]);
                    const double digit = std::pow(10.0, -rowOf(goal.order->figure.name).digits);
                    QVERIFY2(apart > digit, std::to_string(i + 1).c_str());
                }
            }
        }
    }

private:
    static double valueAt(const Goal& goal, const StudiedRun& run, std::size_t place) {
        Figure figure = goal.order->figure;
        figure.place = placeName(run.result.project, place);
        return figureValue(figure, run.figures()).value();
    }

    static void checkStudents(const samples::GivenOut& out, std::size_t i) {
        const MadeVariant& variant = out.made.variants[i];
        const auto best_min = variant.best ? std::optional(variant.best->time_min) : std::nullopt;
        const Lesson given = withVariant(out.lesson, variant.levels, best_min);
        const GradedWork right = graded(out, i, given, Pupil::reads);
        for (std::size_t k = 0; k < right.steps.size(); ++k) {
            const GradedStep& step = right.steps[k];
            QVERIFY2(
                step.isPending || step.points == step.most,
                ("variant " + std::to_string(i + 1) + ", step " + std::to_string(k + 1)).c_str());
        }
        QCOMPARE(right.points + right.pending, right.most);
        QVERIFY(right.flags.empty());
        const GradedWork wrong = graded(out, i, given, Pupil::guesses);
        QCOMPARE(wrong.points, 0.0);
        QCOMPARE(wrong.pending, 0.0);
    }

    static GradedWork graded(const samples::GivenOut& out, std::size_t i, const Lesson& given,
                             Pupil pupil) {
        Work work = out.works[i];
        for (std::size_t step = 0; step < given.steps.size(); ++step) {
            samples::handIn(work, step, answerTo(given, step, out.made.variants[i].best, pupil),
                            "2026-11-26T10:00:00Z");
        }
        return gradeWork(out.lesson, {"work", writeWork(work)}, {});
    }
};

} // namespace sparkout::test_practicum

SPARKOUT_TEST(test_practicum, TestPracticum)
#include "test_practicum.moc"
