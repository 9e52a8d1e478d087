// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The parts between dressings: closed form of the drive's limit, every part tried by hand, laws.
#include "core/process/force.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/dressing_interval.h"
#include "core/setup/worn_project.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

namespace sparkout::test_dressing_interval {

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

/// What the stiff plunge removes of each millimetre of the wheel's width, whatever its wheel: 40
/// whole revolutions of 5 µm and a spiral, of which the radii have 1/4 … 4/4 [mm²].
double specific_mm2() {
    return std::numbers::pi * 30 * 0.005 * (40 + 2.5 / 4);
}

/// Parts whose power is below the limit when n parts before them have removed n·V.
std::int64_t closedForm(const Setup& setup, double most_kw) {
    const Project& project = setup.surfaces[0].project;
    const double sharp = power_kw(project, 0);
    const double slope = power_kw(project, 1) - sharp; // k_r, and with it the power, grows with η
    const double mostDull = (most_kw - sharp) / slope;
    const double grown = (mostDull - project.wheel->dullness) / *setup.wear.dulling_per_mm2;
    return static_cast<std::int64_t>(
               std::floor(std::pow(grown, 1 / setup.wear.dulling_exponent) / specific_mm2()))
           + 1;
}

/// The parts that hold, one by one until the first that does not, at most so many: each simulated
/// with a wheel that carries the metal of the first parts before it.
struct ByHand {
    std::int64_t parts = 0;
    std::vector<double> time_s; ///< of each
    double part_mm3 = 0;

    ByHand(const Setup& setup, std::int64_t most) {
        for (; parts < most; ++parts) {
            RemovedMetal ofPart;
            double time = 0;
            for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
                const Project& dressed = setup.surfaces[i].project;
                Project worn = dressed;
                const RemovedMetal before = parts == 0 ? ofPart : m_before[i];
                *worn.wheel = wheelAfter(*dressed.wheel, setup.wear,
                                         before + static_cast<double>(parts) * m_part);
                if (worn.machine->wheel_speed_control == WheelSpeedControl::constant_revolutions) {
                    worn.machine->wheel_speed_m_s *=
                        worn.wheel->diameter_mm / dressed.wheel->diameter_mm;
                }
                const SimulationResult result = simulate(worn);
                if (result.status != RunStatus::completed
                    || !std::ranges::all_of(evaluateConstraints(result),
                                            &ConstraintResult::holds)) {
                    return;
                }
                m_before.push_back(ofPart);
                ofPart += removedMetal(worn, shopNumbers(result).cycle.removedVolume_mm3);
                time += result.time_s;
            }
            m_part = parts == 0 ? ofPart : m_part;
            part_mm3 = m_part.volume_mm3;
            time_s.push_back(time);
        }
    }

private:
    std::vector<RemovedMetal> m_before; ///< of the surfaces before each, in the first part
    RemovedMetal m_part;
};

class TestDressingInterval : public QObject {
    Q_OBJECT

private slots:
    void theDressingCompensatesTheStatedWear() {
        Setup setup = stiffPlunge();
        setup.wear = {};
        setup.wear.grinding_ratio = 20;
        Project& project = setup.surfaces[0].project;
        project.gauge->control = Control::position;
        const DressingInterval plain = dressingInterval(setup);
        QVERIFY(plain.ran());
        project.wheel->radius_wear_um = 30;
        const DressingInterval stated = dressingInterval(setup);
        QVERIFY(stated.ran());
        QVERIFY(plain.parts > 1);
        QCOMPARE(stated.parts, plain.parts);
        QCOMPARE(SurfaceWear(setup, 0).setup.surfaces[0].project.wheel->radius_wear_um, 0.0);
    }

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

    /// p = 1 is η_0 + c·V/B to the last bit; V is the metal removed as simulated, with the runout
    /// of the blank and what is cut past the threshold, not the stock of the drawing.
    void theWheelIsThatOfTheMetalRemovedBefore() {
        const SurfaceWear wear(stiffPlunge(), 0);
        const Project& project = wear.setup.surfaces[0].project;
        const double part_mm3 = removedVolume_mm3(simulate(project));
        QVERIFY(fixtures::close(part_mm3, 40 * specific_mm2(), 1e-8)); // it yields a little
        QVERIFY(part_mm3 > 1.01 * nominalVolume_mm3(project));
        WheelCourse course(wear);
        Project worn = project;
        course.putWheel(worn, 1);
        QCOMPARE(worn.wheel->dullness, 0.02);
        course = course.ofCycle(part_mm3);
        for (const std::int64_t part : {1, 2, 10, 500}) {
            const double removed_mm3 = static_cast<double>(part - 1) * part_mm3;
            course.putWheel(worn, part);
            QCOMPARE(worn.wheel->dullness, std::min(1.0, 0.02 + 1e-5 * (removed_mm3 / 40)));
        }
        QVERIFY(!course.isWornOut(500) && course.isWornOut(100000));
    }

    /// Runout that the drawing does not know of is cut too: the same part with a greater runout
    /// dulls the wheel sooner.
    void runoutDullsTheWheelToo() {
        Setup setup = stiffPlunge();
        Project& project = setup.surfaces[0].project;
        project.part->profile = ProfileForm::eccentric;
        project.machine->wheel_drive_kw = 1.2 * power_kw(project, project.wheel->dullness);
        setup.wear.dulling_per_mm2 = 1e-6;
        const std::int64_t round = dressingInterval(setup).parts;
        project.part->initial_runout_mm = 0.1;
        const DressingInterval uneven = dressingInterval(setup);
        QVERIFY(uneven.end && uneven.parts > 1 && uneven.parts < 0.9 * double(round));
        QCOMPARE(uneven.parts, ByHand(setup, round).parts);
    }

    /// Random set-ups of up to four surfaces, whose limits fail or hold as they happen to.
    void noPartBeforeTheLastFails() {
        int ended = 0, several = 0, whole = 0;
        const std::int64_t most = 40;
        const auto setups = static_cast<std::uint64_t>(samples::sized(250, 150, 2000));
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
            const ByHand byHand(dressedSetup(*setup), most);
            QCOMPARE(found.parts, byHand.parts);
            QVERIFY2(found.time_s.size() == byHand.time_s.size(), std::to_string(seed).c_str());
            for (std::size_t i = 0; i < byHand.time_s.size(); ++i) {
                QVERIFY(fixtures::close(found.time_s[i], byHand.time_s[i], 1e-12));
            }
            QVERIFY(found.parts == 0
                    || fixtures::close(found.partVolume_mm3, byHand.part_mm3, 1e-12));
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

    /// The worn wheel of a batch's part is that part's own wheel, worn: its diameter and width are
    /// factors of the batch.
    void aScenarioKeepsItsOwnWheel() {
        Setup setup = stiffPlunge();
        Project& project = setup.surfaces[0].project;
        project.machine->wheel_speed_control = WheelSpeedControl::constant_revolutions;
        project.machine->wheel_drive_kw = 1.3 * power_kw(project, project.wheel->dullness);
        setup.wear.dulling_per_mm2 = 2e-6;
        project.batch = Batch{};
        project.batch->factors.wheel_diameter_mm = fixtures::uniform(590, 600);
        DressingOptions options;
        options.scenarios = Scenarios::corners;
        const DressingInterval corners = dressingInterval(setup, options);
        Setup smaller = setup;
        smaller.surfaces[0].project.wheel->diameter_mm = 590;
        smaller.surfaces[0].project.machine->wheel_speed_m_s *= 590.0 / 600;
        const std::int64_t least =
            std::min(dressingInterval(setup).parts, dressingInterval(smaller).parts);
        QVERIFY(dressingInterval(setup).parts != dressingInterval(smaller).parts);
        QCOMPARE(corners.parts, least);
    }

    void aWheelThatIsAsDullAsCanBeGoesOn() {
        Setup setup = stiffPlunge();
        setup.wear.dulling_per_mm2 = 1e-3;
        const DressingInterval found = dressingInterval(setup);
        QVERIFY(found.isEndless && !found.end);
        QVERIFY(found.tried < 100); // the others come to the same wheel
        QCOMPARE(found.time_s.size(), static_cast<std::size_t>(found.parts));
        // The wheel comes to the second of two surfaces as dull as can be a part before it comes so
        // to the first: the part takes the time of both from then on, too.
        setup.surfaces.push_back(setup.surfaces.front());
        setup.wear.dulling_per_mm2 = 3e-3;
        const ByHand byHand(dressedSetup(setup), 60);
        DressingOptions few;
        few.most = 60;
        const DressingInterval both = dressingInterval(setup, few);
        QVERIFY(both.isEndless && byHand.parts == 60);
        QCOMPARE(both.time_s.size(), byHand.time_s.size());
        for (std::size_t i = 0; i < byHand.time_s.size(); ++i) {
            QVERIFY(fixtures::close(both.time_s[i], byHand.time_s[i], 1e-12));
        }
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
        const StoppedSource stop;
        DressingOptions options;
        options.stop = stop.get_token();
        const DressingInterval stopped = dressingInterval(setup, options);
        QVERIFY(stopped.isStopped && stopped.parts == 0 && stopped.time_s.empty());
        setup.surfaces[0].project.cycle->stages.clear();
        QVERIFY(!dressingInterval(setup).ran());
    }
};

} // namespace sparkout::test_dressing_interval

SPARKOUT_TEST(test_dressing_interval, TestDressingInterval)
#include "test_dressing_interval.moc"
