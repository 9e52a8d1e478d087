// SPDX-License-Identifier: GPL-3.0-or-later
// The magnified drawing of a profile, held against geometry.
#include "core/process/profile.h"
#include "tests/core/study/profile_series_bench.h"
#include "tests/registry.h"
#include "ui/chart/profiles_look.h"

#include <algorithm>
#include <numbers>

namespace sparkout::test_magnified_profile {

using namespace profile_series_bench;

class TestMagnifiedProfile : public QObject {
    Q_OBJECT

private slots:
    void theDrawnLineIsClosedAndPassesOnlyThroughSamples_data() {
        QTest::addColumn<int>("radii");
        for (const int radii : {4, 36, 360}) {
            QTest::addRow("%d radii", radii) << radii;
        }
    }

    void theDrawnLineIsClosedAndPassesOnlyThroughSamples() {
        QFETCH(int, radii);
        Project p = plungeProject(1);
        p.part->radii_per_section = radii;
        const ProfileSeries s = series(p);
        const PolarScale scale = polarScale(s, s.profiles[0], RadiusReference::target, 1000);
        const std::vector<ProfilePoint> line = closedLine(s.profiles[0].radii_mm, scale);
        QCOMPARE(line.size(), static_cast<std::size_t>(radii) + 1);
        QCOMPARE(line.front().x, line.back().x);
        QCOMPARE(line.front().y, line.back().y);
        for (int k = 0; k < radii; ++k) {
            const ProfilePoint& point = line[static_cast<std::size_t>(k)];
            QVERIFY(close(scale.radiusAt(distance(point)),
                          s.profiles[0].radii_mm[static_cast<std::size_t>(k)]));
            const double turn = std::remainder(std::atan2(point.y, point.x) - angleOf(k, radii),
                                               2 * std::numbers::pi);
            QVERIFY(std::abs(turn) < 1e-9);
        }
    }

    void theTargetCircleIsDrawnAtDeviationZero() {
        const ProfileSeries s = series(traverseProject());
        for (const double times : {1.0, 2000.0, 1e6}) {
            const PolarScale scale = polarScale(s, s.profiles[1], RadiusReference::target, times);
            QCOMPARE(scale.at(s.target_mm), s.target_mm);
            QVERIFY(close(scale.at(s.upperLimit_mm) - scale.at(s.target_mm), 0.004 * times,
                          times * 1e-14));
        }
    }

    void magnificationOneIsTheTrueShape() {
        const ProfileSeries s = series(plungeProject(1), 3);
        const PolarScale scale = polarScale(s, s.profiles[0], RadiusReference::target, 1);
        const std::vector<ProfilePoint> line = closedLine(s.profiles[0].radii_mm, scale);
        for (std::size_t k = 0; k < s.profiles[0].radii_mm.size(); ++k) {
            QVERIFY(close(distance(line[k]), s.profiles[0].radii_mm[k]));
        }
    }

    void deviationsGrowWithTheMagnification() {
        const PolarScale once{15, 15, 100}, twice{15, 15, 200};
        QVERIFY(close(twice.at(15.01) - 15, 2 * (once.at(15.01) - 15)));
        QVERIFY(close(twice.radiusAt(twice.at(14.99)), 14.99));
    }

    void theChordOfAnEllipseIsStraight() {
        // Four samples of an ellipse: the line between them is the chord, well inside the ellipse.
        Project p = plungeProject(1);
        p.part->radii_per_section = 4;
        p.part->initial_runout_mm = 1;
        const std::vector<double> ellipse = profileRadii(*p.part, 16);
        const PolarScale scale{16, 16, 1};
        const std::vector<ProfilePoint> line = closedLine(ellipse, scale);
        const ProfilePoint middle{(line[0].x + line[1].x) / 2, (line[0].y + line[1].y) / 2};
        QVERIFY(close(distance(middle), std::hypot(16.0, 15.0) / 2));
        // The ellipse itself at 45°: pq·√2/√(p² + q²).
        QVERIFY(distance(middle) < 16 * 15 * std::numbers::sqrt2 / std::hypot(16.0, 15.0) - 4);
    }

    void theOwnMeanTakesTheSizeAway() {
        ProfileSeries s = series(plungeProject(2), 5);
        Profile larger = s.profiles[0];
        for (double& radius : larger.radii_mm) {
            radius += 0.123;
        }
        larger.mean_mm += 0.123;
        const auto drawn = [&](const Profile& p) {
            return closedLine(p.radii_mm, polarScale(s, p, RadiusReference::mean, 2000));
        };
        const std::vector<ProfilePoint> a = drawn(s.profiles[0]), b = drawn(larger);
        double mean = 0;
        for (std::size_t k = 0; k + 1 < a.size(); ++k) {
            QVERIFY(close(a[k].x, b[k].x, 1e-9) && close(a[k].y, b[k].y, 1e-9));
            mean += distance(a[k]) / static_cast<double>(a.size() - 1);
        }
        QVERIFY(close(mean, s.target_mm, 1e-9)); // drawn about the base circle
    }

    void circlesAreDrawnAboutTheirCentres() {
        // R(φ) = e·cos(φ − φ0) + √(r² − e²·sin²(φ − φ0)): a circle of radius r about a point at e.
        const double r = 15, e = 0.4, at = 0.7;
        const FittedCircle circle{e * std::cos(at), e * std::sin(at), r};
        for (int k = 0; k < 36; ++k) {
            const double phi = angleOf(k, 36) - at;
            const double radius =
                e * std::cos(phi) + std::sqrt(r * r - std::pow(e * std::sin(phi), 2));
            QVERIFY(close(radiusOf(circle, angleOf(k, 36)), radius));
        }
        // Not magnified it is the circle itself.
        for (const ProfilePoint& p : circleLine(circle, {r, r, 1})) {
            QVERIFY(close(std::hypot(p.x - circle.x_mm, p.y - circle.y_mm), r));
        }
    }

    void aLobedSectionHasItsReferenceCircles() {
        for (const int lobes : {2, 3, 5}) {
            Project project = plungeProject(1);
            project.part->profile = ProfileForm::lobes;
            project.part->lobes = lobes;
            project.part->radii_per_section = 60;
            ProfileSeries s = series(project, 0);
            addMinimumZone(s.profiles[0]);
            const Profile& p = s.profiles[0];
            const double form = project.part->initial_runout_mm;
            QVERIFY(close(p.leastSquares.deviation(), form, 1e-9));
            QVERIFY(close(p.minimumZone.deviation(), form, 1e-9));
            QVERIFY(close(p.leastSquares.reference_mm, p.mean_mm, 1e-9));
            QVERIFY(std::hypot(p.leastSquares.x_mm, p.leastSquares.y_mm) < 1e-9);
        }
    }

    void magnificationsAreOneTwoFive_data() {
        addColumns<double, double, double>("value", "down", "up");
        QTest::newRow("1") << 1.0 << 1.0 << 1.0;
        QTest::newRow("1.9") << 1.9 << 1.0 << 2.0;
        QTest::newRow("2") << 2.0 << 2.0 << 2.0;
        QTest::newRow("4.99") << 4.99 << 2.0 << 5.0;
        QTest::newRow("7") << 7.0 << 5.0 << 10.0;
        QTest::newRow("999999") << 999999.0 << 500000.0 << 1000000.0;
        QTest::newRow("1000") << 1000.0 << 1000.0 << 1000.0;
        QTest::newRow("0.03") << 0.03 << 0.02 << 0.05;
    }

    void magnificationsAreOneTwoFive() {
        QFETCH(double, value);
        QFETCH(double, down);
        QFETCH(double, up);
        QVERIFY(close(roundDown125(value), down, down * 1e-9));
        QVERIFY(close(roundUp125(value), up, up * 1e-9));
    }

    void theChosenMagnificationIsTheLargestThatFits() {
        // Inwards 4 µm of 15 mm: 0.6·15/0.004 = 2250, so 2000.
        QCOMPARE(suitableMagnification({0.004, 0.001}, 15), 2000.0);
        // A blank 170 µm above the target: 15/0.17 = 88, so 50.
        QCOMPARE(suitableMagnification({0.004, 0.170}, 15), 50.0);
        QCOMPARE(suitableMagnification({0, 0}, 15), 1e6); // perfectly round
        QCOMPARE(suitableMagnification({14, 0}, 15), 1.0);
    }

    void noSampleIsEverDrawnThroughTheCentre() {
        for (int stroke : {0, 1, 20, 69}) {
            for (const Surface surface : {Surface::external, Surface::internal}) {
                Project p = plungeProject(3);
                p.part->surface = surface;
                p.wheel->diameter_mm = surface == Surface::internal ? 20 : 400;
                const ProfileSeries s = series(p, stroke);
                for (const auto reference : {RadiusReference::target, RadiusReference::mean}) {
                    const Reach reach = reachOf(s, {0, 1, 2}, reference, true);
                    const std::vector<double> all = possibleMagnifications(reach, s.target_mm);
                    QVERIFY(all.front() == 1 && std::ranges::is_sorted(all));
                    QVERIFY(suitableMagnification(reach, s.target_mm) <= all.back());
                    for (const Profile& profile : s.profiles) {
                        const PolarScale scale = polarScale(s, profile, reference, all.back());
                        for (const double radius : s.blank_mm) {
                            QVERIFY(scale.at(radius) > 0);
                        }
                    }
                }
            }
        }
    }

    void theNearestSampleIsFoundAtAnyAngle() {
        QCOMPARE(nearestRadius(0, 36), 0);
        QCOMPARE(nearestRadius(angleOf(5, 36) + 0.08, 36), 5); // half a step is 0.087
        QCOMPARE(nearestRadius(-angleOf(1, 36), 36), 35);
        QCOMPARE(nearestRadius(2 * std::numbers::pi - 0.01, 36), 0);
        QCOMPARE(nearestRadius(-std::numbers::pi / 2, 4), 3);
    }

    void aBoreIsDrawnOutsideItsBlank() {
        const ProfileSeries s = series(boreProject(2));
        QVERIFY(!s.profiles.empty());
        for (const Profile& profile : s.profiles) {
            const PolarScale scale = polarScale(s, profile, RadiusReference::target, 50);
            QVERIFY(distance(closedLine(s.blank_mm, scale)[0])
                    < distance(closedLine(profile.radii_mm, scale)[0]));
        }
    }
};

} // namespace sparkout::test_magnified_profile

SPARKOUT_TEST(test_magnified_profile, TestMagnifiedProfile)
#include "test_magnified_profile.moc"
