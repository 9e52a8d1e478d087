// SPDX-License-Identifier: GPL-3.0-or-later
// Infeed at either or both reversals, and continuous infeed while the table travels [MODEL-5].
#include "core/project/validate.h"
#include "core/quality/ranges.h"
#include "core/simulation/feed_series.h"
#include "core/simulation/step_shares.h"
#include "core/simulation/traverse.h"

#include "tests/core/simulation/strokes_by_hand.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cstring>

namespace sparkout::test_traverse_infeed {

using fixtures::sparkStage;
using fixtures::strokeStage;
using fixtures::Traced;
using fixtures::within;
using strokes_by_hand::byHand;
using strokes_by_hand::Cut;
using strokes_by_hand::feed;
using strokes_by_hand::um;

// Two double strokes each. S_t = 8 µm, all at the exit.
const std::vector<Cut> exitInfeed{
    {Zone::rz1, Step::e2, 0, 0, 0.0 / 1},       {Zone::rz1, Step::e3, 0, 0, 0.0 / 1},
    {Zone::nz, Step::e1, 0, 0, 0.0 / 1},        {Zone::rz2, Step::e1, 0, 0, 0.0 / 1},
    {Zone::rz2, Step::e4, 4, 4, 4.0 / 3},       {Zone::rz2, Step::e4, 8, 4, 20.0 / 9},
    {Zone::rz2, Step::e2, 8, 0, 40.0 / 27},     {Zone::rz1, Step::e4, 8, 8, 4.0 / 1},
    {Zone::nz, Step::e2, 8, 8, 4.0 / 1},        {Zone::rz2, Step::e3, 8, 0, 40.0 / 27},
    {Zone::rz1, Step::e5, 8, 0, 4.0 / 3},       {Zone::rz1, Step::e2, 8, 0, 8.0 / 9},
    {Zone::rz1, Step::e3, 8, 0, 8.0 / 9},       {Zone::nz, Step::e1, 8, 0, 2.0 / 1},
    {Zone::rz2, Step::e1, 8, 0, 20.0 / 27},     {Zone::rz2, Step::e4, 12, 4, 128.0 / 81},
    {Zone::rz2, Step::e4, 16, 4, 580.0 / 243},  {Zone::rz2, Step::e2, 16, 0, 1160.0 / 729},
    {Zone::rz1, Step::e4, 16, 8, 40.0 / 9},     {Zone::nz, Step::e2, 16, 8, 5.0 / 1},
    {Zone::rz2, Step::e3, 16, 0, 1160.0 / 729}, {Zone::rz1, Step::e5, 16, 0, 40.0 / 27}};

// 4 µm at the entry, 4 µm at the exit.
const std::vector<Cut> halfAtEach{
    {Zone::rz1, Step::e1, 4, 4, 4.0 / 3},      {Zone::rz1, Step::e2, 4, 0, 8.0 / 9},
    {Zone::rz1, Step::e3, 4, 0, 8.0 / 9},      {Zone::nz, Step::e1, 4, 4, 2.0 / 1},
    {Zone::rz2, Step::e1, 4, 4, 2.0 / 1},      {Zone::rz2, Step::e4, 8, 4, 2.0 / 1},
    {Zone::rz2, Step::e2, 8, 0, 4.0 / 3},      {Zone::rz1, Step::e4, 8, 4, 22.0 / 9},
    {Zone::nz, Step::e2, 8, 4, 3.0 / 1},       {Zone::rz2, Step::e3, 8, 0, 4.0 / 3},
    {Zone::rz1, Step::e5, 8, 0, 22.0 / 27},    {Zone::rz1, Step::e1, 12, 4, 152.0 / 81},
    {Zone::rz1, Step::e2, 12, 0, 304.0 / 243}, {Zone::rz1, Step::e3, 12, 0, 304.0 / 243},
    {Zone::nz, Step::e1, 12, 4, 7.0 / 2},      {Zone::rz2, Step::e1, 12, 4, 8.0 / 3},
    {Zone::rz2, Step::e4, 16, 4, 20.0 / 9},    {Zone::rz2, Step::e2, 16, 0, 40.0 / 27},
    {Zone::rz1, Step::e4, 16, 4, 638.0 / 243}, {Zone::nz, Step::e2, 16, 4, 15.0 / 4},
    {Zone::rz2, Step::e3, 16, 0, 40.0 / 27},   {Zone::rz1, Step::e5, 16, 0, 638.0 / 729}};

// S_c alone: 2 µm a turn, 20 µm a stroke, of which РЗ1 sees a tenth, НЗ a half, РЗ2 nine tenths.
const std::vector<Cut> continuous{
    {Zone::rz1, Step::e2, 2, 2, 2.0 / 3},      {Zone::rz1, Step::e3, 4, 2, 5.0 / 3},
    {Zone::nz, Step::e1, 12, 12, 6.0 / 1},     {Zone::rz2, Step::e1, 20, 20, 10.0 / 1},
    {Zone::rz2, Step::e2, 24, 4, 14.0 / 3},    {Zone::rz1, Step::e4, 42, 38, 119.0 / 6},
    {Zone::nz, Step::e2, 34, 22, 14.0 / 1},    {Zone::rz2, Step::e3, 26, 2, 17.0 / 3},
    {Zone::rz1, Step::e5, 46, 4, 143.0 / 18},  {Zone::rz1, Step::e2, 48, 2, 161.0 / 27},
    {Zone::rz1, Step::e3, 50, 2, 188.0 / 27},  {Zone::nz, Step::e1, 58, 24, 19.0 / 1},
    {Zone::rz2, Step::e1, 66, 40, 137.0 / 6},  {Zone::rz2, Step::e2, 70, 4, 161.0 / 18},
    {Zone::rz1, Step::e4, 88, 38, 607.0 / 27}, {Zone::nz, Step::e2, 80, 22, 41.0 / 2},
    {Zone::rz2, Step::e3, 72, 2, 179.0 / 18},  {Zone::rz1, Step::e5, 92, 4, 715.0 / 81}};

// The same beside 8 µm at the entry.
const std::vector<Cut> continuousAndEntry{
    {Zone::rz1, Step::e1, 6, 6, 2.0 / 1},           {Zone::rz1, Step::e1, 12, 6, 10.0 / 3},
    {Zone::rz1, Step::e2, 14, 2, 26.0 / 9},         {Zone::rz1, Step::e3, 16, 2, 35.0 / 9},
    {Zone::nz, Step::e1, 24, 24, 12.0 / 1},         {Zone::rz2, Step::e1, 32, 32, 16.0 / 1},
    {Zone::rz2, Step::e2, 36, 4, 20.0 / 3},         {Zone::rz1, Step::e4, 54, 38, 377.0 / 18},
    {Zone::nz, Step::e2, 46, 22, 17.0 / 1},         {Zone::rz2, Step::e3, 38, 2, 23.0 / 3},
    {Zone::rz1, Step::e5, 58, 4, 449.0 / 54},       {Zone::rz1, Step::e1, 64, 6, 611.0 / 81},
    {Zone::rz1, Step::e1, 70, 6, 1708.0 / 243},     {Zone::rz1, Step::e2, 72, 2, 3902.0 / 729},
    {Zone::rz1, Step::e3, 74, 2, 4631.0 / 729},     {Zone::nz, Step::e1, 82, 36, 53.0 / 2},
    {Zone::rz2, Step::e1, 90, 52, 179.0 / 6},       {Zone::rz2, Step::e2, 94, 4, 203.0 / 18},
    {Zone::rz1, Step::e4, 112, 38, 32333.0 / 1458}, {Zone::nz, Step::e2, 104, 22, 97.0 / 4},
    {Zone::rz2, Step::e3, 96, 2, 221.0 / 18},       {Zone::rz1, Step::e5, 116, 4, 38165.0 / 4374}};

bool sameRun(const Traced& a, const Traced& b) {
    const auto& x = a.trajectory.visits;
    const auto& y = b.trajectory.visits;
    return fixtures::sameBits(a.result, b.result)
           && a.trajectory.passes.size() == b.trajectory.passes.size() && x.size() == y.size()
           && std::memcmp(x.data(), y.data(), x.size() * sizeof(Visit)) == 0;
}

class TestTraverseInfeed : public QObject {
    Q_OBJECT

private slots:
    void twoDoubleStrokesAreAsByHand_data() {
        addColumns<ReversalInfeed, double>("at", "reversal_um");
        QTest::addColumn<double>("continuous_mm_min"); // 2 µm a turn
        addColumns<double, std::vector<Cut>>("all_um", "table");
        QTest::newRow("at the exit") << ReversalInfeed::exit << 8.0 << 0.0 << 16.0 << exitInfeed;
        QTest::newRow("half at each") << ReversalInfeed::both << 8.0 << 0.0 << 16.0 << halfAtEach;
        QTest::newRow("continuous") << ReversalInfeed::entry << 0.0 << 0.12 << 92.0 << continuous;
        QTest::newRow("continuous and at the entry")
            << ReversalInfeed::entry << 8.0 << 0.12 << 116.0 << continuousAndEntry;
    }
    void twoDoubleStrokesAreAsByHand() {
        QFETCH(ReversalInfeed, at);
        QFETCH(double, reversal_um);
        QFETCH(double, continuous_mm_min);
        QFETCH(double, all_um);
        QFETCH(std::vector<Cut>, table);
        for (const bool rigid : {true, false}) {
            Project p = byHand(rigid);
            p.machine->reversal_infeed = at;
            feed(p, reversal_um, continuous_mm_min, all_um);
            QVERIFY(!hasErrors(validate(p)));
            const Traced run(p);
            QCOMPARE(run.result.cycleCount, 2);
            QCOMPARE(strokes_by_hand::difference(run, table, rigid), QString());
            double start_s = 0;
            for (const Pass& pass : run.trajectory.passes) {
                QVERIFY(pass.start_s >= start_s);
                start_s = pass.start_s;
            }
        }
    }

    void noContinuousInfeedAndInfeedAtTheEntryChangeNothing() {
        for (const Project& plain : {fixtures::traverse(), byHandOfStages()}) {
            Project stated = plain;
            stated.machine->reversal_infeed = ReversalInfeed::entry;
            for (Stage& stage : stated.cycle->stages) {
                stage.continuous_feed_mm_min = 0;
            }
            QVERIFY(sameRun(Traced(plain), Traced(stated)));
        }
    }

    // A spark-out feeds nothing, whatever is set.
    void aSparkOutHasNoContinuousInfeed() {
        Project p = byHandOfStages();
        p.cycle->stages.push_back(sparkStage(fixtures::count(3), 0, 600));
        Project set = p;
        set.cycle->stages.back().continuous_feed_mm_min = 0.1;
        QVERIFY(sameRun(Traced(p), Traced(set)));
    }
    // What is left of the stage is less than S_c·T: the infeed stops where the stage ends, in the
    // middle of a stroke, and the double stroke goes on to its end.
    void positionControlStopsTheContinuousInfeedAtTheStagesEnd() {
        for (const double left_um : {1.0, 13.0, 30.0, 45.0}) {
            Project p = byHand(false);
            feed(p, 0, 0.12, 46 + left_um);
            const Traced run(p);
            QCOMPARE(run.result.cycleCount, 2);
            const double end = (46 + left_um) * um;
            double most = 0;
            for (const Visit& visit : run.trajectory.visits) {
                QVERIFY(visit.programmed_mm <= end + 1e-15);
                most = std::max(most, visit.programmed_mm);
            }
            QVERIFY(within(most, end, 1e-15));
            QVERIFY(within(run.result.time_s, 2 * 23, 1e-12));
            QVERIFY(within(run.trajectory.passes.front().radialFeed_mm, 46 * um, 1e-15));
            QVERIFY(within(run.trajectory.passes.back().radialFeed_mm, left_um * um, 1e-15));
            const Pass& dwell = run.trajectory.passes.back();
            QVERIFY(within(run.visit(dwell, 0).programmed_mm, end, 1e-15) || left_um > 44);
        }
        // with an infeed at the reversals as well, which comes first
        Project p = byHand(false);
        p.machine->reversal_infeed = ReversalInfeed::both;
        feed(p, 8, 0.12, 58 + 13);
        const Traced run(p);
        QCOMPARE(run.result.cycleCount, 2);
        QVERIFY(within(run.trajectory.visits.back().programmed_mm, 71 * um, 1e-15));
        const auto plungeIns = std::ranges::count_if(run.trajectory.passes, [](const Pass& pass) {
            return pass.place.cycleCount == 2
                   && strokeStep(pass.place.zone, pass.place.step) == StrokeStep::exitPlungeIn;
        });
        QCOMPARE(plungeIns, 0); // the continuous infeed had come to the end by then
    }

    /// Position control cuts the infeed of a double stroke short as a whole and shares what is
    /// left: of 26 µm by 10 µm the last 6 are fed 3 and 3.
    void positionControlHalvesWhatIsLeft() {
        Project p = byHand(true);
        p.machine->reversal_infeed = ReversalInfeed::both;
        feed(p, 10, 0, 26);
        const Traced run(p);
        QCOMPARE(run.result.cycleCount, 3);
        const auto last = [&run](Zone zone, Step step) {
            std::vector<Pass> found;
            for (const Pass& pass : run.trajectory.passes) {
                if (pass.place.cycleCount == 3 && pass.place.zone == zone
                    && pass.place.step == step) {
                    found.push_back(pass);
                }
            }
            return found;
        };
        const std::vector<Pass> entry = last(Zone::rz1, Step::e1), exit = last(Zone::rz2, Step::e4);
        QCOMPARE(entry.size(), 1u); // ⌈60·0.003/0.24⌉ turns each, not two and one
        QCOMPARE(exit.size(), 1u);
        QVERIFY(within(run.visit(entry[0], 3).programmed_mm, 23 * um, 1e-12));
        QVERIFY(within(run.visit(exit[0], 3).programmed_mm, 26 * um, 1e-12));
    }

    void aStageThatFeedsContinuouslyMayDoWithoutAReversalInfeed() {
        Project p = byHand(false);
        feed(p, 0, 0.12, 92);
        const Issues issues = validate(p);
        QVERIFY(!hasErrors(issues));
        QVERIFY(std::ranges::none_of(issues, [](const Issue& issue) {
            return issue.path.find("feed") != std::string::npos;
        }));
        p.machine->limits.radial_feed_mm = std::vector<double>{0.001, 0.02, 0.0005};
        QVERIFY(checkMachineRanges(p).empty()); // what is not set is not out of range
        p.cycle->stages[0].continuous_feed_mm_min = 0;
        QVERIFY(hasErrors(validate(p)));
    }

    /// As it is without one: test_last_stage_bound holds what is followed against whole runs.
    void aRadiusIsFollowedWithAContinuousInfeed() {
        Project p = byHand(false);
        p.gauge->control = Control::gauge;
        feed(p, 8, 0, 92);
        QVERIFY(traverseSteps(p, Zone::nz, nullptr, {})->follower());
        p.cycle->stages[0].continuous_feed_mm_min = 0.1;
        QVERIFY(traverseSteps(p, Zone::nz, nullptr, {})->follower());
    }

    void theStepsOfAnInfeedAtTheExitAreTimedAndSummedUp() {
        Project p = byHand(false);
        p.machine->reversal_infeed = ReversalInfeed::both;
        feed(p, 8, 0.03, 200);
        Trajectory trajectory;
        const SimulationResult result = simulateUnchecked(p, &trajectory);
        const StepShares shares = stepShares(result, trajectory);
        const StepSums& time = shares.time_s.front();
        QVERIFY(within(time.total(), result.time_s, 1e-9));
        const double turns = time[StrokeStep::exitPlungeIn];
        QVERIFY(turns >= result.cycleCount - 1.0 && turns <= result.cycleCount); // one each
        QVERIFY(shares.removed_mm[2].front()[StrokeStep::exitPlungeIn] > 0);
        QCOMPARE(shares.removed_mm[0].front()[StrokeStep::exitPlungeIn], 0.0);
        const FeedSeries series = makeFeedSeries(result, trajectory);
        double fed = 0;
        for (const FeedPoint& point : series.columns[1].strokes) {
            fed += point.programmed_um.mean;
        }
        QVERIFY(fed > 150 && fed <= 200 + 1e-9); // НЗ sees no more after its last stroke
    }

private:
    static Project byHandOfStages() {
        Project p = byHand(false);
        p.part->initial_runout_mm = 0.02;
        p.part->stock_mm = 0.1;
        p.gauge->control = Control::gauge;
        p.cycle->stages = {strokeStage(0.004, 900, 0.07), strokeStage(0.001, 600, 0.03)};
        return p;
    }
};

} // namespace sparkout::test_traverse_infeed

SPARKOUT_TEST(test_traverse_infeed, TestTraverseInfeed)
#include "test_traverse_infeed.moc"
