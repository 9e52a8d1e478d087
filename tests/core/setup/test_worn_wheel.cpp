// SPDX-License-Identifier: GPL-3.0-or-later
// A worn wheel: its radius under position control, and its speed as the drive has it [MODEL-7, 8,
// 12].
#include "core/batch/scenario_source.h"
#include "core/batch/sweep_run.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/dressing_interval.h"
#include "core/setup/setup.h"
#include "core/setup/setup_run.h"
#include "core/setup/worn_project.h"
#include "core/study/sweep_edits.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

namespace sparkout::test_worn_wheel {

using fixtures::close;
using fixtures::within;

constexpr double rigid = 1e-15; ///< [mm/N]

Project byPosition(Project p) {
    p.gauge->control = Control::position;
    return p;
}

/// A shaft and a bore by plunging, and a shaft by traverse grinding, all rigid.
std::vector<Project> rigidProjects() {
    Project plunge = fixtures::plunge();
    plunge.part->initial_runout_mm = 0.02;
    plunge.machine->compliance_mm_per_n = std::vector<double>{rigid};
    plunge.cycle->stages = {fixtures::plungeStage(0.9, 0.17), fixtures::plungeStage(0.2, 0.03),
                            fixtures::sparkStage(fixtures::count(5))};
    Project bore = plunge;
    bore.part->surface = Surface::internal;
    bore.part->diameter_mm = 50;
    bore.wheel->diameter_mm = 40;
    Project traverse = fixtures::traverse();
    traverse.machine->compliance_mm_per_n = ZoneCompliance{rigid, rigid, rigid};
    Project both = traverse;
    both.machine->reversal_infeed = ReversalInfeed::both;
    return {plunge, bore, traverse, both};
}

SimulationResult worn(Project p, double wear_um) {
    p.wheel->radius_wear_um = wear_um;
    return simulate(p);
}

/// How much larger the radii of a part are than those of another, all of them alike [mm]; not a
/// number: they are not.
double larger_mm(const SimulationResult& part, const SimulationResult& other, double tolerance_mm) {
    const double by = part.sections[0].radii_mm[0] - other.sections[0].radii_mm[0];
    for (std::size_t i = 0; i < part.sections.size(); ++i) {
        for (std::size_t k = 0; k < part.sections[i].radii_mm.size(); ++k) {
            if (!within(part.sections[i].radii_mm[k] - other.sections[i].radii_mm[k], by,
                        tolerance_mm)) {
                return std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
    return by;
}

Setup positioned(double ratio) {
    Setup setup = plainSetup(byPosition(rigidProjects().front()));
    setup.wear.grinding_ratio = ratio;
    return setup;
}

/// The results of part after part, each with the wheel that comes to it.
std::vector<SimulationResult> partsOf(const Setup& setup, std::int64_t count) {
    const SurfaceWear wear(setup, 0);
    WheelCourse course(wear);
    std::vector<SimulationResult> parts;
    Project project = setup.surfaces[0].project;
    for (std::int64_t part = 1; part <= count; ++part) {
        course.putWheel(project, part);
        parts.push_back(simulate(project));
        course = part == 1 ? course.ofCycle(removedVolume_mm3(parts.front())) : course;
    }
    return parts;
}

class TestWornWheel : public QObject {
    Q_OBJECT

private slots:
    /// Whichever surface is run: that of the first cycle by which it follows from what is measured.
    void oneWheelHasOneFactorOfRa() {
        Project first = fixtures::plunge();
        first.wheel->roughness_factor = 1;
        first.wheel->measured_ra = MeasuredRa{0.6, {}, {}};
        Project second = first;
        second.part->diameter_mm += 10;
        Setup setup{{{"first", first}, {"second", second}}, {}, {}};
        const auto isOfAll = [&setup](double factor) {
            const Setup dressed = dressedSetup(setup);
            for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
                const WornProject worn = wornProject(setup, i);
                if (worn.project.wheel->roughness_factor != factor
                    || dressed.surfaces[i].project.wheel->roughness_factor != factor) {
                    return false;
                }
            }
            return true;
        };
        const double ofFirst = factorOfMeasuredRa(first).value();
        const double ofSecond = factorOfMeasuredRa(second).value();
        QVERIFY(ofFirst != ofSecond && ofFirst != 1);
        QVERIFY(isOfAll(ofFirst));
        setup.surfaces[0].project.cycle->stages.clear();
        QVERIFY(isOfAll(ofSecond));
        for (GroundSurface& each : setup.surfaces) {
            each.project.wheel->roughness_factor = 2;
        }
        QVERIFY(isOfAll(2)); // as it is given
    }

    // --- the radius under position control ----------------------------------------------------

    /// The head stands where it would with a new wheel: every radius is left larger by w, in a bore
    /// smaller.
    void positionControlLeavesThePartLargerByTheWear() {
        for (const Project& project : rigidProjects()) {
            for (const bool fromDatum : {false, true}) {
                Project p = byPosition(project);
                p.gauge->datum_mm = fromDatum
                                        ? std::optional(makeBlank(*p.part).totalInfeed_mm + 0.005)
                                        : std::nullopt;
                const double side = p.part->surface == Surface::external ? 1 : -1;
                const SimulationResult fresh = simulate(p);
                QVERIFY(fresh.status == RunStatus::completed);
                for (const double wear_um : {0.4, 3.0, 17.5}) {
                    const SimulationResult result = worn(p, wear_um);
                    QVERIFY(result.status == RunStatus::completed);
                    QCOMPARE(result.time_s, fresh.time_s);
                    QVERIFY(within(larger_mm(result, fresh, 1e-10), side * wear_um / 1000, 1e-10));
                }
            }
        }
    }

    void gaugeControlDoesNotKnowTheWear() {
        for (Project p : rigidProjects()) {
            QVERIFY(fixtures::sameBits(worn(p, 12), simulate(p)));
        }
        Setup setup = positioned(1);
        setup.surfaces[0].project.gauge->control = Control::gauge;
        const std::vector<SimulationResult> parts = partsOf(setup, 5);
        QVERIFY(parts.back().project.wheel->radius_wear_um > 1);
        for (const SimulationResult& part : parts) {
            QVERIFY(within(larger_mm(part, parts.front(), 1e-12), 0, 1e-12));
        }
    }

    /// G not given: the radius stays, and with it the part, to the bit.
    void withoutAGrindingRatioThereIsNoWear() {
        Setup setup = positioned(1);
        setup.wear = {};
        setup.wear.dulling_per_mm2 = 0;
        const std::vector<SimulationResult> parts = partsOf(setup, 4);
        for (const SimulationResult& part : parts) {
            QVERIFY(fixtures::sameBits(part, parts.front()));
            QCOMPARE(part.project.wheel->radius_wear_um, 0.0);
        }
    }

    /// Size of part n = size of part 1 + 2·Δr, Δr by what n − 1 first parts have worn off the
    /// wheel where it grinds: π·(D_0² − D²)/4·b of it for V/G, b the ground length.
    void fromPartToPartTheSizeFollowsTheWornRadius() {
        for (const double length_mm : {40.0, 22.0}) {
            Setup setup = positioned(1.5);
            Project& project = setup.surfaces[0].project;
            project.part->length_mm = length_mm;
            const double dressed_mm = project.wheel->diameter_mm;
            const std::vector<SimulationResult> parts = partsOf(setup, 12);
            const double part_mm2 = removedVolume_mm3(parts.front()) / length_mm / 1.5;
            double before_mm = -1;
            for (std::size_t n = 0; n < parts.size(); ++n) {
                const Wheel& wheel = *parts[n].project.wheel;
                const double square =
                    dressed_mm * dressed_mm - 4 * double(n) * part_mm2 / std::numbers::pi;
                const double radius_mm = (dressed_mm - std::sqrt(square)) / 2;
                QVERIFY(within(wheel.radius_wear_um, 1000 * radius_mm, 1e-9));
                QVERIFY(within(larger_mm(parts[n], parts.front(), 1e-10), radius_mm, 1e-10));
                QVERIFY(radius_mm > before_mm);
                // the diameter is that of the whole width
                QVERIFY(close(dressed_mm - wheel.diameter_mm, 2 * radius_mm * length_mm / 40, 1e-4)
                        || n == 0);
                before_mm = radius_mm;
            }
            QVERIFY(before_mm > 0.005);
        }
    }

    /// The parts to a dressing, which is the compensation, end where the field does: the next
    /// interval begins with the first part's size again.
    void theFieldEndsTheIntervalOfAWheelThatWears() {
        Setup setup = positioned(4);
        Part& part = *setup.surfaces[0].project.part;
        part.initial_runout_mm = 0;
        part.upper_deviation_um = 20;
        part.lower_deviation_um = -4;
        part.target_diameter_mm = part.diameter_mm;
        const DressingInterval found = dressingInterval(setup);
        QVERIFY(found.ran() && found.end && found.end->worst);
        QVERIFY(found.end->worst->kind == ConstraintKind::diameterMax);
        const std::vector<SimulationResult> parts = partsOf(setup, found.parts + 1);
        const auto size_um = [&](std::int64_t number) {
            return 1000
                   * parts[static_cast<std::size_t>(number - 1)]
                         .sections[0]
                         .diameterDeviationMax_mm;
        };
        QVERIFY(found.parts > 3);
        QVERIFY(size_um(found.parts) <= 20 && size_um(found.parts + 1) > 20);
        QVERIFY(within(size_um(1), 0, 1e-6));
        setup.wear.grinding_ratio = std::nullopt;
        setup.wear.dulling_per_mm2 = 1e-9;
        DressingOptions few;
        few.most = found.parts + 1;
        QCOMPARE(dressingInterval(setup, few).parts, found.parts + 1);
    }

    /// Within a part: the second surface is left larger by what the first wore off.
    void inASetUpTheWearGoesOnFromSurfaceToSurface() {
        Setup setup = positioned(0.8);
        setup.surfaces.push_back(setup.surfaces.front());
        setup.surfaces[0].name = "a";
        setup.surfaces[1].name = "b";
        const SetupRun run = runSetup(setup);
        QVERIFY(run.isCompleted(setup));
        const SimulationResult &first = run.surfaces[0].result, &second = run.surfaces[1].result;
        const double wear_mm =
            (first.project.wheel->diameter_mm - second.project.wheel->diameter_mm) / 2;
        QVERIFY(wear_mm > 0.001);
        QVERIFY(within(larger_mm(second, first, 1e-10), wear_mm, 1e-10));
        for (GroundSurface& each : setup.surfaces) { // a wear that a file states is there as well
            each.project.wheel->radius_wear_um = 3;
        }
        const SetupRun stated = runSetup(setup);
        const double now_mm = (first.project.wheel->diameter_mm
                               - stated.surfaces[1].result.project.wheel->diameter_mm)
                              / 2;
        QVERIFY(within(larger_mm(stated.surfaces[1].result, first, 1e-10), now_mm + 0.003, 1e-10));
    }

    // --- the speed ----------------------------------------------------------------------------

    /// One law for a batch, a sweep, a set-up and the parts to a dressing: V_k ∝ D at constant
    /// revolutions, V_k as given at constant speed, which a project that does not say has.
    void theSpeedOfAWornWheelIsOneLawEverywhere() {
        const Project silent = fixtures::plunge();
        QVERIFY(silent.machine->wheel_speed_control == WheelSpeedControl::constant_speed);
        for (const auto control :
             {WheelSpeedControl::constant_speed, WheelSpeedControl::constant_revolutions}) {
            const bool falls = control == WheelSpeedControl::constant_revolutions;
            Setup setup = plainSetup(fixtures::plunge());
            setup.wear.grinding_ratio = 0.05;
            setup.surfaces.push_back(setup.surfaces.front());
            setup.surfaces[1].name = "b";
            for (GroundSurface& each : setup.surfaces) {
                each.project.machine->wheel_speed_control = control;
            }
            const Project& given = setup.surfaces[0].project;
            int compared = 0;
            const auto isLaw = [&](const Project& p) {
                const double ratio = p.wheel->diameter_mm / given.wheel->diameter_mm;
                compared += ratio < 0.9999 ? 1 : 0;
                return close(p.machine->wheel_speed_m_s,
                             given.machine->wheel_speed_m_s * (falls ? ratio : 1), 1e-15);
            };
            const SetupRun run = runSetup(setup);
            QVERIFY(isLaw(run.surfaces[1].result.project));
            Setup alone = setup;
            alone.surfaces.resize(1);
            for (const SimulationResult& part : partsOf(alone, 4)) {
                QVERIFY(isLaw(part.project));
            }
            const double worn_mm = run.surfaces[1].result.project.wheel->diameter_mm;
            Project batch = given;
            batch.batch = Batch{};
            batch.batch->scenarios = Scenarios::corners;
            batch.batch->factors.wheel_diameter_mm = fixtures::uniform(worn_mm, 600);
            const Project part = ScenarioSource(batch).project(0);
            QCOMPARE(part.wheel->diameter_mm, worn_mm);
            QVERIFY(isLaw(part));
            Project swept = given;
            swept.sweep = Sweep{{{"/wheel/diameter_mm", worn_mm, 600, 3, SweepSpacing::linear}}};
            const SweepResult sweep = runSweep(swept);
            QVERIFY(sweep.ran());
            const Project point = withPoint(given, sweep, 0);
            QCOMPARE(point.wheel->diameter_mm, worn_mm);
            QVERIFY(isLaw(point));
            // and the cycles with it are one
            const double time_s = simulate(point).time_s;
            QCOMPARE(simulate(part).time_s, time_s);
            QCOMPARE(sweep.points[0].values[0].value, time_s);
            QCOMPARE(run.surfaces[1].result.time_s, time_s);
            QVERIFY(compared >= 5);
        }
    }

    /// A V_k that is varied itself counts as it is, in either place of the sweep.
    void aVariedSpeedCountsAsItIs() {
        Project p = fixtures::plunge();
        p.machine->wheel_speed_control = WheelSpeedControl::constant_revolutions;
        const SweepAxis diameter{"/wheel/diameter_mm", 500, 600, 2, SweepSpacing::linear};
        const SweepAxis speed{"/machine/wheel_speed_m_s", 20, 30, 2, SweepSpacing::linear};
        for (const bool first : {false, true}) {
            const std::vector<SweepAxis> axes =
                first ? std::vector{speed, diameter} : std::vector{diameter, speed};
            Project set = p;
            putSweptValues(set, axes,
                           first ? std::vector<double>{20, 500} : std::vector<double>{500, 20});
            QCOMPARE(set.machine->wheel_speed_m_s, 20.0);
            QCOMPARE(set.wheel->diameter_mm, 500.0);
        }
    }
};

} // namespace sparkout::test_worn_wheel

SPARKOUT_TEST(test_worn_wheel, TestWornWheel)
#include "test_worn_wheel.moc"
