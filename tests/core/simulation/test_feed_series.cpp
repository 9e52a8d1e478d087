// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/system_compliance.h"
#include "core/project/validate.h"
#include "core/simulation/feed_curves.h"
#include "core/simulation/simulate.h"

#include "tests/registry.h"
#include "tests/two_stage_projects.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout::test_feed_series {

struct Run {
    SimulationResult result;
    Trajectory trajectory;
    FeedSeries series;
};

Run run(const Project& project) {
    Run run;
    run.result = simulateUnchecked(project, &run.trajectory);
    run.series = makeFeedSeries(run.result, run.trajectory);
    return run;
}

using fixtures::traverseProject;

Project plungeProject(int sections) {
    Project p = fixtures::plungeProject(sections);
    auto& gammas = std::get<std::vector<double>>(p.machine->compliance_mm_per_n);
    for (int j = 0; j < sections; ++j) {
        gammas[static_cast<std::size_t>(j)] += 1e-6 * j;
    }
    return p;
}

FeedPoints allPasses(const Run& run, const FeedColumn& column) {
    return passPoints(run.series, column, run.trajectory, 0, run.series.end_s);
}

class TestFeedSeries : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_traverse = run(traverseProject());
        m_plunge = run(plungeProject(20));
        QVERIFY(m_traverse.result.status == RunStatus::completed);
        QVERIFY(m_plunge.result.status == RunStatus::completed);
    }

    void aPassShowsTheMeanOfItsRadii() {
        std::size_t seen = 0;
        for (const FeedColumn& column : m_traverse.series.columns) {
            const FeedPoints passes = allPasses(m_traverse, column);
            QCOMPARE(passes.size(), column.passIndex.size());
            for (std::size_t i = 0; i < passes.size(); ++i, ++seen) {
                const Pass& pass = m_traverse.trajectory.passes[column.passIndex[i]];
                double sum = 0;
                for (int k = 0; k < m_traverse.trajectory.radii; ++k) {
                    sum += m_traverse.trajectory.visits[pass.firstVisit + std::size_t(k)].actual_mm;
                }
                const Spread& actual = passes[i].actual_um;
                QVERIFY(std::abs(actual.mean - sum / m_traverse.trajectory.radii * 1000) < 1e-9);
                QVERIFY(actual.min <= actual.mean && actual.mean <= actual.max);
            }
        }
        QCOMPARE(seen, m_traverse.trajectory.passes.size());
    }

    void radiusBeforeLessRadiusAfterIsTheActualFeed() {
        for (const FeedColumn& column : m_traverse.series.columns) {
            const FeedPoints passes = allPasses(m_traverse, column);
            const FeedPoints points = radiusPoints(m_traverse.series, column, m_traverse.trajectory,
                                                   0, m_traverse.series.end_s);
            QCOMPARE(points.size(), passes.size() * 36);
            for (const FeedPoint& p : points) {
                QVERIFY(std::abs(p.came_um.mean - p.left_um.mean - p.actual_um.mean) < 1e-9);
            }
            // What a pass leaves is what the next one finds.
            for (std::size_t i = 1; i < passes.size(); ++i) {
                QVERIFY(std::abs(passes[i].came_um.mean - passes[i - 1].left_um.mean) < 1e-8);
            }
        }
    }

    void aDoubleStrokeIsTheSumOfItsPasses() {
        const FeedSeries& series = m_traverse.series;
        QCOMPARE(series.strokeCount(), m_traverse.result.cycleCount);
        for (const FeedColumn& column : series.columns) {
            std::vector<double> actual(series.strokeStart_s.size()), fed(actual), force(actual);
            for (const FeedPoint& p : allPasses(m_traverse, column)) {
                const auto i = static_cast<std::size_t>(p.place.cycleCount - 1);
                actual[i] += p.actual_um.mean;
                fed[i] += p.programmed_um.mean;
                force[i] = std::max(force[i], p.force_n.mean);
            }
            QCOMPARE(column.strokes.size(), actual.size());
            for (std::size_t i = 0; i < actual.size(); ++i) {
                QVERIFY(std::abs(column.strokes[i].actual_um.mean - actual[i]) < 1e-9);
                QVERIFY(std::abs(column.strokes[i].programmed_um.mean - fed[i]) < 1e-9);
                QCOMPARE(column.strokes[i].force_n.mean, force[i]); // that of the hardest pass
            }
            // The first double stroke feeds S_t of stage 1, the last that of stage 2.
            QVERIFY(std::abs(column.strokes.front().programmed_um.mean - 4) < 1e-9);
            QVERIFY(std::abs(column.strokes.back().programmed_um.mean - 1) < 1e-9);
        }
    }

    void theLastAccumulatedFeedIsTheProgrammedInfeed() {
        const SimulationResult& result = m_traverse.result;
        const double total = 4.0 * result.countsByStage[0] + 1.0 * result.countsByStage[1];
        const CycleScale scale(m_traverse.series, CycleAxis::time); // minutes
        for (const FeedColumn& column : m_traverse.series.columns) {
            const std::vector<XY> line =
                polyline(column.strokes, Quantity::programmedSum, Edge::mean, scale);
            QVERIFY(std::abs(line.back().y - total) < 1e-6);
            QVERIFY(std::abs(line.back().x - result.time_s / 60) < 1e-9);
            QVERIFY(line.front().y >= -1e-12 && line.front().y < 1e-9);
        }
    }

    void theStrokeAxisCountsStrokesAndInverts() {
        const FeedSeries& series = m_traverse.series;
        for (CycleAxis axis : {CycleAxis::time, CycleAxis::strokes, CycleAxis::revolutions}) {
            const CycleScale scale(series, axis);
            for (double part : {0.0, 0.123, 0.5, 0.77, 1.0}) {
                const double time = part * series.end_s;
                QVERIFY(std::abs(scale.time_s(scale.at(time)) - time) < 1e-9);
            }
        }
        const CycleScale strokes(series, CycleAxis::strokes);
        QVERIFY(std::abs(strokes.at(series.end_s) - series.strokeCount()) < 1e-9);
        QVERIFY(std::abs(strokes.at(series.strokeStart_s[26]) - 26) < 1e-9);
        QCOMPARE(series.strokeAt(series.strokeStart_s[26] + 0.01), 27);
    }

    void shortTimesAreInSecondsUnlessALongerOneIsShownBeside() {
        FeedSeries series;
        series.end_s = 119.9;
        QCOMPARE(CycleScale(series, CycleAxis::time).at(90), 90.0);
        QCOMPARE(CycleScale(series, CycleAxis::time).time_s(90), 90.0);
        QCOMPARE(CycleScale(series, CycleAxis::time, 120).at(90), 1.5);
        series.end_s = 120;
        QCOMPARE(CycleScale(series, CycleAxis::time).at(90), 1.5);
    }

    /// The table of the model, section 5.
    void aDoubleStrokeRunsThroughTheStepsOfEachZone() {
        const double from_s = m_traverse.series.strokeStart_s[26];
        const double to_s = m_traverse.series.strokeEnd_s(27);
        const std::vector<std::vector<Step>> expected = {
            {Step::e1, Step::e2, Step::e3, Step::e4, Step::e5},
            {Step::e1, Step::e2},
            {Step::e1, Step::e2, Step::e3}};
        for (std::size_t zone = 0; zone < 3; ++zone) {
            std::vector<Step> steps;
            double last_s = 0;
            for (const StepSpan& span :
                 stepSpans(m_traverse.series.columns[zone], m_traverse.trajectory, from_s, to_s)) {
                QVERIFY(span.end_s > span.start_s && span.start_s >= last_s - 1e-9);
                last_s = span.end_s;
                if (span.place.cycleCount == 27) {
                    steps.push_back(span.place.step);
                }
            }
            QVERIFY(steps == expected[zone]);
        }
    }

    void aSpanGivesItsPassesAndOneNeighbourAtEachSide() {
        const FeedColumn& column = m_plunge.series.columns[3];
        const FeedPoints all = allPasses(m_plunge, column);
        const FeedPoints some = passPoints(m_plunge.series, column, m_plunge.trajectory,
                                           all[10].start_s + 1e-6, all[12].end_s - 1e-6);
        QCOMPARE(some.size(), std::size_t{5});
        QCOMPARE(some.front().start_s, all[9].start_s);
        QCOMPARE(some.back().start_s, all[13].start_s);
        // A pass seen alone is the pass seen in the row: the feed since the radius' last visit.
        QCOMPARE(some[2].programmed_um.mean, all[11].programmed_um.mean);
        const Project project = traverseProject();
        const double perTurn_um = 500 / project.machine->work_speed_rpm;
        QVERIFY(std::abs(some[2].programmed_um.mean - perTurn_um) < 1e-9);
    }

    void everySectionHasItsColumn() {
        QCOMPARE(m_plunge.series.columns.size(), std::size_t{20});
        QCOMPARE(std::ranges::count(m_plunge.series.columns, true, &FeedColumn::gauge), 1);
        QVERIFY(m_plunge.series.columns[10].gauge);
        for (std::size_t j = 0; j < 20; ++j) {
            const FeedColumn& column = m_plunge.series.columns[j];
            QCOMPARE(column.section, static_cast<int>(j));
            double largest = 0;
            for (const FeedPoint& p : column.strokes) {
                largest = std::max(largest, p.force_n.max);
            }
            QCOMPARE(largest, m_plunge.result.sections[j].peakNormalForce_n);
        }
    }

    void theGaugeStandsAtTheSectionNearestToItsFreePosition() {
        Project project = plungeProject(4); // sections of 10 mm, middles at 5, 15, 25, 35
        project.gauge->position_mm = 17;
        project.gauge->compliance_mm_per_n = 2e-5;
        QVERIFY(!hasErrors(validate(project)));
        QCOMPARE(gaugeSection(project), 1);
        QVERIFY(run(project).series.columns[1].gauge);
        project.gauge->position_mm = 39;
        QCOMPARE(gaugeSection(project), 3);
    }

    void evenlyChosenSectionsHoldEndsAndGauge_data() {
        addColumns<int, int>("count", "gauge");
        for (int count : {1, 2, 3, 4, 5, 20, 200}) {
            for (int gauge : {0, count / 2, count - 1}) {
                QTest::addRow("%d sections, gauge at %d", count, gauge) << count << gauge;
            }
        }
    }
    void evenlyChosenSectionsHoldEndsAndGauge() {
        QFETCH(int, count);
        QFETCH(int, gauge);
        const std::vector<int> shown = shownSections(count, gauge);
        QCOMPARE(static_cast<int>(shown.size()), std::min(count, 4));
        QVERIFY(std::ranges::count(shown, 0) == 1 && std::ranges::count(shown, count - 1) == 1);
        QCOMPARE(std::ranges::count(shown, gauge), 1);
    }

    void aWantedSectionIsShownBesideTheGauge() {
        for (int wanted = 0; wanted < 20; ++wanted) {
            const std::vector<int> shown = shownSections(20, 10, wanted);
            QCOMPARE(shown.size(), std::size_t{4});
            QCOMPARE(std::ranges::count(shown, wanted), 1);
            QCOMPARE(std::ranges::count(shown, 10), 1);
        }
    }

    void valuesThatAreNoNumbersAreCountedAndLeftOut() {
        Run damaged = run(traverseProject());
        damaged.trajectory.visits[40].actual_mm = std::nan("");
        damaged.trajectory.visits[5000].radius_mm = std::numeric_limits<double>::infinity();
        damaged.series = makeFeedSeries(damaged.result, damaged.trajectory);
        QCOMPARE(damaged.series.dropped, 2);
        for (const FeedColumn& column : damaged.series.columns) {
            for (const FeedPoints& points : {column.strokes, allPasses(damaged, column)}) {
                for (const FeedPoint& p : points) {
                    for (const Spread& s : {p.programmed_um, p.actual_um, p.programmedSum_um,
                                            p.actualSum_um, p.came_um, p.left_um, p.force_n}) {
                        QVERIFY(std::isfinite(s.min) && std::isfinite(s.mean)
                                && std::isfinite(s.max));
                    }
                }
            }
        }
    }

    void curvesOfALongPlungeAreThinned() {
        Project project = plungeProject(4);
        project.cycle->stages[1].radial_feed_mm_min = 0.004;
        const Run slow = run(project);
        QVERIFY(slow.series.strokeCount() > 1000);
        for (const FeedColumn& column : slow.series.columns) {
            const FeedPoints passes = allPasses(slow, column);
            QVERIFY(column.strokes.size() <= mostStrokePoints);
            QCOMPARE(column.strokes.back().end_s, passes.back().end_s);
            QCOMPARE(column.strokes.back().left_um.mean, passes.back().left_um.mean);
            // Nothing is lost: points follow one another, and their mean feeds times their
            // revolutions add up to the whole.
            double fed = 0;
            for (std::size_t i = 0; i < column.strokes.size(); ++i) {
                const FeedPoint& p = column.strokes[i];
                if (i > 0) {
                    QVERIFY(std::abs(p.start_s - column.strokes[i - 1].end_s) < 1e-9);
                }
                fed += p.programmed_um.mean
                       * std::round((p.end_s - p.start_s) * slow.series.revolutions_per_s);
            }
            QVERIFY(std::abs(fed / passes.back().programmedSum_um.mean - 1) < 1e-6);
        }
    }

    void withoutATrajectoryThereAreColumnsWithoutPoints() {
        const FeedSeries series = makeFeedSeries(m_plunge.result, Trajectory());
        QCOMPARE(series.columns.size(), std::size_t{20});
        QVERIFY(series.columns[0].strokes.empty() && series.strokeCount() == 0);
    }

private:
    Run m_traverse, m_plunge;
};

} // namespace sparkout::test_feed_series

SPARKOUT_TEST(test_feed_series, TestFeedSeries)
#include "test_feed_series.moc"
