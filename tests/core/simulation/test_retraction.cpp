// SPDX-License-Identifier: GPL-3.0-or-later
// Stages with a negative feed: the wheel head is drawn back so that the stored deflection is let go
// sooner. An option beyond the sources [MODEL-7].
#include "core/project/validate.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_retraction {

using fixtures::plungeStage;
using fixtures::sparkStage;
using fixtures::Traced;
using fixtures::within;

/// A soft system, so that there is much to let go: roughing, retraction, finishing.
Project retracting(double feed_mm_min = -0.6, double stock_mm = 0.01) {
    Project p = fixtures::plunge();
    p.machine->compliance_mm_per_n = std::vector<double>{1e-4};
    p.cycle->stages = {plungeStage(1.8, 0.2 - stock_mm - 0.005), plungeStage(feed_mm_min, stock_mm),
                       plungeStage(0.05, 0.005)};
    return p;
}

std::vector<Pass> stagePasses(const Traced& run, int stage) {
    std::vector<Pass> passes;
    for (const Pass& pass : run.trajectory.passes) {
        if (pass.place.stage == stage) {
            passes.push_back(pass);
        }
    }
    return passes;
}

class TestRetraction : public QObject {
    Q_OBJECT

private slots:
    // t_П − (|S_p|/n)·(k+1)/K, revolution by revolution, and the balance holds on the way back.
    void wheelHeadIsDrawnBackAlongTheRevolution() {
        const Project p = retracting();
        const Traced run(p);
        QCOMPARE(run.result.status, RunStatus::completed);
        const std::vector<Pass> passes = stagePasses(run, 2);
        QVERIFY(passes.size() >= 2);
        const double step = 0.6 / 180;
        const fixtures::Law law(p);
        const Pass before = stagePasses(run, 1).back();
        const double from = run.visit(before, 3).programmed_mm;
        for (std::size_t m = 0; m < passes.size(); ++m) {
            QVERIFY(within(passes[m].radialFeed_mm, -step, 1e-15));
            for (int k = 0; k < 4; ++k) {
                const Visit& v = run.visit(passes[m], k);
                QVERIFY(within(v.programmed_mm, from - step * (double(m) + (k + 1) / 4.0), 1e-14));
                const double h = v.programmed_mm - (v.accumulated_mm - v.actual_mm);
                const double rest = v.actual_mm + 1e-4 * law.force(40, v.actual_mm) - h;
                QVERIFY(h > 0 ? within(rest, 0, 1e-12) : v.actual_mm == 0);
            }
        }
    }

    void retractionEndsWithItsStock() {
        const Traced run(retracting());
        const Pass last = stagePasses(run, 2).back();
        const Pass first = stagePasses(run, 3).front();
        QVERIFY(run.visit(last, 3).actual_mm > 1e-6); // still cutting
        QCOMPARE(first.place.cycleCount, last.place.cycleCount + 1);
        QVERIFY(run.result.remainingStock_mm <= 1e-9);
    }

    // Drawn back faster than the stock comes off: the stage ends when nothing is cut, not never.
    void retractionThatLosesContactHandsOver() {
        const Traced run(retracting(-60, 0.1));
        QCOMPARE(run.result.status, RunStatus::completed);
        const std::vector<Pass> passes = stagePasses(run, 2);
        QCOMPARE(passes.size(), std::size_t(1)); // a third of a millimetre at once
        QCOMPARE(run.visit(passes.back(), 3).actual_mm, 0.0);
        QVERIFY(stagePasses(run, 3).size() > 10); // the finishing feed does the rest
        QVERIFY(run.result.remainingStock_mm <= 1e-9);
    }

    // What it is for: the same finishing depth sooner than by the finishing feed alone.
    void retractionReachesTheFinishingDepthSooner() {
        Project without = retracting();
        without.cycle->stages = {plungeStage(1.8, 0.185), plungeStage(0.05, 0.015)};
        const auto depthAfter = [](const Traced& run, int revolutions) {
            return run.visit(run.trajectory.passes[std::size_t(revolutions - 1)], 3).actual_mm;
        };
        const Traced with(retracting()), plain(without);
        const int rough = with.result.countsByStage[0];
        QCOMPARE(plain.result.countsByStage[0], rough);
        QVERIFY(depthAfter(with, rough + 3) < depthAfter(plain, rough + 3));
        Project slow = without;
        slow.cycle->stages = {plungeStage(1.8, 0.1), plungeStage(0.05, 0.1)};
        QVERIFY(with.result.time_s < Traced(slow).result.time_s);
    }

    void partNeverGrows() {
        const Traced run(retracting(-2));
        double last = 1e9;
        for (const Pass& pass : run.trajectory.passes) {
            QVERIFY(run.visit(pass, 3).radius_mm <= last);
            last = run.visit(pass, 3).radius_mm;
        }
    }

    void onlyAStageBetweenOthersMayRetract_data() {
        addColumns<int, bool, bool>("place", "position", "allowed");
        QTest::newRow("first") << 0 << false << false;
        QTest::newRow("between") << 1 << false << true;
        QTest::newRow("last") << 2 << false << false;
        QTest::newRow("by position") << 1 << true << false;
    }
    void onlyAStageBetweenOthersMayRetract() {
        QFETCH(int, place);
        QFETCH(bool, position);
        QFETCH(bool, allowed);
        Project p = retracting(0.3);
        p.gauge->control = position ? Control::position : Control::gauge;
        p.cycle->stages[std::size_t(place)].radial_feed_mm_min = -0.3;
        const Issues issues = validate(p);
        QCOMPARE(!hasErrors(issues), allowed);
        const std::string path = "/cycle/stages/" + std::to_string(place) + "/radial_feed_mm_min";
        const auto found = std::ranges::find(issues, path, &Issue::path);
        QCOMPARE(found == issues.end(), allowed); // where it is allowed, it is nothing unusual
        QVERIFY(allowed || found->code == IssueCode::feedMissing);
    }

    void strokesNeverRetract() {
        Project p = fixtures::traverse();
        p.cycle->stages.insert(p.cycle->stages.begin() + 1,
                               fixtures::strokeStage(-0.001, 1000, 0.01));
        QVERIFY(hasErrors(validate(p)));
    }
};

} // namespace sparkout::test_retraction

SPARKOUT_TEST(test_retraction, TestRetraction)
#include "test_retraction.moc"
