// SPDX-License-Identifier: GPL-3.0-or-later
// The best position of the gauge [AKINTSEVA2020, section 3].
#include "core/study/gauge_placement.h"

#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_gauge_placement {

using fixtures::plungeStage;
using fixtures::within;

/// Sections ever softer towards the tailstock, as in the article's figure 2.
Project article() {
    Project p = fixtures::plunge();
    p.sections = 4;
    p.machine->compliance_mm_per_n = std::vector<double>{2e-5, 3e-5, 4e-5, 5e-5};
    p.part->upper_deviation_um = 20;
    p.part->lower_deviation_um = -20;
    p.cycle->stages = {plungeStage(0.9, 0.17), plungeStage(0.2, 0.03)};
    return p;
}

constexpr double middles[] = {5, 15, 25, 35}; // of the four sections

/// The mean diameter deviation at section j with the gauge over section g [mm].
double deviation(const GaugePlacement& placement, std::size_t g, std::size_t j) {
    return placement.positions[g].meanDeviations_mm[j];
}

class TestGaugePlacement : public QObject {
    Q_OBJECT

private slots:
    void candidatesReachFromEndToEnd() {
        const std::vector<double> plunge = gaugeCandidates(article(), 9);
        QCOMPARE(plunge.size(), std::size_t(9));
        QCOMPARE(plunge.front(), 0.0);
        QCOMPARE(plunge[4], 20.0);
        QCOMPARE(plunge.back(), 40.0);
        Project p = fixtures::traverse();
        QCOMPARE(gaugeCandidates(p, 9), (std::vector<double>{19, 46, 73}));
        p.machine->overrun_entry_mm = 2;
        p.machine->entry_side = EntrySide::tailstock;
        QCOMPARE(gaugeCandidates(p, 9), (std::vector<double>{19, 41, 68}));
    }

    // What the article says: a gauge on the stiffest section leaves the others larger, on the
    // softest smaller, in between both ways. By the balance the softer section ends larger.
    void gaugeOnTheStiffestSectionLeavesTheOthersLarger() {
        const GaugePlacement placement =
            placeGauge(article(), {middles[0], middles[1], middles[2], middles[3]});
        QCOMPARE(placement.positions.size(), std::size_t(4));
        for (std::size_t g = 0; g < 4; ++g) {
            QCOMPARE(placement.positions[g].status, RunStatus::completed);
            for (std::size_t j = 0; j < 4; ++j) {
                const double away = deviation(placement, g, j) - deviation(placement, g, g);
                QVERIFY(j > g ? away > 1e-4 : j < g ? away < -1e-4 : away == 0);
            }
            QCOMPARE(placement.positions[g].sectionOfMin, std::size_t(0));
            QCOMPARE(placement.positions[g].sectionOfMax, std::size_t(3));
            QVERIFY(placement.positions[g].taper_mm > 0); // larger at the tailstock
        }
    }

    void eachPositionIsTheCycleWithThatGauge() {
        Project p = article();
        p.gauge->section = 3; // not read
        const GaugePlacement placement = placeGauge(p, {0, 12.5, 40});
        for (const GaugePosition& at : placement.positions) {
            Project one = p;
            one.gauge->section.reset();
            one.gauge->position_mm = at.position_mm;
            const SimulationResult r = simulateUnchecked(one);
            QCOMPARE(at.time_s, r.time_s);
            double least = 1, most = -1;
            for (std::size_t j = 0; j < 4; ++j) {
                least = std::min(least, r.sections[j].diameterDeviationMin_mm);
                most = std::max(most, r.sections[j].diameterDeviationMax_mm);
                double sum = 0;
                for (const double R : r.sections[j].radii_mm) {
                    sum += R;
                }
                QVERIFY(within(at.meanDeviations_mm[j], 2 * sum / 4 - 30, 1e-13));
            }
            QCOMPARE(at.deviationMin_mm, least);
            QCOMPARE(at.deviationMax_mm, most);
            QVERIFY(within(at.margin_mm, std::min(0.02 - most, least + 0.02), 1e-15));
        }
    }

    void bestPositionHasTheLargestMargin() {
        Project p = article();
        const GaugePlacement placement = placeGauge(p, gaugeCandidates(p, 33));
        QVERIFY(placement.best);
        const double best = placement.positions[*placement.best].margin_mm;
        for (const GaugePosition& at : placement.positions) {
            QVERIFY(at.margin_mm <= best);
        }
        // set to the middle of the field, the best place is neither end
        QVERIFY(*placement.best > 0 && *placement.best < 32);
    }

    // The straight part of mean radii that rise evenly is their whole rise.
    void taperOfEvenlyRisingRadiiIsTheirRise() {
        Project p = article();
        p.wheel->dullness = 0; // γ·P is then proportional to γ at a steady feed
        p.part->stock_mm = 2;
        p.cycle->stages = {plungeStage(0.9, 2)};
        const GaugePosition at = placeGauge(p, {5}).positions.front();
        const fixtures::Law law(p);
        QVERIFY(within(at.taper_mm, (5e-5 - 2e-5) * law.force(40, 0.005), 1e-9));
    }

    void strokesSeeOnlyTheZoneTheGaugeIsIn() {
        Project p = fixtures::traverse();
        p.machine->compliance_mm_per_n = ZoneCompliance{1e-4, 4e-4, 2.5e-4};
        p.cycle->stages = {fixtures::strokeStage(0.002, 1000, 0.15)};
        // zones of 38, 16, 38 mm
        const GaugePlacement placement = placeGauge(p, {0, 37.9, 38.1, 53.9, 54.1, 92});
        QCOMPARE(placement.positions.size(), std::size_t(6));
        const Zone expected[] = {Zone::rz1, Zone::rz1, Zone::nz, Zone::nz, Zone::rz2, Zone::rz2};
        for (std::size_t i = 0; i < 6; ++i) {
            QCOMPARE(placement.positions[i].zone, expected[i]);
            QCOMPARE(placement.positions[i].time_s, placement.positions[i / 2 * 2].time_s);
        }
        const SimulationResult r = simulateUnchecked(p);
        QCOMPARE(placement.positions[2].time_s, r.time_s); // НЗ is where simulate() has it
        QCOMPARE(placement.positions[2].deviationMax_mm, r.sections[1].diameterDeviationMax_mm);
        // the gauge in НЗ, the largest zone, lets the cycle run longest
        QVERIFY(placement.positions[2].time_s > placement.positions[0].time_s);
        QVERIFY(placement.positions[2].deviationMin_mm < placement.positions[0].deviationMin_mm);
        // each zone's own reading ends its cycle at or below size
        const GaugePosition& entry = placement.positions[0];
        QVERIFY(entry.meanDeviations_mm[0] < entry.meanDeviations_mm[1]);
    }

    void entryAtTheTailstockMirrorsTheZones() {
        Project p = fixtures::traverse();
        p.machine->entry_side = EntrySide::tailstock;
        const GaugePlacement placement = placeGauge(p, {1, 91});
        QCOMPARE(placement.positions[0].zone, Zone::rz2);
        QCOMPARE(placement.positions[1].zone, Zone::rz1);
    }

    void positionControlLeavesTheGaugeNoSay() {
        Project p = article();
        p.gauge->control = Control::position;
        const GaugePlacement placement = placeGauge(p, gaugeCandidates(p, 5));
        for (const GaugePosition& at : placement.positions) {
            QCOMPARE(at.meanDeviations_mm, placement.positions[0].meanDeviations_mm);
            QCOMPARE(at.time_s, placement.positions[0].time_s);
        }
        QCOMPARE(placement.best, std::optional<std::size_t>(2)); // of equals the middle one
    }

    void coupledSectionsAreAskedToo() {
        Project p = article();
        p.machine->compliance_mm_per_n = std::monostate{};
        p.machine->stiffness_n_um = Stiffness{60, 10, 50};
        p.part->shaft.segments = {{30, 25}, {60, 30}};
        p.part->shaft.ground_from_mm = 45;
        p.sections_coupled = true;
        const GaugePlacement placement = placeGauge(p, {0, 40});
        QVERIFY(placement.positions[1].compliance_mm_per_n
                > placement.positions[0].compliance_mm_per_n);
        QVERIFY(placement.positions[1].deviationMax_mm < placement.positions[0].deviationMax_mm);
    }

    void progressIsToldAndAStopIsHeeded() {
        const Project p = article();
        std::vector<std::size_t> told;
        std::stop_source source;
        const GaugePlacement placement = placeGauge(
            p, gaugeCandidates(p, 10),
            [&](std::size_t done, std::size_t total) {
                QCOMPARE(total, std::size_t(10));
                told.push_back(done);
                if (done == 4) {
                    source.request_stop();
                }
            },
            source.get_token());
        QCOMPARE(told, (std::vector<std::size_t>{1, 2, 3, 4}));
        QVERIFY(placement.stopped);
        QCOMPARE(placement.positions.size(), std::size_t(4));
        QVERIFY(placement.best);
    }

    void cyclesThatDoNotEndAreNotTheBest() {
        Project p = article();
        p.cycle->stages = {plungeStage(0.9, 0.19),
                           fixtures::sparkStage(fixtures::untilSize(), 0.01)};
        p.wheel->dullness = 0;
        const GaugePlacement placement = placeGauge(p, {5, 35});
        for (const GaugePosition& at : placement.positions) {
            QCOMPARE(at.status, RunStatus::cannotReachSize);
        }
        QVERIFY(!placement.best);
    }
};

} // namespace sparkout::test_gauge_placement

SPARKOUT_TEST(test_gauge_placement, TestGaugePlacement)
#include "test_gauge_placement.moc"
