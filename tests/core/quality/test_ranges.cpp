// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/ranges.h"

#include "core/quality/constraints.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_ranges {

using fixtures::within;

std::vector<MachineRange> ofKind(const Project& project, ConstraintKind kind) {
    std::vector<MachineRange> found;
    for (const MachineRange& check : checkMachineRanges(project)) {
        if (check.kind == kind) {
            found.push_back(check);
        }
    }
    return found;
}

/// What the settings are held against, by kind.
std::vector<ConstraintResult> heldOf(const Project& project, ConstraintKind kind) {
    SimulationResult result;
    result.project = project;
    std::vector<ConstraintResult> found;
    requirementOf(kind).evaluate(kind, {result, {}}, found);
    return found;
}

/// The ranges of the project file's page.
void limit(Project& project) {
    project.machine->limits.radial_feed_mm = {0.0005, 0.02, 0.0005};
    project.machine->limits.axial_feed_mm_min = {50, 5000, 50};
    project.machine->limits.plunge_feed_mm_min = {0.02, 5, 0.01};
    project.machine->limits.work_speed_rpm = {50, 500, 5};
}

class TestRanges : public QObject {
    Q_OBJECT

private slots:
    void rangeThatIsNotGivenIsNotListed() {
        QVERIFY(checkMachineRanges(fixtures::traverse()).empty());
        QVERIFY(checkMachineRanges(fixtures::plunge()).empty());
        Project p = fixtures::traverse();
        p.machine->limits.work_speed_rpm = {50, 500, 5};
        QCOMPARE(checkMachineRanges(p).size(), std::size_t(1));
    }

    void everyFeedAndSpeedOfATraverseCycleIsLookedAt() {
        Project p = fixtures::traverse();
        limit(p);
        const auto radial = ofKind(p, ConstraintKind::rangeRadialFeed);
        QCOMPARE(radial.size(), std::size_t(2));
        QCOMPARE(radial[0].stage, 1);
        QCOMPARE(radial[1].stage, 2);
        QCOMPARE(radial[1].value, 0.001);
        QCOMPARE(ofKind(p, ConstraintKind::rangeAxialFeed).size(), std::size_t(2));
        QCOMPARE(ofKind(p, ConstraintKind::rangePlungeFeed).size(), std::size_t(1));
        QCOMPARE(ofKind(p, ConstraintKind::rangePlungeFeed)[0].value,
                 p.machine->plunge_feed_mm_min);
        QCOMPARE(ofKind(p, ConstraintKind::rangePlungeFeed)[0].stage, 0);
        QCOMPARE(ofKind(p, ConstraintKind::rangeWorkSpeed).size(), std::size_t(1));
        for (const MachineRange& check : checkMachineRanges(p)) {
            QVERIFY(check.onStep);
            for (const ConstraintResult& found : heldOf(p, check.kind)) {
                QVERIFY(found.holds && found.margin > 0);
            }
        }
    }

    void plungeCycleIsHeldAgainstThePlungeFeedsAlone() {
        Project p = fixtures::plunge();
        limit(p);
        p.cycle->stages = {fixtures::plungeStage(0.9, 0.15), fixtures::plungeStage(6, 0.05)};
        QVERIFY(ofKind(p, ConstraintKind::rangeRadialFeed).empty());
        QVERIFY(ofKind(p, ConstraintKind::rangeAxialFeed).empty());
        const auto feeds = heldOf(p, ConstraintKind::rangePlungeFeed);
        QCOMPARE(feeds.size(), std::size_t(2));
        QVERIFY(feeds[0].holds && !feeds[1].holds);
        QVERIFY(within(feeds[1].margin, -1, 1e-15));
    }

    void aRetractionIsAsFastAsItsFeed() {
        Project p = fixtures::plunge();
        limit(p);
        p.cycle->stages = {fixtures::plungeStage(0.9, 0.2), fixtures::plungeStage(-1.5, 0),
                           fixtures::plungeStage(-6, 0)};
        const auto feeds = heldOf(p, ConstraintKind::rangePlungeFeed);
        QCOMPARE(feeds.size(), std::size_t(3));
        QVERIFY(feeds[1].value == 1.5 && feeds[1].holds);
        QVERIFY(feeds[2].value == 6 && !feeds[2].holds);
    }

    // Where the machine has a range, 10 mm/min of a machine that feeds 1 does not pass.
    void aContinuousInfeedIsHeldAgainstItsRange() {
        Project p = fixtures::traverse();
        p.cycle->stages[0].continuous_feed_mm_min = 10;
        QVERIFY(ofKind(p, ConstraintKind::rangeContinuousFeed).empty());
        p.machine->limits.continuous_feed_mm_min = {0.01, 1, 0.01};
        auto feeds = heldOf(p, ConstraintKind::rangeContinuousFeed);
        QCOMPARE(feeds.size(), std::size_t(1)); // the other stage has none
        QVERIFY(feeds[0].stage == 1 && feeds[0].value == 10 && !feeds[0].holds);
        p.cycle->stages[0].continuous_feed_mm_min = 0.5;
        feeds = heldOf(p, ConstraintKind::rangeContinuousFeed);
        QVERIFY(feeds.size() == 1 && feeds[0].holds);
        p.machine->limits.continuous_feed_mm_min = {0, 0, 0}; // a machine without it
        QVERIFY(!heldOf(p, ConstraintKind::rangeContinuousFeed).front().holds);
        for (Stage& stage : p.cycle->stages) {
            stage.continuous_feed_mm_min.reset();
        }
        QVERIFY(ofKind(p, ConstraintKind::rangeContinuousFeed).empty());
        Project plunge = fixtures::plunge();
        plunge.cycle->stages[0].continuous_feed_mm_min = 10; // of no use there
        plunge.machine->limits.continuous_feed_mm_min = {0.01, 1, 0.01};
        QVERIFY(ofKind(plunge, ConstraintKind::rangeContinuousFeed).empty());
    }

    void sparkOutStageSetsNoInfeed() {
        Project p = fixtures::traverse();
        limit(p);
        p.cycle->stages.push_back(fixtures::sparkStage(fixtures::count(3), 0, 300));
        QCOMPARE(ofKind(p, ConstraintKind::rangeRadialFeed).size(), std::size_t(2));
        QCOMPARE(ofKind(p, ConstraintKind::rangeAxialFeed).size(), std::size_t(3));
    }

    void marginIsTheDistanceToTheNearerEnd_data() {
        addColumns<double, double, bool>("speed", "margin", "holds");
        QTest::newRow("inside") << 180.0 << 130.0 << true;
        QTest::newRow("near the top") << 450.0 << 50.0 << true;
        QTest::newRow("at the bottom") << 50.0 << 0.0 << true;
        QTest::newRow("at the top") << 500.0 << 0.0 << true;
        QTest::newRow("below") << 40.0 << -10.0 << false;
        QTest::newRow("above") << 600.0 << -100.0 << false;
    }
    void marginIsTheDistanceToTheNearerEnd() {
        QFETCH(double, speed);
        QFETCH(double, margin);
        QFETCH(bool, holds);
        Project p = fixtures::traverse();
        limit(p);
        p.machine->work_speed_rpm = speed;
        const ConstraintResult check = heldOf(p, ConstraintKind::rangeWorkSpeed).front();
        QCOMPARE(check.margin, margin);
        QCOMPARE(check.relativeMargin, margin / 450);
        QCOMPARE(check.holds, holds);
    }

    void nearestSettingIsOnTheStepsFromTheLowestOn_data() {
        addColumns<double, double, bool>("feed", "nearest", "onStep");
        QTest::newRow("on a step") << 0.0035 << 0.0035 << true; // seven steps of a rounded 0.0005
        QTest::newRow("between") << 0.0033 << 0.0035 << false;
        QTest::newRow("a trifle off") << 0.0035 + 4e-10 << 0.0035 << true;
        QTest::newRow("below") << 0.0001 << 0.0005 << false;
        QTest::newRow("above") << 0.3 << 0.02 << false;
        QTest::newRow("the highest") << 0.02 << 0.02 << true;
    }
    void nearestSettingIsOnTheStepsFromTheLowestOn() {
        QFETCH(double, feed);
        QFETCH(double, nearest);
        QFETCH(bool, onStep);
        Project p = fixtures::traverse();
        limit(p);
        p.cycle->stages[0].radial_feed_mm = feed;
        const MachineRange check = ofKind(p, ConstraintKind::rangeRadialFeed).front();
        QVERIFY(within(check.nearest, nearest, 1e-15));
        QCOMPARE(check.onStep, onStep);
    }
    void highestThatNoStepMeetsCannotBeSet() {
        Project p = fixtures::traverse();
        p.machine->limits.work_speed_rpm = {50, 502, 5};
        p.machine->work_speed_rpm = 502;
        const MachineRange check = ofKind(p, ConstraintKind::rangeWorkSpeed).front();
        QVERIFY(heldOf(p, ConstraintKind::rangeWorkSpeed).front().holds && !check.onStep);
        QCOMPARE(check.nearest, 500.0);
        p.machine->limits.work_speed_rpm = {50, 503, 5}; // nearer to the step beyond
        p.machine->work_speed_rpm = 503;
        QCOMPARE(ofKind(p, ConstraintKind::rangeWorkSpeed).front().nearest, 500.0);
    }
    void rangeWithoutAStepCanBeSetAnywhere() {
        Project p = fixtures::traverse();
        p.machine->limits.work_speed_rpm = {50, 500, 0};
        p.machine->work_speed_rpm = 123.456;
        QVERIFY(ofKind(p, ConstraintKind::rangeWorkSpeed).front().onStep);
    }

    void stagesNeedAsManyCommands() {
        Project p = fixtures::traverse();
        p.gauge->commands = 2;
        const auto found = [&p] { return heldOf(p, ConstraintKind::gaugeCommands); };
        QVERIFY(found().front().holds);
        QCOMPARE(found().front().margin, 0.0);
        p.cycle->stages.push_back(p.cycle->stages.back());
        QVERIFY(!found().front().holds);
        QCOMPARE(found().front().margin, -1.0);
        p.gauge->control = Control::position;
        QVERIFY(!checkGaugeCommands(p) && found().empty());
    }
};

} // namespace sparkout::test_ranges

SPARKOUT_TEST(test_ranges, TestRanges)
#include "test_ranges.moc"
