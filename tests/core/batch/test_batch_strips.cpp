// SPDX-License-Identifier: GPL-3.0-or-later
// Where strips stay uncut, nothing of the finished surface is a number: in the result, and in a
// batch, whose parts fail by the overlap alone.
#include "core/batch/batch_summary.h"
#include "core/batch/sweep_run.h"
#include "core/quality/ranges.h"
#include "core/quality/result_json.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_batch_strips {

using nlohmann::json;

constexpr std::int64_t parts = 30;

/// Every requirement that is of the surface, and the drives; the first stage leaves strips.
Project stripped() {
    Project project = fixtures::shaftBatch(static_cast<int>(parts));
    Tolerance& tolerance = project.part->tolerance;
    tolerance.roundness_um = tolerance.cylindricity_um = tolerance.total_runout_um = 5;
    tolerance.radial_runout_um = tolerance.roughness_ra_um = 5;
    project.machine->wheel_drive_kw = 10;
    project.cycle->stages.front().axial_feed_mm_min =
        1.25 * project.wheel->width_mm * project.machine->work_speed_rpm;
    return project;
}

Project whole() {
    Project project = stripped();
    project.cycle->stages.front().axial_feed_mm_min =
        0.8 * project.wheel->width_mm * project.machine->work_speed_rpm;
    return project;
}

/// Parts of both kinds in one batch, as a factor of the axial feed would make them.
BatchResult mixed() {
    BatchResult result = runBatch(whole());
    const BatchResult others = runBatch(stripped());
    result.statistics.add(others.statistics);
    result.batchParts += others.batchParts;
    return result;
}

/// The numbers of a result that are of the finished surface.
std::vector<json> surfaceOf(const json& result) {
    std::vector<json> all;
    for (const json& zone : result.at("zones")) {
        for (const char* key : {"diameter_deviation_um", "radial_runout_um", "roundness_um",
                                "roundness_least_squares_um", "roughness_ra_um", "radii_um"}) {
            all.push_back(zone.at(key));
        }
    }
    for (const auto& [key, value] : result.at("part").items()) {
        if (key != "machine_known") { // of the inputs
            all.push_back(value);
        }
    }
    return all;
}

class TestBatchStrips : public QObject {
    Q_OBJECT

private slots:
    void theResultStatesNothingOfTheSurface() {
        for (const bool strips : {true, false}) {
            const SimulationResult result = simulateUnchecked(strips ? stripped() : whole());
            QVERIFY(result.status == RunStatus::completed);
            const json answer = json::parse(resultJson(result, evaluateConstraints(result)));
            QCOMPARE(answer.contains("strips_uncut"), strips);
            const std::vector<json> surface = surfaceOf(answer);
            QCOMPARE(surface.size(), std::size_t{3 * 6 + 6});
            for (const json& value : surface) {
                QCOMPARE(value.is_null(), strips);
            }
            QVERIFY(answer.at("peak").at("power_w").is_number());
            QVERIFY(answer.at("zones").at("nz").at("peak_normal_force_n").is_number());
        }
    }

    void sectionsOfAZoneStateNothingOfTheSurface() {
        for (const bool strips : {true, false}) {
            Project project = strips ? stripped() : whole();
            project.zone_sections = 2;
            const json zone =
                json::parse(resultJson(simulateUnchecked(project), {}))["zones"]["nz"];
            QCOMPARE(zone.at("sections").size(), std::size_t{2});
            for (const json& section : zone.at("sections")) {
                for (const char* key :
                     {"diameter_deviation_um", "radial_runout_um", "mean_radius_um"}) {
                    QCOMPARE(section.at(key).is_null(), strips);
                }
                QVERIFY(section.at("position_mm").is_number());
            }
        }
    }

    void aSweepsPointStatesNothingOfTheSurface() {
        for (const SweepQuantity& quantity :
             measurePoint(simulateUnchecked(stripped())).quantities) {
            QVERIFY2(quantity.section < 0, quantity.name.c_str());
        }
    }

    void everyPartFailsByTheOverlapAlone() {
        const BatchResult result = runBatch(stripped());
        const BatchSummary summary = summarise(result);
        QCOMPARE(summary.bad.count, parts);
        QCOMPARE(summary.stripped, parts);
        QCOMPARE(summary.causes.size(), std::size_t{1});
        QVERIFY(summary.causes[0].kind == ConstraintKind::overlap);
        QCOMPARE(summary.causes[0].count, parts);
        QVERIFY(summary.worstPart >= 0);
        QVERIFY(std::abs(result.statistics.worst.value + 0.2) < 1e-9); // 1/1.25 − 1
        std::size_t ofSurface = 0;
        for (const CharacteristicSummary& of : summary.characteristics) {
            const bool surface = isOfSurface(of.characteristic);
            ofSurface += surface ? 1 : 0;
            QCOMPARE(of.count, surface ? std::int64_t{0} : parts);
            QCOMPARE(of.unstated, surface ? parts : std::int64_t{0});
            QVERIFY(!surface || (!of.pp && !of.ppk && !of.expectedOutside && of.histogram.empty()));
            QVERIFY(!surface || of.outside.count == 0);
        }
        QCOMPARE(ofSurface, std::size_t{3 * 6 + 2}); // four sizes, roundness, Ra; the part's two
        QVERIFY(ofSurface < summary.characteristics.size());
        const BatchVerdict verdict = weigh(summary, result);
        QVERIFY(verdict.fitness == Fitness::unfit && verdict.reason == BatchReason::partsFail);
        QCOMPARE(verdict.value, 1.0);
    }

    void partsWithStripsAreLeftOutOfTheFigures() {
        const BatchSummary all = summarise(mixed()), good = summarise(runBatch(whole()));
        QCOMPARE(all.parts, 2 * parts);
        QCOMPARE(all.stripped, parts);
        QCOMPARE(good.stripped, std::int64_t{0});
        bool capable = false;
        for (std::size_t i = 0; i < all.characteristics.size(); ++i) {
            const CharacteristicSummary &one = all.characteristics[i],
                                        &was = good.characteristics[i];
            if (!isOfSurface(one.characteristic)) {
                QCOMPARE(one.count, 2 * parts);
                continue;
            }
            QCOMPARE(one.count, parts);
            QCOMPARE(one.unstated, parts);
            QCOMPARE(was.unstated, std::int64_t{0});
            QCOMPARE(one.moments.mean, was.moments.mean);
            QCOMPARE(one.moments.deviation, was.moments.deviation);
            capable = capable || was.ppk;
            QVERIFY(!one.pp && !one.ppk && !one.expectedOutside);
        }
        QVERIFY(capable);
    }
};

} // namespace sparkout::test_batch_strips

SPARKOUT_TEST(test_batch_strips, TestBatchStrips)
#include "test_batch_strips.moc"
