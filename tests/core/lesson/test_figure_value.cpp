// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that a lesson asks for beside those of a run's own result: the force law, burn, the form
// after a pass, the batch, the search. Each is held against the law it stands for.
#include "core/lesson/figure_value.h"
#include "core/lesson/make_variants.h"
#include "core/process/force.h"
#include "core/statistics/intervals.h"
#include "core/surface/burn.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

#include <cmath>

namespace sparkout::test_figure_value {

Project projectOf(const char* lesson) {
    const auto path =
        samples::sourcePath(std::string("resources/lessons/") + lesson + ".sparkout-lesson");
    return readLesson(samples::readText(path)).lesson->base.surfaces.front().project;
}

Figure figureOf(FigureName name, PlaceName place = {}, std::optional<int> stage = {},
                std::optional<int> count = {}, Step step = Step::none) {
    return {name, place, stage, count, step};
}

class TestFigureValue : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_project = projectOf("01-force-and-balance");
        m_run = studyRun(m_project, true);
        QVERIFY(m_run.isCompleted());
    }

    void aPassWorkedOutByHandIsTheEngines() {
        const double De = value(FigureName::equivalentDiameter);
        const double ks = value(FigureName::shearCoefficient);
        const double kr = value(FigureName::flatCoefficient);
        const double d = m_project.part->diameter_mm, D = m_project.wheel->diameter_mm;
        QVERIFY(std::abs(De - d * D / (d + D)) < 1e-12 * De);
        const double n = m_project.machine->work_speed_rpm / 60;
        const double Vd = 3.14159265358979323846 * d * n;
        const double Vk = m_project.machine->wheel_speed_m_s * 1000;
        const double sigma = m_project.material->flow_stress_mpa;
        QVERIFY(std::abs(ks - 1.9 * sigma * Vd / Vk) < 1e-9 * ks);
        QVERIFY(std::abs(kr - m_project.wheel->dullness * sigma * std::sqrt(De) / 3) < 1e-9 * kr);
        // The balance a + γ·P(a) = h of the first working stroke in НЗ, h the whole feed.
        const PlaceName nz = PlaceName::ofWord(1);
        const double gamma = value(FigureName::compliance, nz);
        const double b = 1800.0 / m_project.machine->work_speed_rpm, h = 0.01;
        const double A = 1 + gamma * b * ks, C = gamma * b * kr;
        const double u = (-C + std::sqrt(C * C + 4 * A * h)) / (2 * A);
        const auto of = [&](FigureName name) {
            return *figureValue(figureOf(name, nz, 1, 1, Step::e1), m_run.figures());
        };
        QVERIFY(std::abs(of(FigureName::actualFeed) - 1000 * u * u) < 1e-6);
        QVERIFY(std::abs(of(FigureName::force) - b * (ks * u * u + kr * u)) < 1e-6);
    }

    void theDepthThatDoesNotBurnRaisesTheSurfaceToTheLimit() {
        const double U = *m_project.material->burn_rise_k;
        const double free_um = value(FigureName::burnFreeFeed);
        QVERIFY(std::abs(BurnModel(m_project).rise(0, free_um / 1000) - U) < 1e-6 * U);
        Project unlimited = m_project;
        unlimited.material->burn_rise_k.reset();
        const StudiedRun run = studyRun(unlimited, true);
        const PlaceName nz = PlaceName::ofWord(1);
        for (const FigureName name :
             {FigureName::burnFreeFeed, FigureName::burnLimit, FigureName::damagedLayer}) {
            QVERIFY(!figureValue(figureOf(name, nz, 1), run.figures()));
        }
    }

    void burnOfAPassHoldsWhereItsLayerIsWithinTheStock() {
        const Project project = projectOf("06-burn");
        const StudiedRun run = studyRun(project, true);
        const BurnModel model(project);
        const double U = *project.material->burn_rise_k;
        const PlaceName place = PlaceName::ofNumber(0);
        int burning = 0, holding = 0;
        for (int count = 5; count <= run.result.cycleCount; count += 4) {
            const auto of = [&](FigureName name) {
                return *figureValue(figureOf(name, place, {}, count), run.figures());
            };
            const double layer_mm = of(FigureName::damagedLayer) / 1000;
            const double depth_mm = of(FigureName::actualFeed) / 1000;
            const double limit_mm = of(FigureName::burnLimit) / 1000;
            QVERIFY(limit_mm >= model.burnFreeDepth(U) - 1e-9);
            if (layer_mm > 0) { // the layer ends where the rise is the one that burns
                QVERIFY(layer_mm < 0.2);
            }
            (depth_mm > limit_mm ? burning : holding) += 1;
        }
        QVERIFY(burning > 0 && holding > 0);
        const auto margin = figureValue(figureOf(FigureName::burnMargin), run.figures());
        QVERIFY(*margin < 0);
    }

    void theLastFormIsThatOfThePart() {
        const Project project = projectOf("05-out-of-round");
        const StudiedRun run = studyRun(project, true);
        const PlaceName place = PlaceName::ofNumber(0);
        const auto at = [&](std::optional<int> count) {
            return *figureValue(figureOf(FigureName::runoutAfter, place, {}, count), run.figures());
        };
        const double geometric_um = project.machine->geometric_runout_um;
        const auto radial = figureValue(figureOf(FigureName::radialRunout, place), run.figures());
        QVERIFY(std::abs(at({}) + geometric_um - *radial) < 1e-9);
        QVERIFY(at(1) <= 1000 * project.part->initial_runout_mm + 1e-9);
        for (int count = 2; count <= 30; ++count) {
            QVERIFY(at(count) <= at(count - 1) + 1e-9);
        }
    }

    void theBatchIsDescribedByItsOwnNumbers() {
        const Project project = projectOf("09-batch");
        const StudiedRun run = studyRun(project, false);
        const PlaceName nz = PlaceName::ofWord(1);
        const auto of = [&](FigureName name) {
            return *figureValue(figureOf(name, nz), run.figures());
        };
        const double mean = of(FigureName::batchMean), s = of(FigureName::batchDeviation);
        const Interval interval = studentInterval(mean, s, 50, 0.95);
        QVERIFY(std::abs(of(FigureName::batchMeanHalf) - (interval.high - mean)) < 1e-9);
        QVERIFY(std::abs(of(FigureName::batchPp) - 16 / (6 * s)) < 1e-9);
        QVERIFY(std::abs(of(FigureName::batchPpk) - std::min(0 - mean, mean + 16) / (3 * s))
                < 1e-9);
        QCOMPARE(*figureValue(figureOf(FigureName::batchBad), run.figures()), 0.0);
        // Another zone is another value; without a batch there is none.
        QVERIFY(figureValue(figureOf(FigureName::batchMean, PlaceName::ofWord(0)), run.figures())
                != mean);
        Project alone = project;
        alone.batch.reset();
        const StudiedRun without = studyRun(alone, false);
        QVERIFY(!figureValue(figureOf(FigureName::batchMean, nz), without.figures()));
        QVERIFY(!figureValue(figureOf(FigureName::batchBad), without.figures()));
    }

    void theRuleIsNeverQuickerThanWhatIsProved() {
        const Project project = projectOf("10-dynamic-programming");
        const StudiedRun run = studyRun(project, false);
        const auto of = [&](FigureName name) {
            return *figureValue(figureOf(name), run.figures());
        };
        const double rule = of(FigureName::levelsRuleTime), best = of(FigureName::levelsBestTime);
        QVERIFY(rule >= best);
        QVERIFY(std::abs(of(FigureName::levelsRuleGap) - 100 * (rule / best - 1)) < 1e-9);
        QCOMPARE(of(FigureName::bestTime), bestAnswer(project)->time_min);
        Project alone = project;
        alone.optimisation.reset();
        const StudiedRun without = studyRun(alone, false);
        for (const FigureName name : {FigureName::bestTime, FigureName::levelsBestTime,
                                      FigureName::levelsRuleTime, FigureName::levelsRuleGap}) {
            QVERIFY(!figureValue(figureOf(name), without.figures()));
        }
    }

private:
    [[nodiscard]] double value(FigureName name, PlaceName place = {}) const {
        return figureValue(figureOf(name, place), m_run.figures()).value();
    }

    Project m_project;
    StudiedRun m_run;
};

} // namespace sparkout::test_figure_value

SPARKOUT_TEST(test_figure_value, TestFigureValue)
#include "test_figure_value.moc"
