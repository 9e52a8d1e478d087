// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of MODEL-2…7 and 11 on the balance, the forces and their limits, held against random
// cycles: 10,000 each, see rapidcheck_runs.h.
#include "tests/check_line.h"
#include "tests/core/simulation/random_cycles.h"
#include "tests/registry.h"

namespace sparkout::test_model_properties {

using namespace random_cycles;

class TestModelProperties : public QObject {
    Q_OBJECT

    HeldFunctions m_held;

private slots:
    void cleanup() {
        m_held.count();
        const std::string law = QTest::currentTestFunction();
        if (law == "removedMaterialIsTheDifferenceOfBlankAndPart"
            || law == "everyCutBalancesInfeedAgainstRemovalAndDeflection") {
            const int cycles = qgetenv("RC_PARAMS").split('=').last().toInt();
            checkLine("13", cycles, asked(10'000, cycles),
                      !QTest::currentTestFailed() && cycles >= asked(10'000, cycles),
                      QStringLiteral("random cycles: ") + QString::fromStdString(law));
        }
    }
    void cleanupTestCase() {
        m_held.print("14", QStringLiteral("laws of single cuts and passes, each on %1 random ones")
                               .arg(QString::fromUtf8(qgetenv("RC_PARAMS").split('=').last())));
    }

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
            const bool external = run.result.project.part->surface == Surface::external;
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
            const Blank blank = makeBlank(*run.result.project.part);
            const double side = run.result.project.part->surface == Surface::external ? 1 : -1;
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
            const ZoneLengths zones{p.wheel->width_mm - p.machine->overrun_entry_mm, 0,
                                    p.wheel->width_mm - p.machine->overrun_exit_mm};
            forEachVisit(run, [&](const Pass& pass, int, const Visit& visit, double) {
                double b = p.part->length_mm;
                if (pass.axialFeed_mm_min > 0) {
                    b = std::min(pass.axialFeed_mm_min / p.machine->work_speed_rpm,
                                 p.wheel->width_mm);
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
                const double N = Pz * r.project.machine->wheel_speed_m_s;
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
            p.wheel->dullness = 0;
            p.part->profile = ProfileForm::lobes; // R_k = R_max exactly when ΔR = 0
            p.part->initial_runout_mm = 0;
            p.gauge->control = Control::position;
            const int feeding = pick(1, 80), sparking = pick(1, 40);
            const double f = between(0.0005, 0.01);
            p.part->stock_mm = f * feeding;
            p.cycle->stages = {
                fixtures::plungeStage(f * p.machine->work_speed_rpm, p.part->stock_mm),
                fixtures::sparkStage(fixtures::count(sparking))};
            const Traced run(p);
            RC_ASSERT(run.result.countsByStage == (std::vector{feeding, sparking}));
            for (std::size_t j = 0; j < run.result.sections.size(); ++j) {
                const double gbks =
                    run.result.sections[j].compliance_mm_per_n * p.part->length_mm * Law(p).ks;
                const double r = gbks / (1 + gbks);
                const auto passes = run.passesOf(int(j));
                // Errors of t_П and depth come back as deflection and fade with r: 1/(1 − r) sums
                // them up.
                const double off = rounding(p.part->stock_mm, feeding + sparking) / (1 - r);
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
            p.machine->compliance_mm_per_n = std::vector<double>(std::size_t(p.sections), gamma);
            const Traced run(p);
            const double most = Law(p).force(p.part->length_mm, programmed(run));
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
            p.gauge->control = Control::position; // a gauge would wait too long
            const double gamma = decades(-2, 0);
            p.machine->compliance_mm_per_n = std::vector<double>(std::size_t(p.sections), gamma);
            const Traced run(p);
            const Law law(p);
            const double b = p.part->length_mm;
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
            wide.part->length_mm *= s;
            wide.wheel->width_mm *= s;
            for (double& gamma : std::get<std::vector<double>>(wide.machine->compliance_mm_per_n)) {
                gamma /= s;
            }
            const SimulationResult a = simulateUnchecked(p);
            const SimulationResult b = simulateUnchecked(wide);
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
};

} // namespace sparkout::test_model_properties

SPARKOUT_TEST(test_model_properties, TestModelProperties)
#include "test_model_properties.moc"
