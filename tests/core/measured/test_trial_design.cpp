// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The choice of a short trial: what it expects is what fits of simulated trials scatter by, and it
// knows what each kind of record cannot tell.
#include "core/measured/trial_design.h"
#include "tests/ready_made.h"
#include "tests/whole_project.h"

#include "core/measured/fit_problem.h"
#include "core/measured/identifiability.h"
#include "core/project/validate.h"
#include "core/statistics/intervals.h"
#include "core/statistics/philox.h"
#include "tests/check_line.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <cmath>

namespace sparkout::test_trial_design {

/// A plunge that yields, with dull grains.
Project plunge() {
    Project project = samples::project("smallest-plunge");
    project.sections = 1;
    project.machine->compliance_mm_per_n = std::vector<double>{5e-4};
    project.part->stock_mm = 0.3;
    project.part->radii_per_section = 12;
    project.wheel->dullness = 0.01;
    return project;
}

FittedParameter of(FittedKind kind) {
    return {kind, {}, {}};
}

const Trial* find(const TrialDesign& design, double factor, TrialSparkOut sparkOut,
                  TrialRecord record) {
    const auto found = std::ranges::find_if(design.trials, [&](const Trial& trial) {
        return std::abs(trial.feedFactor - factor) < 1e-9 && trial.sparkOut == sparkOut
               && trial.record == record;
    });
    return found == design.trials.end() ? nullptr : &*found;
}

double errorOf(const Trial& trial, FittedKind kind) {
    for (const TrialExpectation& expected : trial.expected) {
        if (expected.parameter.kind == kind) {
            return expected.error;
        }
    }
    return INFINITY;
}

bool cannotTell(const Trial& trial, FittedKind kind) {
    return std::ranges::find(trial.cannotTell, kind, &FittedParameter::kind)
           != trial.cannotTell.end();
}

/// Of fits to a trial with random noise: sums of squares of α and β about the truth, and how many
/// values lay in the expected intervals.
struct Scatter {
    std::vector<double> squares = std::vector<double>(2, 0);
    std::vector<int> inside = std::vector<int>(2, 0);
};

Scatter scatterOf(const Trial& trial, const Project& ground, const TrialNoise& noise, int repeats) {
    FitData data;
    FitGroup& group = data.groups.emplace_back();
    for (std::size_t i = 0; i < trial.samples; ++i) {
        group.time_s.push_back(static_cast<double>(i) / noise.hertz);
    }
    group.values.assign(trial.samples, 0);
    group.noise = noise.size_mm;
    const std::vector<FittedParameter> all{of(FittedKind::alpha), of(FittedKind::beta),
                                           of(FittedKind::size_offset), of(FittedKind::time_shift)};
    FitProblem problem(ground, data, all);
    problem.setSteps(trial.stepsByStage);
    std::vector<double> differences;
    const std::vector<double> truth(all.size(), 0);
    Scatter scatter;
    if (!problem.differences(truth, differences)) {
        return scatter;
    }
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t i = 0; i < group.values.size(); ++i) {
            const double z = normalQuantile(openUnit(
                randomBits(static_cast<std::uint32_t>(repeat + 1), RandomStream::plain, i, 7)));
            group.values[i] = -differences[i] + noise.size_mm * z;
        }
        const LeastSquares found = minimise(problem, truth, std::vector<bool>(all.size(), false));
        for (std::size_t p = 0; found.converged && p < scatter.squares.size(); ++p) {
            const TrialExpectation& expected = trial.expected[p];
            scatter.squares[p] += found.q[p] * found.q[p];
            const double value = FitProblem::valueOf(all[p].kind, found.q[p]);
            scatter.inside[p] += value > expected.low && value < expected.high ? 1 : 0;
        }
    }
    return scatter;
}

class TestTrialDesign : public QObject {
    Q_OBJECT

private slots:
    void trialsAreProjectsThatPass() {
        for (const char* name : {"smallest-plunge", "smallest-traverse", "complete"}) {
            const Project project = samples::project(name);
            for (const double factor : {1.0 / 3, 1.0, 3.0}) {
                const Project trial = trialProject(project, factor, TrialSparkOut::untilSettled);
                QVERIFY2(!hasErrors(validate(trial)), samples::listed(validate(trial)).c_str());
            }
        }
    }

    void theBestComesFirst() {
        RunningTimer clock;
        const TrialDesign design =
            designTrial(plunge(), {{of(FittedKind::alpha), of(FittedKind::beta)}, {}});
        QVERIFY(design.status == TrialStatus::designed);
        QCOMPARE(design.trials.size(), std::size_t{24});
        QVERIFY(design.trials.front().logDeterminant.has_value());
        for (std::size_t i = 1; i < design.trials.size(); ++i) {
            const Trial &before = design.trials[i - 1], &after = design.trials[i];
            QVERIFY(before.cannotTell.size() <= after.cannotTell.size());
            QVERIFY(!before.logDeterminant || !after.logDeterminant
                    || *before.logDeterminant >= *after.logDeterminant);
        }
        QVERIFY2(clock.elapsed() < 5000, QByteArray::number(clock.elapsed()).constData());
    }

    void sparkOutTellsBetaBetter() {
        const TrialDesign design =
            designTrial(plunge(), {{of(FittedKind::alpha), of(FittedKind::beta)}, {}});
        for (const double factor : {1.0 / 3, 1.0, 3.0}) {
            const Trial* const without =
                find(design, factor, TrialSparkOut::none, TrialRecord::size);
            const Trial* const with =
                find(design, factor, TrialSparkOut::untilSettled, TrialRecord::size);
            QVERIFY(without && with);
            QVERIFY(errorOf(*with, FittedKind::beta) < 0.5 * errorOf(*without, FittedKind::beta));
        }
    }

    void aRecordKnowsWhatItCannotTell() {
        const TrialDesign design =
            designTrial(plunge(), {{of(FittedKind::compliance), of(FittedKind::flow_stress)}, {}});
        using enum TrialRecord;
        for (const Trial& trial : design.trials) {
            const bool sizeAlone = trial.record == size;
            QCOMPARE(cannotTell(trial, FittedKind::compliance), sizeAlone);
            QCOMPARE(cannotTell(trial, FittedKind::flow_stress), sizeAlone);
            QCOMPARE(trial.logDeterminant.has_value(), !sizeAlone);
        }
        const TrialDesign chips = designTrial(plunge(), {{of(FittedKind::chip_power)}, {}});
        for (const Trial& trial : chips.trials) {
            QCOMPARE(cannotTell(trial, FittedKind::chip_power),
                     trial.record == size || trial.record == force);
        }
    }

    void twiceTheNoiseIsTwiceTheError() {
        TrialRequest request{{of(FittedKind::alpha), of(FittedKind::beta)}, {}};
        const TrialDesign once = designTrial(plunge(), request);
        request.noise.size_mm *= 2;
        const TrialDesign twice = designTrial(plunge(), request);
        const auto* const a = find(once, 3, TrialSparkOut::untilSettled, TrialRecord::size);
        const auto* const b = find(twice, 3, TrialSparkOut::untilSettled, TrialRecord::size);
        QVERIFY(std::abs(errorOf(*b, FittedKind::alpha) / errorOf(*a, FittedKind::alpha) - 2)
                < 1e-9);
        // ln det of two parameters falls by 2·2·ln 2
        QVERIFY(std::abs(*a->logDeterminant - *b->logDeterminant - 4 * std::log(2)) < 1e-6);
    }

    /// A record without noise would promise an exact factor; no machine repeats feed and speed so.
    void noRecordPromisesMoreThanTheMachineRepeats() {
        TrialRequest request{{of(FittedKind::alpha), of(FittedKind::beta)}, {}};
        request.noise.size_mm = 1e-9;
        const TrialDesign design = designTrial(plunge(), request);
        const Trial* const trial = find(design, 1, TrialSparkOut::untilSettled, TrialRecord::size);
        QCOMPARE(trial->expected.size(), std::size_t{2});
        for (const TrialExpectation& expected : trial->expected) {
            QVERIFY(expected.error < 1e-4);
            const double half = std::log(expected.high / expected.low) / 2;
            QVERIFY2(std::abs(half / 0.0196 - 1) < 1e-2, QByteArray::number(half).constData());
        }
    }

    /// To first order in the noise fits of trials scatter by the expected error: with a twentieth
    /// of the usual noise within what the scatter of a standard deviation of so many allows (99.9
    /// %). With the usual one, of which α has an error of 0.23 and scatters by a fifth more, the
    /// values still lie in the expected interval as often as it says.
    void theExpectedErrorIsTheScatterOfFits() {
        const Project project = plunge();
        const int repeats = samples::sized(60, 20, 400);
        for (const double share : {1.0, 0.05}) {
            TrialRequest request{{of(FittedKind::alpha), of(FittedKind::beta)}, {}};
            request.noise.size_mm *= share;
            const TrialDesign design = designTrial(project, request);
            for (const TrialSparkOut sparkOut :
                 {TrialSparkOut::none, TrialSparkOut::untilSettled}) {
                const Trial& trial = *find(design, 1, sparkOut, TrialRecord::size);
                if (!trial.cannotTell.empty()) { // without a spark-out its time is α, too
                    QVERIFY(share == 1 && sparkOut == TrialSparkOut::none);
                    continue;
                }
                const Scatter found =
                    scatterOf(trial, trialProject(project, 1, sparkOut), request.noise, repeats);
                for (std::size_t p = 0; p < found.squares.size(); ++p) {
                    QVERIFY(found.inside[p]
                            >= 0.95 * repeats - 3.3 * std::sqrt(0.05 * 0.95 * repeats));
                    const double scatter = std::sqrt(found.squares[p] / repeats);
                    const double ratio = scatter / trial.expected[p].error;
                    QVERIFY2(share == 1 || std::abs(ratio - 1) < 3.3 / std::sqrt(2.0 * repeats),
                             QByteArray::number(ratio).constData());
                }
            }
        }
    }

    void refusals() {
        QVERIFY(designTrial(plunge(), {}).status == TrialStatus::notApplicable);
        QVERIFY(designTrial(plunge(), {{{FittedKind::compliance, 5, {}}}, {}}).status
                == TrialStatus::notApplicable);
        Project broken = plunge();
        broken.part->stock_mm = -1;
        QVERIFY(designTrial(broken, {{of(FittedKind::alpha)}, {}}).status == TrialStatus::notRun);
        const StoppedSource stop;
        QVERIFY(designTrial(plunge(), {{of(FittedKind::alpha)}, {}}, stop.get_token()).status
                == TrialStatus::stopped);
    }
};

} // namespace sparkout::test_trial_design

SPARKOUT_TEST(test_trial_design, TestTrialDesign)
#include "test_trial_design.moc"
