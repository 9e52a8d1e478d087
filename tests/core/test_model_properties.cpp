// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of MODEL-2…7 and 11, held against random cycles. Every cycle is made here, small and
// varied, and shrinks when a law fails; 10,000 each, see rapidcheck_runs.h.
#include "core/simulation/simulate.h"

#include "core/process/force.h"
#include "core/process/system_compliance.h"
#include "tests/core/project_fixtures.h"
#include "tests/core/rapidcheck_runs.h"
#include "tests/registry.h"

#include <QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace test_model_properties {

using namespace sparkout;
using fixtures::close;
using fixtures::Law;
using fixtures::rounding;
using fixtures::Traced;
using fixtures::within;

namespace {

/// The model's own accuracy of the elastic balance at a pass [mm] (MODEL-11).
constexpr double balance_mm = 1e-12;
/// A radius of up to 65 mm is rounded when it is made from a depth [mm].
constexpr double radiusRounding_mm = 64 * fixtures::epsilon;
/// Added to every threshold that ends a stage [mm] (MODEL-7).
constexpr double threshold_mm = 1e-9;

int pick(int low, int high) {
    return *rc::gen::inRange(low, high);
}
bool oneIn(int n) {
    return pick(0, n) == 0;
}
double between(double low, double high) {
    return low + (high - low) * pick(0, 10'001) / 10'000;
}
double decades(double low, double high) {
    return std::pow(10, between(low, high));
}

void anyBlank(Part& part) {
    part.radii_per_section = std::vector{4, 6, 8, 12, 36}[std::size_t(pick(0, 5))];
    part.stock_mm = between(0.01, 0.25);
    part.initial_runout_mm = oneIn(6) ? 0 : between(0, 0.06);
    part.profile = ProfileForm(pick(0, 4));
    part.lobes = pick(2, 8);
    if (part.profile == ProfileForm::measured) {
        part.radii_um.emplace();
        for (int k = 0; k < part.radii_per_section; ++k) {
            part.radii_um->push_back(between(-30, 0));
        }
    }
}

void anyForce(Project& p) {
    p.material.flow_stress_mpa = between(600, 2800);
    p.material.friction = between(0.1, 0.6);
    p.wheel.dullness = oneIn(4) ? 0 : between(0.005, 0.15);
    p.machine.wheel_speed_m_s = between(20, 50);
    p.machine.work_speed_rpm = between(60, 350);
}

/// One to three stages; `steps` of feed in all, more or less; now and then stocks that do not sum
/// up, position control, a spark-out by count at the end.
void anyStages(Project& p) {
    const int count = pick(1, 4);
    const int steps = pick(3, 40);
    for (int z = 0; z < count; ++z) {
        Stage stage;
        stage.stock_mm = p.part.stock_mm / count * (oneIn(8) ? between(0.2, 3) : 1);
        const double feed = stage.stock_mm * count / steps / (1 + z);
        if (p.operation == Operation::plunge) {
            stage.radial_feed_mm_min = feed * p.machine.work_speed_rpm;
        } else {
            stage.radial_feed_mm = feed;
            stage.axial_feed_mm_min =
                between(0.05, 1.1) * p.wheel.width_mm * p.machine.work_speed_rpm;
        }
        p.cycle.stages.push_back(stage);
    }
    if (oneIn(3)) {
        Stage last = p.cycle.stages.back();
        last.spark_out = fixtures::count(pick(1, 12));
        last.stock_mm = oneIn(2) ? 0 : 0.1 * p.part.stock_mm;
        p.cycle.stages.push_back(last);
    }
    p.gauge.rule = GaugeRule(pick(0, 3));
    p.gauge.control = oneIn(3) ? Control::position : Control::gauge;
}

Project anyPlunge(int leastSections = 1) {
    Project p;
    p.operation = Operation::plunge;
    p.part.surface = oneIn(3) ? Surface::internal : Surface::external;
    p.part.diameter_mm = between(25, 130);
    anyBlank(p.part);
    anyForce(p);
    p.wheel.width_mm = between(15, 70);
    p.wheel.diameter_mm = p.part.surface == Surface::internal
                              ? between(0.3, 0.9) * p.part.diameter_mm
                              : between(250, 750);
    p.part.length_mm = between(0.3, 1) * p.wheel.width_mm;
    p.sections = pick(leastSections, 6);
    std::vector<double> gammas;
    for (int j = 0; j < p.sections; ++j) {
        gammas.push_back(decades(-6, -4));
    }
    p.machine.compliance_mm_per_n = gammas;
    p.gauge.section = pick(0, p.sections);
    anyStages(p);
    return p;
}

Project anyTraverse() {
    Project p;
    p.operation = Operation::traverse;
    p.part.diameter_mm = between(12, 130);
    anyBlank(p.part);
    anyForce(p);
    p.wheel.width_mm = between(15, 70);
    p.wheel.diameter_mm = between(250, 750);
    p.machine.overrun_entry_mm = between(0, 0.7) * p.wheel.width_mm;
    p.machine.overrun_exit_mm = between(0, 0.7) * p.wheel.width_mm;
    p.part.length_mm = 2 * p.wheel.width_mm - p.machine.overrun_entry_mm - p.machine.overrun_exit_mm
                       + between(2, 100);
    p.machine.dwell_entry_s = oneIn(3) ? 0 : between(0.01, 0.6);
    p.machine.dwell_exit_s = oneIn(3) ? 0 : between(0.01, 0.6);
    p.machine.compliance_mm_per_n =
        ZoneCompliance{decades(-6, -3.7), decades(-6, -3.7), decades(-6, -3.7)};
    anyStages(p);
    p.machine.plunge_feed_mm_min = std::max(
        1e-3, p.machine.work_speed_rpm * *p.cycle.stages[0].radial_feed_mm / between(0.3, 6));
    return p;
}

Project anyCycle() {
    return oneIn(2) ? anyPlunge() : anyTraverse();
}

/// t_П at the end of the run; the largest of it rounds worst.
double programmed(const Traced& run) {
    return run.trajectory.visits.back().programmed_mm;
}

/// Calls check(pass, k, visit, depth of the radius before anything is cut) for every visit.
template <class Check>
void forEachVisit(const Traced& run, Check check) {
    const std::vector<double> depths = fixtures::blankDepths(run.result.project);
    for (const Pass& pass : run.trajectory.passes) {
        for (int k = 0; k < run.trajectory.radii; ++k) {
            check(pass, k, run.visit(pass, k), depths[std::size_t(k)]);
        }
    }
}

double gammaOf(const Traced& run, const Pass& pass) {
    return run.result.sections[std::size_t(pass.place.section)].compliance_mm_per_n;
}

/// What the gauge would read of these radii, less the target, per side (MODEL-7) [mm].
double remaining(const Project& p, const std::vector<double>& R) {
    const std::size_t half = R.size() / 2;
    std::vector<double> D;
    for (std::size_t k = 0; k < half; ++k) {
        D.push_back(R[k] + R[k + half]);
    }
    const double mean = std::accumulate(D.begin(), D.end(), 0.0) / double(half);
    const auto [low, high] = std::minmax_element(D.begin(), D.end());
    const bool internal = p.part.surface == Surface::internal;
    const double reading = p.gauge.rule == GaugeRule::mean                ? mean
                           : (p.gauge.rule == GaugeRule::min) != internal ? *low
                                                                          : *high;
    const double target = targetRadius(p.part);
    return internal ? target - reading / 2 : reading / 2 - target;
}

template <class Check>
bool holds(const char* law, Check check) {
    return rc::check(law, check);
}

} // namespace

class TestModelProperties : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(10000); }

    // --- the elastic balance ---------------------------------------------------------------------

    // t_П = depth of the blank + Σa + γ·P_y(a) at every pass in contact
    void everyCutBalancesInfeedAgainstRemovalAndDeflection() {
        QVERIFY(holds("elastic balance", [] {
            const Traced run(anyCycle());
            const Law law(run.result.project);
            double worst = 0;
            forEachVisit(run, [&](const Pass& pass, int, const Visit& visit, double blank) {
                const double left = visit.programmed_mm - blank - visit.accumulated_mm;
                if (visit.actual_mm > 0) {
                    const double P = law.force(pass.effectiveWidth_mm, visit.actual_mm);
                    worst = std::max(worst, std::abs(left - gammaOf(run, pass) * P));
                } else { // no contact: the wheel has not come further than the radius stands
                    worst = std::max(worst, left);
                }
            });
            RC_ASSERT(worst < balance_mm);
        }));
    }

    void removalNeverExceedsTheInfeed() {
        QVERIFY(holds("Σa ≤ t_П", [] {
            const Traced run(anyCycle());
            // Each visit rounds the depth once more.
            const double passes = double(run.trajectory.passes.size());
            forEachVisit(run, [&](const Pass&, int, const Visit& visit, double blank) {
                RC_ASSERT(visit.actual_mm >= 0);
                if (visit.accumulated_mm > 0) {
                    RC_ASSERT(visit.accumulated_mm + blank
                              <= visit.programmed_mm + rounding(visit.programmed_mm, passes));
                }
            });
        }));
    }

    // Rounding is monotone, so these hold to the last bit.
    void radiusOnlyMovesInTheDirectionOfTheInfeed() {
        QVERIFY(holds("R never grows outside, never shrinks inside", [] {
            const Traced run(anyCycle());
            const bool external = run.result.project.part.surface == Surface::external;
            const std::size_t K = std::size_t(run.trajectory.radii);
            std::vector<double> last(run.result.sections.size() * K, external ? 1e9 : 0);
            std::vector<double> removed(last.size());
            forEachVisit(run, [&](const Pass& pass, int k, const Visit& visit, double) {
                const std::size_t lane = std::size_t(pass.place.section) * K + std::size_t(k);
                RC_ASSERT(
                    (external ? visit.radius_mm <= last[lane] : visit.radius_mm >= last[lane]));
                RC_ASSERT(visit.accumulated_mm >= removed[lane]);
                last[lane] = visit.radius_mm;
                removed[lane] = visit.accumulated_mm;
            });
            for (std::size_t j = 0; j < run.result.sections.size(); ++j) {
                for (std::size_t k = 0; k < K; ++k) {
                    RC_ASSERT(run.result.sections[j].radii_mm[k] == last[j * K + k]);
                }
            }
        }));
    }

    // Conservation: what was cut is what is missing. Each addition to a depth rounds once.
    void removedMaterialIsTheDifferenceOfBlankAndPart() {
        QVERIFY(holds("Σa = initial − final radius", [] {
            const Traced run(anyCycle());
            const Blank blank = makeBlank(run.result.project.part);
            const double side = run.result.project.part.surface == Surface::external ? 1 : -1;
            const double passes = double(run.trajectory.passes.size());
            for (std::size_t j = 0; j < run.result.sections.size(); ++j) {
                double initial = 0, final = 0, cut = 0;
                for (std::size_t k = 0; k < blank.depth_mm.size(); ++k) {
                    initial += blank.firstTouchRadius_mm - side * blank.depth_mm[k];
                    final += run.result.sections[j].radii_mm[k];
                }
                for (const Pass& pass : run.passesOf(int(j))) {
                    for (int k = 0; k < run.trajectory.radii; ++k) {
                        cut += run.visit(pass, k).actual_mm;
                    }
                }
                const double K = double(blank.depth_mm.size());
                RC_ASSERT(
                    within(cut, side * (initial - final),
                           K * (radiusRounding_mm * K + rounding(programmed(run), passes * K))));
            }
        }));
    }

    // --- forces ----------------------------------------------------------------------------------

    // K1…K4 of the sources: S_ax/n (at most B) in strokes, the width in contact in plunge passes.
    void forceIsTheSourcesForEveryWidthOfCut() {
        QVERIFY(holds("P_y = K·a + K·√a", [] {
            const Traced run(anyCycle());
            const Project& p = run.result.project;
            const Law law(p);
            const ZoneLengths zones{p.wheel.width_mm - p.machine.overrun_entry_mm, 0,
                                    p.wheel.width_mm - p.machine.overrun_exit_mm};
            forEachVisit(run, [&](const Pass& pass, int, const Visit& visit, double) {
                double b = p.part.length_mm;
                if (pass.axialFeed_mm_min > 0) {
                    b = std::min(pass.axialFeed_mm_min / p.machine.work_speed_rpm,
                                 p.wheel.width_mm);
                } else if (p.operation == Operation::traverse) {
                    b = pass.place.zone == Zone::rz1 ? zones.rz1 : zones.rz2;
                }
                RC_ASSERT(close(pass.effectiveWidth_mm, b, 2 * fixtures::epsilon));
                RC_ASSERT(close(visit.normalForce_n, law.force(b, visit.actual_mm),
                                20 * fixtures::epsilon)); // some ten roundings on either side
            });
        }));
    }

    void peaksAreTheLargestForcesSeenAndWhereTheyWere() {
        QVERIFY(holds("peaks", [] {
            const Traced run(anyCycle());
            const SimulationResult& r = run.result;
            const ForceLaw law = forceLaw(r.project);
            double force = 0, power = 0, there = 0, powerThere = 0;
            std::vector<double> sections(r.sections.size());
            const auto same = [](const Place& a, const Place& b) {
                return a.zone == b.zone && a.step == b.step && a.section == b.section
                       && a.stage == b.stage && a.cycleCount == b.cycleCount
                       && a.revolution == b.revolution;
            };
            forEachVisit(run, [&](const Pass& pass, int, const Visit& visit, double) {
                const double Pz =
                    law.tangential(pass.effectiveWidth_mm, std::sqrt(visit.actual_mm));
                const double N = Pz * r.project.machine.wheel_speed_m_s;
                double& section = sections[std::size_t(pass.place.section)];
                section = std::max(section, visit.normalForce_n);
                force = std::max(force, visit.normalForce_n);
                power = std::max(power, N);
                if (same(pass.place, r.peakNormalForceAt)) {
                    there = std::max(there, visit.normalForce_n);
                }
                if (same(pass.place, r.peakPowerAt)) {
                    powerThere = std::max(powerThere, N);
                }
            });
            constexpr double few = 10 * fixtures::epsilon;
            RC_ASSERT(close(r.peakNormalForce_n, force, few));
            RC_ASSERT(close(there, force, few));
            RC_ASSERT(close(r.peakPower_w, power, few));
            RC_ASSERT(close(powerThere, power, few));
            for (std::size_t j = 0; j < sections.size(); ++j) {
                RC_ASSERT(close(r.sections[j].peakNormalForce_n, sections[j], few));
            }
        }));
    }

    // R_max − R_min = γ·(P_max − P_min) where every radius was in contact at the same t_П: the
    // difference of two balances.
    void runoutAfterAPassIsTheDifferenceOfTheDeflections() {
        long long checked = 0;
        QVERIFY(holds("runout = γ·ΔP", [&checked] {
            const Traced run(anyTraverse());
            for (const Pass& pass : run.trajectory.passes) {
                double low = 1e9, high = 0, least = 1e9, most = 0, fed = 1e9;
                for (int k = 0; k < run.trajectory.radii; ++k) {
                    const Visit& visit = run.visit(pass, k);
                    low = std::min(low, visit.radius_mm);
                    high = std::max(high, visit.radius_mm);
                    least = std::min(least, visit.actual_mm > 0 ? visit.normalForce_n : -1.0);
                    most = std::max(most, visit.normalForce_n);
                    fed = std::min(fed, visit.programmed_mm);
                }
                if (least > 0 && fed == run.visit(pass, run.trajectory.radii - 1).programmed_mm) {
                    ++checked;
                    RC_ASSERT(
                        within(high - low, gammaOf(run, pass) * (most - least), 2 * balance_mm));
                }
            }
        }));
        QVERIFY(checked > 1000);
    }

    // --- closed forms and limits -----------------------------------------------------------------

    // η = 0, round blank, radius K − 1: a_m = f·(1 − r^m), r = γbk_s/(1 + γbk_s); the lag is
    // γ·P_y(f)·(1 − r^m); spark-out goes on with r^j.
    void sharpWheelFollowsTheGeometricLaw() {
        QVERIFY(holds("η = 0", [] {
            Project p = anyPlunge();
            p.wheel.dullness = 0;
            p.part.profile = ProfileForm::lobes; // R_k = R_max exactly when ΔR = 0
            p.part.initial_runout_mm = 0;
            p.gauge.control = Control::position;
            const int feeding = pick(1, 80), sparking = pick(1, 40);
            const double f = between(0.0005, 0.01);
            p.part.stock_mm = f * feeding;
            p.cycle.stages = {fixtures::plungeStage(f * p.machine.work_speed_rpm, p.part.stock_mm),
                              fixtures::sparkStage(fixtures::count(sparking))};
            const Traced run(p);
            RC_ASSERT(run.result.countsByStage == (std::vector{feeding, sparking}));
            for (std::size_t j = 0; j < run.result.sections.size(); ++j) {
                const double gbks =
                    run.result.sections[j].compliance_mm_per_n * p.part.length_mm * Law(p).ks;
                const double r = gbks / (1 + gbks);
                const auto passes = run.passesOf(int(j));
                // Errors of t_П and depth come back as deflection and fade with r: 1/(1 − r) sums
                // them up.
                const double off = rounding(p.part.stock_mm, feeding + sparking) / (1 - r);
                for (int m = 1; m <= feeding + sparking; ++m) {
                    const Visit& v =
                        run.visit(passes[std::size_t(m) - 1], run.trajectory.radii - 1);
                    const double lag = v.programmed_mm - v.accumulated_mm;
                    const double steady = gbks * f;
                    const double rise = 1 - std::pow(r, std::min(m, feeding));
                    const double fall = std::pow(r, std::max(0, m - feeding));
                    RC_ASSERT(within(lag, steady * rise * fall, off));
                    const double a = m <= feeding
                                         ? f * rise
                                         : steady * rise * (1 - r) * std::pow(r, m - feeding - 1);
                    RC_ASSERT(within(v.actual_mm, a, 2 * off));
                }
            }
        }));
    }

    // a = h − γ·P_y(a) ≥ h − γ·P_y(h), and a ≤ h
    void rigidSystemCutsAllOfTheInfeedAtOnce() {
        QVERIFY(holds("γ → 0", [] {
            Project p = anyPlunge();
            const double gamma = decades(-18, -9);
            p.machine.compliance_mm_per_n = std::vector<double>(std::size_t(p.sections), gamma);
            const Traced run(p);
            const double most = Law(p).force(p.part.length_mm, programmed(run));
            const double passes = double(run.trajectory.passes.size());
            forEachVisit(run, [&](const Pass&, int, const Visit& v, double blank) {
                const double reached = std::max(v.programmed_mm, blank);
                RC_ASSERT(within(blank + v.accumulated_mm, reached,
                                 gamma * most + rounding(v.programmed_mm, passes)));
            });
        }));
    }

    // A ≥ 1 + γ·b·k_s and C ≥ 0 alone give a ≤ h/(1 + γbk_s), and with friction a ≤ (h/γbk_r)².
    void softSystemCutsNextToNothing() {
        QVERIFY(holds("γ → ∞", [] {
            Project p = anyPlunge();
            p.gauge.control = Control::position; // a gauge would wait too long
            const double gamma = decades(-2, 0);
            p.machine.compliance_mm_per_n = std::vector<double>(std::size_t(p.sections), gamma);
            const Traced run(p);
            const Law law(p);
            const double b = p.part.length_mm;
            forEachVisit(run, [&](const Pass&, int, const Visit& v, double blank) {
                const double h = v.programmed_mm - blank - v.accumulated_mm + v.actual_mm;
                if (v.actual_mm > 0) {
                    const double off =
                        4 * fixtures::epsilon * v.programmed_mm; // of h, as formed here
                    // Without friction this is an equality; the kernel rounds √a four times.
                    RC_ASSERT(v.actual_mm <= (h + off) / (1 + gamma * b * law.ks)
                                                 * (1 + 8 * fixtures::epsilon));
                    // ε·C/A is the kernel's stated bound for √a
                    const double slip = fixtures::epsilon * law.kr / law.ks;
                    const double most =
                        (h + off) / (gamma * b * law.kr); // of √a; infinite without friction
                    RC_ASSERT(
                        (law.kr == 0 || std::sqrt(v.actual_mm) <= most * (1 + 1e-14) + 2 * slip));
                }
            });
        }));
    }

    // b·s and γ/s: A and C stay as they are. To the last bit for a power of two; forces times s.
    void widerCutOfAStifferSystemIsTheSameCut() {
        QVERIFY(holds("b·s, γ/s", [] {
            const Project p = anyPlunge();
            Project wide = p;
            const double s = std::ldexp(1.0, pick(-3, 6));
            wide.part.length_mm *= s;
            wide.wheel.width_mm *= s;
            for (double& gamma : std::get<std::vector<double>>(wide.machine.compliance_mm_per_n)) {
                gamma /= s;
            }
            const SimulationResult a = simulate(p);
            const SimulationResult b = simulate(wide);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            for (std::size_t j = 0; j < a.sections.size(); ++j) {
                RC_ASSERT(a.sections[j].radii_mm == b.sections[j].radii_mm);
                RC_ASSERT(b.sections[j].peakNormalForce_n == s * a.sections[j].peakNormalForce_n);
            }
        }));
    }

    // D_e → d as D → ∞ outside: so does the cycle, with the force's share d/D.
    void endlessWheelGrindsAsItsEquivalentDiameterSays() {
        QVERIFY(holds("D_e → d", [] {
            const double d = between(1, 2000), D = decades(0, 12);
            const double De = equivalentDiameter(d, D, Surface::external);
            RC_ASSERT((De > 0 && De < d && De < D));
            RC_ASSERT(within(d - De, d * De / D, 4 * fixtures::epsilon * d));
        }));
    }

    // --- one radius, one section, one run at a time ----------------------------------------------

    void sameProjectGivesTheSameBitsWithAndWithoutATrajectory() {
        QVERIFY(holds("determinism", [] {
            const Project p = anyCycle();
            const SimulationResult first = simulate(p);
            RC_ASSERT(fixtures::sameBits(first, simulate(p)));
            RC_ASSERT(fixtures::sameBits(first, Traced(p).result));
        }));
    }

    // Whatever becomes of the others, a section goes its own way as long as the gauge's does.
    void sectionsDoNotFeelEachOther() {
        QVERIFY(holds("sections independent", [] {
            const Project p = anyPlunge(2);
            Project changed = p;
            auto& gammas = std::get<std::vector<double>>(changed.machine.compliance_mm_per_n);
            const int other = (*p.gauge.section + pick(1, p.sections)) % p.sections;
            gammas[std::size_t(other)] = decades(-6, -4);
            const SimulationResult a = simulate(p);
            const SimulationResult b = simulate(changed);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(a.gaugeReading_mm == b.gaugeReading_mm);
            for (int j = 0; j < p.sections; ++j) {
                if (j != other) {
                    RC_ASSERT(a.sections[std::size_t(j)].radii_mm
                              == b.sections[std::size_t(j)].radii_mm);
                }
            }
        }));
    }

    void zonesDoNotFeelEachOther() {
        QVERIFY(holds("zones independent", [] {
            const Project p = anyTraverse();
            Project changed = p;
            std::get<ZoneCompliance>(changed.machine.compliance_mm_per_n).rz1 = decades(-6, -3.7);
            changed.machine.dwell_entry_s = between(0, 1);
            const SimulationResult a = simulate(p);
            const SimulationResult b = simulate(changed);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(a.sections[1].radii_mm == b.sections[1].radii_mm);
            RC_ASSERT(a.sections[2].radii_mm == b.sections[2].radii_mm);
        }));
    }

    // The balance makes the depth after a pass rise with the depth before it and with t_П, and one
    // more pass never lowers it.
    void longerDwellRemovesMoreInTheReversalZone() {
        QVERIFY(holds("dwell", [] {
            const Project p = anyTraverse();
            Project longer = p;
            longer.machine.dwell_entry_s += between(0, 1);
            longer.machine.dwell_exit_s += between(0, 1);
            const SimulationResult a = simulate(p);
            const SimulationResult b = simulate(longer);
            const double passes = double(b.visits) / double(p.part.radii_per_section);
            const double off = rounding(0.5, passes) + radiusRounding_mm;
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(b.time_s >= a.time_s);
            for (const std::size_t zone : {std::size_t(0), std::size_t(2)}) {
                for (std::size_t k = 0; k < a.sections[zone].radii_mm.size(); ++k) {
                    RC_ASSERT(b.sections[zone].radii_mm[k] <= a.sections[zone].radii_mm[k] + off);
                }
            }
        }));
    }

    // MODEL-9: by the balance the softer section ends larger (a bore: smaller).
    void softerSectionKeepsMoreStock() {
        QVERIFY(holds("softer", [] {
            const Traced run(anyPlunge());
            const double side = run.result.project.part.surface == Surface::external ? 1 : -1;
            const double off =
                rounding(programmed(run), double(run.trajectory.passes.size())) + radiusRounding_mm;
            for (const SectionResult& soft : run.result.sections) {
                for (const SectionResult& stiff : run.result.sections) {
                    for (std::size_t k = 0; k < soft.radii_mm.size(); ++k) {
                        RC_ASSERT((soft.compliance_mm_per_n < stiff.compliance_mm_per_n
                                   || side * (soft.radii_mm[k] - stiff.radii_mm[k]) >= -off));
                    }
                }
            }
        }));
    }

    // A bore and a shaft with the same depths of blank and the same D_e are one cycle; min and max
    // of the gauge's rule change places with the surface. D_e is the same to a few ε only, which
    // changes the depths by as little.
    void boreIsGroundAsItsMirroredShaft() {
        QVERIFY(holds("mirror", [] {
            Project shaft = anyPlunge();
            shaft.part.surface = Surface::external;
            shaft.part.diameter_mm = between(25, 130);
            shaft.part.profile = ProfileForm::measured;
            shaft.part.radii_um.emplace();
            for (int k = 0; k < shaft.part.radii_per_section; ++k) {
                shaft.part.radii_um->push_back(pick(-40, 1));
            }
            const double d = shaft.part.diameter_mm;
            const double De = d * between(0.2, 0.8);
            shaft.wheel.diameter_mm = d * De / (d - De);
            Project bore = shaft;
            bore.part.surface = Surface::internal;
            bore.wheel.diameter_mm = d * De / (d + De);
            for (double& deviation : *bore.part.radii_um) {
                deviation = -deviation;
            }
            const SimulationResult a = simulate(shaft);
            const SimulationResult b = simulate(bore);
            const double target = targetRadius(shaft.part);
            RC_ASSERT(a.countsByStage == b.countsByStage);
            RC_ASSERT(within(a.remainingStock_mm, b.remainingStock_mm, balance_mm));
            for (std::size_t j = 0; j < a.sections.size(); ++j) {
                for (std::size_t k = 0; k < a.sections[j].radii_mm.size(); ++k) {
                    RC_ASSERT(within(a.sections[j].radii_mm[k] - target,
                                     target - b.sections[j].radii_mm[k], balance_mm));
                }
            }
        }));
    }

    // --- control ---------------------------------------------------------------------------------

    // Under position control the feed ends where the stocks say, to the rounding of the sum of its
    // steps; a step shorter than the 1e-9 mm of every threshold [MODEL-7] is not made. Nothing is
    // cut past the end.
    void positionControlEndsExactlyAtTheTotalInfeed() {
        QVERIFY(holds("position control", [] {
            Project p = anyCycle();
            p.gauge.control = Control::position;
            double sum = 0;
            for (Stage& stage : p.cycle.stages) {
                if (stage.spark_out.mode != SparkOut::Mode::none) {
                    stage.stock_mm = 0;
                }
                sum += stage.stock_mm;
            }
            p.part.stock_mm = sum;
            const Traced run(p);
            const Blank blank = makeBlank(p.part);
            RC_ASSERT(run.result.status == RunStatus::completed);
            const double off = rounding(blank.totalInfeed_mm, double(run.trajectory.passes.size()));
            const double left = blank.totalInfeed_mm - programmed(run);
            RC_ASSERT(left >= -off);
            RC_ASSERT(left <= threshold_mm + off);
            RC_ASSERT(run.result.remainingStock_mm >= -off);
        }));
    }

    // Step by step: a stage goes on while its threshold is not reached, and ends as soon as it is.
    // Thresholds carry 1e-9 mm; the readings here come from rounded radii.
    void everyStageRunsUntilItsThresholdAndNotOneStepLonger() {
        QVERIFY(holds("stages", [] {
            Project p = anyCycle();
            p.gauge.control = Control::gauge;
            const Traced run(p);
            const int gauged = p.operation == Operation::traverse ? 1 : *p.gauge.section;
            const std::size_t stages = p.cycle.stages.size();
            std::vector<double> later(stages + 1), readings;
            std::vector<int> stageOf, counts(stages);
            for (std::size_t z = stages; z-- > 0;) {
                later[z] = z + 1 == stages ? 0 : later[z + 1] + p.cycle.stages[z + 1].stock_mm;
            }
            for (const Pass& pass : run.passesOf(gauged)) {
                const std::size_t step = std::size_t(pass.place.cycleCount);
                readings.resize(step);
                stageOf.resize(step);
                std::vector<double> R;
                for (int k = 0; k < run.trajectory.radii; ++k) {
                    R.push_back(run.visit(pass, k).radius_mm);
                }
                readings[step - 1] = remaining(p, R);
                stageOf[step - 1] = pass.place.stage - 1;
            }
            constexpr double off = 4 * radiusRounding_mm;
            for (std::size_t step = 0; step < readings.size(); ++step) {
                const std::size_t z = std::size_t(stageOf[step]);
                const std::size_t next =
                    step + 1 < readings.size() ? std::size_t(stageOf[step + 1]) : stages;
                ++counts[z];
                RC_ASSERT(next >= z);
                for (std::size_t ended = z; ended < next; ++ended) {
                    const SparkOut& spark = p.cycle.stages[ended].spark_out;
                    const bool ends = spark.mode == SparkOut::Mode::count
                                          ? counts[ended] == spark.count
                                          : readings[step] <= later[ended] + threshold_mm + off;
                    RC_ASSERT(ends);
                }
                if (next < stages && p.cycle.stages[next].spark_out.mode == SparkOut::Mode::none) {
                    RC_ASSERT(readings[step] > later[next] + threshold_mm - off);
                }
            }
            RC_ASSERT(run.result.status == RunStatus::completed);
            RC_ASSERT(run.result.countsByStage == counts);
            RC_ASSERT(within(run.result.remainingStock_mm, readings.back(), off));
        }));
    }

    // The reading before the last step was above size, so what lies below size was cut in that
    // step.
    void overshootIsLessThanWhatTheLastStepCut() {
        QVERIFY(holds("overshoot", [] {
            Project p = anyCycle();
            p.gauge.control = Control::gauge;
            p.cycle.stages.back().spark_out = {};
            const Traced run(p);
            const int gauged = p.operation == Operation::traverse ? 1 : *p.gauge.section;
            std::vector<double> cut(std::size_t(run.trajectory.radii));
            for (const Pass& pass : run.passesOf(gauged)) {
                if (pass.place.cycleCount == run.result.cycleCount) {
                    for (int k = 0; k < run.trajectory.radii; ++k) {
                        cut[std::size_t(k)] += run.visit(pass, k).actual_mm;
                    }
                }
            }
            const double most = *std::max_element(cut.begin(), cut.end());
            RC_ASSERT(run.result.remainingStock_mm <= 1e-9);
            RC_ASSERT(run.result.remainingStock_mm > -most);
        }));
    }

    // --- bookkeeping -----------------------------------------------------------------------------

    void resultAddsUp() {
        QVERIFY(holds("sums", [] {
            const Traced run(anyCycle());
            const SimulationResult& r = run.result;
            const Project& p = r.project;
            RC_ASSERT(std::accumulate(r.countsByStage.begin(), r.countsByStage.end(), 0)
                      == r.cycleCount);
            const double time =
                std::accumulate(r.timeByStage_s.begin(), r.timeByStage_s.end(), 0.0);
            const double passes = double(run.trajectory.passes.size());
            RC_ASSERT(close(time, r.time_s, fixtures::epsilon * passes));
            RC_ASSERT(r.visits == static_cast<long long>(run.trajectory.visits.size()));
            RC_ASSERT(run.trajectory.visits.size()
                      == run.trajectory.passes.size() * std::size_t(run.trajectory.radii));
            const int gauged = p.operation == Operation::traverse ? 1 : *p.gauge.section;
            RC_ASSERT(within(r.remainingStock_mm,
                             remaining(p, r.sections[std::size_t(gauged)].radii_mm),
                             4 * radiusRounding_mm));
            const double side = p.part.surface == Surface::external ? 1 : -1;
            RC_ASSERT(within(r.gaugeReading_mm / 2,
                             targetRadius(p.part) + side * r.remainingStock_mm, radiusRounding_mm));
            double last = 0;
            for (const Visit& visit : run.trajectory.visits) {
                last = std::max(last, visit.time_s);
            }
            RC_ASSERT(last <= r.time_s * (1 + fixtures::epsilon * passes));
        }));
    }

    // MODEL-7: deviations of all diameters, runout about the axis plus the machine's own.
    void sectionsAreMeasuredAsTheDrawingSays() {
        QVERIFY(holds("measures", [] {
            Project p = anyCycle();
            p.machine.geometric_runout_um = oneIn(2) ? 0 : between(0, 5);
            for (const SectionResult& s : simulate(p).sections) {
                const std::size_t K = s.radii_mm.size();
                double low = 1e9, high = 0;
                for (std::size_t k = 0; k < K; ++k) {
                    const double D = s.radii_mm[k] + s.radii_mm[(k + K / 2) % K];
                    low = std::min(low, D);
                    high = std::max(high, D);
                }
                const auto [least, most] =
                    std::minmax_element(s.radii_mm.begin(), s.radii_mm.end());
                RC_ASSERT(s.diameterDeviationMin_mm == low - p.part.diameter_mm);
                RC_ASSERT(s.diameterDeviationMax_mm == high - p.part.diameter_mm);
                RC_ASSERT(within(s.radialRunout_mm,
                                 *most - *least + p.machine.geometric_runout_um / 1000,
                                 4 * fixtures::epsilon));
            }
        }));
    }
};

} // namespace test_model_properties

SPARKOUT_TEST(test_model_properties, TestModelProperties)
#include "test_model_properties.moc"
