// SPDX-License-Identifier: GPL-3.0-or-later
// The parts between dressings: closed form of the drive's limit, every part tried by hand, laws.
#include "core/dressing/dressing_interval.h"
#include "core/dressing/part_cost.h"
#include "core/dressing/worn_parts.h"
#include "core/process/force.h"
#include "core/project/batch.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <stop_token>

namespace test_dressing_interval {

using namespace sparkout;

namespace {

/// So stiff that every revolution removes what it is fed: 5 µm of 40 mm.
Setup stiffPlunge() {
    Project project = fixtures::plunge();
    project.machine->compliance_mm_per_n = std::vector<double>{1e-12};
    project.part->upper_deviation_um = 100;
    project.part->lower_deviation_um = -100;
    Setup setup = plainSetup(project);
    setup.wear.dulling_per_mm2 = 1e-5;
    return setup;
}

/// The power of the wheel at a dullness, of a cut of 5 µm [kW].
double power_kw(const Project& project, double dullness) {
    Project dull = project;
    dull.wheel->dullness = dullness;
    const ForceLaw law = forceLaw(dull);
    return dull.machine->wheel_speed_m_s * law.tangential(40, std::sqrt(0.005)) / 1000;
}

/// Parts whose power is below the limit when n parts before them have removed n·V.
std::int64_t closedForm(const Setup& setup, double most_kw) {
    const Project& project = setup.surfaces[0].project;
    const double sharp = power_kw(project, 0);
    const double slope = power_kw(project, 1) - sharp; // k_r, and with it the power, grows with η
    const double mostDull = (most_kw - sharp) / slope;
    const double specific_mm2 = std::numbers::pi * 30 * 0.2; // of a part: V/B with L = B
    const double grown = (mostDull - project.wheel->dullness) / *setup.wear.dulling_per_mm2;
    return static_cast<std::int64_t>(
               std::floor(std::pow(grown, 1 / setup.wear.dulling_exponent) / specific_mm2))
           + 1;
}

bool holdsByHand(const Project& project) {
    const SimulationResult result = simulate(project);
    return result.status == RunStatus::completed
           && std::ranges::all_of(evaluateConstraints(result), &ConstraintResult::holds);
}

/// Parts that hold, one by one until the first that does not, at most so many.
std::int64_t byHand(const Setup& setup, std::int64_t most) {
    const double part_mm3 = std::accumulate(setup.surfaces.begin(), setup.surfaces.end(), 0.0,
                                            [](double sum, const GroundSurface& surface) {
                                                const Part& part = *surface.project.part;
                                                return sum
                                                       + std::numbers::pi * part.diameter_mm
                                                             * part.stock_mm * part.length_mm
                                                             * engagedShare(part);
                                            });
    for (std::int64_t n = 1; n <= most; ++n) {
        double before_mm3 = 0;
        for (const GroundSurface& surface : setup.surfaces) {
            Project first = surface.project;
            *first.wheel = wheelAfter(*surface.project.wheel, setup.wear, before_mm3);
            Project worn = surface.project;
            *worn.wheel = wheelAfter(*surface.project.wheel, setup.wear,
                                     static_cast<double>(n - 1) * part_mm3 + before_mm3);
            if (!holdsByHand(worn)) {
                return n - 1;
            }
            before_mm3 += shopNumbers(simulate(first)).cycle.removedVolume_mm3;
        }
    }
    return most;
}

} // namespace

class TestDressingInterval : public QObject {
    Q_OBJECT

private slots:
    void aStiffPlungeGrindsUntilItsDriveIsLoaded() {
        for (const double exponent : {1.0, 0.6, 1.3}) {
            for (const double over : {1.05, 1.2, 1.5}) {
                Setup setup = stiffPlunge();
                Project& project = setup.surfaces[0].project;
                setup.wear.dulling_exponent = exponent;
                setup.wear.dulling_per_mm2 = 1e-3 / std::pow(1000, exponent);
                const double most_kw = over * power_kw(project, project.wheel->dullness);
                project.machine->wheel_drive_kw = most_kw;
                const DressingInterval found = dressingInterval(setup);
                QVERIFY(found.ran() && found.end && found.end->worst);
                QVERIFY(found.end->worst->kind == ConstraintKind::wheelPower);
                QCOMPARE(found.parts, closedForm(setup, most_kw));
                QVERIFY(found.parts > 1);
                QCOMPARE(found.end->part, found.parts + 1);
                QCOMPARE(found.time_s.size(), static_cast<std::size_t>(found.parts));
            }
        }
    }

    /// p = 1 is η_0 + c·V/B to the last bit; the volume ground is that of the drawing.
    void theWheelIsThatOfThePartsBefore() {
        const Setup setup = stiffPlunge();
        const SetupRun first = runSetup(setup);
        const WornParts worn(setup, first);
        const double part_mm3 = nominalVolume_mm3(setup.surfaces[0].project);
        QVERIFY(fixtures::close(part_mm3, std::numbers::pi * 30 * 0.2 * 40, 1e-15));
        QVERIFY(fixtures::close(first.surfaces[0].removed_mm3, part_mm3, 0.05));
        for (const std::int64_t part : {1, 2, 10, 500}) {
            const double specific_mm2 = static_cast<double>(part - 1) * part_mm3 / 40;
            QCOMPARE(worn.wheel(0, part).dullness, std::min(1.0, 0.02 + 1e-5 * specific_mm2));
        }
        QVERIFY(!worn.isWornOut(500) && worn.isWornOut(100000));
    }

    /// Random set-ups of up to four surfaces, whose limits fail or hold as they happen to.
    void noPartBeforeTheLastFails() {
        int ended = 0, several = 0, whole = 0;
        const std::int64_t most = 40;
        const auto setups = static_cast<std::uint64_t>(samples::sized(250, 60, 2000));
        for (std::uint64_t seed = 0; seed < setups; ++seed) {
            auto setup = setup_samples::randomSetup(seed);
            if (!setup) {
                continue;
            }
            setup->wear.dulling_per_mm2 = 1e-6 * static_cast<double>(1 + seed % 97);
            setup->wear.dulling_exponent = seed % 3 == 0 ? 0.7 : 1;
            if (seed % 2 == 0) {
                setup->wear.grinding_ratio = 20;
            }
            for (GroundSurface& surface : setup->surfaces) { // most hold as long as they end
                surface.project.part->tolerance = {};
                surface.project.part->upper_deviation_um += 20;
                surface.project.part->lower_deviation_um -= 20;
            }
            DressingOptions few;
            few.most = most;
            const DressingInterval found = dressingInterval(*setup, few);
            if (!found.ran()) {
                continue;
            }
            QCOMPARE(found.parts, byHand(*setup, most));
            QVERIFY(found.end.has_value() == (found.parts < most));
            ended += found.end ? 1 : 0;
            several += found.parts > 1 && found.end ? 1 : 0;
            whole += found.end ? 0 : 1;
        }
        std::printf("%d set-ups ended, %d of them after some parts, %d held\n", ended, several,
                    whole);
        QVERIFY(ended > 5 && several > 0 && whole > 0);
    }

    void aDullerWheelAndMoreCasesNeverGiveMoreParts() {
        Setup setup = stiffPlunge();
        Project& project = setup.surfaces[0].project;
        project.machine->wheel_drive_kw = 1.3 * power_kw(project, project.wheel->dullness);
        setup.wear.dulling_per_mm2 = 2e-6;
        const std::int64_t parts = dressingInterval(setup).parts;
        project.batch = Batch{};
        project.batch->parts = 12;
        project.batch->factors.flow_stress_mpa = fixtures::uniform(1900, 2100);
        project.batch->factors.dullness = fixtures::uniform(0.5, 0.6); // the wear's instead
        QCOMPARE(dressingInterval(setup).parts, parts);
        DressingOptions options;
        options.scenarios = Scenarios::latin_hypercube;
        const DressingInterval batch = dressingInterval(setup, options);
        QVERIFY(batch.parts < parts && batch.end->scenario);
        options.scenarios = Scenarios::corners;
        const DressingInterval corners = dressingInterval(setup, options);
        QVERIFY(corners.parts <= batch.parts && corners.end->scenario);
        Setup strong = setup;
        strong.surfaces[0].project.material->flow_stress_mpa = 2100;
        QCOMPARE(corners.parts, dressingInterval(strong).parts);
        setup.wear.dulling_per_mm2 = 4e-6;
        QVERIFY(dressingInterval(setup).parts < parts);
    }

    void aWheelThatIsAsDullAsCanBeGoesOn() {
        Setup setup = stiffPlunge();
        setup.wear.dulling_per_mm2 = 1e-3;
        const DressingInterval found = dressingInterval(setup);
        QVERIFY(found.isEndless && !found.end);
        QVERIFY(found.time_s.size() < 100);
    }

    void theBestIntervalIsTheBestOfAll() {
        DressingInterval interval;
        for (int n = 1; n <= 60; ++n) {
            interval.time_s.push_back(30 + 0.02 * n * n);
        }
        Cost cost;
        cost.machine_per_h = 1800;
        cost.handling_s = 20;
        cost.dressing_s = 120;
        cost.dressing_cost = 35;
        const auto quickest = quickestInterval(interval, cost.dressing_s);
        const auto cheapest = cheapestInterval(interval, cost);
        for (int n = 1; n <= 60; ++n) {
            // Σ k² = n(n + 1)(2n + 1)/6
            const double mean_s = 30 + 0.02 * (n + 1) * (2 * n + 1) / 6;
            const double each = 0.5 * (mean_s + 20 + 120.0 / n) + 35.0 / n;
            QVERIFY(quickest->value <= (mean_s + 120.0 / n) * (1 + 1e-14));
            QVERIFY(cheapest->value <= each * (1 + 1e-14));
            if (n == quickest->parts) {
                QVERIFY(fixtures::close(quickest->value, mean_s + 120.0 / n, 1e-14));
            }
            if (n == cheapest->parts) {
                QVERIFY(fixtures::close(cheapest->value, each, 1e-14));
            }
        }
        QVERIFY(quickest->parts < cheapest->parts && cheapest->parts < 60); // wheels cost, too
        QVERIFY(!quickestInterval({}, 1));
    }

    void whatCannotBeSaidIsNot() {
        Setup setup = stiffPlunge();
        setup.wear = {};
        QVERIFY(dressingInterval(setup).fault == DressingFault::noWear);
        setup = stiffPlunge();
        std::stop_source stop;
        stop.request_stop();
        DressingOptions options;
        options.stop = stop.get_token();
        const DressingInterval stopped = dressingInterval(setup, options);
        QVERIFY(stopped.isStopped && stopped.parts == 0 && stopped.time_s.empty());
        setup.surfaces[0].project.cycle->stages.clear();
        QVERIFY(!dressingInterval(setup).ran());
    }
};

} // namespace test_dressing_interval

SPARKOUT_TEST(test_dressing_interval, TestDressingInterval)
#include "test_dressing_interval.moc"
