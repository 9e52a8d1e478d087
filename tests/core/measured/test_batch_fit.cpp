// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Parameters from finished parts: table 2 of the thesis, a truth that the interval holds, and what
// sizes cannot tell.
#include "core/measured/calibration.h"
#include "core/measured/cycle_response.h"
#include "core/measured/identification.h"
#include "core/phases/phase_decision.h"
#include "core/process/profile.h"
#include "core/simulation/simulate.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "tests/check_line.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

#include <cmath>

namespace sparkout::test_batch_fit {

using Kinds = std::vector<FittedKind>;

Identification fit(const Project& project, const Kinds& kinds) {
    IdentificationRequest request{.parameters = {}, .withParts = true};
    for (const FittedKind kind : kinds) {
        request.parameters.push_back({kind, {}, {}});
    }
    return identify(project, request);
}

Project factory() {
    return samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
}

Project tableTwo() {
    return samples::projectIn("resources/examples/shaft-30h6-measured.sparkout");
}

double normal(std::uint32_t seed, std::uint64_t index) {
    return normalQuantile(openUnit(randomBits(seed, RandomStream::plain, index, 0)));
}

/// Parts of a project with stocks anywhere in one infeed, each zone measured to 0.3 µm.
std::vector<MeasuredPart> ground(const Project& truth, int count, std::uint32_t seed) {
    const StockRange range = usualPhases(truth);
    std::vector<MeasuredPart> parts;
    for (int i = 0; i < count; ++i) {
        Project part = truth;
        const double share =
            openUnit(randomBits(seed, RandomStream::plain, static_cast<std::uint64_t>(i), 1));
        part.part->stock_mm = range.from_mm + share * (range.to_mm - range.from_mm);
        const SimulationResult result = simulate(part);
        for (std::size_t place = 0; place < result.sections.size(); ++place) {
            const SectionResult& section = result.sections[place];
            MeasuredPart& made = parts.emplace_back();
            made.part = std::to_string(i + 1);
            made.place = static_cast<int>(place);
            made.diameters_mm = {
                part.part->diameter_mm
                + (section.diameterDeviationMin_mm + section.diameterDeviationMax_mm) / 2
                + 3e-4 * normal(seed, static_cast<std::uint64_t>(i) * 8 + place)};
        }
    }
    return parts;
}

bool holds(const Identification& result, FittedKind kind, double truth) {
    return std::ranges::any_of(result.values, [&](const FittedValue& value) {
        return value.parameter.kind == kind && value.interval95.low <= truth
               && truth <= value.interval95.high;
    });
}

QByteArray said(const Identification& result) {
    QByteArray text = "status " + QByteArray::number(static_cast<int>(result.status));
    for (const FittedValue& value : result.values) {
        text += QByteArray("; ") + keyOf(value.parameter.kind) + ' '
                + QByteArray::number(value.value, 'g', 8) + " in "
                + QByteArray::number(value.interval95.low, 'g', 8) + "…"
                + QByteArray::number(value.interval95.high, 'g', 8);
    }
    return text;
}

class TestBatchFit : public QObject {
    Q_OBJECT

private slots:
    /// Three means, two numbers: β 8.5 times that of the file, the gauge at the upper limit.
    void tableTwoOfTheThesis() {
        const Project project = tableTwo();
        RunningTimer timer;
        const Identification found = fit(project, {FittedKind::beta, FittedKind::gauge_setting});
        const double seconds = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
        qInfo("table 2: %s; %.2f s, %s", said(found).constData(), seconds, beside(seconds, 10.0));
        QVERIFY2(found.status == IdentificationStatus::fitted, said(found));
        QVERIFY2(holds(found, FittedKind::beta, 8.5), said(found));
        QVERIFY2(holds(found, FittedKind::gauge_setting, 30), said(found));
        QVERIFY(found.residuals.front().rms < 0.5);
        QCOMPARE(found.count, std::size_t{150});
        QVERIFY2(seconds < 40, qPrintable(QString::number(seconds)));
        // Taken over, the cycle leaves these means.
        const Project made = withCalibration(project, found, "table 2", "2026-11-29");
        QCOMPARE(made.measured->calibrations.back().input, std::string("/part/target_diameter_mm"));
        const SizesOverPhases sizes = sizesOverPhases(made, factorsOf(made));
        for (std::size_t place = 0; place < 3; ++place) {
            const double mean_um = made.measured->summaries[place].mean_um;
            QVERIFY2(std::abs(sizes.means_um[place] - mean_um) < 0.6,
                     qPrintable(QString::number(sizes.means_um[place] - mean_um)));
        }
    }

    void whatSizesCannotTellIsNamedAsAProduct() {
        const Identification found = fit(
            tableTwo(), {FittedKind::dullness, FittedKind::compliance, FittedKind::gauge_setting});
        QVERIFY2(found.status == IdentificationStatus::cannotTell, said(found));
        QCOMPARE(found.unidentified.size(), std::size_t{1});
        QCOMPARE(found.unidentified.front().parameters, (std::vector<std::size_t>{0, 1}));
        QVERIFY(found.unidentified.front().isProduct);
        QVERIFY(found.unidentified.front().advice == Advice::power);
        // What no finished part shows is said by itself.
        const Identification power =
            fit(tableTwo(), {FittedKind::beta, FittedKind::chip_power, FittedKind::gauge_setting});
        QVERIFY(power.status == IdentificationStatus::cannotTell);
        // Four numbers are not in three means.
        QVERIFY(fit(tableTwo(), {FittedKind::alpha, FittedKind::beta, FittedKind::flow_stress,
                                 FittedKind::gauge_setting})
                    .status
                == IdentificationStatus::noData);
    }

    /// The known β comes back within its 95 % interval in 93…97 of 100 batches, as far as so many
    /// batches tell it; the others are hardly ever refused.
    void aKnownTruthIsHeld() {
        const int sets = samples::sized(3, 1, 50);
        int held = 0, settings = 0, answers = 0, refused = 0;
        for (int set = 0; set < sets; ++set) {
            const auto seed = static_cast<std::uint32_t>(set + 1);
            Project project = factory();
            CycleFactors truth = factorsOf(project);
            truth.beta =
                std::exp(openUnit(randomBits(seed, RandomStream::plain, 9, 9)) * 1.4 + 0.7);
            Project made = scaledProject(project, truth);
            made.part->target_diameter_mm = 29.995;
            project.measured.emplace().parts = ground(made, 50, seed);
            const Identification found =
                fit(project, {FittedKind::beta, FittedKind::gauge_setting});
            refused += found.status == IdentificationStatus::doesNotFit;
            if (found.status == IdentificationStatus::fitted) {
                ++answers;
                held += holds(found, FittedKind::beta, truth.beta);
                settings += holds(found, FittedKind::gauge_setting, 29.995);
            }
        }
        qInfo("%d batches of 50: %d answers, β held in %d, the setting in %d, %d do not fit", sets,
              answers, held, settings, refused);
        QVERIFY(clopperPearson(refused, sets, 0.95).low <= 0.05);
        QVERIFY(2 * answers > sets);
        QVERIFY(clopperPearson(held, answers, 0.95).high >= 0.93);
        QVERIFY(clopperPearson(settings, answers, 0.95).high >= 0.93);
    }

    /// One place tells the setting alone: it is off by what the mean is off.
    void aSettingAloneIsTheDifferenceOfTheMeans() {
        Project project = samples::projectIn("resources/examples/plunge-shaft-two-stage.sparkout");
        const SizesOverPhases sizes = sizesOverPhases(project, factorsOf(project));
        MeasuredSummary summary;
        summary.place = *project.gauge->section;
        summary.count = 30;
        summary.deviation_um = 1;
        summary.mean_um = sizes.means_um[static_cast<std::size_t>(summary.place)] + 2.5;
        project.measured.emplace().summaries = {summary};
        const Identification found = fit(project, {FittedKind::gauge_setting});
        QVERIFY2(found.status == IdentificationStatus::fitted, said(found));
        const double before = 2 * targetRadius(*project.part);
        QVERIFY(std::abs(found.values.front().value - before - 2.5e-3) < 1e-9);
        constexpr double ofPrediction_um = 0.03;
        const double half = studentQuantile(0.975, 29) * 1e-3
                            * std::sqrt(1 / 30.0 + ofPrediction_um * ofPrediction_um);
        QVERIFY(std::abs(found.values.front().interval95.high - found.values.front().value - half)
                < 1e-9);
    }

    /// No gauge is set off by more than every field of a ground part.
    void aSettingFarFromTheProjectsIsNotUsed() {
        Project project = samples::projectIn("resources/examples/plunge-shaft-two-stage.sparkout");
        const SizesOverPhases sizes = sizesOverPhases(project, factorsOf(project));
        MeasuredSummary summary;
        summary.place = *project.gauge->section;
        summary.count = 30;
        summary.deviation_um = 1;
        for (const double off_um : {90.0, 110.0}) {
            summary.mean_um = sizes.means_um[static_cast<std::size_t>(summary.place)] + off_um;
            project.measured.emplace().summaries = {summary};
            const Identification found = fit(project, {FittedKind::gauge_setting});
            QCOMPARE(found.values.size(), std::size_t{1});
            QCOMPARE(found.values.front().isUsual(), off_um < 100);
            QVERIFY2(off_um < 100 || found.status == IdentificationStatus::doesNotFit, said(found));
        }
    }

    void zonesThatContradictTheShaftDoNotFit() {
        Project project = tableTwo();
        project.measured->summaries[0].mean_um += 8; // RZ1 above NZ
        const Identification found = fit(project, {FittedKind::beta, FittedKind::gauge_setting});
        QVERIFY2(found.status == IdentificationStatus::doesNotFit, said(found));
        QVERIFY(withCalibration(project, found, "x", "y").measured.isSharedWith(project.measured));
    }

    void aSettingIsNotOfTraces() {
        Project project = samples::projectIn("resources/examples/plunge-shaft-two-stage.sparkout");
        MeasuredTrace& trace = project.measured.emplace().traces.emplace_back();
        trace.time_s = Samples({0, 1, 2, 3});
        trace.values = Samples({0.4, 0.3, 0.2, 0.1});
        QVERIFY(fit(project, {FittedKind::gauge_setting}).status
                == IdentificationStatus::notApplicable);
    }
};

} // namespace sparkout::test_batch_fit

SPARKOUT_TEST(test_batch_fit, TestBatchFit)
#include "test_batch_fit.moc"
