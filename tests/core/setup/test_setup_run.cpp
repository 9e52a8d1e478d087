// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of a set-up one after the other: wheel, times, verdict.
#include "core/quality/result_json.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/setup_run.h"
#include "core/setup/worn_project.h"
#include "core/simulation/simulate.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <stop_token>
#include <thread>
#include <utility>

namespace sparkout::test_setup_run {

using namespace setup_samples;
using nlohmann::json;

Setup threeSurfaces() {
    const json one = samples::sample("complete");
    return *readSetup(setupOf({one, one, one}).dump()).setup;
}

std::string resultOf(const Project& project) {
    const SimulationResult result = simulate(project);
    return resultJson(result, evaluateConstraints(result));
}

bool isNear(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

class TestSetupRun : public QObject {
    Q_OBJECT

private slots:
    /// Without wear each surface is what its own file gives, to the last digit.
    void surfacesDoNotTouchEachOtherUnlessTheWheelWears() {
        int surfaces = 0;
        for (std::uint64_t seed = 0; seed < 150; ++seed) {
            const auto setup = randomSetup(seed);
            if (!setup) {
                continue;
            }
            const SetupRun run = runSetup(*setup);
            QCOMPARE(run.surfaces.size(), setup->surfaces.size());
            for (std::size_t i = 0; i < run.surfaces.size(); ++i) {
                QCOMPARE(resultJson(run.surfaces[i].result, run.surfaces[i].constraints),
                         resultOf(setup->surfaces[i].project));
                ++surfaces;
            }
        }
        QVERIFY(surfaces > 60);
    }

    /// What the parts lose is what the wheel has lost, times G; dullness by the volume.
    void theWheelGoesOnFromSurfaceToSurface() {
        Setup setup = threeSurfaces();
        setup.wear.grinding_ratio = 0.5;
        setup.wear.dulling_per_mm2 = 1e-5;
        const Wheel first = *setup.surfaces[0].project.wheel;
        const SetupRun run = runSetup(setup);
        QCOMPARE(run.surfaces.size(), 3u);
        double removed_mm3 = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Wheel& wheel = *run.surfaces[i].result.project.wheel;
            const double lost_mm3 =
                std::numbers::pi / 4 * first.width_mm
                * (std::pow(first.diameter_mm, 2) - std::pow(wheel.diameter_mm, 2));
            QVERIFY(std::abs(0.5 * lost_mm3 - removed_mm3) <= 1e-6 * (1 + removed_mm3));
            QVERIFY(isNear(wheel.dullness, first.dullness + 1e-5 * removed_mm3 / first.width_mm));
            QCOMPARE(resultOf(wornProject(setup, i).project),
                     resultJson(run.surfaces[i].result, run.surfaces[i].constraints));
            removed_mm3 += shopNumbers(run.surfaces[i].result).cycle.removedVolume_mm3;
        }
        QVERIFY(removed_mm3 > 100);
        QVERIFY(run.surfaces[2].result.peakNormalForce_n
                > run.surfaces[0].result.peakNormalForce_n);
    }

    /// The wheel that comes to a surface is to the bit the one of a fresh run, after any edit; what
    /// is known is not run again.
    void whatIsKnownOfTheSurfacesBeforeIsNotRunAgain() {
        Setup setup = threeSurfaces();
        setup.wear.grinding_ratio = 40;
        setup.wear.dulling_per_mm2 = 1e-5;
        RemovedVolumes known;
        const auto check = [&] {
            for (std::size_t i = 0; i < 3; ++i) {
                const WornProject fresh = wornProject(setup, i);
                for (int times = 0; times < 2; ++times) {
                    const WornProject made = wornProject(setup, i, {}, &known);
                    QVERIFY(made.project.wheel->diameter_mm == fresh.project.wheel->diameter_mm);
                    QVERIFY(made.project.wheel->dullness == fresh.project.wheel->dullness);
                    QCOMPARE(resultOf(made.project), resultOf(fresh.project));
                }
            }
        };
        check();
        setup.surfaces[0].project.cycle->stages[0].stock_mm *= 0.5;
        check();
        setup.surfaces[1].project.machine->work_speed_rpm += 10;
        check();
        setup.wear.grinding_ratio = 20;
        check();
        setup.surfaces[0].project.wheel->dullness = 0.03;
        check();
        std::swap(setup.surfaces[0], setup.surfaces[1]);
        check();

        RemovedVolumes invented;
        const Project first = setup.surfaces[0].project;
        QVERIFY(!invented.find(first));
        (void)wornProject(setup, 1, {}, &invented);
        const double removed_mm3 = runSetup(setup).surfaces[0].removed_mm3;
        QVERIFY(invented.find(first) == removed_mm3);
        RemovedVolumes none;
        none.add(first, 0); // taken as it is
        const double wheel_mm = setup.surfaces[1].project.wheel->diameter_mm;
        const WornProject unworn = wornProject(setup, 1, {}, &none);
        const WornProject worn = wornProject(setup, 1);
        QVERIFY(unworn.project.wheel->diameter_mm == wheel_mm);
        QVERIFY(worn.project.wheel->diameter_mm < wheel_mm);
    }

    /// Whenever the stop comes, what is known is what a whole run removes.
    void aRunThatWasStoppedIsNotKnown() {
        Setup setup = threeSurfaces();
        setup.wear.grinding_ratio = 40;
        setup.surfaces[0].project.part->radii_per_section = 3600; // takes its time
        const Project& first = setup.surfaces[0].project;
        const double removed_mm3 = runSetup(setup).surfaces[0].removed_mm3;
        int unknown = 0;
        for (int delay_us = 0; delay_us <= 6000; delay_us += 100) {
            std::stop_source stop;
            RemovedVolumes known;
            std::thread stopper([&stop, delay_us] {
                std::this_thread::sleep_for(std::chrono::microseconds(delay_us));
                stop.request_stop();
            });
            (void)wornProject(setup, 2, stop.get_token(), &known);
            stopper.join();
            const std::optional<double> found = known.find(first);
            QVERIFY(!found || *found == removed_mm3);
            unknown += found ? 0 : 1;
        }
        QVERIFY(unknown > 0);
    }

    void aWheelBeyondItsRangeIsAFaultOfTheSurfaceItComesTo() {
        Setup setup = threeSurfaces();
        setup.wear.grinding_ratio = 0.01; // wears off altogether
        setup.surfaces[0].project.wheel->diameter_mm = 5;
        setup.surfaces[1].project.wheel->diameter_mm = 5;
        const SetupRun run = runSetup(setup);
        QCOMPARE(run.surfaces.size(), 1u);
        QVERIFY(!run.isCompleted(setup) && !run.holds(setup));
        QVERIFY(!run.issues.empty());
        QCOMPARE(run.issues.front().path, std::string("/wheel/diameter_mm"));
        QCOMPARE(wornProject(setup, 2).surface, 1u); // whose fault it is
        const json answer = json::parse(setupJson(setup, run));
        QVERIFY(answer.at("part").at("main_time_min").is_null());
        QVERIFY(answer.at("part").at("completed") == false);
    }

    /// n·(approach + retreat + gauging) + (n − 1)·positioning + handling, by hand.
    void timesAddUp() {
        Setup setup = threeSurfaces();
        setup.times.approach_s = 3;
        setup.times.retreat_s = 2;
        setup.times.gauging_s = 10;
        setup.times.positioning_s = 6;
        setup.times.handling_s = 33;
        setup.times.service_percent = 10;
        setup.times.preparation_min = 20;
        setup.times.batch_size = 40;
        const SetupRun run = runSetup(setup);
        const double cycle_min = simulate(setup.surfaces[0].project).time_s / 60;
        QVERIFY(isNear(run.time.main_min, 3 * cycle_min));
        QVERIFY(isNear(run.time.auxiliary_min, 1.5)); // 3·15 s + 2·6 s + 33 s
        QVERIFY(isNear(run.time.piece_min, 1.1 * (3 * cycle_min + 1.5)));
        QVERIFY(isNear(run.time.calculation_min, run.time.piece_min + 0.5));
        setup.times.main_min = 5;
        setup.times.auxiliary_min = 2;
        const PieceTime given = pieceTime(setup.times, 3, cycle_min);
        QVERIFY(isNear(given.piece_min, 7.7));
        setup.times.piece_min = 9;
        QVERIFY(isNear(pieceTime(setup.times, 3, cycle_min).calculation_min, 9.5));
        QVERIFY(isNear(pieceTime({}, 1, cycle_min).calculation_min, cycle_min));
    }

    void thePartHoldsWhenEverySurfaceDoes() {
        Setup setup = threeSurfaces();
        QVERIFY(runSetup(setup).holds(setup));
        setup.surfaces[1].project.part->tolerance.roundness_um = 1e-6;
        const SetupRun run = runSetup(setup);
        QVERIFY(run.isCompleted(setup) && !run.holds(setup));
        QVERIFY(run.surfaces[0].holds() && !run.surfaces[1].holds() && run.surfaces[2].holds());
    }

    /// The shipped spindle: journals by traverse, seats by plunging, one with a keyway.
    void theShippedSpindleHoldsItsDrawing() {
        const auto file = samples::sourcePath("resources/examples/setups/spindle.sparkout");
        const ReadSetup read = readSetup(samples::readText(file));
        QVERIFY2(read.setup, samples::listed(read.issues).c_str());
        const Setup& setup = *read.setup;
        QCOMPARE(setup.surfaces.size(), 5u);
        const auto count = [&setup](const auto& is) {
            return std::ranges::count_if(setup.surfaces, [&is](const GroundSurface& surface) {
                return is(surface.project);
            });
        };
        QCOMPARE(count([](const Project& p) { return p.operation == Operation::traverse; }), 2);
        QCOMPARE(count([](const Project& p) { return !p.part->gaps.empty(); }), 1);
        const SetupRun run = runSetup(setup);
        QVERIFY(run.holds(setup));
        QVERIFY(run.time.piece_min > run.time.main_min && run.time.main_min > 1);
    }

    void aStopLeavesWhatWasRun() {
        const Setup setup = threeSurfaces();
        const StoppedSource stop;
        QVERIFY(runSetup(setup, stop.get_token()).surfaces.empty());
    }
};

} // namespace sparkout::test_setup_run

SPARKOUT_TEST(test_setup_run, TestSetupRun)
#include "test_setup_run.moc"
