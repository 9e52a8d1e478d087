// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Power recorded late against the size: with its delay fitted the intervals cover the truth,
// without it a warning says so; none where the clocks agree.
#include "core/measured/calibration.h"
#include "core/measured/identification.h"
#include "tests/core/measured/measured_cycles.h"
#include "tests/registry.h"

namespace sparkout::test_out_of_step {

using namespace measured_cycles;

constexpr double alpha = 1.25, beta = 0.875;

/// As it is: α and β by these factors.
const Record& cycleAsItIs() {
    static const Record cycle = [] {
        Project truth = yieldingPlunge();
        truth.machine->compliance_mm_per_n = std::vector<double>{5e-4 * alpha};
        truth.wheel->dullness *= beta / alpha;
        return record(truth);
    }();
    return cycle;
}

/// Size and power of it, the power late by so much.
Project recorded(double amount, std::uint32_t seed, double begin_s = 0.4) {
    const Record& cycle = cycleAsItIs();
    Project project = yieldingPlunge();
    const double end_s = cycle.end_s.back() + 2;
    project.measured.emplace().traces = {trace(TraceQuantity::gauge_size, cycle,
                                               {.hertz = 20,
                                                .from_s = -1,
                                                .to_s = end_s,
                                                .noise = 1e-3,
                                                .offset = 0.02,
                                                .shift_s = begin_s,
                                                .seed = seed}),
                                         trace(TraceQuantity::wheel_power, cycle,
                                               {.hertz = 20,
                                                .from_s = -1,
                                                .to_s = end_s,
                                                .noise = 0.02,
                                                .offset = 0.6,
                                                .shift_s = begin_s + amount,
                                                .seed = seed})};
    return project;
}

Identification fit(const Project& project, bool withDelay) {
    IdentificationRequest request;
    for (const FittedKind kind :
         {FittedKind::alpha, FittedKind::beta, FittedKind::chip_power, FittedKind::friction_power,
          FittedKind::idle_power, FittedKind::size_offset, FittedKind::time_shift}) {
        request.parameters.push_back({kind, {}, {}});
    }
    if (withDelay) {
        request.parameters.push_back({FittedKind::power_delay, {}, {}});
    }
    return identify(project, request);
}

/// Of the size alone, without the beginning of the cycle.
Identification fitOfSize(Project& project) {
    project.measured->traces.pop_back();
    return identify(project, {.parameters = {{FittedKind::alpha, {}, {}},
                                             {FittedKind::beta, {}, {}},
                                             {FittedKind::size_offset, {}, {}}}});
}

bool holds(const FittedValue& value, double truth) {
    return value.interval95.low <= truth && truth <= value.interval95.high;
}

class TestOutOfStep : public QObject {
    Q_OBJECT

private slots:
    void theDelayIsFittedOrWarnedOf_data() {
        QTest::addColumn<double>("amount");
        for (const double amount : {0.1, 0.2, 0.5, -0.2}) {
            QTest::newRow(qPrintable(QString::number(amount))) << amount;
        }
    }

    void theDelayIsFittedOrWarnedOf() {
        QFETCH(double, amount);
        const int seeds = samples::sized(2, 1, 8);
        int covered = 0, delayCovered = 0, noticed = 0, wrong = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            const Project project = recorded(amount, static_cast<std::uint32_t>(seed));
            const Identification with = fit(project, true);
            QVERIFY(with.status == IdentificationStatus::fitted);
            QVERIFY(with.outOfStep.empty());
            covered += holds(with.values.front(), alpha);
            delayCovered += holds(with.values.back(), amount);
            const Identification without = fit(project, false);
            if (without.status != IdentificationStatus::fitted || !without.outOfStep.empty()) {
                ++noticed;
            } else {
                wrong += !holds(without.values.front(), alpha);
            }
            QVERIFY(without.outOfStep.empty()
                    || without.status == IdentificationStatus::doesNotFit);
            for (const OutOfStep& found : without.outOfStep) {
                QVERIFY(!isLag(found.kind) || found.amount > 0); // that would be a delay
                if (found.kind == FittedKind::power_delay) {
                    // With the steps of the stages held a long one is said roughly.
                    const double room = std::abs(amount) > 0.3 ? 0.5 : 0.2;
                    QVERIFY2(std::abs(found.amount - amount) < room * std::abs(amount),
                             qPrintable(QString::number(found.amount)));
                }
            }
        }
        const Interval share = clopperPearson(covered, seeds, 0.95),
                       ofDelay = clopperPearson(delayCovered, seeds, 0.95);
        qInfo("delay %g s: α covered %d, delay covered %d; without it noticed %d, α wrong and not "
              "noticed %d, of %d",
              amount, covered, delayCovered, noticed, wrong, seeds);
        QVERIFY(share.high >= 0.93);
        QVERIFY(ofDelay.high >= 0.93);
        // What is not noticed does not matter.
        QVERIFY(noticed > seeds / 2);
        QVERIFY(clopperPearson(wrong, seeds, 0.95).low <= 0.05);
    }

    /// The threshold is that of one fit in 2,000.
    void clocksThatAgreeAreHardlyEverDoubted() {
        const int seeds = samples::sized(6, 2, 40);
        int warned = 0, covered = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            const Identification found = fit(recorded(0, static_cast<std::uint32_t>(seed)), false);
            const bool isWarned = !found.outOfStep.empty();
            QVERIFY(
                found.status
                == (isWarned ? IdentificationStatus::doesNotFit : IdentificationStatus::fitted));
            warned += isWarned;
            covered += holds(found.values.front(), alpha);
        }
        qInfo("clocks that agree: %d of %d warned, α covered %d", warned, seeds, covered);
        QVERIFY(clopperPearson(warned, seeds, 0.99).low <= 0.0005);
    }

    /// The beginning of the cycle in the traces is a time like the others.
    void tracesThatBeginLateAreWarnedOf() {
        Project project = recorded(0, 1, 0.1);
        const Identification found = fitOfSize(project);
        QVERIFY(found.status == IdentificationStatus::doesNotFit);
        QVERIFY(!found.outOfStep.empty());
        QVERIFY(found.outOfStep.front().kind == FittedKind::time_shift);
        QVERIFY(std::abs(found.outOfStep.front().amount - 0.1) < 0.02);
    }

    /// A time so short that the residuals are hardly more than noise moves the values all the same:
    /// they are shown and not taken.
    void whatIsLeftOutIsRefusedWhereTheResidualsAreNoise() {
        constexpr std::uint32_t seeds = 12;
        bool isSeen = false;
        for (std::uint32_t seed = 1; seed <= seeds && !isSeen; ++seed) {
            Project project = recorded(0, seed, 0.02);
            const Identification found = fitOfSize(project);
            isSeen = !found.outOfStep.empty() && !found.residuals.front().lack.isLacking();
            if (isSeen) {
                QVERIFY(found.status == IdentificationStatus::doesNotFit);
                QCOMPARE(found.values.size(), std::size_t{3});
                QVERIFY(withCalibration(project, found, "test.csv", "2026-11-30")
                            .measured.isSharedWith(project.measured));
            }
        }
        QVERIFY(isSeen);
    }

    /// Of the power alone its delay and the beginning of the cycle are one.
    void aDelayWithNothingToCompareIsRefused() {
        Project project = recorded(0.2, 1);
        project.measured->traces.erase(project.measured->traces.begin());
        const auto ask = [&](bool withDelay) { return fit(project, withDelay); };
        const Identification found =
            identify(project, {.parameters = {{FittedKind::chip_power, {}, {}},
                                              {FittedKind::idle_power, {}, {}},
                                              {FittedKind::time_shift, {}, {}},
                                              {FittedKind::power_delay, {}, {}}}});
        QVERIFY(found.status == IdentificationStatus::cannotTell);
        QCOMPARE(found.unidentified.front().parameters, (std::vector<std::size_t>{2, 3}));
        QVERIFY(found.unidentified.front().advice == Advice::size);
        QVERIFY(ask(false).outOfStep.empty());
    }

    void exactDataAreInStep() {
        Project project = yieldingPlunge();
        project.measured.emplace().traces = {
            trace(TraceQuantity::gauge_size, cycleAsItIs(), {.shift_s = 0.3}),
            trace(TraceQuantity::wheel_power, cycleAsItIs(), {.offset = 0.6, .shift_s = 0.3})};
        const Identification found = fit(project, false);
        QVERIFY(found.status == IdentificationStatus::fitted);
        QVERIFY(found.outOfStep.empty());
        QVERIFY(std::abs(found.values.front().value - alpha) < 1e-6);
    }
};

} // namespace sparkout::test_out_of_step

SPARKOUT_TEST(test_out_of_step, TestOutOfStep)
#include "test_out_of_step.moc"
