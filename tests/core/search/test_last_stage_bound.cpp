// SPDX-License-Identifier: GPL-3.0-or-later
// The bound that three radii give for a last stage holds for the whole part.
#include "core/search/last_stage_bound.h"
#include "core/simulation/plunge.h"
#include "core/simulation/traverse.h"

#include "tests/core/search/followed_cases.h"
#include "tests/registry.h"

namespace sparkout::test_last_stage_bound {

using search_cases::fedContinuously;
using search_cases::plunged;
using search_cases::traversed;

struct CycleRun {
    explicit CycleRun(const Project& p)
        : project(p)
        , steps(p.operation == Operation::traverse ? traverseSteps(p, Zone::nz, nullptr, {})
                                                   : plungeSteps(p, nullptr, {}))
        , control(p, infeedsOfStages(p), steps->run().blank().totalInfeed_mm) {}
    [[nodiscard]] StepFeed feed() const {
        const std::size_t stage = control.stage();
        return {control.nextInfeed(steps->run().fed_mm), stage,
                project.cycle->stages[stage].axial_feed_mm_min.value_or(0),
                project.cycle->stages[stage].continuousFeed_mm_min()};
    }
    void step() {
        QVERIFY(steps->step(feed()));
        control.stepDone(steps->remaining(), steps->run().fed_mm, steps->run().time_s());
    }
    const Project& project;
    std::unique_ptr<CycleSteps> steps;
    StageControl control;
};

bool standAlike(const FollowedRadii& a, const FollowedRadii& b) {
    return a.fed_mm == b.fed_mm
           && std::ranges::equal(a.radii, b.radii, [](const auto& one, const auto& other) {
                  return std::abs(one.depth_mm - other.depth_mm) < 1e-14;
              });
}

LastStage lastStage(const CycleRun& run, double infeed_mm) {
    StepFeed step = run.feed();
    step.infeed_mm = infeed_mm;
    return {.feed = run.steps->follower()->feed(step)};
}

LastStageBound boundOf(const CycleRun& run, const LastStage& stage) {
    return lastStageBound(*run.steps, criticalRadii(*run.steps), stage, PassCuts(run.project));
}

bool diameterMisses(const SimulationResult& result, ConstraintKind kind) {
    const std::vector<ConstraintResult> all = evaluateConstraints(result);
    return std::any_of(all.begin(), all.end(),
                       [kind](const auto& each) { return each.kind == kind && !each.holds; });
}

class TestLastStageBound : public QObject {
    Q_OBJECT

private slots:
    void aRadiusFollowedAloneStandsWhereTheWholeRunHasItAndByStrokesAloneNoDeeper() {
        int shallower = 0;
        for (unsigned seed = 0; seed < 100; ++seed) {
            const Project p = seed % 2 == 0 ? traversed(seed) : fedContinuously(seed);
            CycleRun whole(p);
            const auto K = static_cast<std::size_t>(p.part->radii_per_section);
            const FollowedRadii::Lanes lanes{seed % K, K + seed % K, 2 * K + K - 1};
            const RadiusFollower* follower = whole.steps->follower();
            QVERIFY(follower);
            const FollowedFeed feed = follower->feed(whole.feed());
            FollowedRadii alone = follower->follow(lanes);
            FollowedRadii strokes = alone;
            double fed_mm = alone.fed_mm;
            while (whole.control.stage() == 0) {
                follower->stepAlone(alone, feed);
                follower->strokesAlone(strokes, feed);
                whole.step();
                const FollowedRadii there = follower->follow(lanes);
                QVERIFY(standAlike(alone, there));
                QCOMPARE(strokes.fed_mm, there.fed_mm);
                for (std::size_t i = 0; i < lanes.size(); ++i) {
                    QVERIFY(strokes.radii[i].depth_mm <= alone.radii[i].depth_mm);
                }
                QCOMPARE(strokes.radii[1].depth_mm, alone.radii[1].depth_mm); // cut by strokes only
                QVERIFY(std::abs(alone.fed_mm - fed_mm - feed.all_mm) < 1e-12);
                fed_mm = alone.fed_mm;
                shallower += strokes.radii[0].depth_mm < alone.radii[0].depth_mm ? 1 : 0;
            }
        }
        QVERIFY(shallower > 100); // else the plunge and the dwells were none
    }

    void inPlungeGrindingARadiusFollowedAloneStandsWhereTheWholeRunHasIt() {
        for (unsigned seed = 0; seed < 100; ++seed) {
            const Project p = plunged(seed);
            CycleRun whole(p);
            const auto K = static_cast<std::size_t>(p.part->radii_per_section);
            const FollowedRadii::Lanes lanes{seed % K, (seed + K / 3) % K, K - 1};
            const RadiusFollower* follower = whole.steps->follower();
            QVERIFY(follower && follower->hasStrokesAlone());
            const FollowedFeed feed = follower->feed(whole.feed());
            FollowedRadii alone = follower->follow(lanes);
            FollowedRadii critical = criticalRadii(*whole.steps);
            while (whole.control.stage() == 0) {
                follower->stepAlone(alone, feed);
                follower->strokesAlone(critical, feed);
                whole.step();
                QVERIFY(standAlike(alone, follower->follow(lanes)));
                const Run& run = whole.steps->run();
                const double deepest_mm = run.depth_mm(run.deepestLane(whole.steps->gaugePoint()));
                QVERIFY(critical.radii[0].depth_mm > deepest_mm - 1e-14); // none comes deeper
            }
        }
    }

    void theStageTakesNoFewerStepsAndWhatIsToldTooDeepIsSo_data() {
        addColumns<bool, bool>("travels", "continuous");
        QTest::addRow("traverse") << true << false;
        QTest::addRow("continuous infeed") << true << true;
        QTest::addRow("plunge") << false << false;
    }

    void theStageTakesNoFewerStepsAndWhatIsToldTooDeepIsSo() {
        QFETCH(bool, travels);
        QFETCH(bool, continuous);
        int exact = 0, deep = 0, missed = 0, stages = 0;
        for (unsigned seed = 0; seed < 400; ++seed) {
            const Project p = continuous ? fedContinuously(seed)
                              : travels  ? traversed(seed)
                                         : plunged(seed);
            const PassCuts cuts(p);
            CycleRun run(p);
            while (run.control.stage() == 0) {
                run.step();
            }
            if (run.control.finished()) { // both ended at one reading
                continue;
            }
            const LastStageBound bound = boundOf(run, lastStage(run, run.feed().infeed_mm));
            while (!run.control.finished()) {
                run.step();
            }
            const int steps = run.control.stepsByStage().back();
            const bool misses = diameterMisses(
                run.steps->copy()->finish(run.control.stepsByStage()), cuts.tooDeep());
            QVERIFY(bound.leastSteps <= steps);
            QVERIFY(!bound.cutsTooDeep || misses);
            ++stages;
            exact += !bound.cutsTooDeep && bound.leastSteps == steps;
            deep += bound.cutsTooDeep;
            missed += misses;
        }
        qInfo("%d of %d last stages ended at the bound, %d of %d too deep were refuted", exact,
              stages - deep, deep, missed);
        QVERIFY(exact > (stages - deep) / 2); // else the bound is too weak to be of use
        QVERIFY(deep > missed / 2 && missed > 20 && missed < stages);
    }

    void aSparkOutIsFollowedForItsSteps() {
        const Project p = traversed(3);
        CycleRun run(p);
        while (run.control.stage() == 0) {
            run.step();
        }
        LastStage sparkOut = lastStage(run, 0);
        sparkOut.sparkOut = 7;
        QCOMPARE(boundOf(run, sparkOut).leastSteps, 7);
        sparkOut.mostSteps = 4;
        QCOMPARE(boundOf(run, sparkOut).leastSteps, 4);
    }

    void noRadiusIsFollowedWhereRadiiDependOnEachOther() {
        Project p = traversed(1);
        p.machine->wheel_contact = WheelContact{std::vector<std::vector<double>>{{50, 20}}};
        QVERIFY(!CycleRun(p).steps->follower());
        Project plunge = fixtures::plunge();
        QVERIFY(plungeSteps(plunge, nullptr, {})->follower());
        plunge.gauge->position_mm = plunge.part->length_mm / 3;
        plunge.gauge->compliance_mm_per_n = 1e-5;
        QVERIFY(!plungeSteps(plunge, nullptr, {})->follower());
        plunge.gauge->position_mm.reset();
        fixtures::putOnSlenderShaft(plunge);
        plunge.sections = 3;
        plunge.sections_coupled = true;
        QVERIFY(!plungeSteps(plunge, nullptr, {})->follower());
    }
};

} // namespace sparkout::test_last_stage_bound

SPARKOUT_TEST(test_last_stage_bound, TestLastStageBound)
#include "test_last_stage_bound.moc"
