// SPDX-License-Identifier: GPL-3.0-or-later
// The profiles of a moment of the cycle, held against its visits.
#include "core/study/profile_series.h"
#include "tests/core/study/profile_series_bench.h"
#include "tests/registry.h"

#include <algorithm>

namespace sparkout::test_profile_moments {

using namespace profile_series_bench;

class TestProfileMoments : public QObject {
    Q_OBJECT

private slots:
    void theEndOfTheCycleIsTheResult() {
        const Ran ran = run(traverseProject());
        const ProfileSeries s = makeProfileSeries(ran.result, ran.trajectory);
        QCOMPARE(s.profiles.size(), ran.result.sections.size());
        for (std::size_t i = 0; i < s.profiles.size(); ++i) {
            QCOMPARE(s.profiles[i].radii_mm, ran.result.sections[i].radii_mm);
            QCOMPARE(s.profiles[i].diameterMin_mm, ran.result.sections[i].diameterDeviationMin_mm);
            QCOMPARE(s.profiles[i].radialRunout_mm, ran.result.sections[i].radialRunout_mm);
        }
        QVERIFY(s.atEnd() && s.stage == 2);
        QCOMPARE(s.time_s, ran.result.time_s);
    }

    void theLastStrokeOfTheTrajectoryIsTheEnd_data() {
        QTest::addColumn<bool>("plunge");
        QTest::newRow("traverse") << false;
        QTest::newRow("plunge") << true;
    }

    void theLastStrokeOfTheTrajectoryIsTheEnd() {
        QFETCH(bool, plunge);
        const Ran ran = run(plunge ? plungeProject(5) : traverseProject());
        // A result that claims one stroke more makes the last recorded one be read back.
        SimulationResult longer = ran.result;
        longer.cycleCount += 1;
        const ProfileSeries read = makeProfileSeries(
            longer, ran.trajectory, progressAfter(ran.trajectory, ran.result.cycleCount));
        const ProfileSeries end = makeProfileSeries(ran.result, ran.trajectory);
        QVERIFY(!read.atEnd() && end.atEnd());
        for (std::size_t i = 0; i < end.profiles.size(); ++i) {
            const Profile& a = read.profiles[i];
            const Profile& b = end.profiles[i];
            QCOMPARE(a.radii_mm, b.radii_mm);
            QVERIFY(close(a.diameterMin_mm, b.diameterMin_mm));
            QVERIFY(close(a.diameterMax_mm, b.diameterMax_mm));
            QVERIFY(close(a.radialRunout_mm, b.radialRunout_mm));
        }
        QVERIFY(close(read.time_s, end.time_s, 1e-9));
    }

    void everyStrokeShowsItsOwnLastVisits() {
        const Ran ran = run(traverseProject());
        const int stroke = ran.result.cycleCount / 2;
        const ProfileSeries s =
            makeProfileSeries(ran.result, ran.trajectory, progressAfter(ran.trajectory, stroke));
        // By brute force: the last pass of each zone up to the end of that stroke.
        for (const Profile& p : s.profiles) {
            const Pass* last = nullptr;
            for (const Pass& pass : ran.trajectory.passes) {
                if (pass.place.zone == p.zone && pass.place.cycleCount <= stroke) {
                    last = &pass;
                }
            }
            QVERIFY(last && last->place.cycleCount == stroke);
            for (std::size_t k = 0; k < p.radii_mm.size(); ++k) {
                QCOMPARE(p.radii_mm[k], ran.trajectory.visits[last->firstVisit + k].radius_mm);
            }
        }
    }

    void beforeTheFirstStrokeStandsTheBlank() {
        for (const Surface surface : {Surface::external, Surface::internal}) {
            Project p = plungeProject(3);
            p.part->surface = surface;
            p.wheel->diameter_mm = 20;
            const ProfileSeries s = series(p, 0);
            QCOMPARE(s.profiles.size(), std::size_t{3});
            QCOMPARE(s.profiles[1].radii_mm, s.blank_mm);
            const auto [low, high] = std::ranges::minmax(s.blank_mm);
            QVERIFY(close(high - low, p.part->initial_runout_mm));
            // The minimum stock lies between the target and the nearest radius [MODEL-4].
            const double stock =
                surface == Surface::external ? low - s.target_mm : s.target_mm - high;
            QVERIFY(close(stock, p.part->stock_mm));
            QCOMPARE(s.stage, 0);
        }
    }

    void radiiNeverGrowOutwardsFromStrokeToStroke_data() {
        QTest::addColumn<bool>("internal");
        QTest::newRow("external") << false;
        QTest::newRow("internal") << true;
    }

    void radiiNeverGrowOutwardsFromStrokeToStroke() {
        QFETCH(bool, internal);
        Project p = plungeProject(2);
        p.part->surface = internal ? Surface::internal : Surface::external;
        p.wheel->diameter_mm = internal ? 20 : 400;
        const Ran ran = run(p);
        QVERIFY(ran.result.cycleCount > 10);
        std::vector<double> before = makeProfileSeries(ran.result, ran.trajectory).blank_mm;
        const double side = internal ? 1 : -1;
        for (int n = 1; n <= ran.result.cycleCount; ++n) {
            const ProfileSeries s =
                makeProfileSeries(ran.result, ran.trajectory, progressAfter(ran.trajectory, n));
            for (std::size_t k = 0; k < before.size(); ++k) {
                QVERIFY(side * (s.profiles[0].radii_mm[k] - before[k]) >= 0);
            }
            before = s.profiles[0].radii_mm;
        }
    }

    void internalGrindingBeginsInsideItsEnd() {
        const ProfileSeries s = series(boreProject(2));
        QVERIFY(!s.profiles.empty());
        for (const Profile& profile : s.profiles) {
            const auto [blankLow, blankHigh] = std::ranges::minmax(s.blank_mm);
            QVERIFY(blankHigh < std::ranges::min(profile.radii_mm));
        }
        const ProfilePoint blank =
            lengthLine(s, LengthLine::blankMax, LengthQuantity::radius_um)[0];
        const ProfilePoint end = lengthLine(s, LengthLine::min, LengthQuantity::radius_um)[0];
        QVERIFY(blank.y < end.y);
    }

    void withoutATrajectoryOnlyTheEndIsThere() {
        const Ran ran = run(traverseProject());
        const ProfileSeries s = makeProfileSeries(ran.result, Trajectory{}, Progress{});
        QVERIFY(s.atEnd());
        QCOMPARE(s.profiles[0].radii_mm, ran.result.sections[0].radii_mm);
    }

    void outOfFieldIsTheVerdictsRule() {
        ProfileSeries s = series(traverseProject());
        Profile p = s.profiles[0];
        p.diameterMin_mm = -0.016;
        p.diameterMax_mm = 0;
        QVERIFY(!outOfField(s, p)); // on the limits
        p.diameterMin_mm = -0.016 - 0.5e-9;
        QVERIFY(!outOfField(s, p));
        p.diameterMin_mm = -0.016 - 2e-9;
        QVERIFY(outOfField(s, p));
        p.diameterMin_mm = -0.010;
        p.diameterMax_mm = 2e-9;
        QVERIFY(outOfField(s, p));
    }
};

} // namespace sparkout::test_profile_moments

SPARKOUT_TEST(test_profile_moments, TestProfileMoments)
#include "test_profile_moments.moc"
