// SPDX-License-Identifier: GPL-3.0-or-later
// What the view "Zone profiles" computes from a result, held against geometry and the model.
#include "core/process/profile.h"
#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "tests/two_stage_projects.h"
#include "ui/views/longitudinal_series.h"
#include "ui/views/profiles_series.h"

#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_profiles {

using namespace sparkout;

namespace {

using fixtures::traverseProject;

Project plungeProject(int sections) {
    Project p = fixtures::plungeProject(sections);
    p.machine.geometric_runout_um = 0.5;
    return p;
}

struct Ran {
    SimulationResult result;
    Trajectory trajectory;
};

Ran run(const Project& project) {
    Ran ran;
    if (!hasErrors(validate(project))) {
        ran.result = simulate(project, &ran.trajectory);
    }
    return ran;
}

ProfileSeries series(const Project& project, std::optional<int> stroke = {}) {
    const Ran ran = run(project);
    return makeProfileSeries(ran.result, ran.trajectory,
                             stroke ? std::optional(progressAfter(ran.trajectory, *stroke))
                                    : std::nullopt);
}

double distance(const ProfilePoint& p) {
    return std::hypot(p.x, p.y);
}

bool close(double a, double b, double within = 1e-12) {
    return std::abs(a - b) <= within;
}

} // namespace

class TestProfiles : public QObject {
    Q_OBJECT
private slots:
    void theEndOfTheCycleIsTheResult();
    void theLastStrokeOfTheTrajectoryIsTheEnd_data();
    void theLastStrokeOfTheTrajectoryIsTheEnd();
    void everyStrokeShowsItsOwnLastVisits();
    void beforeTheFirstStrokeStandsTheBlank();
    void radiiNeverGrowOutwardsFromStrokeToStroke_data();
    void radiiNeverGrowOutwardsFromStrokeToStroke();
    void internalGrindingBeginsInsideItsEnd();
    void withoutATrajectoryOnlyTheEndIsThere();
    void outOfFieldIsTheVerdictsRule();

    void theDrawnLineIsClosedAndPassesOnlyThroughSamples_data();
    void theDrawnLineIsClosedAndPassesOnlyThroughSamples();
    void theTargetCircleIsDrawnAtDeviationZero();
    void magnificationOneIsTheTrueShape();
    void deviationsGrowWithTheMagnification();
    void theChordOfAnEllipseIsStraight();
    void theOwnMeanTakesTheSizeAway();
    void circlesAreDrawnAboutTheirCentres();
    void aLobedSectionHasItsReferenceCircles();

    void magnificationsAreOneTwoFive_data();
    void magnificationsAreOneTwoFive();
    void theChosenMagnificationIsTheLargestThatFits();
    void noSampleIsEverDrawnThroughTheCentre();
    void theNearestSampleIsFoundAtAnyAngle();

    void zonesStandAtTheirLengths();
    void theEntryAtTheTailstockMirrorsTheZones();
    void zonesAreStepsAndSectionsAreJoined();
    void limitsAndTargetAreTheDrawings();
    void diametersAndRadiiTellTheSameSize();
    void aPlaceBelongsToItsZoneOrNearestSection();
    void theShaftBeginsBeforeItsGroundLength();
};

// --- moments ------------------------------------------------------------------------------------

void TestProfiles::theEndOfTheCycleIsTheResult() {
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

void TestProfiles::theLastStrokeOfTheTrajectoryIsTheEnd_data() {
    QTest::addColumn<bool>("plunge");
    QTest::newRow("traverse") << false;
    QTest::newRow("plunge") << true;
}

void TestProfiles::theLastStrokeOfTheTrajectoryIsTheEnd() {
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

void TestProfiles::everyStrokeShowsItsOwnLastVisits() {
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

void TestProfiles::beforeTheFirstStrokeStandsTheBlank() {
    for (const Surface surface : {Surface::external, Surface::internal}) {
        Project p = plungeProject(3);
        p.part.surface = surface;
        p.wheel.diameter_mm = 20;
        const ProfileSeries s = series(p, 0);
        QCOMPARE(s.profiles.size(), std::size_t{3});
        QCOMPARE(s.profiles[1].radii_mm, s.blank_mm);
        const auto [low, high] = std::ranges::minmax(s.blank_mm);
        QVERIFY(close(high - low, p.part.initial_runout_mm));
        // The minimum stock lies between the target and the nearest radius [MODEL-4].
        const double stock = surface == Surface::external ? low - s.target_mm : s.target_mm - high;
        QVERIFY(close(stock, p.part.stock_mm));
        QCOMPARE(s.stage, 0);
    }
}

void TestProfiles::radiiNeverGrowOutwardsFromStrokeToStroke_data() {
    QTest::addColumn<bool>("internal");
    QTest::newRow("external") << false;
    QTest::newRow("internal") << true;
}

void TestProfiles::radiiNeverGrowOutwardsFromStrokeToStroke() {
    QFETCH(bool, internal);
    Project p = plungeProject(2);
    p.part.surface = internal ? Surface::internal : Surface::external;
    p.wheel.diameter_mm = internal ? 20 : 400;
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

void TestProfiles::internalGrindingBeginsInsideItsEnd() {
    Project p = plungeProject(2);
    p.part.surface = Surface::internal;
    p.wheel.diameter_mm = 20;
    const ProfileSeries s = series(p);
    QVERIFY(!s.profiles.empty());
    for (const Profile& profile : s.profiles) {
        const auto [blankLow, blankHigh] = std::ranges::minmax(s.blank_mm);
        QVERIFY(blankHigh < std::ranges::min(profile.radii_mm));
        const PolarScale scale = polarScale(s, profile, RadiusReference::target, 50);
        QVERIFY(distance(closedLine(s.blank_mm, scale)[0])
                < distance(closedLine(profile.radii_mm, scale)[0]));
    }
    const ProfilePoint blank = lengthLine(s, LengthLine::blankMax, LengthQuantity::radius_um)[0];
    const ProfilePoint end = lengthLine(s, LengthLine::min, LengthQuantity::radius_um)[0];
    QVERIFY(blank.y < end.y);
}

void TestProfiles::withoutATrajectoryOnlyTheEndIsThere() {
    const Ran ran = run(traverseProject());
    const ProfileSeries s = makeProfileSeries(ran.result, Trajectory{}, Progress{});
    QVERIFY(s.atEnd());
    QCOMPARE(s.profiles[0].radii_mm, ran.result.sections[0].radii_mm);
}

void TestProfiles::outOfFieldIsTheVerdictsRule() {
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

// --- the magnified drawing ----------------------------------------------------------------------

void TestProfiles::theDrawnLineIsClosedAndPassesOnlyThroughSamples_data() {
    QTest::addColumn<int>("radii");
    for (const int radii : {4, 36, 360}) {
        QTest::addRow("%d radii", radii) << radii;
    }
}

void TestProfiles::theDrawnLineIsClosedAndPassesOnlyThroughSamples() {
    QFETCH(int, radii);
    Project p = plungeProject(1);
    p.part.radii_per_section = radii;
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
        const double turn =
            std::remainder(std::atan2(point.y, point.x) - angleOf(k, radii), 2 * std::numbers::pi);
        QVERIFY(std::abs(turn) < 1e-9);
    }
}

void TestProfiles::theTargetCircleIsDrawnAtDeviationZero() {
    const ProfileSeries s = series(traverseProject());
    for (const double times : {1.0, 2000.0, 1e6}) {
        const PolarScale scale = polarScale(s, s.profiles[1], RadiusReference::target, times);
        QCOMPARE(scale.at(s.target_mm), s.target_mm);
        QVERIFY(
            close(scale.at(s.upperLimit_mm) - scale.at(s.target_mm), 0.004 * times, times * 1e-14));
    }
}

void TestProfiles::magnificationOneIsTheTrueShape() {
    const ProfileSeries s = series(plungeProject(1), 3);
    const PolarScale scale = polarScale(s, s.profiles[0], RadiusReference::target, 1);
    const std::vector<ProfilePoint> line = closedLine(s.profiles[0].radii_mm, scale);
    for (std::size_t k = 0; k < s.profiles[0].radii_mm.size(); ++k) {
        QVERIFY(close(distance(line[k]), s.profiles[0].radii_mm[k]));
    }
}

void TestProfiles::deviationsGrowWithTheMagnification() {
    const PolarScale once{15, 15, 100}, twice{15, 15, 200};
    QVERIFY(close(twice.at(15.01) - 15, 2 * (once.at(15.01) - 15)));
    QVERIFY(close(twice.radiusAt(twice.at(14.99)), 14.99));
}

void TestProfiles::theChordOfAnEllipseIsStraight() {
    // Four samples of an ellipse: the line between them is the chord, well inside the ellipse.
    Project p = plungeProject(1);
    p.part.radii_per_section = 4;
    p.part.initial_runout_mm = 1;
    const std::vector<double> ellipse = profileRadii(p.part, 16);
    const PolarScale scale{16, 16, 1};
    const std::vector<ProfilePoint> line = closedLine(ellipse, scale);
    const ProfilePoint middle{(line[0].x + line[1].x) / 2, (line[0].y + line[1].y) / 2};
    QVERIFY(close(distance(middle), std::hypot(16.0, 15.0) / 2));
    // The ellipse itself at 45°: pq·√2/√(p² + q²).
    QVERIFY(distance(middle) < 16 * 15 * std::numbers::sqrt2 / std::hypot(16.0, 15.0) - 4);
}

void TestProfiles::theOwnMeanTakesTheSizeAway() {
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

void TestProfiles::circlesAreDrawnAboutTheirCentres() {
    // R(φ) = e·cos(φ − φ0) + √(r² − e²·sin²(φ − φ0)): a circle of radius r about a point at e.
    const double r = 15, e = 0.4, at = 0.7;
    const FittedCircle circle{e * std::cos(at), e * std::sin(at), r};
    for (int k = 0; k < 36; ++k) {
        const double phi = angleOf(k, 36) - at;
        const double radius = e * std::cos(phi) + std::sqrt(r * r - std::pow(e * std::sin(phi), 2));
        QVERIFY(close(radiusOf(circle, angleOf(k, 36)), radius));
    }
    // Not magnified it is the circle itself.
    for (const ProfilePoint& p : circleLine(circle, {r, r, 1})) {
        QVERIFY(close(std::hypot(p.x - circle.x_mm, p.y - circle.y_mm), r));
    }
}

void TestProfiles::aLobedSectionHasItsReferenceCircles() {
    for (const int lobes : {2, 3, 5}) {
        Project project = plungeProject(1);
        project.part.profile = ProfileForm::lobes;
        project.part.lobes = lobes;
        project.part.radii_per_section = 60;
        ProfileSeries s = series(project, 0);
        addMinimumZones(s, {0});
        const Profile& p = s.profiles[0];
        const double form = project.part.initial_runout_mm;
        QVERIFY(close(p.leastSquares.deviation(), form, 1e-9));
        QVERIFY(close(p.minimumZone.deviation(), form, 1e-9));
        QVERIFY(close(p.leastSquares.reference_mm, p.mean_mm, 1e-9));
        QVERIFY(std::hypot(p.leastSquares.x_mm, p.leastSquares.y_mm) < 1e-9);
    }
}

// --- magnification ------------------------------------------------------------------------------

void TestProfiles::magnificationsAreOneTwoFive_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("down");
    QTest::addColumn<double>("up");
    QTest::newRow("1") << 1.0 << 1.0 << 1.0;
    QTest::newRow("1.9") << 1.9 << 1.0 << 2.0;
    QTest::newRow("2") << 2.0 << 2.0 << 2.0;
    QTest::newRow("4.99") << 4.99 << 2.0 << 5.0;
    QTest::newRow("7") << 7.0 << 5.0 << 10.0;
    QTest::newRow("999999") << 999999.0 << 500000.0 << 1000000.0;
    QTest::newRow("1000") << 1000.0 << 1000.0 << 1000.0;
    QTest::newRow("0.03") << 0.03 << 0.02 << 0.05;
}

void TestProfiles::magnificationsAreOneTwoFive() {
    QFETCH(double, value);
    QFETCH(double, down);
    QFETCH(double, up);
    QVERIFY(close(roundDown125(value), down, down * 1e-9));
    QVERIFY(close(roundUp125(value), up, up * 1e-9));
}

void TestProfiles::theChosenMagnificationIsTheLargestThatFits() {
    // Inwards 4 µm of 15 mm: 0.6·15/0.004 = 2250, so 2000.
    QCOMPARE(suitableMagnification({0.004, 0.001}, 15), 2000.0);
    // A blank 170 µm above the target: 15/0.17 = 88, so 50.
    QCOMPARE(suitableMagnification({0.004, 0.170}, 15), 50.0);
    QCOMPARE(suitableMagnification({0, 0}, 15), 1e6); // perfectly round
    QCOMPARE(suitableMagnification({14, 0}, 15), 1.0);
}

void TestProfiles::noSampleIsEverDrawnThroughTheCentre() {
    for (int stroke : {0, 1, 20, 69}) {
        for (const Surface surface : {Surface::external, Surface::internal}) {
            Project p = plungeProject(3);
            p.part.surface = surface;
            p.wheel.diameter_mm = surface == Surface::internal ? 20 : 400;
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

void TestProfiles::theNearestSampleIsFoundAtAnyAngle() {
    QCOMPARE(nearestRadius(0, 36), 0);
    QCOMPARE(nearestRadius(angleOf(5, 36) + 0.08, 36), 5); // half a step is 0.087
    QCOMPARE(nearestRadius(-angleOf(1, 36), 36), 35);
    QCOMPARE(nearestRadius(2 * std::numbers::pi - 0.01, 36), 0);
    QCOMPARE(nearestRadius(-std::numbers::pi / 2, 4), 3);
}

// --- along the axis -----------------------------------------------------------------------------

void TestProfiles::zonesStandAtTheirLengths() {
    Project p = traverseProject(); // B = 50, L = 92, o1 = o2 = 12 by default
    p.machine.overrun_exit_mm = 20;
    const ProfileSeries s = series(p);
    const double rz1 = p.wheel.width_mm - 12, rz2 = p.wheel.width_mm - 20;
    QVERIFY(close(s.profiles[0].from_mm, 0) && close(s.profiles[0].to_mm, rz1));
    QVERIFY(close(s.profiles[1].from_mm, rz1) && close(s.profiles[1].to_mm, 92 - rz2));
    QVERIFY(close(s.profiles[2].from_mm, 92 - rz2) && close(s.profiles[2].to_mm, 92));
    QVERIFY(close(s.gauge_mm, (rz1 + 92 - rz2) / 2));
}

void TestProfiles::theEntryAtTheTailstockMirrorsTheZones() {
    Project p = traverseProject();
    p.machine.overrun_exit_mm = 20;
    const ProfileSeries left = series(p);
    p.machine.entry_side = EntrySide::tailstock;
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

void TestProfiles::zonesAreStepsAndSectionsAreJoined() {
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

void TestProfiles::limitsAndTargetAreTheDrawings() {
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

void TestProfiles::diametersAndRadiiTellTheSameSize() {
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

void TestProfiles::aPlaceBelongsToItsZoneOrNearestSection() {
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

void TestProfiles::theShaftBeginsBeforeItsGroundLength() {
    Project p = traverseProject();
    QVERIFY(shaftSteps(p).empty());
    p.part.shaft.segments = {{25, 20}, {100, 30}, {30, 18}};
    p.part.shaft.ground_from_mm = 29;
    const std::vector<ShaftStep> steps = shaftSteps(p);
    QCOMPARE(steps.size(), std::size_t{3});
    QCOMPARE(steps[0].from_mm, -29.0);
    QCOMPARE(steps[1].from_mm, -4.0);
    QCOMPARE(steps[1].radius_mm, 15.0);
    QCOMPARE(steps[2].to_mm, 126.0);
    p.part.surface = Surface::internal;
    QVERIFY(shaftSteps(p).empty());
}

} // namespace test_profiles

SPARKOUT_TEST(test_profiles, TestProfiles)
#include "test_profiles.moc"
