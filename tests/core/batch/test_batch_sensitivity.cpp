// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/sensitivity.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_batch_sensitivity {

using fixtures::uniform;
using fixtures::within;

/// A system that does not yield: the power follows the flow stress alone, the time the stock alone.
Project stiffBatch() {
    Project project = fixtures::stiffBatch(60);
    project.batch->factors.stock_mm = uniform(0.1, 0.3);
    project.batch->factors.flow_stress_mpa = uniform(1800, 2200);
    return project;
}

/// Eight parts, half of them with the one stock and half with the other.
BatchResult twoValuedBatch() {
    Project project = fixtures::stiffBatch(8);
    project.batch->factors.stock_mm = fixtures::measured({0.1, 0.2});
    return runBatchUnchecked(project);
}

double stockOf(const BatchResult& result, std::int64_t part) {
    return ScenarioSource(result.project).values(part)[0];
}

std::size_t indexOf(const Project& project, const std::string& name) {
    const auto characteristics = characteristicsOf(project);
    std::size_t i = 0;
    while (name != characteristics.at(i).name) {
        ++i;
    }
    return i;
}

class TestBatchSensitivity : public QObject {
    Q_OBJECT

private slots:
    void ranksFollowTheOneFactorThatActs() {
        const Project project = stiffBatch();
        const auto found = rankRegressions(runBatchUnchecked(project));
        const auto& power = found.at(indexOf(project, "wheel_power"));
        QVERIFY(power.has_value());
        QVERIFY(within(power->coefficients[0], 0, 1e-9)); // stock
        QVERIFY(within(power->coefficients[1], 1, 1e-9)); // flow stress
        QVERIFY(within(power->determination, 1, 1e-9));
        const auto& time = found.at(indexOf(project, "time"));
        QVERIFY(time.has_value() && time->coefficients[0] > 0.99);
    }

    // A factor of two values and a characteristic that falls as it rises: shared ranks lie on one
    // line, ranks in the order of the parts would not.
    void equalValuesShareTheirRank() {
        BatchResult result = twoValuedBatch();
        for (PartRow& row : result.statistics.rows) {
            row.values.assign(row.values.size(), -stockOf(result, row.part));
        }
        const auto found = rankRegressions(result);
        QVERIFY(found.front().has_value());
        QVERIFY(within(found.front()->coefficients[0], -1, 1e-12));
        QVERIFY(within(found.front()->determination, 1, 1e-12));
        std::size_t low = 0; // half of the parts; of these the ranks' mean is (n/2 − 1)/2
        for (PartRow& row : result.statistics.rows) {
            const bool isLow = stockOf(result, row.part) < 0.15;
            row.values.assign(row.values.size(), isLow && low++ < 2 ? 2.0 : isLow ? 1.0 : 3.0);
        }
        // y of 8 parts: 1, 1, 2, 2, 3 ×4 with the ranks −3, −3, −1, −1, 2 ×4; x: −2 ×4, 2 ×4.
        const auto uneven = rankRegressions(result);
        QVERIFY(within(uneven.front()->coefficients[0], 32 / std::sqrt(32.0 * 36.0), 1e-12));
    }

    void fewerPartsThanTwiceTheFactorsAndTwoAreTooFew() {
        for (const int parts : {5, 6}) {
            Project project = stiffBatch(); // of two factors
            project.batch->parts = parts;
            BatchResult result = runBatchUnchecked(project);
            const std::size_t power = indexOf(project, "wheel_power");
            QCOMPARE(rankRegressions(result).at(power).has_value(), parts == 6);
            result.statistics.rows.clear(); // by bins
            QCOMPARE(rankRegressions(result).at(power).has_value(), parts == 6);
        }
    }

    /// What is summed up in bins says what the parts themselves say.
    void withoutItsRowsABatchHasTheSameRegression() {
        Project project = fixtures::shaftBatch(600);
        BatchResult result = runBatchUnchecked(project);
        const auto exact = rankRegressions(result);
        result.statistics.rows.clear();
        const auto binned = rankRegressions(result);
        QCOMPARE(binned.size(), exact.size());
        int compared = 0;
        for (std::size_t c = 0; c < exact.size(); ++c) {
            QCOMPARE(binned[c].has_value(), exact[c].has_value());
            for (std::size_t f = 0; exact[c] && f < 3; ++f, ++compared) {
                QVERIFY(within(binned[c]->coefficients[f], exact[c]->coefficients[f], 2e-3));
            }
        }
        QVERIFY(compared > 30);
    }

    /// A drift over the batch weighs with all of it, not with the parts that are kept one by one.
    void aDriftWeighsWithTheWholeBatch() {
        Project project = fixtures::stiffBatch(12'000);
        Factor drift;
        drift.grows = {0.015, 0.03};
        project.batch->factors.dullness = drift;
        project.batch->factors.flow_stress_mpa = uniform(1700, 2300);
        const std::size_t power = indexOf(project, "wheel_power");
        const BatchResult result = runBatchUnchecked(project);
        const auto whole = rankRegressions(result).at(power);
        const auto indices = sobolIndices(project, 256);
        QVERIFY(whole && indices);
        const double dullness = whole->coefficients[0], stress = whole->coefficients[1];
        const auto& of = indices->byCharacteristic.at(power);
        qInfo("ranks: dullness %.3f, σ_i %.3f; Sobol: %.3f, %.3f", dullness, stress, of[0].total,
              of[1].total);
        QVERIFY(of[0].total > of[1].total && dullness > stress);
        // Independent factors: the squares of the coefficients are shares of the variance.
        QVERIFY(within(dullness * dullness, of[0].total, 0.05));
        QVERIFY(within(stress * stress, of[1].total, 0.05));
        BatchStatistics kept = result.statistics;
        kept.parts = BatchStatistics::keptRows;
        const auto first = rankRegressions({project, {}, {}, {}, 0, {}, {}, kept}).at(power);
        QVERIFY(first->coefficients[0] < first->coefficients[1]); // what the first parts would say
    }

    void theVarianceBelongsToTheOneFactorThatActs() {
        const Project project = stiffBatch();
        const auto indices = sobolIndices(project, 512);
        QVERIFY(indices.has_value());
        QCOMPARE(indices->simulations, std::int64_t{512 * 4});
        const auto& power = indices->byCharacteristic.at(indexOf(project, "wheel_power"));
        QVERIFY(within(power.at(1).first, 1, 0.02) && within(power.at(1).total, 1, 0.02));
        QVERIFY(within(power.at(0).first, 0, 1e-6) && within(power.at(0).total, 0, 1e-6));
        const auto& time = indices->byCharacteristic.at(indexOf(project, "time"));
        QVERIFY(within(time.at(0).first, 1, 0.02) && within(time.at(1).total, 0, 1e-6));
    }

    void indicesAreTheSameForAnyThreads() {
        BatchOptions one, three;
        one.threads = 1;
        three.threads = 3;
        const auto a = sobolIndices(stiffBatch(), 32, one);
        const auto b = sobolIndices(stiffBatch(), 32, three);
        QVERIFY(a && b);
        for (std::size_t c = 0; c < a->byCharacteristic.size(); ++c) {
            QCOMPARE(a->byCharacteristic[c].size(), b->byCharacteristic[c].size());
            for (std::size_t f = 0; f < a->byCharacteristic[c].size(); ++f) {
                QVERIFY(a->byCharacteristic[c][f].first == b->byCharacteristic[c][f].first);
                QVERIFY(a->byCharacteristic[c][f].total == b->byCharacteristic[c][f].total);
            }
        }
    }

    void correlatedFactorsHaveNoIndices() {
        Project project = stiffBatch();
        project.batch->correlation = {{1, 0.5}, {0.5, 1}};
        QVERIFY(!sobolIndices(project, 8));
    }
};

} // namespace sparkout::test_batch_sensitivity

SPARKOUT_TEST(test_batch_sensitivity, TestBatchSensitivity)
#include "test_batch_sensitivity.moc"
