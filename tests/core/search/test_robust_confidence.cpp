// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// What a robust answer states of the phases it was not tried on, and what a stop leaves unsaid.
#include "core/search/binding.h"
#include "core/search/robust.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <chrono>
#include <random>
#include <stop_token>
#include <thread>

namespace sparkout::test_robust_confidence {

/// Tries cycle after cycle, the k-th with a share(k) of failing phases, on 500 each until one meets
/// none. The share of the runs in which what is stated of it is true; a run without one states
/// nothing.
double coverage(const std::function<double(int)>& share, const std::function<double(int)>& stated,
                unsigned seed, int runs = 4000) {
    constexpr int mostCandidates = 60;
    std::mt19937 random(seed);
    int isTrue = 0;
    for (int run = 0; run < runs; ++run) {
        int passed = 0;
        for (int k = 1; k <= mostCandidates && passed == 0; ++k) {
            const auto fails = static_cast<std::uint_fast32_t>(share(k) * 0x1p32);
            int phases = 0;
            while (phases < freshPhaseCount && random() >= fails) {
                ++phases;
            }
            passed = phases == freshPhaseCount ? k : 0;
        }
        isTrue += passed == 0 || share(passed) <= stated(passed) ? 1 : 0;
    }
    return static_cast<double>(isTrue) / runs;
}

/// A part whose cycle takes long to run: sections that deflect each other.
Project slow() {
    Project p = fixtures::plunge();
    p.part->radii_per_section = 360;
    fixtures::putOnSlenderShaft(p);
    p.sections = 40;
    p.sections_coupled = true;
    p.part->lower_deviation_um = -400;
    p.part->upper_deviation_um = 400;
    p.part->tolerance = {};
    return p;
}

class TestRobustConfidence : public QObject {
    Q_OBJECT

private slots:
    void ofTheFirstCycleItIsTheBoundOfATwentiethHalved() {
        QVERIFY(std::abs(mostFailing(500, 1) - std::log(40.0) / 500) < 1e-15);
        QVERIFY(std::abs(mostFailing(500, 3) - std::log(240.0) / 500) < 1e-15);
        QCOMPARE(mostFailing(1, 1), 1.0); // a share is no more
        for (int k = 1; k < 100; ++k) {   // the chances of all cycles together
            QVERIFY(mostFailing(500, k) < mostFailing(500, k + 1));
        }
    }

    // Whatever the cycles are that are tried one after another: alike, worse and worse, or each
    // just a little worse than what would be stated of it.
    void whatIsStatedIsTrueInNineteenOfTwentyRuns() {
        const auto own = [](int k) { return mostFailing(freshPhaseCount, k); };
        const auto threeOverN = [](int) { return 3.0 / freshPhaseCount; };
        double least = 1;
        unsigned seed = 0;
        for (double p = 0.001; p < 0.03; p *= 1.1) {
            least = std::min(least, coverage([p](int) { return p; }, own, ++seed));
            least = std::min(least, coverage([p](int k) { return p * k; }, own, ++seed));
        }
        for (const double worse : {1.02, 1.05, 1.2}) {
            least = std::min(least,
                             coverage([&](int k) { return own(k) * worse; }, own, ++seed, 20'000));
        }
        const double before = coverage([](int) { return 0.0065; }, threeOverN, ++seed);
        qInfo("%.2f %% of the runs at least; with 3/n %.2f %%", 100 * least, 100 * before);
        QVERIFY2(least >= 0.95, QByteArray::number(least));
        QVERIFY2(before < 0.5, QByteArray::number(before)); // of one cycle alone it would hold
    }

    void aTrialThatIsStoppedIsNoFailure() {
        const Project p = slow();
        QVERIFY(!failingPhase(p, 1, {}, 1)); // it holds
        std::stop_source stop;
        std::jthread stopper([&stop] {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            stop.request_stop();
        });
        RunningTimer took;
        const auto failing = failingPhase(p, 1, stop.get_token(), 100'000);
        QVERIFY(stop.stop_requested());
        qInfo("stopped after %lld ms", took.elapsed());
        QVERIFY(!failing);
    }

    void aStopKeepsTheBestThatCameThroughItsTests() {
        Project p = samples::projectIn("resources/examples/plunge-shaft-two-stage.sparkout");
        p.optimisation->non_increasing = false; // more candidates
        int calls = 0, kept = 0, stopped = 0;
        SearchOptions counted;
        counted.onProgress = [&calls](const SearchProgress&) { ++calls; };
        const RobustSummary whole = optimiseRobustly(p, undecidedScenarios(p), {.search = counted});
        QVERIFY(whole.holdsInSample && whole.search.status == SearchStatus::proved);
        const int all = calls;
        for (int part = 1; part < 12; ++part) {
            std::stop_source stop;
            int left = all * part / 12;
            SearchOptions options;
            options.stop = stop.get_token();
            options.onProgress = [&](const SearchProgress&) {
                if (--left == 0) {
                    stop.request_stop();
                }
            };
            const RobustSummary found =
                optimiseRobustly(p, undecidedScenarios(p, options.stop), {.search = options});
            stopped += found.search.status == SearchStatus::stopped ? 1 : 0;
            if (!found.holdsInSample) {
                continue;
            }
            const Project best = withBest(p, found.search);
            QVERIFY(found.decided && found.candidate > 0);
            QVERIFY(decidePhases(best, found.decided->stocks).holds());
            QVERIFY(found.search.best->time_us >= whole.search.best->time_us);
            kept += found.search.status == SearchStatus::stopped ? 1 : 0;
        }
        qInfo("%d progress reports; %d of 11 stopped, %d of them with a best", all, stopped, kept);
        QVERIFY(stopped > 3 && kept > 0);
    }

    void whatBindsIsNotKnownWhereItWasStopped() {
        Project p = fixtures::plunge();
        p.machine->wheel_drive_kw = 1e3;
        p.optimisation = Optimisation{};
        p.optimisation->stages = {1};
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.2, 0.4};
        const SearchSummary best = optimise(p);
        QVERIFY(best.best);
        QVERIFY(bindingRequirements(p, *best.best).has_value());
        const StoppedSource stop;
        QVERIFY(!bindingRequirements(p, *best.best, {}, stop.get_token()));
        QVERIFY(!bindingRequirements(p, best.cycle, best.best->time_us, {}, stop.get_token()));
    }
};

} // namespace sparkout::test_robust_confidence

SPARKOUT_TEST(test_robust_confidence, TestRobustConfidence)
#include "test_robust_confidence.moc"
