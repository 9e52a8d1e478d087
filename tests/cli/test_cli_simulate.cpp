// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// What simulate prints, as text and as JSON, is what the engine computes.
#include "core/batch/batch_run.h"
#include "core/batch/judgement.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/quality/constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"
#include "core/study/whole_batch.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"
#include "words/judgement_words.h"

#include <cmath>

namespace test_cli_simulate {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

const char* zoneName(Zone zone) {
    return zone == Zone::rz1 ? "rz1" : zone == Zone::nz ? "nz" : "rz2";
}

class TestCliSimulate : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void jsonSaysWhatSimulateComputes_data() { runnableRows(); }
    void jsonSaysWhatSimulateComputes() {
        QFETCH(QString, file);
        const json answer = answerTo({"simulate", file, "--json"});
        const SimulationResult result = simulate(projectOf(file));
        const bool traverse = result.project.operation == Operation::traverse;
        QVERIFY(answer.at("status") == "completed");
        QVERIFY(answer.at("operation") == (traverse ? "traverse" : "plunge"));
        QCOMPARE(answer.at("cycle_time_min").get<double>(), result.time_s / 60);
        QVERIFY(answer.at(traverse ? "double_strokes" : "revolutions") == result.cycleCount);
        QVERIFY(answer.at(traverse ? "double_strokes_by_stage" : "revolutions_by_stage")
                == json(result.countsByStage));
        QVERIFY(!answer.contains(traverse ? "revolutions" : "double_strokes"));
        QVERIFY(!answer.contains(traverse ? "sections" : "zones"));
        QCOMPARE(answer.at("peak").at("normal_force_n").get<double>(), result.peakNormalForce_n);
        QCOMPARE(answer.at("peak").at("power_w").get<double>(), result.peakPower_w);
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            checkSection(traverse ? answer.at("zones").at(zoneName(result.sections[i].zone))
                                  : answer.at("sections").at(i),
                         result.sections[i], result.project.part->diameter_mm);
        }
        QCOMPARE(answer.at(traverse ? "zones" : "sections").size(), result.sections.size());
        checkForm(answer, result);
        checkConstraints(answer.at("constraints"), worstByKind(evaluateConstraints(result)));
        checkShop(answer.at("shop"), shopNumbers(result));
    }

    /// Beside what is stated of the part that was run: how the cycle stands for every stock.
    void jsonJudgesEveryStock_data() { runnableRows(); }
    void jsonJudgesEveryStock() {
        QFETCH(QString, file);
        const SimulationResult result = simulate(projectOf(file));
        const auto constraints = evaluateConstraints(result);
        const Judgement judgement = judge(result, constraints, judgeStocks(result));
        const ProcessOutcome outcome = run({"simulate", file, "--json"});
        const json stated = json::parse(judgedResultJson(result, constraints, judgement));
        QVERIFY(json::parse(outcome.out).at("judged") == stated.at("judged"));
        const std::string headline = JudgementWording().headline(judgement);
        QVERIFY(has(run({"simulate", file}).out, "\njudged               " + headline + '\n'));
    }

    void batchIsJudgedWhereItIsAskedFor() {
        const QString file = examplePath("shaft-30h6-factory");
        const Project project = projectOf(file);
        const BatchStatistics statistics = runBatch(project).statistics;
        const json alone = json::parse(run({"simulate", file, "--json"}).out).at("judged");
        QVERIFY(alone.at("batch").is_null());
        const ProcessOutcome outcome = run({"simulate", file, "--batch", "--json"});
        QCOMPARE(outcome.status, 0);
        const json batch = json::parse(outcome.out).at("judged").at("batch");
        QCOMPARE(batch.at("parts").get<std::int64_t>(), statistics.parts);
        QCOMPARE(batch.at("bad").get<std::int64_t>(), statistics.bad);
        QCOMPARE(batch.at("seed").get<int>(), project.batch->seed);
        QCOMPARE(batch.at("interval_95").size(), std::size_t{2});
        QVERIFY(json::parse(outcome.out).at("judged").at("measured").is_null());
    }

    void measuredPartsAreJudgedWithTheBatch() {
        json moved =
            json::parse(samples::readText(examplePath("shaft-30h6-calibrated").toStdString()));
        moved.erase("runs");
        json& mean = moved["measured"]["summaries"][0]["mean_um"];
        mean = mean.get<double>() + 20;
        const QString file = save(QStringLiteral("moved.sparkout"), moved.dump());
        const ProcessOutcome outcome = run({"simulate", file, "--batch", "--json"});
        const json judged = json::parse(outcome.out).at("judged");
        const BatchJudgement by = judgeBatchOf(projectOf(file));
        QVERIFY(by.batch && by.measured);
        QCOMPARE(judged.at("batch").at("bad").get<std::int64_t>(), by.batch->bad);
        const json& measured = judged.at("measured");
        QCOMPARE(measured.at("name").get<std::string>(), std::string("diameter_min"));
        QCOMPARE(measured.at("where").get<std::string>(), std::string("rz1"));
        QCOMPARE(measured.at("bias_um").get<double>(), by.measured->bias_um);
    }

    void checkJudgesThePartThatWasRun() {
        const QString file = examplePath("plunge-shaft-two-stage");
        const Project project = projectOf(file);
        json narrow = json::parse(samples::readText(file.toStdString()));
        narrow.erase("runs");
        bool isFound = false;
        for (double field_um = 8; field_um > 0.1 && !isFound; field_um *= 0.97) {
            Project tried = project;
            const double middle_um =
                (project.part->upper_deviation_um + project.part->lower_deviation_um) / 2;
            tried.part->upper_deviation_um = middle_um + field_um / 2;
            tried.part->lower_deviation_um = middle_um - field_um / 2;
            const SimulationResult result = simulate(tried);
            const Judgement judgement =
                judge(result, evaluateConstraints(result), judgeStocks(result));
            isFound = judgement.state == JudgedState::stocksFail;
            narrow["part"]["upper_deviation_um"] = tried.part->upper_deviation_um;
            narrow["part"]["lower_deviation_um"] = tried.part->lower_deviation_um;
        }
        QVERIFY(isFound);
        const ProcessOutcome outcome =
            run({"simulate", save(QStringLiteral("narrow.sparkout"), narrow.dump()), "--check",
                 "--json"});
        QCOMPARE(outcome.status, 0);
        const json judged = json::parse(outcome.out).at("judged");
        QVERIFY(judged.at("nominal").get<bool>());
        QVERIFY(!judged.at("stocks").at("holds").get<bool>());
        QVERIFY(judged.at("stocks").at("failing_share").get<double>() > 0);
    }

    void textNamesTheRequirements() {
        json file = samples::sample("complete");
        file["title"] = "a\x1b[2Jb";
        const ProcessOutcome outcome = run({"simulate", save("title.sparkout", file.dump())});
        QCOMPARE(outcome.status, 0);
        QVERIFY(outcome.out.starts_with("a\\u001B[2Jb\n"));
        for (const std::string& word : samples::listOf(
                 "status|machining time|double strokes|diameter_min|diameter_max|radial_runout|"
                 "rz1|nz|rz2|cylindricity, µm|total runout, µm|taper|roundness|roughness|burn|"
                 "nearest to burning|the finished surface is |wheel_power|kW  met in "
                 "|gauge_commands|overlap")) {
            QVERIFY2(has(outcome.out, word), word.c_str());
        }
    }

    void sectionsAreCountedFrom1InTextsAndFrom0InFiles() {
        const std::string out = run({"simulate", samplePath("smallest-plunge")}).out;
        QVERIFY(has(out, "  section 1 ") && !has(out, "section 0"));
        QVERIFY(has(run({"--help"}).out, "counted from 0"));
    }

    void timesBelowTwoMinutesAreInSeconds() {
        const std::string brief = run({"simulate", samplePath("smallest-plunge")}).out; // 21 s
        QCOMPARE(row(brief, "machining time").back(), std::string("s"));
        QVERIFY(!row(brief, "  Time, s").empty() && row(brief, "  Time, min").empty());
        const std::string longer = run({"simulate", samplePath("complete")}).out; // 19 min
        QCOMPARE(row(longer, "machining time").back(), std::string("min"));
        QVERIFY(!row(longer, "  Time, min").empty());
    }

    void textListsTheShopsNumbersStageByStage() {
        const std::string out = run({"simulate", samplePath("complete")}).out;
        const ShopNumbers shop = shopNumbers(simulate(projectOf(samplePath("complete"))));
        const auto head = row(out, "shop figures");
        QCOMPARE(head.size(), 2 * shop.stages.size() + 1); // "stage 1 stage 2 … cycle"
        QCOMPARE(head.back(), std::string("cycle"));
        const auto energies = row(out, "  Energy, J/mm³");
        QCOMPARE(energies.size(), shop.stages.size() + 1);
        for (std::size_t z = 0; z < shop.stages.size(); ++z) {
            const double shown = QByteArray::fromStdString(energies[z]).toDouble();
            QVERIFY(std::abs(shown / *shop.stages[z].energy_j_mm3 - 1) < 1e-3); // four digits
        }
        QVERIFY(!row(out, "  Overlap B/s").empty());
        QVERIFY(row(run({"simulate", samplePath("smallest-plunge")}).out, "  Overlap").empty());
    }

    void textMarksWhatLiesOutsideItsBand() {
        json file = samples::sample("complete");
        QCOMPARE(run({"simulate", samplePath("complete")}).out.find("(<)"), std::string::npos);
        file["wheel"]["dullness"] = 0; // the shear alone: 5.6 J/mm³
        file["wheel"]["diameter_mm"] = 500;
        file["machine"]["work_speed_rpm"] = 150;
        file["machine"]["wheel_speed_m_s"] = 31.416; // 1200 rev/min, 8 : 1
        const std::string out = run({"simulate", save("sharp.sparkout", file.dump())}).out;
        QVERIFY(has(out, "(<)5.600"));
        QVERIFY(has(out, "20…120 J/mm³"));
        QVERIFY(has(out, "8.000, near a whole number: waviness"));
    }

private:
    static void checkSection(const json& answer, const SectionResult& section, double diameter) {
        const json& deviation = answer.at("diameter_deviation_um");
        QCOMPARE(deviation.size(), std::size_t{2});
        QCOMPARE(deviation[0].get<double>(), section.diameterDeviationMin_mm * 1000);
        QCOMPARE(deviation[1].get<double>(), section.diameterDeviationMax_mm * 1000);
        QCOMPARE(answer.at("radial_runout_um").get<double>(), section.radialRunout_mm * 1000);
        QCOMPARE(answer.at("position_mm").get<double>(), section.position_mm);
        QCOMPARE(answer.at("compliance_mm_per_n").get<double>(), section.compliance_mm_per_n);
        QCOMPARE(answer.at("radii_um").size(), section.radii_mm.size());
        for (std::size_t k = 0; k < section.radii_mm.size(); ++k) {
            QCOMPARE(answer.at("radii_um")[k].get<double>(),
                     (section.radii_mm[k] - diameter / 2) * 1000);
        }
    }

    static void checkForm(const json& answer, const SimulationResult& result) {
        const PartAccuracy accuracy = accuracyOf(result);
        const json& part = answer.at("part");
        QCOMPARE(part.at("cylindricity_um").get<double>(), accuracy.minimumZone.deviation() * 1000);
        QCOMPARE(part.at("total_runout_um").get<double>(), accuracy.totalRunout_mm * 1000);
        QCOMPARE(part.at("taper_um").get<double>(), accuracy.profile.taper_mm * 1000);
        QCOMPARE(part.at("crown_um").get<double>(), accuracy.profile.crown_mm * 1000);
        for (std::size_t i = 0; i < result.sections.size(); ++i) {
            const bool traverse = result.project.operation == Operation::traverse;
            const json& section = traverse
                                      ? answer.at("zones").at(zoneName(result.sections[i].zone))
                                      : answer.at("sections").at(i);
            QCOMPARE(section.at("roundness_um").get<double>(),
                     accuracy.sections[i].minimumZone.deviation() * 1000);
            QCOMPARE(section.at("roundness_least_squares_um").get<double>(),
                     accuracy.sections[i].leastSquares.deviation() * 1000);
            QCOMPARE(section.at("roughness_ra_um").is_null(), !result.sections[i].lastCut);
        }
    }

    static void checkConstraints(const json& answer,
                                 const std::vector<ConstraintResult>& expected) {
        QCOMPARE(answer.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QVERIFY(answer[i].at("name") == requirementOf(expected[i].kind).key);
            QCOMPARE(answer[i].at("limit").get<double>(), expected[i].limit);
            QCOMPARE(answer[i].at("value").get<double>(), expected[i].value);
            QCOMPARE(answer[i].at("margin").get<double>(), expected[i].margin);
            QCOMPARE(answer[i].at("relative_margin").get<double>(), expected[i].relativeMargin);
            QVERIFY(answer[i].at("ok") == expected[i].holds);
            QVERIFY(!answer[i].at("where").get<std::string>().empty());
        }
    }

    /// The words of the line that begins so, after that beginning; empty without such a line.
    static std::vector<std::string> row(const std::string& text, const std::string& beginning) {
        for (const std::string& line : split(text, '\n')) {
            if (line.starts_with(beginning)) {
                std::istringstream words(line.substr(beginning.size()));
                return {std::istream_iterator<std::string>(words), {}};
            }
        }
        return {};
    }

    static void checkShop(const json& answer, const ShopNumbers& expected) {
        QCOMPARE(answer.at("stages").size(), expected.stages.size());
        for (std::size_t z = 0; z < expected.stages.size(); ++z) {
            checkColumn(answer.at("stages")[z], expected.stages[z]);
        }
        checkColumn(answer.at("cycle"), expected.cycle);
        QCOMPARE(answer.at("wheel_speed_rpm").get<double>(), expected.wheelSpeed_rpm);
        QCOMPARE(answer.at("rotation_ratio").get<double>(), expected.rotationRatio);
        QVERIFY(answer.at("rotation_ratio_near_integer") == expected.ratioNearInteger());
    }

    static void checkColumn(const json& answer, const ShopColumn& expected) {
        const std::pair<const char*, double> numbers[] = {
            {"largest_depth_um", expected.depth_mm.value * 1000},
            {"removal_rate_mm3_mm_s", expected.removalRate_mm2_s},
            {"mean_removal_rate_mm3_mm_s", expected.meanRemovalRate_mm2_s},
            {"equivalent_chip_um", expected.equivalentChip_um},
            {"aggressiveness", expected.aggressiveness},
            {"removed_volume_mm3", expected.removedVolume_mm3},
            {"energy_j", expected.energy_j},
            {"grinding_time_min", expected.time_s / 60},
            {"peak_power_w", expected.power_w.value},
            {"mean_power_w", expected.meanPower_w},
            {"peak_normal_force_n", expected.normalForce_n.value}};
        for (const auto& [key, value] : numbers) {
            QCOMPARE(answer.at(key).get<double>(), value);
        }
        QVERIFY(answer.at("overlap_ratio")
                == (expected.overlap ? json(*expected.overlap) : json(nullptr)));
        QVERIFY(answer.at("specific_energy_j_mm3")
                == (expected.energy_j_mm3 ? json(*expected.energy_j_mm3) : json(nullptr)));
        QVERIFY(answer.at("specific_energy_plausible")
                == (expected.energy_j_mm3 ? json(expected.specificEnergyBand() == BandSide::inside)
                                          : json(nullptr)));
        for (const char* key :
             {"largest_depth_where", "peak_power_where", "peak_normal_force_where"}) {
            QCOMPARE(answer.at(key).is_null(), expected.depth_mm.value == 0);
        }
    }
};

} // namespace test_cli_simulate

SPARKOUT_TEST(test_cli_simulate, TestCliSimulate)
#include "test_cli_simulate.moc"
