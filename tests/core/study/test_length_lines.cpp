// SPDX-License-Identifier: GPL-3.0-or-later
// The profiles along the axis: zones, sections, limits and the shaft at their places.
#include "core/study/profile_series.h"
#include "tests/core/study/profile_series_bench.h"
#include "tests/registry.h"

#include <algorithm>

namespace sparkout::test_length_lines {

using namespace profile_series_bench;

class TestLengthLines : public QObject {
    Q_OBJECT

private slots:
    void zonesStandAtTheirLengths() {
        Project p = traverseProject(); // B = 50, L = 92, o1 = o2 = 12 by default
        p.machine->overrun_exit_mm = 20;
        const ProfileSeries s = series(p);
        const double rz1 = p.wheel->width_mm - 12, rz2 = p.wheel->width_mm - 20;
        QVERIFY(close(s.profiles[0].from_mm, 0) && close(s.profiles[0].to_mm, rz1));
        QVERIFY(close(s.profiles[1].from_mm, rz1) && close(s.profiles[1].to_mm, 92 - rz2));
        QVERIFY(close(s.profiles[2].from_mm, 92 - rz2) && close(s.profiles[2].to_mm, 92));
        QVERIFY(close(s.gauge_mm, (rz1 + 92 - rz2) / 2));
    }

    void theEntryAtTheTailstockMirrorsTheZones() {
        Project p = traverseProject();
        p.machine->overrun_exit_mm = 20;
        const ProfileSeries left = series(p);
        p.machine->entry_side = EntrySide::tailstock;
        const ProfileSeries right = series(p);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(close(right.profiles[i].from_mm, 92 - left.profiles[i].to_mm));
            QVERIFY(close(right.profiles[i].to_mm, 92 - left.profiles[i].from_mm));
            QVERIFY(right.profiles[i].from_mm < right.profiles[i].position_mm
                    && right.profiles[i].position_mm < right.profiles[i].to_mm);
        }
        const auto a = lengthLine(left, LengthLine::mean, LengthQuantity::radius_um);
        const auto b = lengthLine(right, LengthLine::mean, LengthQuantity::radius_um);
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            QVERIFY(close(a[i].x, 92 - b[b.size() - 1 - i].x, 1e-9));
            QVERIFY(close(a[i].y, b[b.size() - 1 - i].y, 1e-9));
            QVERIFY(i == 0 || b[i].x >= b[i - 1].x);
        }
    }

    void zonesAreStepsAndSectionsAreJoined() {
        const ProfileSeries zones = series(traverseProject());
        const auto steps = lengthLine(zones, LengthLine::max, LengthQuantity::radius_um);
        QCOMPARE(steps.size(), std::size_t{6});
        for (std::size_t i = 0; i < 6; i += 2) {
            QCOMPARE(steps[i].y, steps[i + 1].y); // held over the zone
            const auto largest = std::ranges::max(zones.profiles[i / 2].radii_mm);
            QVERIFY(close(steps[i].y, (largest - zones.target_mm) * 1000, 1e-9));
        }
        const ProfileSeries sections = series(plungeProject(20));
        const auto line = lengthLine(sections, LengthLine::mean, LengthQuantity::radius_um);
        QCOMPARE(line.size(), std::size_t{20});
        QVERIFY(close(line[3].x, 40 * 3.5 / 20)); // at the sections' middles
    }

    void limitsAndTargetAreTheDrawings() {
        const ProfileSeries s = series(traverseProject()); // 30 −0.016…0
        const auto at = [&](LengthLine line, LengthQuantity quantity) {
            return lengthLine(s, line, quantity).front().y;
        };
        QVERIFY(close(at(LengthLine::lowerLimit, LengthQuantity::diameter_um), -16, 1e-9));
        QVERIFY(close(at(LengthLine::upperLimit, LengthQuantity::diameter_um), 0, 1e-9));
        QVERIFY(close(at(LengthLine::lowerLimit, LengthQuantity::radius_um), -4, 1e-9));
        QVERIFY(close(at(LengthLine::upperLimit, LengthQuantity::radius_um), 4, 1e-9));
        QVERIFY(close(at(LengthLine::target, LengthQuantity::radius_um), 0, 1e-9));
        QVERIFY(close(at(LengthLine::target, LengthQuantity::radius_mm), 14.996, 1e-12));
        QCOMPARE(lengthLine(s, LengthLine::upperLimit, LengthQuantity::radius_um).back().x, 92.0);
    }

    void diametersAndRadiiTellTheSameSize() {
        const ProfileSeries s = series(plungeProject(3), 12);
        for (const Profile& p : s.profiles) {
            const LengthSpread radius = spreadOf(p.radii_mm, s, LengthQuantity::radius_um);
            const LengthSpread across = spreadOf(p.radii_mm, s, LengthQuantity::diameter_um);
            const double shift = (2 * s.target_mm - s.nominal_mm) * 1000;
            QVERIFY(close(across.mean, 2 * radius.mean + shift, 1e-9));
            QVERIFY(close(across.min, p.diameterMin_mm * 1000, 1e-9));
            QVERIFY(close(across.max, p.diameterMax_mm * 1000, 1e-9));
            QVERIFY(across.max - across.min <= 2 * (radius.max - radius.min) + 1e-9);
        }
    }

    void aPlaceBelongsToItsZoneOrNearestSection() {
        const ProfileSeries zones = series(traverseProject());
        QCOMPARE(profileAt(zones, 1), 0);
        QCOMPARE(profileAt(zones, 46), 1);
        QCOMPARE(profileAt(zones, 91), 2);
        QCOMPARE(profileAt(zones, 500), 2);
        const ProfileSeries sections = series(plungeProject(4));
        QCOMPARE(profileAt(sections, 9.9), 0);
        QCOMPARE(profileAt(sections, 10.1), 1);
        QCOMPARE(profileAt(ProfileSeries{}, 1), -1);
    }

    void theShaftBeginsBeforeItsGroundLength() {
        Project p = traverseProject();
        QVERIFY(shaftSteps(p).empty());
        p.part->shaft.segments = {{25, 20}, {100, 30}, {30, 18}};
        p.part->shaft.ground_from_mm = 29;
        const std::vector<ShaftStep> steps = shaftSteps(p);
        QCOMPARE(steps.size(), std::size_t{3});
        QCOMPARE(steps[0].from_mm, -29.0);
        QCOMPARE(steps[1].from_mm, -4.0);
        QCOMPARE(steps[1].radius_mm, 15.0);
        QCOMPARE(steps[2].to_mm, 126.0);
        p.part->surface = Surface::internal;
        QVERIFY(shaftSteps(p).empty());
    }
};

} // namespace sparkout::test_length_lines

SPARKOUT_TEST(test_length_lines, TestLengthLines)
#include "test_length_lines.moc"
