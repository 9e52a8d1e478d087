// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_summary.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_batch_verdict {

/// Fifty good parts of three characteristics: of the P_pk's bounds 1.3 and 1.1, and without one.
BatchSummary goodSummary() {
    BatchSummary summary;
    summary.parts = 50;
    for (const double low : {1.3, 1.1}) {
        CharacteristicSummary of;
        of.count = 50;
        of.ppk = Estimate{low + 0.2, {low, low + 0.4}};
        of.expectedOutside = 1e-3 * (2 - low);
        summary.characteristics.push_back(of);
    }
    summary.characteristics.emplace_back();
    return summary;
}

BatchResult resultOf() {
    BatchResult result;
    result.project = fixtures::shaftBatch(50);
    return result;
}

void fail(BatchSummary& summary, std::int64_t parts) {
    summary.bad.count = parts;
    summary.bad.value = static_cast<double>(parts) / static_cast<double>(summary.parts);
}

class TestBatchVerdict : public QObject {
    Q_OBJECT

private slots:
    void itIsFitWhenTheLowestBoundReachesTheLimit() {
        const BatchVerdict verdict = weigh(goodSummary(), resultOf());
        QVERIFY(verdict.fitness == Fitness::fit && verdict.reason == BatchReason::allHold);
        QVERIFY(verdict.characteristic == std::optional<std::size_t>(1));
        QVERIFY(verdict.value == 1.1 && verdict.limit == 1);
    }

    /// A P_pk of 0.94 with the bounds 0.73…1.14: nothing failed of 50, but more of them would.
    void aLowBoundMakesItConditional() {
        BatchSummary summary = goodSummary();
        summary.characteristics[0].ppk = Estimate{0.94, {0.73, 1.14}};
        BatchResult result = resultOf();
        const BatchVerdict verdict = weigh(summary, result);
        QVERIFY(verdict.fitness == Fitness::conditional && verdict.reason == BatchReason::ppk);
        QVERIFY(verdict.characteristic == std::optional<std::size_t>(0));
        QCOMPARE(verdict.value, 0.73);
        result.project.batch->least_ppk = 0.73;
        QVERIFY(weigh(summary, result).fitness == Fitness::fit);
        result.project.batch->least_ppk = 1.2;
        QVERIFY(weigh(goodSummary(), result).fitness == Fitness::conditional);
    }

    void aFailedPartDecidesBeforeAllElse() {
        BatchSummary summary = goodSummary();
        fail(summary, 2);
        BatchResult result = resultOf();
        result.project.batch->least_ppk = 5;
        BatchVerdict verdict = weigh(summary, result);
        QVERIFY(verdict.fitness == Fitness::unfit && verdict.reason == BatchReason::partsFail);
        QCOMPARE(verdict.value, 0.04);
        result.project.batch->most_outside_share = 0.04; // as many may
        verdict = weigh(summary, result);
        QVERIFY(verdict.fitness == Fitness::conditional && verdict.reason == BatchReason::someFail);
        result.project.batch->most_outside_share = 0.039;
        QVERIFY(weigh(summary, result).fitness == Fitness::unfit);
    }

    void anExpectedShareBeyondTheLimitMakesItConditional() {
        BatchResult result = resultOf();
        result.project.batch->most_outside_share = 8e-4;
        const BatchVerdict verdict = weigh(goodSummary(), result);
        QVERIFY(verdict.fitness == Fitness::conditional && verdict.reason == BatchReason::outside);
        QVERIFY(verdict.characteristic == std::optional<std::size_t>(1));
        QVERIFY(fixtures::close(verdict.value, 9e-4, 1e-12) && verdict.limit == 8e-4);
        result.project.batch->most_outside_share = 9.1e-4;
        QVERIFY(weigh(goodSummary(), result).fitness == Fitness::fit);
    }

    void whatTellsNoCapabilityIsConditional() {
        BatchResult result = resultOf();
        BatchSummary corners = goodSummary();
        corners.isSample = false;
        QVERIFY(weigh(corners, result).reason == BatchReason::noSample);
        QVERIFY(weigh(corners, result).fitness == Fitness::conditional);
        BatchSummary one = goodSummary();
        one.parts = 1;
        QVERIFY(weigh(one, result).reason == BatchReason::fewParts);
        result.status = BatchStatus::stopped;
        QVERIFY(weigh(goodSummary(), result).reason == BatchReason::stopped);
        QVERIFY(weigh({}, result).fitness == Fitness::unfit);
    }

    /// Parts that do not scatter need no P_pk.
    void aBatchWithoutScatterIsFit() {
        BatchSummary summary = goodSummary();
        for (CharacteristicSummary& of : summary.characteristics) {
            of.ppk.reset();
            of.expectedOutside.reset();
        }
        const BatchVerdict verdict = weigh(summary, resultOf());
        QVERIFY(verdict.fitness == Fitness::fit && !verdict.characteristic);
    }
};

} // namespace sparkout::test_batch_verdict

SPARKOUT_TEST(test_batch_verdict, TestBatchVerdict)
#include "test_batch_verdict.moc"
