// SPDX-License-Identifier: GPL-3.0-or-later
// Several sections in each zone of traverse grinding [MODEL-5].
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/traverse.h"
#include "core/study/profile_series.h"

#include "tests/core/simulation/strokes_by_hand.h"
#include "tests/registry.h"

#include <cstring>

namespace sparkout::test_zone_sections {

using fixtures::close;
using fixtures::Traced;
using fixtures::within;
using strokes_by_hand::um;

Project with(Project p, int sections) {
    p.zone_sections = sections;
    return p;
}

/// γ(x) differs all along; burn and roughness are watched.
Project slender() {
    Project p = fixtures::traverse();
    fixtures::putOnSlenderShaft(p);
    p.part->length_mm = 110;
    p.part->tolerance.roughness_ra_um = 0.8;
    p.material->conductivity_w_mk = 36;
    p.material->diffusivity_mm2_s = 9;
    p.material->burn_rise_k = 700;
    return p;
}

bool sameTrajectory(const Traced& a, const Traced& b) {
    const auto& x = a.trajectory.visits;
    const auto& y = b.trajectory.visits;
    return a.trajectory.passes.size() == b.trajectory.passes.size() && x.size() == y.size()
           && std::memcmp(x.data(), y.data(), x.size() * sizeof(Visit)) == 0;
}

class TestZoneSections : public QObject {
    Q_OBJECT

private slots:
    void oneSectionIsTheZone() {
        for (const Project& p : {fixtures::traverse(), slender()}) {
            QVERIFY(writeProject(p).find("zone_sections") == std::string::npos);
            const Traced plain(p), stated(with(p, 1));
            QVERIFY(fixtures::sameBits(plain.result, stated.result));
            QVERIFY(sameTrajectory(plain, stated));
            QVERIFY(plain.result.zoneSections.empty());
            QVERIFY(accuracyOf(plain.result).zones.empty());
        }
        const ReadResult read = readProject(writeProject(with(slender(), 7)));
        QVERIFY(read.project);
        QCOMPARE(read.project->zone_sections, 7);
    }

    void sectionsStandAtTheMiddlesOfEqualSlices() {
        Project p = strokes_by_hand::byHand(false); // zones of 20, 60 and 20 mm
        p.zone_sections = 2;
        const auto positions = [&p] {
            std::vector<double> found;
            for (const CompliantPoint& point : zoneSectionPoints(p)) {
                found.push_back(point.position_mm);
            }
            return found;
        };
        QCOMPARE(positions(), (std::vector<double>{5, 15, 35, 65, 85, 95}));
        p.machine->entry_side = EntrySide::tailstock;
        QCOMPARE(positions(), (std::vector<double>{95, 85, 65, 35, 15, 5}));
        p.part->surface = Surface::internal; // in a blind bore those of what the wheel reaches
        p.wheel->diameter_mm = 20;
        p.part->blind_bore = true;
        p.machine->overrun_exit_mm = -8;
        p.zone_sections = 4;
        const std::vector<CompliantPoint> points = zoneSectionPoints(p);
        QVERIFY(within(points.back().position_mm, 8 + 5, 1e-12));
        QVERIFY(within(points[8].position_mm, 8 + 35, 1e-12));
        QVERIFY(within(points.back().length_mm, 10, 1e-12));
        p.zone_sections = 1;
        QVERIFY(zoneSectionPoints(p).empty());
    }

    /// One rule for a zone and its sections, before the wall of a blind bore too: what the wheel
    /// reaches. There it stands while it grinds the zone, visited where it turns.
    void aZoneStandsInTheMiddleOfItsSections() {
        for (const double exit_mm : {-8.0, -0.5, 0.0, 15.0}) {
            for (const auto side : {EntrySide::headstock, EntrySide::tailstock}) {
                Project p = strokes_by_hand::byHand(true);
                p.machine->entry_side = side;
                p.part->surface = Surface::internal;
                p.part->diameter_mm = 50;
                p.wheel->diameter_mm = 20;
                p.part->blind_bore = exit_mm <= 0;
                const bool atEntry = side == EntrySide::headstock; // the wall is at the headstock
                (atEntry ? p.machine->overrun_entry_mm : p.machine->overrun_exit_mm) = exit_mm;
                p.zone_sections = 5;
                strokes_by_hand::feed(p, 8, 0, 40);
                const SimulationResult result = simulate(p);
                QVERIFY(result.status == RunStatus::completed);
                const std::vector<Stretch> stretches = groundStretches(p);
                for (std::size_t zone = 0; zone < 3; ++zone) {
                    double sum = 0;
                    for (std::size_t i = 0; i < 5; ++i) {
                        sum += result.zoneSections[zone * 5 + i].position_mm;
                    }
                    QVERIFY(within(result.sections[zone].position_mm, sum / 5, 1e-12));
                    QVERIFY(within(result.sections[zone].position_mm,
                                   (stretches[zone].from_mm + stretches[zone].to_mm) / 2, 1e-12));
                }
                const std::size_t wall = atEntry ? 0 : 2;
                QVERIFY(within(stretches[wall].from_mm, std::max(-exit_mm, 0.0), 1e-12));
                QVERIFY(within(stretches[wall].to_mm, 40 - exit_mm, 1e-12));
            }
        }
    }

    // The zones' middles carry the gauge and are what is recorded.
    void theCycleIsThatOfTheMiddles() {
        const Project p = slender();
        const Traced plain(p);
        for (const int sections : {2, 3, 10, 50}) {
            const Traced several(with(p, sections));
            QVERIFY(sameTrajectory(plain, several));
            QCOMPARE(several.result.countsByStage, plain.result.countsByStage);
            QCOMPARE(several.result.time_s, plain.result.time_s);
            QCOMPARE(several.result.gaugeReading_mm, plain.result.gaugeReading_mm);
            QCOMPARE(several.result.sections.size(), std::size_t{3});
            QCOMPARE(several.result.zoneSections.size(), std::size_t(3 * sections));
            for (std::size_t zone = 0; zone < 3; ++zone) {
                QCOMPARE(several.result.sections[zone].radii_mm,
                         plain.result.sections[zone].radii_mm);
            }
        }
    }

    void sectionsWithOneComplianceAreAlike() {
        Project p = slender();
        p.machine->compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
        const SimulationResult plain = simulate(p), several = simulate(with(p, 4));
        for (std::size_t i = 0; i < 12; ++i) {
            QCOMPARE(several.zoneSections[i].radii_mm, plain.sections[i / 4].radii_mm);
            QCOMPARE(several.zoneSections[i].zone, plain.sections[i / 4].zone);
            QVERIFY(several.zoneSections[i].lastCut.has_value());
        }
        for (std::size_t zone = 0; zone < 3; ++zone) {
            const SectionResult &a = several.sections[zone], &b = plain.sections[zone];
            QCOMPARE(a.diameterDeviationMin_mm, b.diameterDeviationMin_mm);
            QCOMPARE(a.diameterDeviationMax_mm, b.diameterDeviationMax_mm);
            QCOMPARE(a.radialRunout_mm, b.radialRunout_mm);
            QCOMPARE(a.peakNormalForce_n, b.peakNormalForce_n);
            QCOMPARE(a.lastCut->depth_mm, b.lastCut->depth_mm);
        }
        QCOMPARE(several.burn->depth_mm, plain.burn->depth_mm);
        QCOMPARE(several.peakNormalForce_n, plain.peakNormalForce_n);
        QCOMPARE(several.peakPower_w, plain.peakPower_w);
        const ShopColumn a = shopNumbers(several).cycle, b = shopNumbers(plain).cycle;
        QVERIFY(close(a.removedVolume_mm3, b.removedVolume_mm3, 1e-12));
        QVERIFY(close(a.energy_j, b.energy_j, 1e-12));
        QVERIFY(close(a.time_s, b.time_s, 1e-12));
        for (const ZoneForm& zone : accuracyOf(several).zones) {
            QVERIFY(within(zone.profile.taper_mm, 0, 1e-12));
        }
    }

    // Sections depend on nothing but their γ and their zone's steps.
    void aSectionIsAsAZoneOfItsCompliance() {
        Project p = slender();
        p.gauge->control = Control::position;
        const SimulationResult several = simulate(with(p, 3));
        for (std::size_t i = 0; i < several.zoneSections.size(); ++i) {
            const double gamma = several.zoneSections[i].compliance_mm_per_n;
            Project alone = p;
            alone.machine->compliance_mm_per_n = ZoneCompliance{gamma, gamma, gamma};
            QCOMPARE(several.zoneSections[i].radii_mm, simulate(alone).sections[i / 3].radii_mm);
        }
        for (std::size_t zone = 0; zone < 3; ++zone) { // of three the second is the middle
            const SectionResult &middle = several.zoneSections[3 * zone + 1],
                                &of = several.sections[zone];
            QVERIFY(within(middle.position_mm, of.position_mm, 1e-12));
            QVERIFY(close(middle.compliance_mm_per_n, of.compliance_mm_per_n, 1e-12));
        }
    }

    void aZoneHasTheWorstOfItsSections() {
        const SimulationResult result = simulate(with(slender(), 5));
        const PartAccuracy accuracy = accuracyOf(result);
        QCOMPARE(accuracy.sections.size(), std::size_t{3});
        QCOMPARE(accuracy.zones.size(), std::size_t{3});
        const PartAccuracy all = partAccuracy(shapesOf(result), 0);
        QCOMPARE(all.sections.size(), std::size_t{15});
        QCOMPARE(accuracy.minimumZone.deviation(), all.minimumZone.deviation());
        QCOMPARE(accuracy.totalRunout_mm, all.totalRunout_mm);
        for (std::size_t zone = 0; zone < 3; ++zone) {
            double low = 1, high = -1, runout = 0, force = 0, roundness = 0, cut = 0;
            for (std::size_t i = 5 * zone; i < 5 * zone + 5; ++i) {
                const SectionResult& section = result.zoneSections[i];
                low = std::min(low, section.diameterDeviationMin_mm);
                high = std::max(high, section.diameterDeviationMax_mm);
                runout = std::max(runout, section.radialRunout_mm);
                force = std::max(force, section.peakNormalForce_n);
                cut = std::max(cut, section.lastCut->depth_mm);
                roundness = std::max(roundness, all.sections[i].minimumZone.deviation());
            }
            QCOMPARE(result.sections[zone].diameterDeviationMin_mm, low);
            QCOMPARE(result.sections[zone].diameterDeviationMax_mm, high);
            QCOMPARE(result.sections[zone].radialRunout_mm, runout);
            QCOMPARE(result.sections[zone].peakNormalForce_n, force);
            QCOMPARE(result.sections[zone].lastCut->depth_mm, cut);
            QCOMPARE(accuracy.sections[zone].minimumZone.deviation(), roundness);
            QCOMPARE(accuracy.sections[zone].radialRunout_mm, runout);
            QCOMPARE(roundnessOf(result, zone), roundness);
            const ZoneForm& form = accuracy.zones[zone];
            QVERIFY(form.cylindricity_mm > 0);
            QVERIFY(form.cylindricity_mm <= accuracy.minimumZone.deviation() + 1e-12);
            QVERIFY(form.totalRunout_mm >= runout - 1e-15);
            QVERIFY(form.totalRunout_mm <= accuracy.totalRunout_mm + 1e-15);
            QVERIFY(std::abs(form.profile.taper_mm) > 1e-6); // γ(x) has a slope in each
        }
        const SectionResult middle = simulate(slender()).sections[1]; // alone it says too little
        QVERIFY(result.sections[1].diameterDeviationMax_mm > middle.diameterDeviationMax_mm
                || result.sections[1].diameterDeviationMin_mm < middle.diameterDeviationMin_mm);
        for (const ConstraintResult& found : evaluateConstraints(result)) {
            if (found.kind == ConstraintKind::diameterMax) {
                QCOMPARE(found.value,
                         result.sections[std::size_t(found.section)].diameterDeviationMax_mm
                             * 1000);
            }
        }
    }

    // 2 µm a turn and 20 µm a stroke of 100 mm: a section at x mm from the entry is visited when
    // x/5 µm of the stroke are fed, on the way back when (100 − x)/5 µm are. Two double strokes.
    void aContinuousInfeedFindsEachWhereItStands() {
        const std::vector<double> rigid{92, 92, 83, 77, 73, 71};
        const std::vector<double> compliant{6037.0 / 81, 6007.0 / 81, 967.0 / 16,
                                            937.0 / 16,  562.0 / 9,   185.0 / 3};
        for (const bool isRigid : {true, false}) {
            Project p = strokes_by_hand::byHand(isRigid);
            p.zone_sections = 2;
            strokes_by_hand::feed(p, 0, 0.12, 92);
            const SimulationResult result = simulate(p);
            QCOMPARE(result.cycleCount, 2);
            const double first_mm = 15 + p.part->lower_deviation_um / 4000 + 92 * um;
            for (std::size_t i = 0; i < 6; ++i) {
                const double removed = first_mm - result.zoneSections[i].radii_mm.back();
                QVERIFY(within(removed, (isRigid ? rigid : compliant)[i] * um, 1e-12));
            }
        }
    }

    void noRadiusIsFollowedAlone() {
        const Project p = slender(), several = with(p, 2);
        QVERIFY(traverseSteps(p, Zone::nz, nullptr, {})->follower());
        QVERIFY(!traverseSteps(several, Zone::nz, nullptr, {})->follower());
    }

    void linesAlongThePartGoThroughAllAtTheEnd() {
        const Traced run(with(slender(), 4));
        const ProfileSeries end = makeProfileSeries(run.result, run.trajectory);
        QCOMPARE(end.profiles.size(), std::size_t{3});
        QCOMPARE(end.zoneSections.size(), std::size_t{12});
        const auto line = lengthLine(end, LengthLine::mean, LengthQuantity::radius_mm);
        QCOMPARE(line.size(), std::size_t{24});
        QVERIFY(within(line.front().x, 0, 1e-12));
        QVERIFY(within(line.back().x, run.result.project.part->length_mm, 1e-12));
        QVERIFY(std::ranges::is_sorted(line, {}, &ProfilePoint::x));
        const ProfileSeries before =
            makeProfileSeries(run.result, run.trajectory, progressAfter(run.trajectory, 3));
        QVERIFY(before.zoneSections.empty());
        QCOMPARE(lengthLine(before, LengthLine::mean, LengthQuantity::radius_mm).size(),
                 std::size_t{6});
    }

    void theirNumberIsChecked() {
        QVERIFY(!hasErrors(validate(with(slender(), 50))));
        QVERIFY(hasErrors(validate(with(slender(), 51))));
        QVERIFY(hasErrors(validate(with(slender(), 0))));
    }
};

} // namespace sparkout::test_zone_sections

SPARKOUT_TEST(test_zone_sections, TestZoneSections)
#include "test_zone_sections.moc"
