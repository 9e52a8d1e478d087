// SPDX-License-Identifier: GPL-3.0-or-later
// A calibration is held against a cycle with other feeds that it has not seen: the model that made
// both agrees, a machine that has changed since does not.
#include "core/measured/calibration.h"
#include "core/measured/cycle_response.h"
#include "core/measured/hold_out.h"
#include "core/measured/identification.h"
#include "core/project/number_input.h"
#include "tests/core/measured/measured_cycles.h"
#include "tests/registry.h"
#include "words/measured_words.h"

#include <cmath>

namespace sparkout::test_hold_out {

using namespace measured_cycles;

class TestHoldOut : public QObject {
    Q_OBJECT

    /// Another feed than the one that the calibration knows, and a spark-out of revolutions.
    static void feedOtherwise(Project& project) {
        project.cycle->stages[0].radial_feed_mm_min = 1.2;
        project.cycle->stages[1].radial_feed_mm_min = 0.25;
    }
    static Project withSparkOut(Project project) {
        Stage last = project.cycle->stages.back();
        last.sparkOutFor(12);
        last.radial_feed_mm_min.reset();
        last.stock_mm = 0.01;
        project.cycle->stages.back().stock_mm -= 0.01;
        project.cycle->stages.push_back(last);
        return project;
    }
    static MeasuredTrace traceOf(const Project& truth, TraceQuantity quantity, const char* source,
                                 std::uint32_t seed) {
        const bool isSize = quantity == TraceQuantity::gauge_size;
        MeasuredTrace made = trace(quantity, record(truth),
                                   {.hertz = 20,
                                    .noise = isSize ? 3e-4 : 0.02,
                                    .offset = isSize ? 0.02 : 0.4,
                                    .shift_s = 0.3,
                                    .seed = seed});
        made.source = source;
        made.idle = isSize ? std::nullopt : std::optional(0.4);
        return made;
    }
    /// Calibrated on a cycle of the machine, with a trace of another one with other feeds.
    static Project heldAgainst(double alpha, double beta, double laterBeta, std::uint32_t seed) {
        Project project = withSparkOut(yieldingPlunge());
        CycleFactors factors = factorsOf(project);
        factors.alpha = alpha;
        factors.beta = beta;
        const Project truth = scaledProject(project, factors);
        Measured& measured = project.measured.emplace();
        measured.traces.push_back(traceOf(truth, TraceQuantity::gauge_size, "first.csv", seed));
        const Identification found =
            identify(project, {.parameters = {{FittedKind::alpha, {}, {}},
                                              {FittedKind::beta, {}, {}},
                                              {FittedKind::size_offset, {}, {}},
                                              {FittedKind::time_shift, {}, {}}}});
        if (found.status != IdentificationStatus::fitted) {
            return project;
        }
        Project calibrated = withCalibration(project, found, "first.csv", "2026-11-30");
        feedOtherwise(calibrated);
        feedOtherwise(project);
        project.measured.reset();
        factors.beta = laterBeta;
        Project later = scaledProject(project, factors);
        calibrated.measured->traces.push_back(
            traceOf(later, TraceQuantity::gauge_size, "second.csv", seed + 1));
        return calibrated;
    }

private slots:
    void theSameMachineAgreesAtAnotherFeed() {
        const int sets = samples::sized(20, 2, 200);
        int rows = 0, agreeing = 0, uncalibrated = 0;
        for (int set = 0; set < sets; ++set) {
            const auto seed = static_cast<std::uint32_t>(2 * set + 1);
            const Project calibrated = heldAgainst(1.2, 1.5, 1.5, seed);
            if (!calibrated.measured || calibrated.measured->calibrations.empty()) {
                ++uncalibrated; // a time left out, by chance
                continue;
            }
            const std::vector<HoldOutRow> found = holdOut(calibrated);
            QCOMPARE(found.size(), std::size_t{2}); // of the second trace alone
            for (const HoldOutRow& row : found) {
                QCOMPARE(row.trace, 1);
                QVERIFY(row.predicted95.low < row.predicted
                        && row.predicted < row.predicted95.high);
                QVERIFY(row.difference95.low < row.difference95.high);
                QVERIFY(std::abs(row.measured / row.predicted - 1) < 0.2);
                ++rows;
                agreeing += row.agrees();
            }
        }
        qInfo("%d of %d rows of a machine that has not changed agree", agreeing, rows);
        QVERIFY(clopperPearson(agreeing, rows, 0.95).high >= 0.95);
        QVERIFY(clopperPearson(uncalibrated, sets, 0.95).low <= 0.05);
    }

    void aMachineThatHasChangedDoesNot() {
        const std::vector<HoldOutRow> found = holdOut(heldAgainst(1.2, 1.5, 6, 5));
        QVERIFY(!found.empty());
        for (const HoldOutRow& row : found) {
            qInfo("%s: measured %.3f, predicted %.3f (%.3f…%.3f)", wordsOf(row.quantity).key,
                  row.measured, row.predicted, row.predicted95.low, row.predicted95.high);
        }
        QVERIFY(!std::ranges::all_of(found, &HoldOutRow::agrees)); // a duller wheel lags more
    }

    void nothingIsHeldOutWithoutACalibrationOrAnotherTrace() {
        Project project = heldAgainst(1.2, 1.5, 1.5, 3);
        Project used = project;
        used.measured->traces.pop_back();
        QVERIFY(holdOut(used).empty());
        Project plain = project;
        plain.measured->calibrations.clear();
        QVERIFY(holdOut(plain).empty());
        // An input that was changed since rests on no calibration any more.
        for (const Calibration& record : project.measured->calibrations) {
            setNumberInput(project, record.input, record.value * 1.01);
        }
        QVERIFY(holdOut(project).empty());
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(holdOut(heldAgainst(1.2, 1.5, 1.5, 3), stop.get_token()).empty());
    }

    void powerIsHeldAgainstWhereTheIdlePowerIsStated() {
        Project project = heldAgainst(1.2, 1.5, 1.5, 9);
        Project later = project;
        later.measured.reset();
        MeasuredTrace power = traceOf(later, TraceQuantity::wheel_power, "second.csv", 4);
        project.measured->traces.push_back(power);
        const std::vector<HoldOutRow> found = holdOut(project);
        QCOMPARE(found.size(), std::size_t{3});
        const HoldOutRow& row = found.back();
        QVERIFY(row.quantity == HoldOutQuantity::power);
        // The mean over the revolutions that feed, another way.
        const Record cycle = record(later);
        const std::vector<int> counts = simulate(later).countsByStage;
        const auto fed = static_cast<std::size_t>(counts[0] + counts[1]);
        double energy = 0;
        for (std::size_t i = 0; i < fed; ++i) {
            energy += cycle.power_kw[i + 1] * (cycle.end_s[i + 1] - cycle.end_s[i]);
        }
        const double mean_kw = energy / cycle.end_s[fed];
        QVERIFY2(std::abs(row.predicted / mean_kw - 1) < 1e-9,
                 qPrintable(QString::number(row.predicted / mean_kw - 1)));
        QVERIFY2(row.agrees(), qPrintable(QString::number(row.measured - row.predicted)));
        project.measured->traces.back().idle.reset();
        QCOMPARE(holdOut(project).size(), std::size_t{2});
    }

    void theAnswerCarriesIt() {
        const Project project = heldAgainst(1.2, 1.5, 1.5, 7);
        MeasuredAnswer answer;
        answer.holdOut = holdOut(project);
        const auto json = nlohmann::json::parse(measuredJson(project, answer));
        const auto& row = json.at("hold_out").at(0);
        QCOMPARE(row.at("quantity").get<std::string>(), std::string("time"));
        QCOMPARE(row.at("unit").get<std::string>(), std::string("s"));
        QCOMPARE(row.at("measured").get<double>(), answer.holdOut.front().measured);
        QCOMPARE(row.at("agrees").get<bool>(), answer.holdOut.front().agrees());
    }
};

} // namespace sparkout::test_hold_out

SPARKOUT_TEST(test_hold_out, TestHoldOut)
#include "test_hold_out.moc"
