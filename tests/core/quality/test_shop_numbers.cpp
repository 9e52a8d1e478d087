// SPDX-License-Identifier: GPL-3.0-or-later
// The shop's own numbers: at the largest depth, of the settings, their bands.
#include "core/quality/shop_numbers.h"

#include "tests/core/quality/shop_cycles.h"
#include "tests/registry.h"

namespace sparkout::test_shop_numbers {

using namespace shop_cycles;
using fixtures::close;
using fixtures::Traced;
using fixtures::within;

class TestShopNumbers : public QObject {
    Q_OBJECT

private slots:
    // --- the numbers at the largest depth -------------------------------------------------------

    // d 30, D 600, n 180, V_k 35: V_d = 282.743 mm/s, D_e = 600/21; a = 5 µm.
    void removalRateChipAndAggressivenessByHand() {
        const ShopColumn stage = shopNumbers(simulateUnchecked(rigidPlunge())).stages[0];
        QVERIFY(within(stage.depth_mm.value, 0.005, 1e-12));
        QVERIFY(within(stage.removalRate_mm2_s, 1.413717, 1e-6));
        QVERIFY(within(stage.equivalentChip_um, 0.0403919, 1e-7));
        QVERIFY(within(stage.aggressiveness, 106.86, 0.01));
    }

    void numbersAreTakenAtTheLargestDepthWhereTheyWere() {
        for (int seed = 1; seed <= seeds() / 3; ++seed) {
            const Traced run(random(seed));
            const Project& p = run.result.project;
            const ShopNumbers shop = shopNumbers(run.result);
            for (std::size_t z = 0; z < shop.stages.size(); ++z) {
                const ShopColumn& stage = shop.stages[z];
                const double a = stage.depth_mm.value;
                if (a == 0) {
                    continue;
                }
                QCOMPARE(stage.depth_mm.at.stage, int(z) + 1);
                const double recorded = largestAt(run, stage.depth_mm.at);
                QVERIFY(recorded == a || (p.zone_sections > 1 && recorded < a)); // of the middles
                const double speeds = workSpeed(p) / (p.machine->wheel_speed_m_s * 1000);
                QVERIFY(close(stage.removalRate_mm2_s, a * workSpeed(p), 1e-14));
                QVERIFY(close(stage.equivalentChip_um, a * speeds * 1000, 1e-14));
                const double d = p.part->diameter_mm, D = p.wheel->diameter_mm;
                const bool external = p.part->surface == Surface::external;
                const double De = external ? d * D / (d + D) : d * D / (d - D);
                QVERIFY(close(stage.aggressiveness, 1e6 * speeds * std::sqrt(a / De), 1e-14));
                QVERIFY(shop.cycle.depth_mm.value >= a);
            }
        }
    }

    // --- what the settings alone give -----------------------------------------------------------

    void overlapIsTheWheelsWidthOverTheAxialFeedPerRevolution() {
        Project p = fixtures::traverse(); // B 50, n 180
        const ShopNumbers shop = shopNumbers(simulateUnchecked(p));
        QVERIFY(close(*shop.stages[0].overlap, 5, 1e-15));
        QVERIFY(close(*shop.stages[1].overlap, 30, 1e-15));
        QVERIFY(close(*shop.cycle.overlap, 5, 1e-15));
        QCOMPARE(shop.stages[0].overlapBand(), BandSide::inside);
        p.cycle->stages[1].axial_feed_mm_min = 50.01 * 180;
        const ShopNumbers fast = shopNumbers(simulateUnchecked(p));
        QCOMPARE(fast.stages[1].overlapBand(), BandSide::below);
        QCOMPARE(fast.cycle.overlapBand(), BandSide::below);
        QVERIFY(!shopNumbers(simulateUnchecked(fixtures::plunge())).cycle.overlap);
        QCOMPARE(shopNumbers(simulateUnchecked(fixtures::plunge())).cycle.overlapBand(),
                 BandSide::none);
    }

    // BADGER2010: 40 m/s, work 200 rev/min, wheel worn from 500 to 350 mm: 1528…2182 rev/min,
    // ratio 7.63…10.91 (the article cuts the last digits off).
    void rotationRatioIsAsPublished_data() {
        addColumns<double, double, double>("diameter", "rpm", "ratio");
        QTest::newRow("new") << 500.0 << 1528.0 << 7.635;
        QTest::newRow("worn") << 350.0 << 2182.5 << 10.91;
    }
    void rotationRatioIsAsPublished() {
        QFETCH(double, diameter);
        QFETCH(double, rpm);
        QFETCH(double, ratio);
        Project p = fixtures::plunge();
        p.machine->wheel_speed_m_s = 40;
        p.machine->work_speed_rpm = 200;
        p.wheel->diameter_mm = diameter;
        const ShopNumbers shop = shopNumbers(simulateUnchecked(p));
        QVERIFY(within(shop.wheelSpeed_rpm, rpm, 0.5));
        QVERIFY(within(shop.rotationRatio, ratio, 0.006));
    }

    void ratiosNearAWholeNumberAreFlagged_data() {
        addColumns<double, bool>("ratio", "flagged");
        QTest::newRow("whole") << 8.0 << true;
        QTest::newRow("just above") << 8.049 << true;
        QTest::newRow("just below") << 7.951 << true;
        QTest::newRow("far enough above") << 8.051 << false;
        QTest::newRow("far enough below") << 7.949 << false;
        QTest::newRow("half") << 8.5 << false;
        QTest::newRow("one") << 1.0 << true;
        QTest::newRow("wheel far slower than work") << 0.03 << false;
    }
    void ratiosNearAWholeNumberAreFlagged() {
        QFETCH(double, ratio);
        QFETCH(bool, flagged);
        ShopNumbers shop;
        shop.rotationRatio = ratio;
        QCOMPARE(shop.ratioNearInteger(), flagged);
    }

    // --- bands and stages that do nothing -------------------------------------------------------

    void specificEnergyBandIsTwentyToAHundredAndTwenty_data() {
        addColumns<double, BandSide>("energy", "band");
        QTest::newRow("below") << 19.99 << BandSide::below;
        QTest::newRow("at the least") << 20.0 << BandSide::inside;
        QTest::newRow("at the most") << 120.0 << BandSide::inside;
        QTest::newRow("above") << 120.01 << BandSide::above;
    }
    void specificEnergyBandIsTwentyToAHundredAndTwenty() {
        QFETCH(double, energy);
        QFETCH(BandSide, band);
        ShopColumn column;
        QCOMPARE(column.specificEnergyBand(), BandSide::none);
        column.energy_j_mm3 = energy;
        QCOMPARE(column.specificEnergyBand(), band);
    }

    // The first stage leaves less than the second asks for: several stages end at one reading.
    void stageThatNeverRanIsAllZero() {
        Project p = fixtures::plunge();
        p.cycle->stages = {fixtures::plungeStage(0.9, 0.2), fixtures::plungeStage(0.1, 0),
                           fixtures::sparkStage(fixtures::count(3))};
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(r.countsByStage[1], 0);
        const ShopNumbers shop = shopNumbers(r);
        const ShopColumn& skipped = shop.stages[1];
        QCOMPARE(skipped.removedVolume_mm3, 0.0);
        QCOMPARE(skipped.energy_j, 0.0);
        QCOMPARE(skipped.time_s, 0.0);
        QCOMPARE(skipped.meanPower_w, 0.0);
        QCOMPARE(skipped.meanRemovalRate_mm2_s, 0.0);
        QVERIFY(!skipped.energy_j_mm3);
        QVERIFY(shop.stages[2].removedVolume_mm3 > 0);
    }

private:
    /// The largest depth of the pass at this place.
    static double largestAt(const Traced& run, const Place& at) {
        double largest = 0;
        for (const Pass& pass : run.trajectory.passes) {
            const Place& place = pass.place;
            if (place.zone == at.zone && place.step == at.step && place.section == at.section
                && place.stage == at.stage && place.cycleCount == at.cycleCount
                && place.revolution == at.revolution) {
                for (int k = 0; k < run.trajectory.radii; ++k) {
                    largest = std::max(largest, run.visit(pass, k).actual_mm);
                }
            }
        }
        return largest;
    }
};

} // namespace sparkout::test_shop_numbers

SPARKOUT_TEST(test_shop_numbers, TestShopNumbers)
#include "test_shop_numbers.moc"
