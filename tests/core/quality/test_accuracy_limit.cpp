// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of the feed by accuracy: its curve against the release it follows from, and its bound
// against every cut of random plunge cycles.
#include "core/quality/accuracy_limit.h"

#include "tests/core/quality/limit_curves.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <numeric>
#include <random>

namespace sparkout::test_accuracy_limit {

using namespace limit_curves;
using fixtures::between;
using fixtures::close;
using fixtures::holds;
using fixtures::pick;
using fixtures::plungeOfThree;

double force(const ForceLaw& law, double b, double a) {
    return b * (law.ks * a + law.kr * std::sqrt(a));
}

class TestAccuracyLimit : public QObject {
    Q_OBJECT

private slots:
    void aReleaseIsThePassWithoutInfeed() {
        QVERIFY(holds("σ", [] {
            const ForceLaw law{between(100, 5000), between(0, 300), 0, 0};
            const double b = between(1, 60), gamma = between(1e-6, 1e-3);
            const double a = between(1e-5, 0.05);
            const double next = depthAfter(law, b, gamma, a);
            RC_ASSERT(close(next + gamma * force(law, b, next), gamma * force(law, b, a), 1e-12));
            RC_ASSERT(next < a);
            RC_ASSERT(close(depthBefore(law, b, gamma, next), a, 1e-9));
        }));
    }

    /// Sharp grains: σ multiplies by r = α/(1 + α), the curve is that of a geometric series.
    void theCurveOfSharpGrainsIsAGeometricSeries() {
        const ForceLaw law{1000, 0, 0, 0};
        const double b = 40, gamma = 5e-5, alpha = gamma * b * law.ks, r = alpha / (1 + alpha);
        const double lastCut = 1e-3;
        const LimitPoints curve = releaseCurve(law, b, gamma, lastCut, 0.2);
        double stock = 0, a = lastCut;
        for (int n = 0; stock < 0.2; ++n) {
            QVERIFY(close(valueAt(curve, stock), a, 1e-9));
            stock += a;
            a /= r;
        }
        QCOMPARE(curve.back().stock_mm, 0.2);
        for (std::size_t i = 1; i < curve.size(); ++i) {
            QVERIFY(curve[i].stock_mm > curve[i - 1].stock_mm);
            QVERIFY(curve[i].depth_mm >= curve[i - 1].depth_mm);
        }
    }

    void theRootOfTheSpreadIsOne() {
        QVERIFY(holds("spread", [] {
            const ForceLaw law{between(100, 5000), between(0, 300), 0, 0};
            const double b = between(1, 60), stiff = between(1e-6, 1e-4);
            const double soft = stiff * between(1.05, 4), s = between(0.001, 0.02);
            const double a = lastCutOfSpread(law, b, stiff, soft, s);
            RC_ASSERT(a > 0);
            RC_ASSERT(close(soft * force(law, b, a) - stiff * force(law, b, a + s), s, 1e-9));
        }));
        QVERIFY(std::isinf(lastCutOfSpread({1000, 10, 0, 0}, 40, 1e-5, 1e-5, 0.01)));
    }

    /// Whatever spread a cycle ends with, its last cuts obey the bound of that spread, and every
    /// cut before obeys the curve that follows from its last cut.
    // Of the two lanes of random plunges the radii end apart by what they do; so much allowed, no
    // two or three last cuts are more than the bound, which some come near to.
    void theLastCutsTogetherAreNoMoreThanTheSpreadAllows() {
        std::mt19937_64 random(11);
        const auto drawn = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        double nearest = 0, oneByOne = 0;
        for (int trial = 0; trial < 400; ++trial) {
            const ForceLaw law{.ks = drawn(10, 60), .kr = trial % 5 == 0 ? 0 : drawn(10, 200)};
            const double b = 40, stiff = drawn(1e-5, 1e-4), soft = stiff * drawn(1.05, 4);
            double a_1 = 0, a_2 = 0, apart_mm = 0;
            std::vector<double> cuts;
            const int passes = 2 + trial % 9;
            for (int i = 0; i < passes; ++i) {
                const bool sparks = i > passes / 2 && trial % 3 > 0;
                const double infeed_mm = sparks ? 0 : drawn(0, 0.02);
                a_1 = depthAfter(law, b, stiff, a_1, infeed_mm);
                a_2 = depthAfter(law, b, soft, a_2, infeed_mm);
                apart_mm += a_1 - a_2;
                cuts.push_back(a_2);
            }
            for (int count = 1; count <= std::min(3, passes); ++count) {
                const double sum = std::accumulate(cuts.end() - count, cuts.end(), 0.0);
                const double bound = lastCutsOfSpread(law, b, stiff, soft, apart_mm, count,
                                                      [](double) { return 0.05; });
                QVERIFY2(sum <= bound * (1 + 1e-9), QByteArray::number(trial));
                nearest = count > 1 ? std::max(nearest, sum / bound) : nearest;
                if (count == 1) {
                    const double alone =
                        std::min(lastCutOfSpread(law, b, stiff, soft, apart_mm), 0.05);
                    QVERIFY(fixtures::close(bound, alone, 1e-12));
                    oneByOne = std::max(oneByOne, sum / bound);
                }
            }
        }
        QVERIFY2(nearest > 0.8 && oneByOne > 0.8, QByteArray::number(nearest));
    }

    void everyCutOfEveryPlungeObeysIt() {
        QVERIFY(holds("bound", [] {
            Project p = plungeOfThree();
            const double stiff = between(5e-6, 1e-4);
            p.machine->compliance_mm_per_n =
                std::vector<double>{stiff * between(1, 3), stiff, stiff * between(1, 3)};
            p.part->initial_runout_mm = between(0, 0.05);
            p.part->radii_per_section = 8;
            p.cycle->stages = {fixtures::plungeStage(between(0.3, 3), 0.12),
                               fixtures::plungeStage(between(0.05, 1), 0.08)};
            if (pick(0, 2) == 0) {
                p.cycle->stages.push_back(fixtures::sparkStage(fixtures::count(pick(1, 20))));
            }
            const Drawn drawn(p);
            RC_PRE(drawn.result.status == RunStatus::completed);
            const ForceLaw law = forceLaw(p);
            const double b = p.part->length_mm;
            const auto& gammas = std::get<std::vector<double>>(p.machine->compliance_mm_per_n);
            for (std::size_t j : {std::size_t{0}, std::size_t{2}}) {
                const double gamma = gammas[j];
                for (int k = 0; k < drawn.trajectory.radii; ++k) {
                    const auto at = static_cast<std::size_t>(k);
                    const double end = drawn.result.sections[j].radii_mm[at];
                    const double spread = end - drawn.result.sections[1].radii_mm[at];
                    RC_ASSERT(spread > -1e-12);
                    std::vector<const Visit*> cuts;
                    for (const Pass& pass : drawn.trajectory.passes) {
                        if (pass.place.section == static_cast<int>(j)) {
                            cuts.push_back(&drawn.trajectory.visits[pass.firstVisit + at]);
                        }
                    }
                    const double last = cuts.back()->actual_mm;
                    if (!(last > 0)) {
                        continue;
                    }
                    if (gamma > 1.01 * stiff && spread > 1e-9) {
                        RC_ASSERT(last
                                  <= lastCutOfSpread(law, b, stiff, gamma, spread) * (1 + 1e-6));
                    }
                    const LimitPoints curve = releaseCurve(law, b, gamma, last, 0.3);
                    for (const Visit* const visit : cuts) {
                        const double left = std::max(visit->radius_mm - end, 0.0);
                        // Straight between the points of a curve that may bend: a hundredth.
                        RC_ASSERT(visit->actual_mm <= valueAt(curve, left) * 1.01 + 1e-9);
                    }
                }
            }
        }));
    }

    void theBoundOfASeriesComesFromDrawingAndCompliance() {
        const Project project = plungeOfThree();
        const Drawn drawn(project);
        const ForceLaw law = forceLaw(project);
        const double s = 0.008; // half of the field of 16 µm
        const double softest = lastCutOfSpread(law, 40, 2e-5, 7e-5, s);
        for (const LimitGroup& group : drawn.series.groups) {
            const auto limit =
                accuracyLimit(drawn.result, drawn.series, group, AccuracyProof::proved);
            QVERIFY(limit.has_value());
            const double gamma = std::vector<double>{4e-5, 2e-5, 7e-5}[std::size_t(group.section)];
            const double wanted = std::min(lastCutOfSpread(law, 40, 2e-5, gamma, s), softest + s);
            QVERIFY(close(limit->lastCut_mm, wanted, 1e-12));
            QVERIFY(close(valueAt(limit->curve, 0), wanted, 1e-12));
            // Of cuts that are alike, in all lanes.
            const auto steady =
                accuracyLimit(drawn.result, drawn.series, group, AccuracyProof::estimate);
            QVERIFY(close(5e-5 * force(law, 40, steady->lastCut_mm), s, 1e-12));
            QVERIFY(steady->lastCut_mm < limit->lastCut_mm);
        }
        Project rounder = project;
        rounder.part->tolerance.total_runout_um = 4;
        const Drawn strict(rounder);
        const auto last = [](const Drawn& of) {
            return accuracyLimit(of.result, of.series, of.series.groups[2], AccuracyProof::proved)
                ->lastCut_mm;
        };
        QVERIFY(last(strict) < last(drawn));
        // A machine that takes the whole runout leaves no feed, which is not the same as no limit.
        rounder.machine->geometric_runout_um = 5;
        const Drawn spent(rounder);
        for (const AccuracyProof proof : {AccuracyProof::proved, AccuracyProof::estimate}) {
            const auto none =
                accuracyLimit(spent.result, spent.series, spent.series.groups[2], proof);
            QVERIFY(none.has_value());
            QCOMPARE(none->lastCut_mm, 0.0);
            QCOMPARE(valueAt(none->curve, 0), 0.0);
            QCOMPARE(none->curve.back().stock_mm, spent.series.deepest_mm);
        }
    }

    void alikeSectionsHaveNoBoundUnlessRoughnessIsCalibrated() {
        Project project = plungeOfThree();
        project.machine->compliance_mm_per_n = std::vector<double>{2e-5, 2e-5, 2e-5};
        const Drawn alike(project);
        for (const AccuracyProof proof : {AccuracyProof::proved, AccuracyProof::estimate}) {
            QVERIFY(!accuracyLimit(alike.result, alike.series, alike.series.groups.front(), proof));
        }
        project.part->tolerance.roughness_ra_um = 0.5;
        project.wheel->roughness_factor = 3;
        const Drawn rough(project);
        const auto limit = accuracyLimit(rough.result, rough.series, rough.series.groups.front(),
                                         AccuracyProof::proved);
        QVERIFY(limit.has_value());
        // No spark-out takes off more than half of it.
        project.part->tolerance.roughness_ra_um = 1.0;
        for (const DepthLimit& depth : depthLimits(project, 40, 0)) {
            QVERIFY(depth.kind != ConstraintKind::roughness
                    || close(depth.depth_mm, limit->lastCut_mm, 1e-12));
        }
    }

    /// Passes of zones differ: nothing is proved of them.
    void zonesHaveAnEstimateAlone() {
        const Drawn zones(fixtures::traverse());
        for (const LimitGroup& group : zones.series.groups) {
            QVERIFY(!accuracyLimit(zones.result, zones.series, group, AccuracyProof::proved));
        }
    }

    /// At the limit the pass has just the runout of the drawing.
    void thePublishedLimitIsThatOfEachPass() {
        Project project = plungeOfThree();
        project.part->tolerance.radial_runout_um = 6;
        const Drawn drawn(project);
        const ForceLaw law = forceLaw(project);
        const LimitGroup& group = drawn.series.groups[2];
        const LimitPoints points =
            publishedAccuracy(drawn.result, drawn.trajectory, drawn.series, group);
        QCOMPARE(points.size(), group.cuts.size());
        double least = HUGE_VAL;
        for (const Pass& pass : drawn.trajectory.passes) {
            if (pass.place.section == 2) { // the last one stays
                least = HUGE_VAL;
                for (int k = 0; k < drawn.trajectory.radii; ++k) {
                    least = std::min(
                        least, drawn.trajectory.visits[pass.firstVisit + std::size_t(k)].actual_mm);
                }
            }
        }
        QVERIFY(close(7e-5 * (force(law, 40, points.front().depth_mm) - force(law, 40, least)),
                      0.006, 1e-6));
    }

    void programmedStepsAreThoseOfTheStages() {
        const Drawn drawn(plungeOfThree());
        const LimitPoints steps =
            programmedSteps(drawn.result, drawn.series, drawn.series.groups.front());
        QVERIFY(steps.size() >= 4);
        QVERIFY(close(steps.back().depth_mm, 1.2 / 180, 1e-12));
        QVERIFY(steps.front().depth_mm == 0);
        QCOMPARE(steps.back().stock_mm, drawn.series.deepest_mm);
    }
};

} // namespace sparkout::test_accuracy_limit

SPARKOUT_TEST(test_accuracy_limit, TestAccuracyLimit)
#include "test_accuracy_limit.moc"
