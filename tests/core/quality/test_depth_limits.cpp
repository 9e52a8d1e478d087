// SPDX-License-Identifier: GPL-3.0-or-later
// Roughness, self-sharpening and power: what limits the depth of cut beside burn [MODEL-8].
#include "core/quality/limit_series.h"
#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

namespace sparkout::test_depth_limits {

using fixtures::anyCutting;
using fixtures::between;
using fixtures::close;
using fixtures::decades;
using fixtures::holds;
using fixtures::Law;
using fixtures::within;

/// Strengths like those of the handbooks (MODEL-8).
void giveStrengths(Wheel& wheel) {
    wheel.grain_surface_energy_j_m2 = 18;
    wheel.grain_modulus_gpa = 390;
    wheel.bond_surface_energy_j_m2 = 4;
    wheel.bond_modulus_gpa = 65;
}

Project anyWheel() {
    Project p = anyCutting();
    p.wheel->grain_surface_energy_j_m2 = decades(0, 5);
    p.wheel->grain_modulus_gpa = between(50, 900);
    p.wheel->bond_surface_energy_j_m2 = decades(0, 5);
    p.wheel->bond_modulus_gpa = between(10, 300);
    return p;
}

/// Isakov's formula as it is printed, in mm and min, for external grinding.
double isakov(const Project& p, double a) {
    const double d = p.part->diameter_mm, D = p.wheel->diameter_mm, n = p.machine->work_speed_rpm;
    const double Vk = p.machine->wheel_speed_m_s * 60e3, eta = p.wheel->dullness;
    const double Ns = 0.5 * (62 - 100 * p.wheel->grain_share);
    const double phi = p.wheel->grain_tip_angle_deg * std::numbers::pi / 180;
    const double pi2 = std::numbers::pi * std::numbers::pi;
    const double opened =
        std::sqrt(eta + pi2 / Vk * std::sqrt(d * (d + D) * n * (a * n) / D)) - std::sqrt(eta);
    return p.wheel->roughness_factor * 0.2
           * std::pow(p.wheel->grain_mm / std::tan(phi)
                          * std::sqrt(p.wheel->dressing_chipping_mm / (4 * Ns)) * opened,
                      2.0 / 3);
}

class TestDepthLimits : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(2000); }

    // --- the width in contact --------------------------------------------------------------------

    void theWidthOfADwellIsThatOfItsOwnZone() {
        Project p = fixtures::traverse();
        p.machine->overrun_entry_mm = 12;
        p.machine->overrun_exit_mm = 4;
        const double B = p.wheel->width_mm;
        Place place;
        place.stage = 1;
        place.zone = Zone::rz1;
        for (const Step step : {Step::e1, Step::e2, Step::e5}) {
            place.step = step;
            QCOMPARE(effectiveWidth(p, place), B - 12);
        }
        place.zone = Zone::rz2;
        place.step = Step::e2;
        QCOMPARE(effectiveWidth(p, place), B - 4);
        const double stroke = 1800 / p.machine->work_speed_rpm;
        for (const auto& [zone, step] :
             {std::pair{Zone::rz1, Step::e3}, std::pair{Zone::nz, Step::e2},
              std::pair{Zone::rz2, Step::e1}, std::pair{Zone::rz2, Step::e3}}) {
            place.zone = zone;
            place.step = step;
            QVERIFY(close(effectiveWidth(p, place), stroke, 1e-15));
        }
    }

    // --- roughness -------------------------------------------------------------------------------

    void roughnessIsIsakovsFormula() {
        QVERIFY(holds("printed form", [] {
            Project p = anyCutting();
            p.part->surface = Surface::external;
            p.wheel->diameter_mm = between(100, 900);
            p.wheel->dullness = between(0, 0.02); // the printed difference loses digits beyond
            const double a = decades(-4, -1);
            RC_ASSERT(close(RoughnessModel(p).roughness(a), isakov(p, a), 1e-9));
        }));
    }

    // MODEL-8: as published it tends to be low, 0.07…0.16 µm at 0.5…5 µm per revolution.
    void roughnessAsPublishedIsInTheRangeTheModelStates() {
        const RoughnessModel model(Project{}, 1);
        QVERIFY(within(model.roughness(0.0005) * 1000, 0.07, 0.005));
        QVERIFY(within(model.roughness(0.005) * 1000, 0.16, 0.005));
    }

    // A sharp wheel: Ra ~ a^(1/6); a dull one, the root linear: Ra ~ a^(1/3).
    void roughnessGrowsBetweenTheSixthAndTheThirdRootOfTheDepth() {
        QVERIFY(holds("powers", [] {
            const RoughnessModel model(anyCutting());
            const double a = decades(-6, -1);
            const double ratio = model.roughness(64 * a) / model.roughness(a);
            RC_ASSERT(ratio > 2 * (1 - 1e-13) && ratio < 4 * (1 + 1e-13));
            RC_ASSERT(model.roughness(0) == 0);
        }));
        Project p = fixtures::plunge();
        p.wheel->dullness = 0;
        const RoughnessModel sharp(p);
        QVERIFY(close(sharp.roughness(0.0064), 2 * sharp.roughness(0.0001), 1e-14));
        p.wheel->dullness = 1;
        const RoughnessModel dull(p);
        QVERIFY(close(dull.roughness(64e-9), 4 * dull.roughness(1e-9), 1e-4));
    }

    void depthForARoughnessLeavesIt() {
        QVERIFY(holds("inversion", [] {
            const RoughnessModel model(anyCutting());
            const double Ra = decades(-5, -2);
            const double a = model.limitDepth(Ra);
            RC_ASSERT(close(model.roughness(a), Ra, 1e-12));
            RC_ASSERT(model.limitDepth(Ra * 1.001) > a);
        }));
    }

    // Every length c times, speeds c times: the roughness is c times; the calibration multiplies.
    void roughnessIsALengthAndCalibratedByAFactor() {
        QVERIFY(holds("scaling", [] {
            Project p = anyCutting();
            const double a = decades(-5, -2), c = between(0.2, 5);
            const double Ra = RoughnessModel(p).roughness(a);
            p.part->diameter_mm *= c;
            p.wheel->diameter_mm *= c;
            p.machine->wheel_speed_m_s *= c;
            p.wheel->grain_mm *= c;
            p.wheel->dressing_chipping_mm *= c;
            RC_ASSERT(close(RoughnessModel(p).roughness(c * a), c * Ra, 1e-13));
            p.wheel->roughness_factor *= 3;
            RC_ASSERT(close(RoughnessModel(p).roughness(c * a), 3 * c * Ra, 1e-13));
        }));
    }

    // Written a second time: Ra·(½ + ½·exp(−t/τ)), τ = 2·T·h/a.
    void roughnessFallsTowardsARestAndNeverToNothing() {
        QVERIFY(holds("spark-out", [] {
            const RoughnessModel model(anyCutting());
            const double a = decades(-5, -2), h = a * between(1, 50), T = decades(-1, 2);
            const auto left = [&](double t) {
                return model.roughness(
                    {.depth_mm = a, .pressed_mm = h, .step_s = T, .sparkOut_s = t, .at = {}});
            };
            const double straight = model.roughness(a), t = T * decades(-2, 2);
            RC_ASSERT(left(0) == straight);
            RC_ASSERT(close(left(1e-12 * T), straight, 1e-10)); // no jump at the end of the infeed
            RC_ASSERT(close(left(t), straight / 2 * (1 + std::exp(-t * a / (2 * T * h))), 1e-12));
            RC_ASSERT(left(1.1 * t) < left(t) || close(left(t), straight / 2, 1e-12));
            RC_ASSERT(left(t) >= straight / 2 && close(left(1e6 * T), straight / 2, 1e-12));
            // The bound of a limit holds for any spark-out.
            RC_ASSERT(model.mostDepth(left(t)) >= a * (1 - 1e-12));
        }));
    }

    // τ is no less than twice the time constant of the deflection, which a force in proportion to
    // the depth has: x = γ·b·K, −1/ln(x/(1 + x)) steps.
    void roughnessFallsNoFasterThanHalfTheDeflection() {
        for (const double x : {0.01, 0.3, 1.0, 7.0, 100.0}) {
            const double a = 1e-3, h = (1 + x) * a; // a and the lag x·a that it leaves
            const double constant = -1 / std::log(x / (1 + x));
            QVERIFY(2 * h / a >= 2 * constant);
        }
    }

    void factorThatIsNotMeasuredIsARange() {
        Project p = fixtures::plunge();
        QVERIFY(!isRoughnessCalibrated(p));
        const RoughnessFactor estimate = roughnessFactor(p);
        QVERIFY(!estimate.isMeasured() && close(estimate.most / estimate.least, 3, 1e-12));
        const double Ra = RoughnessModel(p, 1).roughness(0.002);
        QVERIFY(close(RoughnessModel(p).roughness(0.002), estimate.least * Ra, 1e-14));
        p.wheel->roughness_factor = 2.5;
        QVERIFY(isRoughnessCalibrated(p) && roughnessFactor(p).isMeasured());
        QVERIFY(close(RoughnessModel(p).roughness(0.002), 2.5 * Ra, 1e-14));
    }

    // What is measured behind an infeed and a spark-out comes out of them again.
    void measuredRaSetsTheFactor() {
        Project p = fixtures::plunge();
        p.part->initial_runout_mm = 0; // every radius loses the same
        p.part->tolerance.roughness_ra_um = 0.8;
        p.cycle->stages = {fixtures::plungeStage(0.9, 0.1), fixtures::plungeStage(0.18, 0.1),
                           fixtures::sparkStage(fixtures::count(8))};
        p.wheel->measured_ra = MeasuredRa{0.6, {}, {}};
        QVERIFY(isRoughnessCalibrated(p));
        const double factor = factorOfMeasuredRa(p).value();
        QCOMPARE(roughnessFactor(p).least, factor);
        const SimulationResult result = simulateUnchecked(p);
        const double left_um = RoughnessModel(p).roughness(*result.sections[0].lastCut) * 1000;
        QVERIFY2(close(left_um, 0.6, 1e-3), qPrintable(QString::number(left_um)));
        p.wheel->measured_ra = MeasuredRa{0.6, 1.0, 8}; // the same, said
        QVERIFY(close(factorOfMeasuredRa(p).value(), factor, 1e-12));
        p.wheel->measured_ra->spark_out_steps = 0;
        QVERIFY(close(RoughnessModel(p, factorOfMeasuredRa(p).value()).roughness(0.001) * 1000, 0.6,
                      1e-12));
        // As its own the factor stays when the wheel dulls.
        const Project settled = withMeasuredRa(p);
        Project dull = settled;
        dull.wheel->dullness *= 3;
        QCOMPARE(roughnessFactor(dull).least, factorOfMeasuredRa(p).value());
        p.wheel->roughness_factor = 2.5; // given beside it: it counts
        QCOMPARE(roughnessFactor(withMeasuredRa(p)).least, 2.5);
        p.wheel->width_mm = 1; // an error
        QVERIFY(!factorOfMeasuredRa(p));
    }

    // --- self-sharpening -------------------------------------------------------------------------

    void selfSharpeningIsOffUntilEveryStrengthIsGiven() {
        Project p = fixtures::plunge();
        giveStrengths(*p.wheel);
        QVERIFY(selfSharpening(p));
        for (auto strength : {&Wheel::grain_surface_energy_j_m2, &Wheel::grain_modulus_gpa,
                              &Wheel::bond_surface_energy_j_m2, &Wheel::bond_modulus_gpa}) {
            Project without = p;
            ((*without.wheel).*strength).reset();
            QVERIFY(!selfSharpening(without));
            QVERIFY(!selfSharpeningSheet(without));
        }
        QVERIFY(!selfSharpening(Project{}));
    }

    // shared/vectors: f_b = f_g gives 0.63212·f_g
    void equalStrengthsGiveTheVectorsShare() {
        Project p = fixtures::plunge();
        giveStrengths(*p.wheel);
        const SelfSharpening unequal = *selfSharpening(p);
        const double factor = unequal.grainForce_n / unequal.bondForce_n;
        *p.wheel->bond_modulus_gpa *= factor * factor;
        const SelfSharpening s = *selfSharpening(p);
        QVERIFY(close(s.bondForce_n, s.grainForce_n, 1e-14));
        QVERIFY(within(s.criticalForce_n / s.grainForce_n, 0.63212, 0.5e-5));
    }

    // A weak bond: the grains fall out, f_cr = f_b; a strong one: they break, f_cr = f_g.
    void weakerOfGrainAndBondDecides() {
        QVERIFY(holds("limits", [] {
            Project p = anyWheel();
            const SelfSharpening s = *selfSharpening(p);
            RC_ASSERT(s.criticalForce_n <= std::min(s.grainForce_n, s.bondForce_n));
            RC_ASSERT(s.criticalForce_n >= 0.63 * std::min(s.grainForce_n, s.bondForce_n));
            const double ratio = s.bondForce_n / s.grainForce_n;
            *p.wheel->bond_modulus_gpa *= std::pow(1e-6 / ratio, 2);
            const SelfSharpening weak = *selfSharpening(p);
            RC_ASSERT(close(weak.criticalForce_n, weak.bondForce_n, 1e-6));
            *p.wheel->bond_modulus_gpa *= std::pow(40e6, 2);
            const SelfSharpening strong = *selfSharpening(p);
            RC_ASSERT(close(strong.criticalForce_n, strong.grainForce_n, 1e-15));
        }));
    }

    // MODEL-8: with the crack length d_g/2 for the bond too, f_b/f_g = √(γ_bE_b/(γ_gE_g))·S_b/d_g²:
    // 001 eq. 23. The bond's crack is D_b/1.7.
    void exponentIsThePrintedOneButForTheBondsCrack() {
        QVERIFY(holds("001 eq. 23", [] {
            Project p = anyWheel();
            const double dg = p.wheel->grain_mm, Wg = p.wheel->grain_share,
                         Wb = p.wheel->bond_share;
            const double gammaE_b = *p.wheel->bond_surface_energy_j_m2 * *p.wheel->bond_modulus_gpa;
            const double gammaE_g =
                *p.wheel->grain_surface_energy_j_m2 * *p.wheel->grain_modulus_gpa;
            const double exponent = std::sqrt(gammaE_b / gammaE_g) * Wb
                                    / (3 * std::pow(Wg, 2.0 / 3) * (1 - std::pow(Wg, 1.0 / 3)));
            const SelfSharpening s = *selfSharpening(p);
            RC_ASSERT(close(s.grainForce_n, dg * dg * std::sqrt(2 * gammaE_g / dg), 1e-12));
            const double crack = s.bridge_mm / 1.7 / (dg / 2);
            RC_ASSERT(close(s.bondForce_n * std::sqrt(crack), s.grainForce_n * exponent, 1e-12));
        }));
    }

    void givenGrainsAndBridgeStandForTheLattices() {
        Project p = fixtures::plunge();
        giveStrengths(*p.wheel);
        const SelfSharpening lattice = *selfSharpening(p);
        p.wheel->grains_per_mm2 = lattice.grains_mm2;
        p.wheel->bond_bridge_mm = lattice.bridge_mm;
        QVERIFY(close(selfSharpening(p)->allowed, lattice.allowed, 1e-15));
        *p.wheel->grains_per_mm2 *= 2;
        QVERIFY(close(selfSharpening(p)->allowed, 2 * lattice.allowed, 1e-14));
        *p.wheel->bond_bridge_mm *= 4; // S_b·√(1/D_b) = π/4·D_b^(3/2)
        QVERIFY(close(selfSharpening(p)->bondForce_n, lattice.bondForce_n * 8, 1e-14));
    }

    // The bridge given is the lattice's area, too: the lattice's own changes nothing, a thinner one
    // makes a weaker wheel, and its strength falls with the power 3/2 of its diameter.
    void thinnerBridgeIsAWeakerWheel() {
        QVERIFY(holds("thinner bridge", [] {
            Project p = anyWheel();
            const SelfSharpening lattice = *selfSharpening(p);
            p.wheel->bond_bridge_mm = lattice.bridge_mm;
            const SelfSharpening same = *selfSharpening(p);
            RC_ASSERT(close(same.bridgeArea_mm2, lattice.bridgeArea_mm2, 1e-15));
            RC_ASSERT(close(same.allowed, lattice.allowed, 1e-13));
            const double share = between(0.05, 0.95);
            p.wheel->bond_bridge_mm = share * lattice.bridge_mm;
            const SelfSharpening thin = *selfSharpening(p);
            RC_ASSERT(close(thin.bondForce_n, lattice.bondForce_n * std::pow(share, 1.5), 1e-12));
            // a bond far stronger than the grain breaks the grain, whatever the bridge
            RC_ASSERT(thin.allowed <= lattice.allowed);
            RC_ASSERT(thin.bondForce_n > 20 * thin.grainForce_n || thin.allowed < lattice.allowed);
            RC_ASSERT(thin.limitDepth().value_or(0) <= lattice.limitDepth().value_or(0));
        }));
    }

    // The limit inserted gives the limit, for every width: P_y = 0.25·f_cr·n_g·b·L.
    void limitingDepthLoadsTheWheelWithAQuarterOfTheCriticalForce() {
        QVERIFY(holds("limit", [] {
            const Project p = anyWheel();
            const SelfSharpening s = *selfSharpening(p);
            const Law law(p);
            const double b = between(1, 100);
            const std::optional<double> a = s.limitDepth();
            RC_ASSERT(a.has_value() == (law.kr < s.allowed));
            RC_PRE(a && law.kr < 0.99 * s.allowed);
            RC_ASSERT(close(law.force(b, *a), s.allowedForce(b, *a), 1e-12));
            RC_ASSERT(close(s.load(*a), 1, 1e-12));
            RC_ASSERT(s.load(*a * 1.01) > 1 && s.load(*a * 0.99) < 1);
            const double De =
                equivalentDiameter(p.part->diameter_mm, p.wheel->diameter_mm, p.part->surface);
            RC_ASSERT(close(s.allowedForce(b, *a),
                            0.25 * s.criticalForce_n * s.grains_mm2 * b * std::sqrt(*a * De),
                            1e-14));
        }));
    }

    // Friction of the flats alone bears on the wheel as much as it may: shallower does not help.
    void wheelTooDullIsNotMetAtAnyDepth() {
        Project p = fixtures::plunge();
        giveStrengths(*p.wheel);
        p.wheel->dullness = 0;
        const SelfSharpening sharp = *selfSharpening(p);
        QVERIFY(sharp.limitDepth());
        const double critical = sharp.allowed / (Law(fixtures::plunge()).kr / 0.02);
        p.wheel->dullness = critical * 1.001;
        const SelfSharpening dull = *selfSharpening(p);
        QVERIFY(!dull.limitDepth());
        for (const double a : {1e-12, 1e-6, 0.01}) {
            QVERIFY(dull.load(a) > 1);
            QVERIFY(Law(p).force(10, a) > dull.allowedForce(10, a));
        }
        p.wheel->dullness = critical * 0.999;
        QVERIFY(selfSharpening(p)->limitDepth());
        QVERIFY(*selfSharpening(p)->limitDepth() < 1e-3 * *sharp.limitDepth());
    }

    // MODEL-8: uncalibrated the limit comes out a tenth of real grinding forces.
    void handbookStrengthsNeedCalibration() {
        Project p = fixtures::plunge();
        giveStrengths(*p.wheel);
        const SelfSharpening s = *selfSharpening(p);
        const double real = Law(p).force(40, 0.005), allowed = s.allowedForce(40, 0.005);
        QVERIFY(allowed < 0.3 * real && allowed > 0.03 * real);
    }

    // --- power -----------------------------------------------------------------------------------

    // shared/vectors: 1, 5, 10 µm take 117, 55.5, 40.9 J/mm³ with μ 0.4.
    void specificEnergyIsTheVectors() {
        Project p = fixtures::plunge();
        p.material->friction = 0.4;
        const PowerModel model(p);
        QVERIFY(within(model.specificEnergy(0.001) / 1000, 117, 0.51));
        QVERIFY(within(model.specificEnergy(0.005) / 1000, 55.5, 0.051));
        QVERIFY(within(model.specificEnergy(0.010) / 1000, 40.9, 0.051));
    }

    void powerIsForceTimesSpeed() {
        QVERIFY(holds("N = P_z·V", [] {
            const Project p = anyCutting();
            const PowerModel model(p);
            const double b = between(1, 100), a = decades(-6, -1);
            const double Pz = forceLaw(p).tangential(b, std::sqrt(a));
            const double Vd =
                std::numbers::pi * p.part->diameter_mm * p.machine->work_speed_rpm / 60;
            RC_ASSERT(close(model.wheelPower(b, a), Pz * p.machine->wheel_speed_m_s * 1000, 1e-14));
            RC_ASSERT(close(model.workPower(b, a), Pz * Vd, 1e-14));
            RC_ASSERT(model.wheelPower(b, a * 1.001) > model.wheelPower(b, a));
            RC_ASSERT(model.wheelPower(b, 0) == 0);
            RC_ASSERT(close(model.wheelPower(2 * b, a), 2 * model.wheelPower(b, a), 1e-14));
        }));
    }

    void limitingDepthTakesJustThePowerOfTheDrive() {
        QVERIFY(holds("limit", [] {
            const PowerModel model(anyCutting());
            const double b = between(1, 100), power = decades(3, 8);
            const double wheel = model.wheelLimitDepth(b, power);
            const double work = model.workLimitDepth(b, power);
            RC_ASSERT(close(model.wheelPower(b, wheel), power, 1e-12));
            RC_ASSERT(close(model.workPower(b, work), power, 1e-12));
            RC_ASSERT(model.wheelLimitDepth(b, power * 1.001) > wheel);
            RC_ASSERT(model.wheelLimitDepth(b * 1.001, power) < wheel);
        }));
    }

    // Sharp: energy of shear alone, ε_i·σ_i, at every depth. Dull: it falls with the depth to that.
    void specificEnergyFallsToTheShearEnergy() {
        Project p = fixtures::plunge();
        p.wheel->dullness = 0;
        QVERIFY(close(PowerModel(p).specificEnergy(0.001), 2.8 * 2000, 1e-14));
        QVERIFY(close(PowerModel(p).specificEnergy(0.1), 2.8 * 2000, 1e-14));
        QVERIFY(holds("energy", [] {
            const Project q = anyCutting();
            const PowerModel model(q);
            const double a = decades(-6, -1);
            const double shear = q.material->shear_strain * q.material->flow_stress_mpa;
            RC_ASSERT(model.specificEnergy(a) >= shear * (1 - 1e-14));
            RC_ASSERT(model.specificEnergy(2 * a) <= model.specificEnergy(a) * (1 + 1e-14));
        }));
    }

    // The engine's own peak power is this function of its largest depth.
    void peakPowerOfARunIsThatOfItsLargestDepth() {
        const fixtures::Traced run(fixtures::plunge());
        double a = 0;
        for (const Visit& visit : run.trajectory.visits) {
            a = std::max(a, visit.actual_mm);
        }
        QVERIFY(close(PowerModel(fixtures::plunge()).wheelPower(40, a) / 1000,
                      run.result.peakPower_w, 1e-12));
    }
};

} // namespace sparkout::test_depth_limits

SPARKOUT_TEST(test_depth_limits, TestDepthLimits)
#include "test_depth_limits.moc"
