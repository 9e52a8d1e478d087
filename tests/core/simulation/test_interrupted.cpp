// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted surfaces: keyways and splines [MODEL-4, 7].
#include "core/project/validate.h"
#include "core/quality/diameter_shares.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/feed_series.h"
#include "core/simulation/progress.h"
#include "core/simulation/stock_layers.h"
#include "core/study/profile_series.h"
#include "core/surface/accuracy.h"
#include "core/surface/harmonics.h"

#include "tests/core/simulation/random_cycles.h"
#include "tests/core/simulation/strokes_by_hand.h"
#include "tests/registry.h"

#include <cstring>

namespace sparkout::test_interrupted {

using fixtures::close;
using fixtures::Traced;
using fixtures::within;

/// Two opposite quarters of sixteen radii: the gaps of one are the surface of the other.
std::vector<SurfaceGap> quarters(bool odd) {
    const double first = odd ? 78.75 : -11.25 + 360;
    return {{first, 90}, {first > 180 ? first - 180 : first + 180, 90}};
}

Project interrupted(Project p, std::vector<SurfaceGap> gaps) {
    p.part->gaps = std::move(gaps);
    return p;
}

/// The same but for what no surface was under.
bool sameOnTheSurface(const Traced& whole, const Traced& gapped) {
    const auto& x = whole.trajectory.visits;
    const auto& y = gapped.trajectory.visits;
    const std::vector<bool> inside = inGaps(*gapped.result.project.part);
    bool same = x.size() == y.size();
    for (std::size_t i = 0; same && i < x.size(); ++i) {
        const bool gap = inside[i % inside.size()];
        same = gap ? y[i].isGap() && y[i].normalForce_n == 0 && y[i].accumulated_mm == 0
                   : std::memcmp(&x[i], &y[i], sizeof(Visit)) == 0;
    }
    return same;
}

/// A lobed plunge of two sections, read off its last revolution.
Project lobed() {
    Project p = fixtures::plunge();
    p.part->radii_per_section = 36;
    p.part->profile = ProfileForm::lobes;
    p.part->lobes = 3;
    p.part->initial_runout_mm = 0.03;
    p.sections = 3;
    p.machine->compliance_mm_per_n = std::vector<double>{2e-5, 3e-5, 4e-5};
    return p;
}

class TestInterrupted : public QObject {
    Q_OBJECT

private slots:
    void radiiStandInAGapFromItsFirstEdgeOn() {
        Part part;
        part.radii_per_section = 8; // 45° apart
        const auto inside = [&part](double from, double width) {
            part.gaps = {{from, width}};
            std::string found;
            for (const bool gap : inGaps(part)) {
                found += gap ? 'x' : '.';
            }
            return found;
        };
        QCOMPARE(inside(90, 0), std::string("........"));
        QCOMPARE(inside(90, 1), std::string("..x....."));
        QCOMPARE(inside(90, 45), std::string("..x....."));
        QCOMPARE(inside(90, 45.1), std::string("..xx...."));
        QCOMPARE(inside(89.9, 45), std::string("..x....."));
        QCOMPARE(inside(90.1, 45), std::string("...x...."));
        QCOMPARE(inside(300, 100), std::string("x......x"));
        QCOMPARE(inside(360, 90), std::string("xx......"));
        part.gaps = {{0, 10}, {200, 50}};
        QCOMPARE(std::ranges::count(inGaps(part), true), 2);
    }

    // Every radius of the surface is cut as if there were no gap.
    void twoDoubleStrokesAreAsByHand() {
        for (const bool rigid : {true, false}) {
            Project p = strokes_by_hand::byHand(rigid);
            p.part->radii_per_section = 8;
            strokes_by_hand::feed(p, 8, 0, 16);
            const Traced whole(p);
            p.part->gaps = {{90, 30}};
            QVERIFY(!hasErrors(validate(p)));
            const Traced run(p);
            QCOMPARE(strokes_by_hand::difference(run, strokes_by_hand::entryInfeed, rigid),
                     QString());
            QVERIFY(sameOnTheSurface(whole, run));
            QVERIFY(std::isnan(run.result.sections[1].radii_mm[2]));
            if (rigid) { // 16 µm off seven eighths of the surface
                const double volume = std::numbers::pi * 30 * 16e-3 * 100 * 7 / 8;
                QVERIFY(close(shopNumbers(run.result).cycle.removedVolume_mm3, volume, 1e-9));
            }
        }
    }

    void aGapOfNoWidthChangesNothing() {
        for (const Project& p : {fixtures::traverse(), lobed()}) {
            const Traced plain(p);
            const Traced gapped(interrupted(p, {{120, 0}, {0, 0}}));
            QVERIFY(fixtures::sameBits(plain.result, gapped.result));
            const auto& x = plain.trajectory.visits;
            const auto& y = gapped.trajectory.visits;
            QCOMPARE(x.size(), y.size());
            QCOMPARE(std::memcmp(x.data(), y.data(), x.size() * sizeof(Visit)), 0);
        }
    }

    void theSurfaceIsCutAsWithoutGaps() {
        int runs = 0;
        QVERIFY(rc::check("a gap is no matter to the other radii", [&] {
            Project p = random_cycles::anyCycle();
            p.gauge->control = Control::position; // the reading is that of the diameters left
            p.part->profile = ProfileForm::lobes;
            const Project gapped = interrupted(p, {{fixtures::between(0, 360), 40}});
            if (hasErrors(validate(gapped))) {
                return;
            }
            RC_ASSERT(sameOnTheSurface(Traced(p), Traced(gapped)));
            ++runs;
        }));
        QVERIFY(runs > 30);
    }

    // Volume, energy and mean power of the surface and of what is missing add up to the whole.
    void twoHalvesOfASurfaceAddUp() {
        Project p = fixtures::traverse();
        p.part->radii_per_section = 16;
        p.part->initial_runout_mm = 0.02;
        p.gauge->control = Control::position;
        const ShopColumn whole = shopNumbers(simulate(p)).cycle;
        const ShopColumn one = shopNumbers(simulate(interrupted(p, quarters(false)))).cycle;
        const ShopColumn other = shopNumbers(simulate(interrupted(p, quarters(true)))).cycle;
        QVERIFY(one.removedVolume_mm3 > 0 && other.removedVolume_mm3 > 0);
        QVERIFY(
            close(one.removedVolume_mm3 + other.removedVolume_mm3, whole.removedVolume_mm3, 1e-12));
        QVERIFY(close(one.energy_j + other.energy_j, whole.energy_j, 1e-12));
        QVERIFY(close(one.meanPower_w + other.meanPower_w, whole.meanPower_w, 1e-12));
        QCOMPARE(one.time_s, whole.time_s);
    }

    // The gauge reads diameters with no end in a gap, by its rule.
    void theGaugeReadsWhatIsLeft() {
        for (const GaugeRule rule : {GaugeRule::min, GaugeRule::mean, GaugeRule::max}) {
            for (const Surface surface : {Surface::external, Surface::internal}) {
                Project p = lobed();
                p.part->surface = surface;
                p.wheel->diameter_mm = surface == Surface::internal ? 20 : 600;
                p.part->profile = ProfileForm::ellipse;
                p.gauge->rule = rule;
                p = interrupted(p, {{350, 25}, {80, 15}});
                const SimulationResult result = simulate(p);
                std::vector<double> R = result.sections[1].radii_mm, D;
                for (std::size_t k = 0; k < 18; ++k) {
                    if (!std::isnan(R[k] + R[k + 18])) {
                        D.push_back(R[k] + R[k + 18]);
                    }
                }
                QCOMPARE(D.size(), std::size_t{13}); // of 350, 0, 10, 80, 90° none
                const auto [low, high] = std::minmax_element(D.begin(), D.end());
                double sum = 0;
                for (const double diameter : D) {
                    sum += diameter;
                }
                const bool lowest = (rule == GaugeRule::min) == (surface == Surface::external);
                const double reading = rule == GaugeRule::mean ? sum / 13 : lowest ? *low : *high;
                QVERIFY(within(result.gaugeReading_mm, reading, 1e-12));
                const SectionResult& section = result.sections[1];
                QVERIFY(within(section.diameterDeviationMin_mm, *low - 30, 1e-12));
                QVERIFY(within(section.diameterDeviationMax_mm, *high - 30, 1e-12));
            }
        }
    }

    void formIsThatOfWhatIsThere() {
        const Project p = lobed();
        const SimulationResult whole = simulate(p);
        const SimulationResult gapped = simulate(interrupted(p, {{100, 41}}));
        const PartAccuracy all = accuracyOf(whole), some = accuracyOf(gapped);
        for (std::size_t j = 0; j < 3; ++j) {
            const std::vector<double>& R = gapped.sections[j].radii_mm;
            double low = 1e9, high = 0;
            for (const double radius : R) {
                low = std::isnan(radius) ? low : std::min(low, radius);
                high = std::isnan(radius) ? high : std::max(high, radius);
            }
            QCOMPARE(std::ranges::count_if(R, [](double r) { return std::isnan(r); }), 5);
            QVERIFY(within(some.sections[j].radialRunout_mm, high - low, 1e-15));
            QVERIFY(within(gapped.sections[j].radialRunout_mm, high - low, 1e-15));
            // Fewer points are held between narrower circles.
            const double zone = some.sections[j].minimumZone.deviation();
            QVERIFY(zone > 0 && zone <= all.sections[j].minimumZone.deviation() + 1e-12);
            QVERIFY(some.sections[j].leastSquares.deviation() >= zone - 1e-12);
            for (const std::size_t k : some.sections[j].minimumZone.contacts) {
                QVERIFY(k < R.size() && !std::isnan(R[k]));
            }
            // Gauss's conditions for the true distances.
            const RoundnessZone& fit = some.sections[j].leastSquares;
            double residuals = 0, across = 0, up = 0;
            for (std::size_t k = 0; k < R.size(); ++k) {
                if (std::isnan(R[k])) {
                    continue;
                }
                const double phi = 2 * std::numbers::pi * double(k) / 36;
                const double x = R[k] * std::cos(phi) - fit.x_mm;
                const double y = R[k] * std::sin(phi) - fit.y_mm;
                const double d = std::hypot(x, y);
                residuals += d - fit.reference_mm;
                across += (d - fit.reference_mm) * x / d;
                up += (d - fit.reference_mm) * y / d;
            }
            QVERIFY(within(residuals, 0, 1e-11) && within(across, 0, 1e-11)
                    && within(up, 0, 1e-11));
        }
        QVERIFY(some.minimumZone.deviation() <= all.minimumZone.deviation() + 1e-12);
        QVERIFY(some.minimumZone.deviation() <= some.leastSquares.deviation() + 1e-12);
        for (const CylinderContact& contact : some.minimumZone.contacts) {
            QVERIFY(!std::isnan(gapped.sections[contact.section].radii_mm[contact.radius]));
        }
        QVERIFY(some.totalRunout_mm > 0 && std::isfinite(some.profile.taper_mm));
    }

    void anExactCircleOffTheAxisIsFoundFromAnArc() {
        std::vector<double> R(36);
        const double x = 0.02, y = -0.01, r = 15;
        for (std::size_t k = 0; k < 36; ++k) {
            const double phi = 2 * std::numbers::pi * double(k) / 36;
            const double along = x * std::cos(phi) + y * std::sin(phi);
            R[k] = k < 15 ? std::nan("") : along + std::sqrt(r * r - x * x - y * y + along * along);
        }
        const Directions directions(36);
        for (const RoundnessZone& zone :
             {leastSquaresCircle(R, directions), minimumZoneCircles(R, directions)}) {
            QVERIFY(within(zone.x_mm, x, 1e-10) && within(zone.y_mm, y, 1e-10));
            QVERIFY(within(zone.reference_mm, r, 1e-10));
            QVERIFY(zone.deviation() < 1e-10);
        }
        const std::vector<SectionShape> shapes{{0, R}, {10, R}, {25, R}};
        for (const CylinderZone& zone :
             {leastSquaresCylinder(shapes, directions), minimumZoneCylinder(shapes, directions)}) {
            QVERIFY(within(zone.x_mm, x, 1e-9) && within(zone.slopeX, 0, 1e-9));
            QVERIFY(zone.deviation() < 1e-9);
        }
    }

    void harmonicsBridgeAGap() {
        std::vector<double> R(36, 15.0), line(36, 15.0);
        for (std::size_t k = 0; k < 5; ++k) { // from 0 at k = 34 to 3 µm at k = 3
            R[(34 + k) % 36] = std::nan("");
            line[(34 + k) % 36] = 15 + 0.003 * double(k + 1) / 6;
        }
        R[3] = line[3] = 15.003;
        const Directions directions(36);
        const auto a = harmonics(R, directions), b = harmonics(line, directions);
        QCOMPARE(a.size(), b.size());
        for (std::size_t n = 0; n < a.size(); ++n) {
            QVERIFY(within(a[n].amplitude_mm, b[n].amplitude_mm, 1e-14));
        }
    }

    // No number of a gap, and none missing beside it, comes into what views and reports show.
    void seriesLeaveGapsOut() {
        Project p = lobed();
        p.gauge->control = Control::position;
        const Traced whole(p), gapped(interrupted(p, {{100, 41}}));
        const FeedSeries feeds = makeFeedSeries(gapped.result, gapped.trajectory);
        QCOMPARE(feeds.dropped, 0);
        const FeedSeries all = makeFeedSeries(whole.result, whole.trajectory);
        for (std::size_t i = 0; i < feeds.columns[0].strokes.size(); ++i) {
            const FeedPoint& x = feeds.columns[0].strokes[i];
            const FeedPoint& y = all.columns[0].strokes[i];
            QVERIFY(x.actual_um.min >= y.actual_um.min && x.actual_um.max <= y.actual_um.max);
            QVERIFY(x.programmed_um.min >= y.programmed_um.min);
            QVERIFY(std::isfinite(x.left_um.mean) && std::isfinite(x.came_um.mean));
        }
        const ProfileSeries profiles = makeProfileSeries(gapped.result, gapped.trajectory, {});
        QVERIFY(std::isnan(profiles.blank_mm[12]) && !std::isnan(profiles.blank_mm[9]));
        const Profile& profile = profiles.profiles[0];
        double sum = 0;
        for (const double radius : profile.radii_mm) {
            sum += std::isnan(radius) ? 0 : radius;
        }
        QVERIFY(within(profile.mean_mm, sum / 31, 1e-12));
        const LengthSpread spread = spreadOf(profile.radii_mm, profiles, LengthQuantity::radius_mm);
        QVERIFY(within(spread.mean, profile.mean_mm, 1e-12));
        QVERIFY(within(spread.max - spread.min, gapped.result.sections[0].radialRunout_mm, 1e-12));
        const Progress middle = progressAfter(gapped.trajectory, 5);
        const ProfileSeries then = makeProfileSeries(gapped.result, gapped.trajectory, middle);
        QVERIFY(std::isfinite(then.profiles[0].diameterMin_mm));
        QVERIFY(std::isfinite(then.profiles[0].radialRunout_mm));
        for (const std::optional<int> radius : {std::optional<int>(), {3}, {12}}) {
            const LayerSeries layers = makeLayerSeries(gapped.result, gapped.trajectory, radius);
            for (const LayerColumn& column : layers.columns) {
                QVERIFY(std::isfinite(column.blank_mm) && std::isfinite(column.final_mm));
                const double removed = std::abs(column.blank_mm - column.final_mm);
                QVERIFY(within(column.sum_mm.back(), removed, 1e-12));
                QCOMPARE(removed > 0, radius != 12);
            }
        }
        const DiameterShares shares = diameterShares(gapped.result, 0, DiameterEnd::largest);
        QVERIFY(std::isfinite(shares.section_um) && std::isfinite(shares.form_um));
    }

    void aGaugeThatDropsInReadsTheLargestOnly() {
        const auto drops = [](const Project& p) {
            return std::ranges::any_of(validate(p), [](const Issue& issue) {
                return issue.code == IssueCode::gaugeDropsIn;
            });
        };
        Project p = interrupted(fixtures::traverse(), {{10, 40}});
        QVERIFY(!drops(p));
        p.gauge->spans_gaps = false;
        QVERIFY(drops(p));
        p.gauge->rule = GaugeRule::mean;
        QVERIFY(drops(p));
        p.gauge->rule = GaugeRule::max;
        QVERIFY(!drops(p));
        p.gauge->rule = GaugeRule::min;
        p.gauge->control = Control::position;
        QVERIFY(!drops(p));
        p.gauge->control = Control::gauge;
        p.part->gaps = {{10, 0}};
        QVERIFY(!drops(p));
    }

    // Deviations in the gaps are of no surface: a keyway may be as deep as it is.
    void aMeasuredProfileCountsOutsideTheGaps() {
        Project p = fixtures::plunge();
        p.part->radii_per_section = 12;
        p.part->profile = ProfileForm::measured;
        p.part->radii_um = std::vector<double>(12, 0.0);
        (*p.part->radii_um)[4] = -5000;
        (*p.part->radii_um)[7] = -20;
        QVERIFY(within(initialRunout(*p.part), 5, 1e-12));
        p.part->gaps = {{115, 20}};
        QVERIFY(within(initialRunout(*p.part), 0.02, 1e-12));
        QVERIFY(!hasErrors(validate(p)));
        const Blank blank = makeBlank(*p.part);
        QVERIFY(blank.isGap(4) && !blank.isGap(7));
        QVERIFY(within(blank.depth_mm[7], 0.02, 1e-12));
        QVERIFY(within(blank.totalInfeed_mm, 0.22, 1e-12));
    }
};

} // namespace sparkout::test_interrupted

SPARKOUT_TEST(test_interrupted, TestInterrupted)
#include "test_interrupted.moc"
