// SPDX-License-Identifier: GPL-3.0-or-later
// What is stated of a batch's characteristics, as JSON and CSV have it.
#include "core/batch/batch_outputs.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

#include <sstream>

namespace sparkout::test_batch_outputs {

class TestBatchOutputs : public QObject {
    Q_OBJECT

private slots:
    void theColumnsKeepTheirNames() {
        std::istringstream csv(batchCsv(runBatch(fixtures::shaftBatch(20))));
        std::string heads;
        QVERIFY(std::getline(csv, heads));
        QCOMPARE(heads,
                 std::string("where,characteristic,unit,low,high,count,min,max,mean,mean_low,"
                             "mean_high,s,cp,cp_low,cp_high,cpk,cpk_low,cpk_high,pp,pp_low,pp_high,"
                             "ppk,ppk_low,ppk_high,outside,outside_low,outside_high,"
                             "expected_outside,normality,normality_test,strips_uncut"));
        const auto columns = std::count(heads.begin(), heads.end(), ',');
        for (std::string line; std::getline(csv, line);) {
            QCOMPARE(std::count(line.begin(), line.end(), ','), columns);
        }
    }

    void nothingIsOutOfNoTolerance() {
        const auto json = nlohmann::json::parse(batchJson(runBatch(fixtures::shaftBatch(20))));
        int limited = 0, free = 0;
        for (const auto& each : json.at("characteristics")) {
            const bool isLimited = !each.at("low").is_null() || !each.at("high").is_null();
            QCOMPARE(each.at("outside").is_null(), !isLimited);
            ++(isLimited ? limited : free);
        }
        QVERIFY(limited > 0 && free > 0);
    }

    /// One part has no mean to speak of, and corners are no sample.
    void whatIsNoSampleHasNoScatter() {
        const auto one = nlohmann::json::parse(batchJson(runBatch(fixtures::shaftBatch(1))));
        Project corners = fixtures::shaftBatch(1);
        corners.batch->scenarios = Scenarios::corners;
        const auto all = nlohmann::json::parse(batchJson(runBatch(corners)));
        for (const auto& each : one.at("characteristics")) {
            QVERIFY(each.at("mean").is_null() && each.at("standard_deviation").is_null());
            QVERIFY(each.at("min") == each.at("max"));
        }
        for (const auto& each : all.at("characteristics")) {
            QVERIFY(!each.contains("mean") && !each.contains("ppk") && each.contains("max"));
        }
    }
};

} // namespace sparkout::test_batch_outputs

SPARKOUT_TEST(test_batch_outputs, TestBatchOutputs)
#include "test_batch_outputs.moc"
