// SPDX-License-Identifier: GPL-3.0-or-later
// Traverse grinding of a bore, through or blind [MODEL-3, 5].
#include "core/project/validate.h"
#include "core/quality/shop_numbers.h"
#include "core/study/new_project.h"
#include "core/study/operation.h"

#include "tests/core/simulation/random_cycles.h"
#include "tests/core/simulation/strokes_by_hand.h"
#include "tests/registry.h"

#include <utility>
#include <variant>

namespace sparkout::test_internal_traverse {

using fixtures::Traced;
using fixtures::within;
using strokes_by_hand::Cut;

// 8 µm at the entry as in the table of a through bore, with a wall there, before which the wheel
// stands with its whole width: A = 5 (b = 40 mm) in РЗ1's plunge passes.
const std::vector<Cut> blindBore{{Zone::rz1, Step::e1, 4, 4, 4.0 / 5},
                                 {Zone::rz1, Step::e1, 8, 4, 36.0 / 25},
                                 {Zone::rz1, Step::e2, 8, 0, 144.0 / 125},
                                 {Zone::rz1, Step::e3, 8, 0, 288.0 / 125},
                                 {Zone::nz, Step::e1, 8, 8, 4.0 / 1},
                                 {Zone::rz2, Step::e1, 8, 8, 4.0 / 1},
                                 {Zone::rz2, Step::e2, 8, 0, 4.0 / 3},
                                 {Zone::rz1, Step::e4, 8, 0, 144.0 / 125},
                                 {Zone::nz, Step::e2, 8, 0, 2.0 / 1},
                                 {Zone::rz2, Step::e3, 8, 0, 4.0 / 3},
                                 {Zone::rz1, Step::e5, 8, 0, 144.0 / 625},
                                 {Zone::rz1, Step::e1, 12, 4, 3076.0 / 3125},
                                 {Zone::rz1, Step::e1, 16, 4, 24804.0 / 15625},
                                 {Zone::rz1, Step::e2, 16, 0, 99216.0 / 78125},
                                 {Zone::rz1, Step::e3, 16, 0, 198432.0 / 78125},
                                 {Zone::nz, Step::e1, 16, 8, 5.0 / 1},
                                 {Zone::rz2, Step::e1, 16, 8, 14.0 / 3},
                                 {Zone::rz2, Step::e2, 16, 0, 14.0 / 9},
                                 {Zone::rz1, Step::e4, 16, 0, 99216.0 / 78125},
                                 {Zone::nz, Step::e2, 16, 0, 5.0 / 2},
                                 {Zone::rz2, Step::e3, 16, 0, 14.0 / 9},
                                 {Zone::rz1, Step::e5, 16, 0, 99216.0 / 390625}};

Project boreByHand(bool rigid) {
    Project p = strokes_by_hand::byHand(rigid);
    p.part->surface = Surface::internal;
    p.wheel->diameter_mm = 20;
    strokes_by_hand::feed(p, 8, 0, 16);
    return p;
}

void makeBlind(Project& p, double overrun_mm) {
    p.part->blind_bore = true;
    const bool entry = p.machine->entry_side == EntrySide::headstock;
    (entry ? p.machine->overrun_entry_mm : p.machine->overrun_exit_mm) = overrun_mm;
}

/// A random shaft of which a bore of the same D_e is the mirror image.
Project anyShaft() {
    Project p = random_cycles::anyTraverse();
    p.part->surface = Surface::external;
    p.wheel->diameter_mm = fixtures::between(250, 750);
    p.part->lower_deviation_um = -p.part->upper_deviation_um - 10;
    p.part->upper_deviation_um = -p.part->lower_deviation_um;
    p.part->profile = ProfileForm::measured;
    std::vector<double> um;
    for (int k = 0; k < p.part->radii_per_section; ++k) {
        um.push_back(fixtures::between(-30, 0));
    }
    p.part->radii_um = um;
    return p;
}

Project boreOf(Project p) {
    const double d = p.part->diameter_mm, D = p.wheel->diameter_mm, De = d * D / (d + D);
    p.part->surface = Surface::internal;
    p.wheel->diameter_mm = d * De / (d + De);
    for (double& deviation : *p.part->radii_um) {
        deviation = -deviation;
    }
    return p;
}

class TestInternalTraverse : public QObject {
    Q_OBJECT

private slots:
    void twoDoubleStrokesAreAsByHand() {
        for (const bool rigid : {true, false}) {
            Project p = boreByHand(rigid);
            QVERIFY(!hasErrors(validate(p)));
            QCOMPARE(strokes_by_hand::difference(Traced(p), strokes_by_hand::entryInfeed, rigid),
                     QString());
            const double first_mm = p.part->diameter_mm / 2 - 16e-3;
            const Traced run(p);
            for (const Visit& visit : run.trajectory.visits) {
                QVERIFY(visit.radius_mm >= first_mm + p.part->lower_deviation_um / 4e3 - 1e-12);
            }
            for (const double overrun : {0.0, -5.0}) {
                Project blind = p;
                makeBlind(blind, overrun);
                QVERIFY(!hasErrors(validate(blind)));
                const Traced there(blind);
                QCOMPARE(strokes_by_hand::difference(there, blindBore, rigid), QString());
                // The plunge passes take so many turns as ever; the strokes are as much shorter.
                const double shorter = 2 * 2 * (20 - overrun) / 600 * 60;
                QVERIFY(within(there.result.time_s, run.result.time_s - shorter, 1e-9));
            }
        }
    }

    void aBoreMirrorsAShaftOfTheSameEquivalentDiameter() {
        int runs = 0;
        QVERIFY(rc::check("a bore mirrors a shaft", [&] {
            const Project shaft = anyShaft();
            const Project bore = boreOf(shaft);
            const Traced a(shaft), b(bore);
            RC_ASSERT(a.result.status == b.result.status);
            RC_ASSERT(a.result.countsByStage == b.result.countsByStage);
            RC_ASSERT(a.trajectory.visits.size() == b.trajectory.visits.size());
            for (std::size_t i = 0; i < a.trajectory.visits.size(); ++i) {
                const Visit& x = a.trajectory.visits[i];
                const Visit& y = b.trajectory.visits[i];
                RC_ASSERT(within(x.actual_mm, y.actual_mm, 1e-12));
                RC_ASSERT(within(x.radius_mm + y.radius_mm, shaft.part->diameter_mm, 1e-12));
            }
            ++runs;
        }));
        QVERIFY(runs > 50);
    }

    // Only where the wheel may turn is what the wall changes.
    void aWheelThatTurnsAtTheEndIsAsInABlindBore() {
        for (const EntrySide side : {EntrySide::headstock, EntrySide::tailstock}) {
            Project p = boreByHand(false);
            p.machine->entry_side = side;
            makeBlind(p, 0);
            const Traced blind(p);
            p.part->blind_bore = false;
            QVERIFY(fixtures::sameBits(blind.result, Traced(p).result));
        }
    }

    // Short of the wall the wheel turns before the zone's middle, which is visited where it turns:
    // what is fed while it travels never goes back.
    void continuousInfeedBeforeAWallNeverGoesBack() {
        Project p = boreByHand(false);
        makeBlind(p, -5);
        for (Stage& stage : p.cycle->stages) {
            stage.continuous_feed_mm_min = 0.5;
        }
        QVERIFY(!hasErrors(validate(p)));
        const Traced run(p);
        QVERIFY(run.trajectory.visits.size() > 10);
        double before = 0;
        for (const Visit& visit : run.trajectory.visits) {
            QVERIFY2(visit.programmed_mm >= before, qPrintable(QString::number(before)));
            before = visit.programmed_mm;
        }
    }

    // What the wheel does not reach is neither ground nor counted.
    void theStripAtTheWallIsNotGround() {
        Project p = boreByHand(true);
        makeBlind(p, -5);
        const SimulationResult result = simulate(p);
        const double ground = p.part->length_mm - 5;
        const double volume = std::numbers::pi * p.part->diameter_mm * 16e-3 * ground;
        QVERIFY(within(shopNumbers(result).stages.front().removedVolume_mm3, volume, 1e-6));
    }

    void theOverrunAtTheWallIsChecked() {
        const auto codesOf = [](const Project& p, const std::string& path) {
            std::vector<IssueCode> codes;
            for (const Issue& issue : validate(p)) {
                if (issue.path == path) {
                    codes.push_back(issue.code);
                }
            }
            return codes;
        };
        const std::string entry = "/machine/overrun_entry_mm", exit = "/machine/overrun_exit_mm";
        using Codes = std::vector<IssueCode>;
        Project p = boreByHand(false);
        QVERIFY(codesOf(p, entry).empty());
        p.part->blind_bore = true;
        QCOMPARE(codesOf(p, entry), Codes{IssueCode::wallOverrun});
        QVERIFY(codesOf(p, exit).empty());
        p.machine->entry_side = EntrySide::tailstock; // the wall stays at the headstock
        QVERIFY(codesOf(p, entry).empty());
        QCOMPARE(codesOf(p, exit), Codes{IssueCode::wallOverrun});
        p.machine->overrun_exit_mm = 0;
        QVERIFY(codesOf(p, exit).empty());
        p.machine->overrun_exit_mm = -5;
        QCOMPARE(codesOf(p, exit), Codes{IssueCode::stripAtWall});
        QVERIFY(!hasErrors(validate(p)));
        p.part->surface = Surface::external; // a shaft has no such wall
        p.wheel->diameter_mm = 600;
        QCOMPARE(codesOf(p, exit), Codes{IssueCode::outOfRange});
    }

    void aBoreStaysABoreWhenItsOperationChanges() {
        Project p = newProject(Operation::plunge);
        p.part->surface = Surface::internal;
        p.part->diameter_mm = 60;
        p.wheel->diameter_mm = 40;
        p.part->blind_bore = true;
        p = withGivenCompliance(std::move(p), false);
        QVERIFY(!hasErrors(validate(p)));
        for (const EntrySide side : {EntrySide::headstock, EntrySide::tailstock}) {
            p.machine->entry_side = side;
            Project narrow = p; // no other wheel is taken
            narrow.wheel->width_mm = p.part->length_mm / 2;
            const Project traverse = withOperation(narrow, Operation::traverse);
            QCOMPARE(traverse.part->surface, Surface::internal);
            QVERIFY(!hasErrors(validate(traverse)));
            QVERIFY(traverse.part->shaft.quill.has_value());
            const bool entry = side == EntrySide::headstock;
            const Machine& machine = *traverse.machine;
            QCOMPARE(entry ? machine.overrun_entry_mm : machine.overrun_exit_mm, 0.0);
            QVERIFY((entry ? machine.overrun_exit_mm : machine.overrun_entry_mm) > 0);
            const Project plunge = withOperation(traverse, Operation::plunge);
            QCOMPARE(plunge.part->surface, Surface::internal);
            QVERIFY(!hasErrors(validate(plunge)));
        }
        p.wheel->width_mm = p.part->length_mm / 2;
        Project strip = withOperation(p, Operation::traverse); // then as a shaft: no wall any more
        strip.machine->overrun_exit_mm = -1;
        Project shaft = withOperation(strip, Operation::plunge);
        shaft.part->surface = Surface::external;
        shaft.wheel->diameter_mm = 400;
        shaft.part->length_mm = 3 * shaft.wheel->width_mm;
        shaft = withComputable(std::move(shaft));
        QVERIFY(!hasErrors(validate(withOperation(shaft, Operation::traverse))));
    }

    // The quill bends alike wherever it grinds.
    void allZonesHaveTheCompliance() {
        Project p = boreByHand(false);
        p.machine->compliance_mm_per_n = std::monostate{};
        p.machine->stiffness_n_um = Stiffness{60, 40, 50};
        QVERIFY(hasErrors(validate(p))); // no quill
        p.part->shaft.quill = Quill{60, 15};
        QVERIFY(!hasErrors(validate(p)));
        const double I = std::numbers::pi * 15 * 15 * 15 * 15 / 64;
        const double gamma = 1e-3 / 60 + 1e-3 / 50 + 60.0 * 60 * 60 / (3 * 210e3 * I);
        const SimulationResult result = simulate(p);
        QCOMPARE(result.sections.size(), std::size_t{3});
        for (const SectionResult& section : result.sections) {
            QVERIFY(fixtures::close(section.compliance_mm_per_n, gamma, 1e-12));
        }
    }
};

} // namespace sparkout::test_internal_traverse

SPARKOUT_TEST(test_internal_traverse, TestInternalTraverse)
#include "test_internal_traverse.moc"
