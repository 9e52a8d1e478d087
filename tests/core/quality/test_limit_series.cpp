// SPDX-License-Identifier: GPL-3.0-or-later
// The cuts of a run against the limits of its feed, as the view "Constraints" draws them.
#include "core/quality/cycle_constraints.h"
#include "tests/core/quality/limit_curves.h"
#include "tests/registry.h"

#include <random>

namespace sparkout::test_limit_series {

using namespace limit_curves;
using fixtures::close;
using fixtures::plungeOfThree;

/// Of BurnTable's limiting depth, twice that of √a.
constexpr double tableError = 4e-6;

Project limited(Project project) {
    project.material->burn_rise_k = 500;
    project.machine->wheel_drive_kw = 3;
    return project;
}

/// Of a curve with steps; infinite beyond its ends.
double depthAt(const LimitPoints& points, double stock) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const LimitPoint &a = points[i - 1], &b = points[i];
        if (a.stock_mm < stock && stock <= b.stock_mm) {
            return a.depth_mm
                   + (b.depth_mm - a.depth_mm) * (stock - a.stock_mm) / (b.stock_mm - a.stock_mm);
        }
    }
    return std::numeric_limits<double>::infinity();
}

/// The least limit of a cut as the engine gives it.
double leastAt(const Project& project, double width, double stock) {
    double least = HUGE_VAL;
    for (const DepthLimit& limit : depthLimits(project, width, stock)) {
        if (limit.kind != ConstraintKind::roughness) {
            least = std::min(least, limit.depth_mm);
        }
    }
    return least;
}

class TestLimitSeries : public QObject {
    Q_OBJECT

private slots:
    void theUsageOfACutIsItsDepthOverTheLeastLimit() {
        for (const Project& project : {limited(fixtures::traverse()), limited(plungeOfThree())}) {
            const Drawn drawn(project);
            QVERIFY(!drawn.series.groups.empty());
            for (const LimitGroup& group : drawn.series.groups) {
                QVERIFY(!group.cuts.empty());
                double worst = 0;
                for (const LimitedCut& cut : group.cuts) {
                    const double limit = leastAt(project, cut.width_mm, cut.stock_mm);
                    QVERIFY(close(cut.usage, cut.depth_mm / limit, tableError));
                    worst = std::max(worst, cut.usage);
                }
                QCOMPARE(group.worst.usage, worst);
            }
        }
    }

    void aPassIsItsWorstRadius() {
        const Project project = limited(plungeOfThree());
        const Drawn drawn(project);
        const double target = targetRadius(*project.part);
        const LimitGroup& group = drawn.series.groups.front();
        const LimitedCut& cut = group.cuts[group.cuts.size() / 2];
        const auto pass = std::ranges::find_if(drawn.trajectory.passes, [&](const Pass& p) {
            return p.place.section == cut.place.section
                   && p.place.cycleCount == cut.place.cycleCount;
        });
        for (int k = 0; k < drawn.trajectory.radii; ++k) {
            const Visit& visit =
                drawn.trajectory.visits[pass->firstVisit + static_cast<std::size_t>(k)];
            const double limit = leastAt(project, cut.width_mm, visit.radius_mm - target);
            QVERIFY(visit.actual_mm / limit <= cut.usage * (1 + tableError));
        }
    }

    /// At the radius named, with its depth and the stock that it keeps.
    void everyCutIsAVisitOfItsZone() {
        for (const Project& project : {limited(fixtures::traverse()), limited(plungeOfThree())}) {
            const Drawn drawn(project);
            const double target = targetRadius(*project.part);
            for (const LimitGroup& group : drawn.series.groups) {
                for (const LimitedCut& cut : group.cuts) {
                    const auto holdsIt = [&](const Pass& pass) {
                        const Visit& visit =
                            drawn.trajectory
                                .visits[pass.firstVisit + static_cast<std::size_t>(cut.radius)];
                        return pass.place.zone == group.zone
                               && pass.place.section == cut.place.section
                               && pass.place.cycleCount == cut.place.cycleCount
                               && visit.actual_mm == cut.depth_mm
                               && std::abs(visit.radius_mm + visit.printed_mm - target
                                           - cut.stock_mm)
                                      < 1e-12;
                    };
                    QVERIFY(std::ranges::any_of(drawn.trajectory.passes, holdsIt));
                }
            }
        }
    }

    void theWorstCutIsTheVisitNearestToBurning() {
        for (Project project : {fixtures::traverse(), plungeOfThree()}) {
            project.material->burn_rise_k = 500;
            const Drawn drawn(project);
            const auto worst = std::ranges::max_element(
                drawn.series.groups, {}, [](const LimitGroup& g) { return g.worst.usage; });
            const BurnState state = burnStateOf(drawn.result).value();
            QVERIFY(
                close(worst->worst.usage, state.visit.depth_mm / state.limitDepth_mm, tableError));
            const auto constraints = evaluateConstraints(drawn.result);
            const auto burn =
                std::ranges::find(constraints, ConstraintKind::burn, &ConstraintResult::kind);
            const LimitedCut cut = limitedCutOf(drawn.result, drawn.trajectory, *burn).value();
            QCOMPARE(cut.depth_mm, state.visit.depth_mm);
            QVERIFY(std::abs(std::max(cut.stock_mm, 0.0) - state.visit.stock_mm) < 1e-12);
            QVERIFY(limitGroupAt(drawn.series, cut.place) >= 0);
        }
    }

    void theWorstCutIsTheOneWithThePeakOfPower() {
        for (Project project : {fixtures::traverse(), plungeOfThree()}) {
            project.machine->wheel_drive_kw = 3;
            const Drawn drawn(project);
            const LimitedCut* worst = &drawn.series.groups.front().worst;
            for (const LimitGroup& group : drawn.series.groups) {
                worst = group.worst.usage > worst->usage ? &group.worst : worst;
            }
            const auto constraints = evaluateConstraints(drawn.result);
            const auto power =
                std::ranges::find(constraints, ConstraintKind::wheelPower, &ConstraintResult::kind);
            const LimitedCut cut = limitedCutOf(drawn.result, drawn.trajectory, *power).value();
            QVERIFY(close(cut.depth_mm, worst->depth_mm, 1e-12));
            QCOMPARE(cut.width_mm, worst->width_mm);
            QCOMPARE(cut.usage > 1, worst->usage > 1);
        }
    }

    void groupsAreZonesByWhatTheWheelDoes() {
        const Drawn traverse(limited(fixtures::traverse()));
        std::vector<std::pair<Zone, bool>> groups;
        for (const LimitGroup& group : traverse.series.groups) {
            groups.emplace_back(group.zone, group.standing);
            for (const LimitedCut& cut : group.cuts) {
                QCOMPARE(wheelStands(cut.place), group.standing);
                QCOMPARE(cut.width_mm, effectiveWidth(traverse.result.project, cut.place));
            }
        }
        QVERIFY(std::ranges::is_sorted(
            groups, {}, [](const auto& g) { return std::pair(g.first, !g.second); }));
        QVERIFY(std::ranges::find(groups, std::pair(Zone::nz, false)) != groups.end());
        QVERIFY(std::ranges::find(groups, std::pair(Zone::nz, true)) == groups.end());
        QVERIFY(std::ranges::find(groups, std::pair(Zone::rz1, true)) != groups.end());
        const Project plunge = limited(plungeOfThree());
        QCOMPARE(Drawn(plunge).series.groups.size(), static_cast<std::size_t>(plunge.sections));
    }

    void curvesAreTheEnginesLimits() {
        for (const Project& project : {limited(fixtures::traverse()), limited(plungeOfThree())}) {
            const Drawn drawn(project);
            for (const LimitPoint& point : drawn.series.burn) {
                const auto limits = depthLimits(project, 1, point.stock_mm);
                const auto burn =
                    std::ranges::find(limits, ConstraintKind::burn, &DepthLimit::kind);
                QVERIFY(close(point.depth_mm, burn->depth_mm, 1e-12));
            }
            for (const LimitGroup& group : drawn.series.groups) {
                const LimitPoints stepless = steplessLimit(drawn.series, group);
                QVERIFY(std::ranges::is_sorted(stepless, {}, &LimitPoint::stock_mm));
                QCOMPARE(stepless.front().stock_mm, drawn.series.least_mm);
                QCOMPARE(stepless.back().stock_mm, drawn.series.deepest_mm);
                // Within each stage it is the least of the limits at that stage's width.
                double from = drawn.series.least_mm;
                for (std::size_t i = group.stages.size(); i-- > 0;) {
                    const double to = i > 0 ? group.stages[i - 1].end_mm : drawn.series.deepest_mm;
                    for (int part = 1; part < 20; ++part) {
                        const double stock = from + (to - from) * part / 20;
                        const double exact = leastAt(project, group.stages[i].width_mm, stock);
                        QVERIFY(close(valueAt(stepless, stock), exact, 2e-3)); // chords
                    }
                    from = to;
                }
            }
        }
    }

    void theEnvelopeNamesTheLeastCurveAtEachStock() {
        std::mt19937_64 random(11);
        std::uniform_real_distribution<double> share(0, 1);
        int changes = 0;
        for (int trial = 0; trial < 200; ++trial) {
            std::vector<BoundCurve> curves;
            for (int c = 0; c < 5; ++c) {
                BoundCurve curve{LimitBound::requirement, static_cast<ConstraintKind>(c), {}};
                double stock = 0.3 * share(random);
                while (stock < 1) {
                    curve.points.push_back({stock, share(random)});
                    if (share(random) < 0.2) { // a step
                        curve.points.push_back({stock, share(random)});
                    }
                    stock += 0.3 * share(random) + 1e-3;
                }
                curves.push_back(std::move(curve));
            }
            const std::vector<BoundCurve> envelope = envelopeOf(curves);
            for (std::size_t i = 1; i < envelope.size(); ++i) {
                QVERIFY(envelope[i - 1].points.back().stock_mm
                        <= envelope[i].points.front().stock_mm);
                changes += envelope[i - 1].kind != envelope[i].kind ? 1 : 0;
            }
            for (int i = 0; i < 300; ++i) {
                const double stock = share(random);
                double least = std::numeric_limits<double>::infinity();
                for (const BoundCurve& curve : curves) {
                    least = std::min(least, depthAt(curve.points, stock));
                }
                const auto piece = std::ranges::find_if(envelope, [stock](const BoundCurve& each) {
                    return each.points.front().stock_mm <= stock
                           && stock <= each.points.back().stock_mm;
                });
                QCOMPARE(piece == envelope.end(), !std::isfinite(least));
                if (piece != envelope.end()) {
                    const auto own = static_cast<std::size_t>(piece->kind);
                    QVERIFY(std::abs(depthAt(piece->points, stock) - least) < 1e-9);
                    QVERIFY(std::abs(depthAt(curves[own].points, stock) - least) < 1e-9);
                }
            }
        }
        QVERIFY(changes > 200);
    }

    // The deepest cuts of a plunge that feeds as fast as the machine may come near to the bound and
    // never beyond it.
    void noCutIsDeeperThanTheMachinesGreatestInfeed() {
        Project p = plungeOfThree();
        p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.01, 1.2, 0.01};
        const double infeed_mm = greatestInfeed_mm(p).value();
        QVERIFY(close(infeed_mm, 1.2 / p.machine->work_speed_rpm, 1e-12));
        const Drawn drawn(p);
        double deepest = 0;
        for (const LimitGroup& group : drawn.series.groups) {
            deepest = std::max(deepest, group.worst.depth_mm);
            for (const LimitedCut& cut : group.cuts) {
                deepest = std::max(deepest, cut.depth_mm);
            }
        }
        QVERIFY(deepest <= infeed_mm * (1 + 1e-9) && deepest > 0.9 * infeed_mm);
        p.machine->limits.plunge_feed_mm_min.reset();
        QVERIFY(!greatestInfeed_mm(p));
    }

    void aWiderCutInAStageLowersThePowerThere() {
        Project project = fixtures::traverse();
        project.machine->wheel_drive_kw = 3;
        project.cycle->stages[0].axial_feed_mm_min = 2000;
        project.cycle->stages[1].axial_feed_mm_min = 1000;
        const Drawn drawn(project);
        const auto nz = std::ranges::find(drawn.series.groups, Zone::nz, &LimitGroup::zone);
        QVERIFY(nz->stages.size() >= 2);
        const LimitPoints power = limitCurve(drawn.series, *nz, ConstraintKind::wheelPower);
        QVERIFY(power.back().depth_mm < power.front().depth_mm);
        const double step = nz->stages[0].end_mm;
        QCOMPARE(std::ranges::count(power, step, &LimitPoint::stock_mm), 2);
    }

    void coupledSectionsShareThePower() {
        Project project = limited(plungeOfThree());
        project.sections_coupled = true;
        Project apart = project;
        apart.sections_coupled = false;
        const auto power = [](const Project& p) {
            const Drawn drawn(p);
            return limitCurve(drawn.series, drawn.series.groups.front(),
                              ConstraintKind::wheelPower);
        };
        QVERIFY(!power(apart).empty());
        // What is computed when coupled needs an influence that this project may lack: ask the
        // series alone.
        const Drawn drawn(apart);
        SimulationResult result = drawn.result;
        result.project.sections_coupled = true;
        const LimitSeries coupled = makeLimitSeries(result, drawn.trajectory);
        QVERIFY(limitCurve(coupled, coupled.groups.front(), ConstraintKind::wheelPower).empty());
        QVERIFY(!coupled.burn.empty());
    }

    void withoutLimitsTheDeepestCutStands() {
        Project project = plungeOfThree();
        project.material->burn_rise_k.reset();
        project.machine->wheel_drive_kw.reset();
        project.machine->work_drive_kw.reset();
        const Drawn drawn(project);
        for (const LimitGroup& group : drawn.series.groups) {
            QVERIFY(steplessLimit(drawn.series, group).empty());
            for (const LimitedCut& cut : group.cuts) {
                QCOMPARE(cut.usage, 0.0);
                QVERIFY(cut.depth_mm <= group.worst.depth_mm);
            }
        }
    }

    void manyCutsAreThinnedToTheirWorst() {
        Project project = limited(plungeOfThree());
        for (Stage& stage : project.cycle->stages) {
            if (stage.radial_feed_mm_min) {
                *stage.radial_feed_mm_min /= 20;
            }
        }
        const Drawn drawn(project);
        const LimitGroup& group = drawn.series.groups.front();
        QVERIFY(drawn.result.cycleCount > static_cast<int>(mostLimitedCuts));
        QCOMPARE(group.cuts.size(), mostLimitedCuts);
        QVERIFY(std::ranges::is_sorted(group.cuts, {},
                                       [](const LimitedCut& cut) { return cut.place.cycleCount; }));
        QVERIFY(std::ranges::find(group.cuts, group.worst.usage, &LimitedCut::usage)
                != group.cuts.end());
    }

    void withoutARecordThereAreNoGroups() {
        const Project project = limited(plungeOfThree());
        const LimitSeries series = makeLimitSeries(simulateUnchecked(project), {});
        QVERIFY(series.groups.empty());
        QVERIFY(!series.burn.empty());
    }
};

} // namespace sparkout::test_limit_series

SPARKOUT_TEST(test_limit_series, TestLimitSeries)
#include "test_limit_series.moc"
