// SPDX-License-Identifier: GPL-3.0-or-later
// Wheel and part from the side: what is cut touches the wheel, and gives way by γ·P_y.
#include "core/process/system_compliance.h"
#include "core/simulation/grinding_scene.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_grinding_scene {

using fixtures::within;

Project plungeOf(int sections) {
    Project p = fixtures::plunge();
    p.part->radii_per_section = 12;
    p.sections = sections;
    std::vector<double> compliance;
    for (int j = 0; j < sections; ++j) {
        compliance.push_back(2e-5 * (1 + j));
    }
    p.machine->compliance_mm_per_n = compliance;
    return p;
}

std::vector<Project> samples() {
    Project bore = plungeOf(2);
    bore.part->surface = Surface::internal;
    bore.wheel->diameter_mm = 20;
    Project tailstock = fixtures::traverse();
    tailstock.machine->entry_side = EntrySide::tailstock;
    Project bothEnds = fixtures::traverse();
    bothEnds.machine->reversal_infeed = ReversalInfeed::both;
    bothEnds.cycle->stages.front().continuous_feed_mm_min = 0.01;
    return {fixtures::traverse(), tailstock, bothEnds, plungeOf(3), bore};
}

/// All moments of a cycle at some of their radii, and what is seen then.
template <typename Check>
void throughTheCycle(const Project& project, Check check) {
    Trajectory trajectory;
    const SimulationResult result = simulateUnchecked(project, &trajectory);
    const std::vector<Pass>& passes = trajectory.passes;
    for (std::size_t open = 0, end = 0; open < passes.size(); open = end) {
        while (end < passes.size() && passes[end].start_s == passes[open].start_s) {
            ++end;
        }
        for (int k = 0; k < trajectory.radii; k += 5) {
            const Progress moment{open, end, k};
            check(result, trajectory, moment, grindingScene(result, trajectory, moment));
        }
    }
}

class TestGrindingScene : public QObject {
    Q_OBJECT

private slots:
    void whatIsCutTouchesTheWheelAndYieldsByItsForce() {
        for (const Project& project : samples()) {
            const std::vector<CompliantPoint> points = compliantPoints(project);
            int cuts = 0;
            throughTheCycle(project, [&](const auto&, const auto&, const Progress&,
                                         const GrindingScene& scene) {
                const SceneSurface& at = scene.surfaces[scene.leading];
                QVERIFY(at.yield_mm >= 0);
                if (scene.cut_mm > 0) {
                    const double seen = at.radius_mm - scene.removalSign * at.yield_mm;
                    QVERIFY(within(seen, scene.edge_mm, 1e-12));
                    const double sprung = points[scene.leading].gamma_mm_n * scene.force_n;
                    QVERIFY(within(at.yield_mm, sprung, 1e-9));
                    ++cuts;
                } else {
                    QCOMPARE(at.yield_mm, 0.0);
                    // It does not reach the wheel.
                    QVERIFY(scene.removalSign * (scene.edge_mm - at.radius_mm) >= -1e-12);
                }
            });
            QVERIFY(cuts > 50);
        }
    }

    void everySectionOfAPlungeTouchesTheWheel() {
        throughTheCycle(
            plungeOf(3), [](const auto&, const auto&, const Progress&, const GrindingScene& scene) {
                for (const SceneSurface& surface : scene.surfaces) {
                    if (surface.yield_mm > 0) {
                        QVERIFY(within(surface.radius_mm - surface.yield_mm, scene.edge_mm, 1e-12));
                    }
                }
            });
    }

    /// It stands over its zone while it plunges or dwells, and runs from end to end and back.
    void theWheelIsWhereItsPassIs() {
        for (const bool mirrored : {false, true}) {
            Project project = fixtures::traverse();
            project.machine->entry_side = mirrored ? EntrySide::tailstock : EntrySide::headstock;
            const double B = project.wheel->width_mm, L = project.part->length_mm;
            const double o1 = project.machine->overrun_entry_mm;
            const double o2 = project.machine->overrun_exit_mm;
            const double entry = mirrored ? L + o1 - B : -o1;
            const double exit = mirrored ? -o2 : L + o2 - B;
            double reached = entry;
            throughTheCycle(project, [&](const auto&, const Trajectory& trajectory,
                                         const Progress& moment, const GrindingScene& scene) {
                QVERIFY(within(scene.wheel.to_mm - scene.wheel.from_mm, B, 1e-12));
                const Place& place = trajectory.passes[moment.open].place;
                const bool moves = moment.end - moment.open > 1;
                const double from = scene.wheel.from_mm;
                if (!moves) {
                    QVERIFY(within(from, place.zone == Zone::rz2 ? exit : entry, 1e-9));
                    QCOMPARE(scene.leading, sectionOf(place));
                } else {
                    QVERIFY(from >= std::min(entry, exit) - 1e-9);
                    QVERIFY(from <= std::max(entry, exit) + 1e-9);
                    const bool there = place.step == Step::e3;
                    const double sign = (exit > entry) == there ? 1 : -1;
                    QVERIFY(moment.radius == 0 || sign * (from - reached) > 0);
                }
                reached = from;
            });
        }
    }

    void atTheBlankTheWheelTouchesNothing() {
        for (const Project& project : samples()) {
            Trajectory trajectory;
            const SimulationResult result = simulateUnchecked(project, &trajectory);
            const GrindingScene scene = grindingScene(result, trajectory, {});
            QCOMPARE(scene.edge_mm, makeBlank(*project.part).firstTouchRadius_mm);
            for (const SceneSurface& surface : scene.surfaces) {
                QCOMPARE(surface.yield_mm, 0.0);
                QVERIFY(scene.removalSign * (scene.edge_mm - surface.radius_mm) >= -1e-12);
            }
            QVERIFY(grindingScene(result, {}, {}).surfaces.empty());
        }
    }
};

} // namespace sparkout::test_grinding_scene

SPARKOUT_TEST(test_grinding_scene, TestGrindingScene)
#include "test_grinding_scene.moc"
