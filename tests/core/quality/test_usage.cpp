// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a limit is used up, and the least margin of a summary.
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/quality/verdict.h"
#include "core/simulation/simulate.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>

namespace sparkout::test_usage {

class TestUsage : public QObject {
    Q_OBJECT

private slots:
    /// Of a tolerance value over limit; of a field, at least half, 1 at either end.
    void usageIsOneAtTheLimit() {
        const ConstraintResult tolerance =
            held(ConstraintKind::radialRunout, Side::atMost, 6, 4.5, 6);
        QCOMPARE(usageOf(tolerance), 0.75);
        QCOMPARE(usageOf(held(ConstraintKind::radialRunout, Side::atMost, 6, 6, 6)), 1.0);
        QCOMPARE(usageOf(held(ConstraintKind::diameterMin, Side::atLeast, -16, -16, 16)), 1.0);
        QCOMPARE(usageOf(held(ConstraintKind::diameterMax, Side::atMost, 0, 8, 16)), 1.5);
        QCOMPARE(usageOf(held(ConstraintKind::diameterMax, Side::atMost, 0, -32, 16)), 0.0);
    }

    void ofAnEstimateThatIsMetItsUpperEndCounts() {
        ConstraintResult rough = held(ConstraintKind::roughness, Side::atMost, 1.6, 0.16, 1.6);
        QCOMPARE(usageOf(rough), 0.1);
        rough.mostValue = 0.48;
        QCOMPARE(usageOf(rough), 0.3);
        rough.mostValue = 1.8; // undecided: no share is stated
        QCOMPARE(usageOf(rough), 0.1);
    }

    void ofALeastSettingItIsTheLimitOverTheValue() {
        QCOMPARE(usageOf(held(ConstraintKind::leastOverlap, Side::atLeast, 1.05, 2.5, 1.05)), 0.42);
        QCOMPARE(usageOf(held(ConstraintKind::leastSteps, Side::atLeast, 2, 16, 2)), 0.125);
        QCOMPARE(usageOf(held(ConstraintKind::overlap, Side::atLeast, 1, 0.8, 1)), 1.25);
    }

    void ofARangeItIsHowCloseTheNearerEndIs() {
        const auto of = [](Side side, double limit, double value) {
            return usageOf(held(ConstraintKind::rangeRadialFeed, side, limit, value, 10));
        };
        QCOMPARE(of(Side::atLeast, 1, 2), 0.5);
        QCOMPARE(of(Side::atMost, 8, 2), 0.25);
        QCOMPARE(of(Side::atLeast, 0, 2), 0.0);
        QVERIFY(std::isfinite(of(Side::atLeast, 1, 0)));
        QVERIFY(of(Side::atMost, 0, 0.1) > 1); // of a machine that cannot do it at all
    }

    /// The machine's own form comes on top of what is known: what holds may still fail.
    void aMarginBesideALowerBoundIsAnUpperBound() {
        ConstraintResult round = held(ConstraintKind::roundness, Side::atMost, 6, 0.54, 6);
        QVERIFY(marginKnown(round) == MarginKnown::exactly && lightOf(round) == Light::holds);
        round.knowsMachine = false;
        QVERIFY(marginKnown(round) == MarginKnown::atMost && lightOf(round) == Light::undecided);
        round.value = 0.004; // 0.00: the limit itself would be the bound
        QVERIFY(marginKnown(round) == MarginKnown::no && lightOf(round) == Light::undecided);
        round = held(ConstraintKind::roundness, Side::atMost, 6, 6.5, 6);
        round.knowsMachine = false; // fails even so
        QVERIFY(marginKnown(round) == MarginKnown::exactly && lightOf(round) == Light::fails);
        ConstraintResult rough = held(ConstraintKind::roughness, Side::atMost, 0.8, 0.3, 0.8);
        rough.mostValue = 0.9;
        QVERIFY(marginKnown(rough) == MarginKnown::no && lightOf(rough) == Light::undecided);
        rough.mostValue = 0.5;
        QVERIFY(marginKnown(rough) == MarginKnown::exactly && lightOf(rough) == Light::holds);
        rough.isWhole = false;
        QVERIFY(marginKnown(rough) == MarginKnown::no);
    }

    void inEveryExampleWhatUsesUpMoreThanItsLimitFails() {
        int held = 0;
        for (const std::string& name : samples::names()) {
            const Project project = samples::project(name);
            if (hasErrors(validate(project))) {
                continue;
            }
            for (const ConstraintResult& of : evaluateConstraints(simulateUnchecked(project))) {
                const bool isRange = requirementOf(of.kind).source == LimitSource::range;
                if (!isRange && of.isWhole) {
                    QVERIFY(of.holds ? usageOf(of) <= 1 + 1e-6 : usageOf(of) >= 1);
                    ++held;
                }
            }
        }
        QVERIFY(held > 40);
    }
};

} // namespace sparkout::test_usage

SPARKOUT_TEST(test_usage, TestUsage)
#include "test_usage.moc"
