// SPDX-License-Identifier: GPL-3.0-or-later
// What a fit compares with is the cycle that simulate() runs.
#include "core/measured/cycle_response.h"

#include "core/measured/fit_data.h"
#include "core/measured/fit_problem.h"
#include "core/process/compliance.h"
#include "core/process/system_compliance.h"
#include "tests/core/measured/measured_cycles.h"
#include "tests/core/support/project_samples.h"
#include "tests/core/support/random_project.h"
#include "tests/registry.h"

#include <set>

namespace sparkout::test_cycle_response {

class TestCycleResponse : public QObject {
    Q_OBJECT

private slots:
    /// Time, size at the gauge and final diameters of random cycles, traverse and plunge.
    void itIsTheSimulatedCycle() {
        int traverse = 0, plunge = 0;
        const int seeds = samples::sized(60, 15, 200);
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
            const ReadResult read = readProject(randomProject(seed).dump());
            if (!read.project) {
                continue;
            }
            const Project& project = *read.project;
            const SimulationResult result = simulate(project);
            if (result.status != RunStatus::completed) {
                continue;
            }
            const CycleResponse response =
                respond(project, factorsOf(project), result.countsByStage, true);
            QVERIFY2(response.ran, std::to_string(seed).c_str());
            const double target_mm = 2 * targetRadius(*project.part);
            const double size_mm = result.gaugeReading_mm - target_mm;
            QVERIFY2(std::abs(response.end_s.back() - result.time_s) < 1e-9 * (1 + result.time_s),
                     std::to_string(seed).c_str());
            QVERIFY2(std::abs(response.size_mm.back() - size_mm) < 1e-9,
                     std::to_string(seed).c_str());
            for (std::size_t i = 0; i < result.sections.size(); ++i) {
                const double mean_mm = 2 * meanOfGround(result.sections[i].radii_mm);
                QVERIFY(std::abs(response.deviation_um[i]
                                 - (mean_mm - project.part->diameter_mm) * 1000)
                        < 1e-6);
            }
            QCOMPARE(response.middle_s.size(), response.end_s.size() + 1);
            QCOMPARE(response.placeSizes_mm.size(), static_cast<std::size_t>(placeCount(project)));
            (project.operation->travels ? traverse : plunge) += 1;
        }
        QVERIFY(traverse > seeds / 10 && plunge > seeds / 10);
    }

    /// Power and force of a plunge as they follow from the visits.
    void powerAndForceAreThoseOfTheVisits() {
        const Project project = samples::project("smallest-plunge");
        const measured_cycles::Record record = measured_cycles::record(project);
        const CycleResponse response =
            respond(project, factorsOf(project), simulate(project).countsByStage, false);
        QCOMPARE(response.middle_s.size(), record.middle_s.size());
        for (std::size_t i = 0; i < record.middle_s.size(); ++i) {
            QVERIFY(std::abs(response.middle_s[i] - record.middle_s[i]) < 1e-9);
            QVERIFY(std::abs(response.chip_kw[i] + response.friction_kw[i] - record.power_kw[i])
                    < 1e-12 + 1e-9 * record.power_kw[i]);
            QVERIFY(std::abs(response.chip_n[i] + response.friction_n[i] - record.force_n[i])
                    < 1e-9 + 1e-9 * record.force_n[i]);
        }
    }

    /// γ from stiffness and shaft is multiplied exactly, as what is given.
    void complianceIsMultiplied() {
        for (const char* name : {"stiffness-traverse", "complete", "smallest-plunge"}) {
            const Project project = samples::project(name);
            Project scaled = project;
            scaleCompliance(scaled, 1.7);
            const auto before = compliantPoints(project), after = compliantPoints(scaled);
            for (std::size_t i = 0; i < before.size(); ++i) {
                QVERIFY(std::abs(after[i].gamma_mm_n / before[i].gamma_mm_n - 1.7) < 1e-9);
            }
            Project places = project;
            scalePlaceCompliances(places, std::vector<double>{1, 2});
            const auto own = compliantPoints(places);
            QVERIFY(std::abs(own[0].gamma_mm_n / before[0].gamma_mm_n - 1) < 1e-12);
            QVERIFY(std::abs(own[1].gamma_mm_n / before[1].gamma_mm_n - 2) < 1e-12);
            QVERIFY(std::abs(own[2].gamma_mm_n / before[2].gamma_mm_n - 1) < 1e-12);
        }
    }

    void betweenTimesItIsLinear() {
        const std::vector<double> times{0, 1, 3}, values{10, 20, 0};
        QCOMPARE(valueAt(times, values, -1), 10.0);
        QCOMPARE(valueAt(times, values, 0.25), 12.5);
        QCOMPARE(valueAt(times, values, 2), 10.0);
        QCOMPARE(valueAt(times, values, 4), 0.0);
    }

    /// Of white noise on a slow curve the estimate is the noise.
    void noiseIsEstimatedFromTheTrace() {
        Project project = samples::project("smallest-plunge");
        const measured_cycles::Record cycle = measured_cycles::record(project);
        project.measured.emplace().traces = {measured_cycles::trace(
            TraceQuantity::gauge_size, cycle, {.hertz = 200, .noise = 5e-4, .seed = 9})};
        MeasuredTrace current =
            measured_cycles::trace(TraceQuantity::wheel_power, cycle, {.hertz = 20});
        current.quantity = TraceQuantity::spindle_current;
        project.measured->traces.push_back(current);
        const FitData data = fitDataOf(project, {}, true);
        QCOMPARE(data.groups.size(), std::size_t{1}); // a current without its factor is no power
        QCOMPARE(data.withoutFactor, std::vector<int>{1});
        QVERIFY(std::abs(data.groups[0].noise / 5e-4 - 1) < 0.15);
        project.measured->traces[1].factor_kw_per_a = 0.5;
        const FitData both = fitDataOf(project, {}, false);
        QCOMPARE(both.groups.size(), std::size_t{2});
        QCOMPARE(both.groups[1].values[5], 0.5 * current.values[5]);
        QCOMPARE(fitDataOf(project, {1}, false).groups.size(), std::size_t{1});
    }

    void robustWeightsAreThoseOfTheirLosses() {
        const auto huber = robustWeights({0.5, -2.69}, RobustLoss::huber);
        QCOMPARE(huber[0], 1.0);
        QVERIFY(std::abs(huber[1] * huber[1] - 0.5) < 1e-12);
        const auto tukey = robustWeights({0, 2.3425, 5}, RobustLoss::tukey);
        QCOMPARE(tukey[0], 1.0);
        QVERIFY(std::abs(tukey[1] - 0.75) < 1e-12);
        QCOMPARE(tukey[2], 0.0);
        QCOMPARE(robustWeights({100}, RobustLoss::none)[0], 1.0);
    }

    void everyParameterHasItsKey() {
        std::set<std::string> keys;
        for (int kind = 0; kind < static_cast<int>(FittedKind::count_); ++kind) {
            keys.insert(keyOf(static_cast<FittedKind>(kind)));
            QVERIFY(plausibleRange(static_cast<FittedKind>(kind)) > 0);
        }
        QCOMPARE(keys.size(), static_cast<std::size_t>(FittedKind::count_));
        QVERIFY(!keys.contains(""));
    }

    /// The project's own values are usual, and traces leave the factors of the depths of cut less
    /// room than finished parts, which need 8.5 times β for a published table.
    void whatTheProjectHasIsUsual() {
        const Project project = measured_cycles::yieldingPlunge();
        for (int i = 0; i < static_cast<int>(FittedKind::count_); ++i) {
            const auto kind = static_cast<FittedKind>(i);
            const auto ofParts = usualRange(project, kind, false);
            const auto ofTraces = usualRange(project, kind, true);
            const bool isAnywhere =
                kind == FittedKind::time_shift || kind == FittedKind::size_offset;
            QCOMPARE(ofParts.has_value(), !isAnywhere);
            QCOMPARE(ofTraces.has_value(), !isAnywhere);
            if (isAnywhere) {
                continue;
            }
            const double own = kind == FittedKind::blank_runout    ? project.part->initial_runout_mm
                               : kind == FittedKind::gauge_setting ? 2 * targetRadius(*project.part)
                                                                   : isFactor(kind);
            QVERIFY2(ofTraces->low <= own && own <= ofTraces->high, keyOf(kind));
            QVERIFY2(ofParts->low <= ofTraces->low && ofTraces->high <= ofParts->high, keyOf(kind));
            if (actsOnDepths(kind)) {
                QCOMPARE(ofTraces->high, mostSearchedFactor);
            }
        }
        QVERIFY(usualRange(project, FittedKind::beta, false)->high > 8.5);
    }
};

} // namespace sparkout::test_cycle_response

SPARKOUT_TEST(test_cycle_response, TestCycleResponse)
#include "test_cycle_response.moc"
