// SPDX-License-Identifier: GPL-3.0-or-later
// What the shop's numbers tell of volume, energy and time, against closed forms, conservation and
// the trace.
#include "core/quality/result_json.h"
#include "tests/core/quality/shop_cycles.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_shop_energy {

using namespace shop_cycles;
using fixtures::close;
using fixtures::Traced;
using fixtures::within;
using nlohmann::json;
using std::numbers::pi;

/// The length of surface a pass stands for, from MODEL-5 and 6.
double lengthOf(const Project& p, const Place& place) {
    const double rz1 = p.wheel->width_mm - p.machine->overrun_entry_mm;
    const double rz2 = p.wheel->width_mm - p.machine->overrun_exit_mm;
    switch (place.zone) {
    case Zone::rz1: return std::min(rz1, p.wheel->width_mm); // all it reaches before a wall
    case Zone::rz2: return std::min(rz2, p.wheel->width_mm);
    case Zone::nz: return p.part->length_mm - rz1 - rz2;
    case Zone::section: break;
    }
    return p.part->length_mm / p.sections;
}

/// Wheel power of a cut b wide and a deep, MODEL-2 written out [W].
double power(const Project& p, double b, double a) {
    const fixtures::Law law(p);
    const double shear = law.ks / p.material->shear_factor * p.material->shear_strain * a;
    return b * (shear + p.material->friction * law.kr * std::sqrt(a)) * p.machine->wheel_speed_m_s;
}

double volumeOf(const ShopNumbers& shop) {
    double sum = 0;
    for (const ShopColumn& stage : shop.stages) {
        sum += stage.removedVolume_mm3;
    }
    return sum;
}

/// How much more energy a stroke takes than its largest power would give in its time: it grinds all
/// of L_p while the table travels less.
double strokeEnergyShare(const Project& p) {
    if (!p.operation->travels) {
        return 1;
    }
    const Machine& machine = *p.machine;
    const double travel =
        p.part->length_mm - p.wheel->width_mm + machine.overrun_entry_mm + machine.overrun_exit_mm;
    return std::max(1.0, p.part->length_mm / travel);
}

/// The shipped projects.
std::vector<Project> examples() {
    std::vector<Project> all;
    for (const auto& entry :
         std::filesystem::directory_iterator(samples::sourcePath("resources/examples"))) {
        if (entry.path().extension() == ".sparkout") {
            all.push_back(readProject(samples::readText(entry.path())).project.value());
        }
    }
    return all;
}

class TestShopEnergy : public QObject {
    Q_OBJECT

private slots:
    // --- volume and energy ----------------------------------------------------------------------

    // 20 revolutions of 5 µm, then 20 of 1 µm; the infeed's spiral takes (k+1)/K of the feed in the
    // first revolution, so radius k is cut 19 times 5 µm and once less, then the rest of that in
    // the first of the second stage.
    void steadyPlungeHasTheClosedForm() {
        const Project p = rigidPlunge();
        const ShopNumbers shop = shopNumbers(simulateUnchecked(p));
        QCOMPARE(shop.stages[0].count, 20);
        QCOMPARE(shop.stages[1].count, 20);
        const double turn_s = 60.0 / 180;
        double volume[2] = {}, energy[2] = {};
        for (int k = 0; k < 4; ++k) {
            const double spiral = (k + 1) / 4.0;
            const double cuts[2][2] = {{0.005 * spiral, 0.005},
                                       {0.005 * (1 - spiral) + 0.001 * spiral, 0.001}};
            for (int z = 0; z < 2; ++z) {
                const auto& [first, steady] = cuts[z];
                volume[z] += pi * 30 * 40 / 4 * (first + 19 * steady);
                energy[z] += turn_s / 4 * (power(p, 40, first) + 19 * power(p, 40, steady));
            }
        }
        for (int z = 0; z < 2; ++z) {
            const ShopColumn& stage = shop.stages[std::size_t(z)];
            QVERIFY(close(stage.removedVolume_mm3, volume[z], 1e-10));
            QVERIFY(close(stage.energy_j, energy[z], 1e-9));
            QVERIFY(close(*stage.energy_j_mm3, energy[z] / volume[z], 1e-9));
            QVERIFY(close(stage.time_s, 20 * turn_s, 1e-13));
            QVERIFY(close(stage.meanPower_w, energy[z] / (20 * turn_s), 1e-9));
        }
        QVERIFY(close(shop.stages[0].power_w.value, power(p, 40, 0.005), 1e-10));
        QVERIFY(
            close(shop.stages[0].normalForce_n.value, fixtures::Law(p).force(40, 0.005), 1e-10));
    }

    // E/V of a cut at one depth is P_z·V_k/(b·a·V_d), whatever its width: the two stages of one
    // rigid plunge, each without its first revolution, by the difference of two cycles.
    void specificEnergyOfOneDepthIsPowerOverRemovalRate() {
        Project longer = rigidPlunge();
        Project shorter = longer;
        shorter.cycle->stages[0].stock_mm = 0.05;
        shorter.part->stock_mm = 0.07;
        const ShopColumn a = shopNumbers(simulateUnchecked(longer)).stages[0];
        const ShopColumn b = shopNumbers(simulateUnchecked(shorter)).stages[0];
        QCOMPARE(a.count, b.count + 10);
        const double difference =
            (a.energy_j - b.energy_j) / (a.removedVolume_mm3 - b.removedVolume_mm3);
        QVERIFY(
            close(difference, power(longer, 40, 0.005) / (40 * 0.005 * workSpeed(longer)), 1e-9));
    }

    // η = 0: P_z = b·k_t·a, so E/V = k_t·V_k/V_d = ε_i·σ_i in every stage of every cycle.
    void sharpWheelNeedsTheShearEnergyAlone() {
        int compared = 0;
        for (int seed = 1; seed <= seeds(); ++seed) {
            Project p = random(seed);
            p.wheel->dullness = 0;
            const double expected = p.material->shear_strain * p.material->flow_stress_mpa / 1000;
            const ShopNumbers shop = shopNumbers(simulateUnchecked(p));
            for (const ShopColumn& stage : shop.stages) {
                if (stage.energy_j_mm3) {
                    QVERIFY(close(*stage.energy_j_mm3, expected, 1e-13));
                    ++compared;
                }
            }
            QVERIFY(close(shop.cycle.energy_j_mm3.value(), expected, 1e-13));
        }
        QVERIFY(compared > seeds());
    }

    // What is removed in all is what blank and part differ by, π·d·ℓ·(mean radius lost).
    void removedVolumeIsTheDifferenceOfBlankAndPart() {
        for (int seed = 1; seed <= seeds(); ++seed) {
            const Project p = random(seed);
            const SimulationResult r = simulateUnchecked(p);
            const ShopNumbers shop = shopNumbers(r);
            const Blank blank = makeBlank(*p.part);
            const double side = p.part->surface == Surface::external ? 1 : -1;
            double expected = 0;
            for (const SectionResult& section :
                 r.zoneSections.empty() ? r.sections : r.zoneSections) {
                const Place place{.zone = section.zone};
                const double inZone = r.zoneSections.empty() ? 1 : p.zone_sections;
                const double K = double(section.radii_mm.size()) * inZone;
                for (std::size_t k = 0; k < section.radii_mm.size(); ++k) {
                    if (blank.isGap(k)) {
                        continue;
                    }
                    const double initial = blank.firstTouchRadius_mm - side * blank.depth_mm[k];
                    expected += pi * p.part->diameter_mm * lengthOf(p, place) / K * side
                                * (initial - section.radii_mm[k]);
                }
            }
            // radii of some 10 mm are rounded to 1e-15 mm, what is lost of them is some 0.1 mm
            QVERIFY2(close(shop.cycle.removedVolume_mm3, expected, 1e-11),
                     qPrintable(QString("seed %1").arg(seed)));
            QVERIFY(close(volumeOf(shop), shop.cycle.removedVolume_mm3, 1e-13));
        }
    }

    // The header's word for "first order": the exact ring differs by (R0 + R1)/d.
    void ringOfARoundBlankDiffersByTheMeanDiameter() {
        Project p = rigidPlunge();
        const SimulationResult r = simulateUnchecked(p);
        const double first = makeBlank(*p.part).firstTouchRadius_mm;
        double exact = 0, mean = 0;
        for (const double R : r.sections[0].radii_mm) {
            exact += pi * (first * first - R * R) * 40 / 4;
            mean += (first + R) / 4;
        }
        QVERIFY(within(exact / shopNumbers(r).cycle.removedVolume_mm3, mean / 30, 1e-7));
    }

    // Every stage against its trace: the pass's own width, time and force.
    void stagesAreTheSumsOverTheirPasses() {
        for (int seed = 1; seed <= seeds() / 3; ++seed) {
            Project whole = random(seed);
            whole.zone_sections = 1; // what is recorded is ground
            const Traced run(whole);
            const Project& p = run.result.project;
            const ShopNumbers shop = shopNumbers(run.result);
            std::vector<ShopColumn> sums(shop.stages.size());
            std::vector<double> ground(shop.stages.size());
            for (const Pass& pass : run.trajectory.passes) {
                ShopColumn& sum = sums[std::size_t(pass.place.stage) - 1];
                const double b = pass.effectiveWidth_mm;
                const double length = lengthOf(p, pass.place);
                const double time = length / b * 60 / p.machine->work_speed_rpm;
                ground[std::size_t(pass.place.stage) - 1] += b * time;
                for (int k = 0; k < run.trajectory.radii; ++k) {
                    const double a = run.visit(pass, k).actual_mm;
                    const double share = 1.0 / run.trajectory.radii;
                    sum.removedVolume_mm3 += pi * p.part->diameter_mm * share * a * length;
                    sum.energy_j += power(p, b, a) * time * share;
                    sum.depth_mm.value = std::max(sum.depth_mm.value, a);
                }
            }
            for (std::size_t z = 0; z < sums.size(); ++z) {
                const ShopColumn& stage = shop.stages[z];
                QVERIFY(within(stage.removedVolume_mm3, sums[z].removedVolume_mm3,
                               1e-10 * sums[z].removedVolume_mm3 + 1e-12));
                QVERIFY(close(stage.energy_j, sums[z].energy_j, 1e-11));
                QCOMPARE(stage.depth_mm.value, sums[z].depth_mm.value);
                QVERIFY(within(stage.meanRemovalRate_mm2_s * ground[z], stage.removedVolume_mm3,
                               1e-11 * stage.removedVolume_mm3));
                const double most = strokeEnergyShare(p) * stage.power_w.value;
                QVERIFY(stage.meanPower_w <= most * (1 + 1e-12));
                QVERIFY(stage.meanRemovalRate_mm2_s <= stage.removalRate_mm2_s * (1 + 1e-12));
            }
        }
    }

    // The J sections share one revolution: cut alike, they give what one section gives.
    void sectionsShareTheRevolution() {
        Project one = fixtures::plunge();
        one.part->initial_runout_mm = 0.02;
        Project seven = one;
        seven.sections = 7;
        seven.machine->compliance_mm_per_n = std::vector<double>(7, 2e-5);
        const ShopColumn a = shopNumbers(simulateUnchecked(one)).cycle;
        const ShopColumn b = shopNumbers(simulateUnchecked(seven)).cycle;
        QVERIFY(close(a.removedVolume_mm3, b.removedVolume_mm3, 1e-13));
        QVERIFY(close(a.energy_j, b.energy_j, 1e-13));
        QVERIFY(close(a.time_s, b.time_s, 1e-13));
        QVERIFY(close(a.meanPower_w, b.meanPower_w, 1e-13));
        QCOMPARE(a.power_w.value, b.power_w.value);
    }

    // A gauge between the sections is no part of the surface, not even where it is stiffest.
    void freeGaugePositionCountsForNothing() {
        Project p = fixtures::plunge();
        p.gauge->control = Control::position; // so that the gauge decides nothing
        p.part->initial_runout_mm = 0.02;
        const ShopColumn without = shopNumbers(simulateUnchecked(p)).cycle;
        p.gauge->position_mm = 11;
        p.gauge->compliance_mm_per_n = 1e-9;
        const ShopColumn with = shopNumbers(simulateUnchecked(p)).cycle;
        QCOMPARE(with.removedVolume_mm3, without.removedVolume_mm3);
        QCOMPARE(with.energy_j, without.energy_j);
        QCOMPARE(with.depth_mm.value, without.depth_mm.value);
        QCOMPARE(with.power_w.value, without.power_w.value);
        QCOMPARE(with.time_s, without.time_s);
    }

    // Beyond B per revolution b stays B: volume is still conserved and energy keeps to it.
    void tableFasterThanTheWheelIsWideKeepsEnergyToVolume() {
        Project p = fixtures::traverse();
        p.wheel->dullness = 0;
        p.cycle->stages[0].axial_feed_mm_min = 1.7 * 50 * 180;
        const ShopNumbers shop = shopNumbers(simulateUnchecked(p));
        QVERIFY(close(*shop.stages[0].energy_j_mm3, 2.8 * 2000 / 1000, 1e-13));
        QVERIFY(shop.stages[0].meanPower_w <= shop.stages[0].power_w.value);
    }

    // --- time -----------------------------------------------------------------------------------

    // Of every example and of random projects, as a program reads them: the wheel grinds in all of
    // the machining time, strokes as long as the table takes for them.
    void theGrindingTimeIsTheMachiningTimeAndTheMeanPowerIsOverIt() {
        std::vector<Project> projects = examples();
        for (int seed = 1; seed <= seeds(); ++seed) {
            projects.push_back(random(seed));
        }
        int strokes = 0;
        for (const Project& p : projects) {
            const SimulationResult result = simulateUnchecked(p);
            const json all = json::parse(resultJson(result, {}));
            const auto check = [](const json& column, double time_s) {
                const double grinding_s = column.at("grinding_time_min").get<double>() * 60;
                QVERIFY(grinding_s <= time_s * (1 + 1e-12));
                QVERIFY(close(grinding_s, time_s, 1e-12));
                QVERIFY(close(column.at("mean_power_w").get<double>() * grinding_s,
                              column.at("energy_j").get<double>(), 1e-9));
            };
            check(all.at("shop").at("cycle"), result.time_s);
            for (std::size_t z = 0; z < result.timeByStage_s.size(); ++z) {
                check(all.at("shop").at("stages").at(z), result.timeByStage_s[z]);
            }
            strokes += p.operation->travels ? 1 : 0;
        }
        QVERIFY(projects.size() > 14 && strokes > 10);
    }

    // A stroke takes travel/S_ax, plunge passes their revolutions: N_E1 + 2·N1 + N2 of them.
    void aStrokeLastsAsLongAsTheTableTravels() {
        const Project p = fixtures::traverse();
        const ShopNumbers shop = shopNumbers(simulateUnchecked(p));
        const double plungeIn[] = {2, 1}; // ⌈180·0.004/0.5⌉, ⌈180·0.001/0.5⌉
        const double dwells = 2 * 1 + 2;  // 0.333 s and 0.667 s at 3 rev/s
        const double axialFeed[] = {1800, 300};
        const double travel = 92 - 50 + 12 + 12;
        for (std::size_t z = 0; z < 2; ++z) {
            const ShopColumn& stage = shop.stages[z];
            const double perStroke = (plungeIn[z] + dwells) / 180 + 2 * travel / axialFeed[z];
            QVERIFY(close(stage.energy_j / stage.meanPower_w, stage.count * perStroke * 60, 1e-12));
        }
        QVERIFY(close(shop.cycle.energy_j / shop.cycle.meanPower_w,
                      shop.stages[0].time_s + shop.stages[1].time_s, 1e-12));
    }
};

} // namespace sparkout::test_shop_energy

SPARKOUT_TEST(test_shop_energy, TestShopEnergy)
#include "test_shop_energy.moc"
