// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/sensitivity.h"

#include "tests/core/batch_fixtures.h"
#include "tests/registry.h"

#include <QTest>

#include <string>

namespace test_batch_sensitivity {

using namespace sparkout;
using fixtures::uniform;
using fixtures::within;

namespace {

/// A system that does not yield: the power follows the flow stress alone, the time the stock alone.
Project stiffBatch() {
    Project project = fixtures::stiffBatch(60);
    project.batch->factors.stock_mm = uniform(0.1, 0.3);
    project.batch->factors.flow_stress_mpa = uniform(1800, 2200);
    return project;
}

std::size_t indexOf(const Project& project, const std::string& name) {
    const auto characteristics = characteristicsOf(project);
    std::size_t i = 0;
    while (name != characteristics.at(i).name) {
        ++i;
    }
    return i;
}

} // namespace

class TestBatchSensitivity : public QObject {
    Q_OBJECT

private slots:
    void ranksFollowTheOneFactorThatActs() {
        const Project project = stiffBatch();
        const auto found = rankRegressions(runBatch(project));
        const auto& power = found.at(indexOf(project, "wheel_power"));
        QVERIFY(power.has_value());
        QVERIFY(within(power->coefficients[0], 0, 1e-9)); // stock
        QVERIFY(within(power->coefficients[1], 1, 1e-9)); // flow stress
        QVERIFY(within(power->determination, 1, 1e-9));
        const auto& time = found.at(indexOf(project, "time"));
        QVERIFY(time.has_value() && time->coefficients[0] > 0.99);
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

} // namespace test_batch_sensitivity

SPARKOUT_TEST(test_batch_sensitivity, TestBatchSensitivity)
#include "test_batch_sensitivity.moc"
