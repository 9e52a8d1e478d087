// SPDX-License-Identifier: GPL-3.0-or-later
// A wheel out of true: the waves that stay on a round part after a long spark-out, by their closed
// form; what its phase, a varied work speed and too few radii make of them; an unbalance as a
// force.
#include "core/process/wheel_wave.h"

#include "core/batch/batch_run.h"
#include "core/batch/batch_statistics.h"
#include "core/batch/scenario_source.h"
#include "core/batch/sweep_run.h"
#include "core/batch/usual_batch.h"
#include "core/phases/failing_stock.h"
#include "core/project/validate.h"
#include "core/quality/accuracy_limit.h"
#include "core/quality/result_json.h"
#include "core/quality/verdict.h"
#include "core/quality/waviness_outputs.h"
#include "core/search/limit.h"
#include "core/search/variants.h"
#include "core/surface/waviness.h"
#include "tests/core/search/search_checks.h"
#include "tests/registry.h"

#include <nlohmann/json.hpp>

#include <numbers>

namespace sparkout::test_wheel_wave {

using namespace search_checks;
using fixtures::within;
using std::numbers::pi;

constexpr double workSpeed_rpm = 200, wheelSpeed_m_s = 40, amplitude_um = 0.5;

/// A round shaft ⌀40 × 40 that is plunged with a wheel of this many waves a turn of the work.
Project shaft(double ratio, int radii, int sparkOuts) {
    Project p = fixtures::plunge();
    p.part->diameter_mm = p.part->length_mm = 40;
    p.part->stock_mm = 0.2;
    p.part->initial_runout_mm = 0;
    p.part->radii_per_section = radii;
    p.part->tolerance = {};
    p.material->flow_stress_mpa = 2000;
    p.material->burn_rise_k.reset();
    p.sections = 1;
    p.gauge->rule = GaugeRule::mean;
    p.machine->compliance_mm_per_n = std::vector<double>{6e-5};
    p.machine->geometric_runout_um = 0;
    p.machine->work_speed_rpm = workSpeed_rpm;
    p.machine->wheel_speed_m_s = wheelSpeed_m_s;
    p.wheel->width_mm = 50;
    p.wheel->dullness = 0.02;
    p.wheel->diameter_mm = wheelSpeed_m_s * 60'000 / (pi * workSpeed_rpm * ratio);
    p.wheel->runout.emplace().amplitude_um = amplitude_um;
    Stage rough, finish, sparkOut;
    rough.stock_mm = 0.18;
    rough.radial_feed_mm_min = 0.6;
    finish.stock_mm = 0.02;
    finish.radial_feed_mm_min = 0.1;
    sparkOut.sparkOutFor(sparkOuts);
    p.cycle->stages = {rough, finish, sparkOut};
    return p;
}

SimulationResult runOf(const Project& project) {
    const SimulationResult result = simulateUnchecked(project);
    if (result.status != RunStatus::completed) {
        qFatal("the cycle does not end");
    }
    return result;
}

/// Radii without mean and eccentricity, from peak to valley [µm], and the largest harmonic.
struct Waves {
    double height_um = 0;
    int order = 0;
};
Waves wavesOf(const Project& project) {
    const std::vector<double> radii = runOf(project).sections[0].radii_mm;
    const std::vector<Harmonic> parts = harmonics(radii, Directions(radii.size()));
    double least = 1e3, most = -1e3;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double phi = 2 * pi * static_cast<double>(k) / static_cast<double>(radii.size());
        const double left = radii[k] - parts[0].amplitude_mm
                            - parts[1].amplitude_mm * std::cos(phi - parts[1].phase_rad);
        least = std::min(least, left);
        most = std::max(most, left);
    }
    const auto largest =
        std::ranges::max_element(parts.begin() + 2, parts.end(), {}, &Harmonic::amplitude_mm);
    return {(most - least) * 1000, largest->lobes};
}

class TestWheelWave : public QObject {
    Q_OBJECT

private slots:
    // p waves of e·(1 − cos(π/q)) at ρ = p/q in lowest terms.
    void longSparkOutLeavesTheWavesOfTheRatio_data() {
        QTest::addColumn<int>("waves");
        QTest::addColumn<int>("turns");
        for (const auto& [p, q] : {std::pair(8, 1), std::pair(5, 2), std::pair(7, 3),
                                   std::pair(9, 4), std::pair(11, 5), std::pair(13, 6)}) {
            QTest::addRow("%d/%d", p, q) << p << q;
        }
    }
    void longSparkOutLeavesTheWavesOfTheRatio() {
        QFETCH(int, waves);
        QFETCH(int, turns);
        const int radii = 360 / (2 * waves) * 2 * waves; // crests and valleys are among them
        Project p = shaft(double(waves) / turns, radii, 400);
        p.wheel->dullness = 0; // what is stored goes exponentially
        const double expected_um = amplitude_um * (1 - std::cos(pi / turns));
        const Waves left = wavesOf(p);
        QVERIFY2(within(left.height_um, expected_um, 0.01 * expected_um),
                 qPrintable(QString::number(left.height_um)));
        QCOMPARE(left.order, waves);
        QCOMPARE(orderOfWaves(p), waves);
        // A shift by a whole number of radii turns the waves, and leaves their height.
        for (const int shift : {1, 7, 100}) {
            p.wheel->runout->phase_deg = std::fmod(360.0 * shift * waves / turns / radii, 360);
            const Waves turned = wavesOf(p);
            QVERIFY(within(turned.height_um, left.height_um, 0.01 * expected_um));
            QCOMPARE(turned.order, waves);
        }
    }

    // The table of the published case: 200 rev/min, 40 m/s, a wheel of 0.5 µm.
    void theTableOfThePublishedCase_data() {
        QTest::addColumn<double>("ratio");
        QTest::addColumn<int>("sparkOuts");
        QTest::addColumn<double>("height");
        for (const auto& [ratio, sparkOuts, height] :
             {std::tuple(8.0, 20, 1.041), std::tuple(8.01, 20, 0.93), std::tuple(8.03, 20, 0.46),
              std::tuple(8.1, 20, 0.15), std::tuple(8.304, 20, 0.080), std::tuple(8.5, 20, 0.11),
              std::tuple(8.5, 400, 0.41), std::tuple(8.0, 100, 1.00)}) {
            QTest::addRow("%g, %d", ratio, sparkOuts) << ratio << sparkOuts << height;
        }
    }
    void theTableOfThePublishedCase() {
        QFETCH(double, ratio);
        QFETCH(int, sparkOuts);
        QFETCH(double, height);
        const double found = wavesOf(shaft(ratio, 360, sparkOuts)).height_um;
        QVERIFY2(within(found, height, 0.05 * height), qPrintable(QString::number(found)));
    }

    // Off the ratio the waves go.
    void wavesGoOffTheRatio() {
        const double at = wavesOf(shaft(8, 360, 20)).height_um;
        QVERIFY2(within(at, 1.04, 0.03), qPrintable(QString::number(at)));
        double before = at;
        for (const double ratio : {8.01, 8.03, 8.1}) {
            const double height = wavesOf(shaft(ratio, 360, 20)).height_um;
            QVERIFY2(height < before, qPrintable(QString::number(height)));
            before = height;
        }
        QVERIFY(before < 0.2 * at);
        QVERIFY(wavesOf(shaft(8.5, 360, 400)).height_um > wavesOf(shaft(8.5, 360, 20)).height_um);
    }

    void noRunoutLeavesNoWaves() {
        Project p = shaft(8, 96, 100);
        p.wheel->runout.reset();
        QVERIFY(wavesOf(p).height_um < 0.01);
        QVERIFY(!wheelWave(p) && !areWavesKnown(p));
        QCOMPARE(wheelAmplitude_mm(p), 0.0);
    }

    void variationOfNothingChangesNothing() {
        Project p = shaft(8.03, 96, 50);
        const std::vector<double> plain = runOf(p).sections[0].radii_mm;
        p.machine->work_speed_variation = SpeedVariation{.percent = 0, .period_s = 5};
        QVERIFY(runOf(p).sections[0].radii_mm == plain);
        p.wheel->runout.reset();
        const std::vector<double> without = runOf(p).sections[0].radii_mm;
        p.machine->work_speed_variation->percent = 8; // nothing is printed that it could spread
        QVERIFY(runOf(p).sections[0].radii_mm == without);
    }

    void variedSpeedSpreadsTheWaves() {
        Project p = shaft(8, 360, 100);
        const double plain = wavesOf(p).height_um;
        p.machine->work_speed_variation = SpeedVariation{.percent = 8, .period_s = 5};
        const double varied = wavesOf(p).height_um;
        QVERIFY2(varied < 0.25 * plain, qPrintable(QString::number(varied)));
    }

    void phaseOfTheWaveIsTheTimeAtTheTurn() {
        const WheelWave wave{.amplitude_mm = 1, .perTurn = 3, .phase = 0.25};
        QVERIFY(within(wave.turnsOfWave(2), 6.25, 1e-12));
        // The mean speed is kept over a period: dt/dθ ≥ 0 returns to the same time.
        const WheelWave varied{.amplitude_mm = 1, .perTurn = 3, .swing = 0.4, .period = 5};
        QVERIFY(within(varied.turnsOfWave(5), 15, 1e-12));
        QVERIFY(within(varied.turnsOfWave(2.5), 7.5 + 3 * 0.8, 1e-12));
        QCOMPARE(wholeTurns(0), 0.0);
        QCOMPARE(wholeTurns(2 + 1e-9), 2.0);
        QCOMPARE(wholeTurns(2.1), 3.0);
    }

    // 19 kg, G 1, 120 rad/s, 60 N/µm: 0.04 µm.
    void unbalanceIsAForceOnTheWheelHead() {
        Project p = shaft(8, 96, 10);
        constexpr double omega = 120;
        p.wheel->diameter_mm = 2 * wheelSpeed_m_s * 1000 / omega;
        p.wheel->runout = WheelRunout{.balance_grade_mm_s = 1, .rotor_mass_kg = 19};
        p.machine->stiffness_n_um = Stiffness{.wheel_head = 60};
        const double e_mm = 19e-3 * omega / 60 / 1000; // M·G·ω/j_w
        QVERIFY(within(wheelAmplitude_mm(p), e_mm, 1e-9));
        p.wheel->runout = WheelRunout{.unbalance_g_mm = 19e3 / omega};
        QVERIFY(within(wheelAmplitude_mm(p), e_mm, 1e-9));
        p.machine->wheel_head_frequency_hz = 2 * omega / (2 * pi);
        QVERIFY(within(wheelAmplitude_mm(p), e_mm / 0.75, 1e-9));
        p.machine->wheel_head_frequency_hz = omega / (2 * pi);
        QVERIFY(within(wheelAmplitude_mm(p), mostResonance * e_mm, 1e-6));
        p.wheel->runout->lobes = 5; // of an amplitude alone
        QVERIFY(within(wavesPerTurn(p), wheelSpeed_rpm(p) / workSpeed_rpm, 1e-12));
    }

    void everyOperationPrintsWaves() {
        Project bore = fixtures::plunge();
        bore.part->surface = Surface::internal;
        bore.part->diameter_mm = 60;
        bore.wheel->diameter_mm = 45;
        for (Project p : {fixtures::traverse(), fixtures::plunge(), bore}) {
            p.wheel->runout = WheelRunout{.amplitude_um = 2};
            resolveWaves(p);
            const SimulationResult with = simulate(p);
            p.wheel->runout.reset();
            const SimulationResult without = simulate(p);
            QVERIFY(with.status == without.status);
            QVERIFY(with.sections[0].radii_mm != without.sections[0].radii_mm);
        }
    }

    void coupledSectionsMeetTheSameWave() {
        Project p = shaft(8, 96, 30);
        p.sections = 3;
        p.sections_coupled = true;
        p.machine->compliance_mm_per_n = std::monostate{};
        p.machine->stiffness_n_um = Stiffness{};
        p.part->shaft.segments = {{100, 40}};
        p.part->shaft.ground_from_mm = 30;
        QVERIFY(!hasErrors(validate(p)));
        const double height = wavesOf(p).height_um;
        QVERIFY2(within(height, 2 * amplitude_um, 0.2), qPrintable(QString::number(height)));
        p.wheel->runout.reset();
        QVERIFY(wavesOf(p).height_um < 0.1 * height);
    }

    void tooFewRadiiAreNamedWithTheNumberThatWouldDo() {
        const auto least = [](const Project& p) {
            const Issues issues = validate(p);
            const auto found = std::ranges::find(issues, IssueCode::wavesUnresolved, &Issue::code);
            return found == issues.end() ? 0 : std::get<Bounds>(found->limit).range.low;
        };
        QCOMPARE(least(shaft(8, 94, 10)), 96.0);
        QCOMPARE(least(shaft(8, 96, 10)), 0.0);
        QCOMPARE(least(shaft(8.5, 96, 10)), 17 * 12.0); // 17 waves in two turns
        QVERIFY(areWavesKnown(shaft(8, 96, 10)) && !areWavesKnown(shaft(8, 94, 10)));
        QCOMPARE(orderOfWaves(shaft(8.42, 96, 10)), 8);
        Project p = shaft(8, 96, 10);
        p.wheel->runout->lobes = 4;
        QCOMPARE(radiiForWaves(p), 4 * 96);
    }

    // The height that is stated and held against the drawing is that of the profile without the
    // lower orders, which a blank out of round has.
    void wavinessIsStatedByOrderWhereItIsKnown() {
        Project p = shaft(8, 96, 100);
        p.part->tolerance.waviness_um = 0.9;
        const auto rowOf = [](const SimulationResult& result) {
            for (const ConstraintResult& each : evaluateConstraints(result)) {
                if (each.kind == ConstraintKind::waviness) {
                    return each;
                }
            }
            return ConstraintResult{ConstraintKind::count_};
        };
        const auto wavesIn = [](const SimulationResult& result) {
            const auto json = nlohmann::json::parse(resultJson(result, {}));
            return json.at("sections").at(0).value("waviness", nlohmann::json());
        };
        const SimulationResult known = runOf(p);
        QVERIFY(within(rowOf(known).value, 2 * amplitude_um, 0.02));
        QVERIFY(!rowOf(known).holds && rowOf(known).knowsMachine);
        QVERIFY(within(wavesIn(known).at("height_um").get<double>(), rowOf(known).value, 1e-9));
        QCOMPARE(wavesIn(known).at("largest_order").get<int>(), 8);
        QCOMPARE(wavesIn(known).at("printed_order").get<int>(), 8);
        QVERIFY(
            within(wavesIn(known).at("largest_amplitude_um").get<double>(), amplitude_um, 0.01));
        QVERIFY(wavesIn(known).at("orders").at(0).at("order").get<int>() >= 4);

        Project oval = p; // of the blank, which the spark-out leaves a part of
        oval.part->profile = ProfileForm::ellipse;
        oval.part->initial_runout_mm = 0.05;
        oval.cycle->stages.back().sparkOutFor(10);
        QVERIFY(within(rowOf(runOf(oval)).value, 2 * amplitude_um, 0.2));

        p.wheel->runout.reset();
        QVERIFY(wavesIn(runOf(p)).is_null()); // not known, and so never 0.00
        QVERIFY(lightOf(rowOf(runOf(p))) == Light::undecided);
    }

    /// Where another speed or wheel needs more radii than the project has, a run takes them.
    void otherSpeedsTakeTheRadiiThatTheyNeed() {
        Project p = shaft(8, 96, 10);
        p.part->tolerance.waviness_um = 0.9;
        p.sweep =
            Sweep{{{.input = "/machine/work_speed_rpm", .from = 160, .to = 200, .points = 2}}};
        const SweepResult swept = runSweep(p);
        const auto column = std::ranges::find(swept.quantities, "waviness", &SweepQuantity::name)
                            - swept.quantities.begin();
        const auto at = [&](std::size_t point) {
            return swept.points[point].values[static_cast<std::size_t>(column)].value;
        };
        Project ten = shaft(10, 120, 10); // as 8 at 200 rev/min is at 160
        ten.machine->work_speed_rpm = 160;
        ten.wheel->diameter_mm = p.wheel->diameter_mm;
        QCOMPARE(orderOfWaves(ten), 10);
        QCOMPARE(at(0), profileWaves(runOf(ten), 0).height_mm * 1000);
        QVERIFY(at(0) > 0.9 && at(1) > 0.9 && !swept.points[0].good);
        Project worn = p;
        changeWheelDiameter(worn, p.wheel->diameter_mm / 2); // 16 a turn
        QCOMPARE(worn.part->radii_per_section, 192);
        setMachine(worn, {.work_speed_rpm = 100, .radii = 96});
        QCOMPARE(worn.part->radii_per_section, 384);
        worn.part->profile = ProfileForm::measured; // whose radii are typed
        changeWheelDiameter(worn, p.wheel->diameter_mm / 4);
        QCOMPARE(worn.part->radii_per_section, 384);
        worn.wheel->runout.reset();
        worn.part->profile = ProfileForm::ellipse;
        changeWheelDiameter(worn, p.wheel->diameter_mm / 8);
        QCOMPARE(worn.part->radii_per_section, 384);
    }

    /// Where the runout is not given, a sweep and a batch have no value.
    void wavesThatAreNotKnownAreNoZero() {
        Project p = shaft(8, 96, 10);
        p.part->tolerance.waviness_um = 0.9;
        p.wheel->runout.reset();
        p.sweep =
            Sweep{{{.input = "/machine/work_speed_rpm", .from = 160, .to = 200, .points = 2}}};
        const SweepResult swept = runSweep(p);
        const auto column = std::ranges::find(swept.quantities, "waviness", &SweepQuantity::name)
                            - swept.quantities.begin();
        const SweepValue& value = swept.points[0].values[static_cast<std::size_t>(column)];
        QVERIFY(std::isnan(value.value) && std::isnan(value.margin));
        p.batch = Batch{};
        p.batch->parts = 3;
        const std::vector<Characteristic> all = characteristicsOf(p);
        const auto row = std::ranges::find_if(all, [](const Characteristic& each) {
            return each.requirement && each.requirement->kind == ConstraintKind::waviness;
        });
        const auto i = static_cast<std::size_t>(row - all.begin());
        QVERIFY(runBatch(p).statistics.values.at(i).count == 0);
        const SimulationResult unknown = runOf(p);
        const auto json = nlohmann::json::parse(resultJson(unknown, evaluateConstraints(unknown)));
        const auto& rows = json.at("constraints");
        const auto waviness = std::ranges::find_if(
            rows, [](const auto& each) { return each.at("name") == "waviness"; });
        QVERIFY(waviness->at("value").is_null() && waviness->at("margin").is_null());
        QVERIFY(!waviness->at("machine_known").template get<bool>());
    }

    /// The round wheel leaves no wave higher than λ²/(4·D_e).
    void theRoundWheelFollowsNoShortWave() {
        Project p = shaft(200, 2400, 10);
        p.wheel->diameter_mm = 400;
        p.machine->wheel_speed_m_s = 200 * workSpeed_rpm * pi * 400 / 60e3;
        p.wheel->runout->amplitude_um = 5;
        const double length_mm = pi * 40 / 200, De = 40.0 * 400 / 440;
        QVERIFY(within(2 * wheelWave(p)->amplitude_mm, length_mm * length_mm / (4 * De), 1e-9));
        p.wheel->runout->amplitude_um = 0.5;
        QVERIFY(within(wheelWave(p)->amplitude_mm, 0.5e-3, 1e-12));
    }

    /// Every stock is decided at four angles of the wheel, by the verdict, the search and the
    /// remedies alike; corners of a batch are two angles.
    void everyStockIsDecidedAtFourAngles() {
        Project p = shaft(8.3, 204, 5);
        p.wheel->runout->amplitude_um = 3;
        p.part->initial_runout_mm = 0.03;
        p.part->profile = ProfileForm::ellipse;
        QCOMPARE(atOtherWheelPhases(p).size(), std::size_t(phasesOfWheel - 1));
        QCOMPARE(atOtherWheelPhases(p)[1].wheel->runout->phase_deg, 180.0);
        const StockRange range = usualPhases(p);
        for (const double limit_um : {7.0, 8.0, 9.0, 10.0, 12.0}) {
            p.part->tolerance.roundness_um = limit_um;
            const PhaseDecision decision = decidePhases(p, range);
            const std::optional<Project> failing = failingStock(p, range);
            QVERIFY(decision.isDecided);
            QCOMPARE(failing.has_value(), !decision.failing.empty());
            if (failing) {
                const auto fails = simulate(*failing);
                QVERIFY(!std::ranges::all_of(evaluateConstraints(fails), &ConstraintResult::holds));
                QVERIFY(std::ranges::all_of(decision.failing, [](const FailingStocks& each) {
                    return each.wheel_deg.has_value();
                }));
            }
        }
        p.batch = Batch{};
        p.batch->scenarios = Scenarios::corners;
        p.batch->factors.wheel_phase_deg = usualFactor(FactorKind::wheelPhase, p);
        const ScenarioSource corners(p);
        const Project first = corners.project(0), second = corners.project(1);
        QCOMPARE(first.wheel->runout->phase_deg, 0.0);
        QCOMPARE(second.wheel->runout->phase_deg, 180.0);
    }

    void wavinessLeavesOutTheLowerOrders() {
        constexpr int radii = 96;
        std::vector<double> profile;
        for (int k = 0; k < radii; ++k) {
            const double phi = 2 * pi * k / radii;
            profile.push_back(20 + 0.01 * std::cos(phi - 1) + 0.005 * std::cos(3 * phi)
                              + 1e-3 * std::cos(8 * phi + 2));
        }
        const Waviness waves = wavinessOf(profile, Directions(radii), 4);
        QVERIFY(within(waves.height_mm, 2e-3, 1e-4)); // crests lie between two radii
        QCOMPARE(waves.orders.front().lobes, 4);
        QCOMPARE(waves.orders.back().lobes, radii / 2);
        QVERIFY(within(waves.orders[4].amplitude_mm, 1e-3, 1e-12));
        profile[5] = std::nan("");
        QVERIFY(std::isfinite(wavinessOf(profile, Directions(radii), 4).height_mm));
    }

    // A batch draws the phase over the whole turn: the waves turn, and keep their height.
    void batchDrawsThePhaseOfTheWheel() {
        Project p = shaft(8, 96, 100);
        p.part->tolerance.waviness_um = 2;
        p.batch = Batch{};
        p.batch->parts = 20;
        p.batch->factors.wheel_phase_deg = usualFactor(FactorKind::wheelPhase, p);
        QVERIFY(checkBatch(p).empty());
        const std::vector<Characteristic> all = characteristicsOf(p);
        const BatchResult batch = runBatch(p);
        bool isFound = false;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].requirement && all[i].requirement->kind == ConstraintKind::waviness) {
                const Moments moments = momentsOf(batch.statistics.values[i]);
                // Twelve radii a wave state its height to 3.4 %, by where they lie on it.
                QVERIFY(within(moments.mean, 2 * amplitude_um, 0.034));
                QVERIFY(moments.deviation < 0.017);
                isFound = true;
            }
        }
        QVERIFY(isFound);
        Project turned = p;
        putFactor(FactorKind::wheelPhase, 180, turned);
        QCOMPARE(turned.wheel->runout->phase_deg, 180.0);
        QVERIFY(runOf(turned).sections[0].radii_mm != runOf(p).sections[0].radii_mm);
        const Project usual = withUsualBatch(p);
        QVERIFY(usual.batch->factors.wheel_phase_deg);
        p.wheel->runout.reset();
        QVERIFY(!checkBatch(p).empty());
        const Project without = withUsualBatch(p);
        QVERIFY(!without.batch->factors.wheel_phase_deg);
    }

    // No radius is deeper than t_П + e, and what is proved of cuts that follow one another is left
    // out.
    void boundsOfTheSearchAllowForTheWave() {
        Project p = shaft(8.3, 96, 10);
        const double limit_s = steplessLimit_s(p);
        QVERIFY(limit_s <= runOf(p).time_s);
        QVERIFY(std::isinf(provedLastCut_mm(p, 40, 6e-5)));
        for (Project each : {fixtures::plunge(), fixtures::traverse()}) {
            each.wheel->runout = WheelRunout{.amplitude_um = 3};
            resolveWaves(each);
            QVERIFY(steplessLimit_s(each) <= simulate(each).time_s);
        }
    }
};

} // namespace sparkout::test_wheel_wave

SPARKOUT_TEST(test_wheel_wave, TestWheelWave)
#include "test_wheel_wave.moc"
