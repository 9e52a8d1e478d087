// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `sparkout-cli optimize` as a user meets it: the real program, its exit status, what it prints and
// writes, and Ctrl+C.
#include "core/batch/judgement.h"
#include "core/search/binding.h"
#include "core/search/limit.h"
#include "core/search/optimise.h"
#include "core/setup/interval_search.h"
#include "core/setup/setup_file.h"
#include "core/simulation/simulate.h"
#include "tests/cli/cli_bench.h"
#include "tests/cli/search_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "words/judgement_words.h"

#include <algorithm>
#include <cmath>

namespace test_cli_optimise {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

/// A soft shaft ground by plunging in three stages of equal stocks, with a field of 4 µm.
json softShaft() {
    json file = json::parse(samples::readText(
        samples::sourcePath("resources/examples/plunge-shaft-two-stage.sparkout")));
    file["part"]["radii_per_section"] = 12;
    file["part"]["lower_deviation_um"] = 8;
    file["part"]["upper_deviation_um"] = 12;
    file["machine"]["compliance_mm_per_n"] = {3e-4, 3e-4, 3e-4, 3e-4};
    file["optimisation"] = {{"stages", json::array({3})},
                            {"stock_step_mm", file["part"]["stock_mm"].get<double>() / 3},
                            {"radial_feed_mm_min", {0.2, 0.6, 1.6}}};
    return file;
}

Project projectOf(const json& file) {
    return readProject(file.dump()).project.value();
}

class TestCliOptimise : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        m_shaft = save("shaft.sparkout", shaft());
    }

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no file") << QStringList{};
        QTest::newRow("empty file name") << QStringList{""};
        QTest::newRow("two files") << QStringList{"a", "b"};
        QTest::newRow("unknown option") << QStringList{"a", "--check"};
        QTest::newRow("unknown method") << QStringList{"a", "--method", "guess"};
        QTest::newRow("no method") << QStringList{"a", "--method"};
        QTest::newRow("no stage") << QStringList{"a", "--stages", "0"};
        QTest::newRow("six stages") << QStringList{"a", "--stages", "1,6"};
        QTest::newRow("empty stage") << QStringList{"a", "--stages", "1,,2"};
        QTest::newRow("half a stage") << QStringList{"a", "--stages", "1.5"};
        QTest::newRow("no thread") << QStringList{"a", "--threads", "0"};
        QTest::newRow("negative time") << QStringList{"a", "--time-limit", "-1"};
        QTest::newRow("empty output") << QStringList{"a", "-o", ""};
        QTest::newRow("over its input") << QStringList{m_shaft, "-o", m_shaft};
    }
    void usageErrors() {
        QFETCH(QStringList, arguments);
        const ProcessOutcome outcome = optimize(arguments);
        QCOMPARE(outcome.status, 2);
        QCOMPARE(lines(outcome.err), std::size_t{1});
        QVERIFY(outcome.err.starts_with("sparkout-cli: "));
        QVERIFY(outcome.out.empty());
    }

    void whatCannotBeSearchedIsRefused_data() {
        addColumns<QString, QString>("patch", "path");
        addRow("no grid", R"({"optimisation": null})",
               "/optimisation: The inputs of the search are missing. sparkout-cli new writes ");
        addRow("no feeds", R"({"optimisation": {"radial_feed_mm": null}})",
               "/optimisation/radial_feed_mm, /optimisation/axial_feed_mm_min: ");
        addRow("no axial feeds", R"({"optimisation": {"axial_feed_mm_min": null}})",
               "/optimisation/radial_feed_mm, /optimisation/axial_feed_mm_min: ");
        addRow("too many feeds",
               R"({"optimisation": {"radial_feed_mm": {"from": 1e-9, "to": 0.9, "step": 1e-9}}})",
               "/optimisation: ");
        addRow("too many steps", R"({"optimisation": {"stock_step_mm": 1e-9}})",
               "/optimisation/stock_step_mm: ");
        addRow("too few steps", R"({"optimisation": {"stages": [3], "stock_step_mm": 0.1}})",
               "/optimisation: ");
        addRow("nothing to share",
               R"({"optimisation": {"stages": [2], "last_stock_mm": [0.05, 0.04]}})",
               "/optimisation: ");
        addRow("too many speeds",
               R"({"optimisation": {"work_speed_rpm": {"from": 100, "to": 300, "step": 0.1}}})",
               "/optimisation: Work speed, dwells and spark-outs make more than 500 "
               "combinations");
        addRow("a whole ratio", R"({"optimisation": {"least_ratio_distance": 0.4}})",
               "/optimisation/least_ratio_distance: The rotation ratio is 6.366, nearer to a whole "
               "number than “least_ratio_distance” allows (0.4)");
        addRow("whole ratios",
               R"({"optimisation": {"least_ratio_distance": 0.1, "work_speed_rpm": [163.7, 191]}})",
               "/optimisation/least_ratio_distance: With every work speed of the search ");
        addRow("a stage that no level fits",
               R"({"optimisation": {"stage_radial_feed_mm": [[0.003, 0.0035]]}})",
               "/optimisation: ");
        addRow("corners of no batch",
               R"({"optimisation": {"scenarios": "corners"}, "batch": null})", "/batch: ");
        addRow("a fault", R"({"part": {"length_mm": -1}})", "/part/length_mm: ");
    }
    void whatCannotBeSearchedIsRefused() {
        QFETCH(QString, patch);
        QFETCH(QString, path);
        json file = shaft();
        file.merge_patch(json::parse(patch.toStdString()));
        const QString saved = save("refused.sparkout", file);
        const ProcessOutcome outcome = optimize({saved});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.out.empty());
        QVERIFY2(has(outcome.err, (saved + ": " + path).toStdString()), outcome.err.c_str());
    }

    void jsonSaysWhatTheEngineFinds() {
        const Project project = projectOf(shaft());
        const SearchSummary found = optimise(project);
        const double limit_s = steplessLimit_s(project);
        const json answer = answerOf({m_shaft, "--json"});
        QVERIFY(answer.at("status") == "proved");
        const double time_s = found.best.value().time_s;
        QCOMPARE(answer.at("cycle_time_min").get<double>(), time_s / 60);
        QCOMPARE(answer.at("limit_time_min").get<double>(), limit_s / 60);
        QCOMPARE(answer.at("gap").get<double>(), 1 - limit_s / time_s);
        QVERIFY(answer.at("gap") >= 0);
        QVERIFY(answer.at("evaluations") == found.evaluations);
        QVERIFY(answer.at("visits") == found.visits);
        QVERIFY(answer.at("grid_size") == found.gridSize);
        QVERIFY(answer.at("scenarios_added") == 0);
        QCOMPARE(answer.at("given").at("cycle_time_min").get<double>(),
                 simulate(project).time_s / 60);
        QVERIFY(answer.at("given").at("fails").empty());
        json binding = json::array();
        const auto kinds = bindingRequirements(project, *found.best);
        for (const ConstraintKind kind : kinds.value()) {
            binding.push_back(requirementOf(kind).key);
        }
        QVERIFY(!binding.empty() && answer.at("binding") == binding);
        json file = shaft();
        file["cycle"] = answer.at("cycle");
        Project alone = project;
        *alone.cycle = found.cycle;
        QVERIFY(sameProject(projectOf(file), alone));
    }

    /// In the words of the verdict: the roundness of a machine whose form is not known.
    void itsFirstLineNamesWhatIsNotDecided() {
        const json answer = answerOf({m_shaft, "--json"});
        std::vector<Undecided> open;
        for (const json& each : answer.at("not_decided")) {
            const auto* row = requirementNamed(each.at("name").get<std::string>());
            QVERIFY(row);
            open.push_back({row->kind, UndecidedReason::machineNotKnown, {}});
        }
        QVERIFY(std::ranges::count(open, ConstraintKind::roundness, &Undecided::kind) == 1);
        const std::string text = optimize({m_shaft}).out;
        const std::string first = text.substr(0, text.find('\n'));
        QVERIFY2(first.ends_with("proved. " + JudgementWording().exceptions(open) + '.'),
                 first.c_str());
        json file = shaft();
        file["part"]["tolerance"] = json::object();
        file["part"]["tolerance"]["radial_runout_um"] = 6;
        const QString decided = save("decided.sparkout", file);
        QVERIFY(answerOf({decided, "--json"}).at("not_decided").empty());
        QVERIFY(!has(optimize({decided}).out, "not decided"));
    }

    /// The limit is moved to the answer, which stays the quickest.
    void anAnswerWithoutAMarginNamesItsRequirement() {
        const json free = json::parse(optimize({m_shaft, "--json"}).out);
        QVERIFY(free.at("remarks").at("no_margin").empty()
                || free.at("least_relative_margin").get<double>() < 5e-4);
        json file = shaft();
        file["cycle"] = free.at("cycle");
        double runout_um = 0;
        for (const ConstraintResult& each : evaluateConstraints(simulate(projectOf(file)))) {
            if (each.kind == ConstraintKind::radialRunout) {
                runout_um = std::max(runout_um, each.value);
            }
        }
        file["part"]["tolerance"]["radial_runout_um"] = runout_um * (1 + 1e-6);
        const QString saved = save("at_limit.sparkout", file);
        const json answer = json::parse(optimize({saved, "--json"}).out);
        QVERIFY(answer.at("cycle") == free.at("cycle"));
        const json& named = answer.at("remarks").at("no_margin");
        QVERIFY(std::find(named.begin(), named.end(), "radial_runout") != named.end());
        const std::string text = optimize({saved}).out;
        QVERIFY2(text.find("No margin is left for: ") != std::string::npos
                     && text.find("set “margin_within_min” in the search.") != std::string::npos,
                 text.c_str());
        file["optimisation"]["margin_within_min"] = 60;
        const json widest = json::parse(optimize({save("wide.sparkout", file), "--json"}).out);
        QVERIFY(widest.at("remarks").at("no_margin").empty());
    }

    /// The wheel turns 1145.9 times a minute, six times while the work turns once at 191 rev/min.
    void aWholeRotationRatioIsRemarkedAndCanBeRuledOut() {
        json file = shaft();
        file["optimisation"]["work_speed_rpm"] = {191};
        QString saved = save("whole_ratio.sparkout", file);
        const json whole = answerOf({saved, "--json"});
        const double ratio = whole.at("remarks").at("rotation_ratio_near_integer").get<double>();
        QVERIFY(std::abs(ratio - 6) < 1e-3);
        QVERIFY(!whole.contains("left_out_work_speeds_rpm"));
        std::string text = optimize({saved}).out;
        QVERIFY2(has(text, "The rotation ratio of wheel and work is near a whole number, 6.000: "
                           "waviness. To rule that out, set “least_ratio_distance” in the search."),
                 text.c_str());
        file["optimisation"]["work_speed_rpm"] = {191, 176};
        file["optimisation"]["least_ratio_distance"] = 0.05;
        saved = save("off_ratio.sparkout", file);
        const json off = answerOf({saved, "--json"});
        QVERIFY(off.at("machine").at("work_speed_rpm") == 176);
        QVERIFY(off.at("grid_size") == whole.at("grid_size"));
        QVERIFY(off.at("remarks").at("rotation_ratio_near_integer").is_null());
        QVERIFY(off.at("left_out_work_speeds_rpm") == json::array({191}));
        text = optimize({saved}).out;
        QVERIFY2(has(text, "Work speeds left out because their rotation ratio is nearer to a whole "
                           "number than “least_ratio_distance” allows: 191.")
                     && !has(text, "waviness"),
                 text.c_str());
        file["part"]["tolerance"]["radial_runout_um"] = 1e-6; // which no cycle meets
        const ProcessOutcome none = optimize({save("no_ratio.sparkout", file)});
        QCOMPARE(none.status, 5);
        QVERIFY2(has(none.err, "No cycle of the grid meets every requirement.")
                     && has(none.err, "Work speeds left out"),
                 none.err.c_str());
    }

    /// Of two dwells the answer has one: at that edge of its levels.
    void aDwellAtTheEdgeOfItsLevelsIsNamed() {
        json file = shaft();
        file["optimisation"]["dwell_entry_s"] = {0.333, 0.666};
        const QString saved = save("dwells.sparkout", file);
        const json answer = answerOf({saved, "--json"});
        const json dwell_s = answer.at("machine").at("dwell_entry_s");
        const bool isMost = dwell_s == 0.666;
        const json edges = answer.at("setting_edges");
        QVERIFY(edges
                == json::array({{{"setting", "dwell_entry_s"},
                                 {"side", isMost ? "greatest" : "least"},
                                 {"level", dwell_s},
                                 {"allowed", isMost ? 3600.0 : 0.0},
                                 {"is_allowed_end", false}}}));
        const std::string text = optimize({saved}).out;
        QVERIFY2(has(text, isMost ? "“dwell_entry_s” has the maximum level, 0.666\u00a0s; allowed: "
                                    "3600\u00a0s."
                                  : "“dwell_entry_s” has the minimum level, 0.333\u00a0s; allowed: "
                                    "0\u00a0s."),
                 text.c_str());
    }

    void theWrittenCycleHoldsAndTakesTheTimeStated() {
        const QString written = m_folder.filePath("best.sparkout");
        const json answer = answerOf({m_shaft, "--json", "-o", written});
        const ProcessOutcome outcome = run({"simulate", written, "--check", "--json"});
        QCOMPARE(outcome.status, 0);
        const double time_min = json::parse(outcome.out).at("cycle_time_min").get<double>();
        QVERIFY(time_min == answer.at("cycle_time_min")); // to the last digit
        json file = json::parse(samples::readText(written.toStdString()));
        file["cycle"] = shaft()["cycle"];
        QVERIFY(sameProject(projectOf(file), projectOf(shaft()))); // nothing else is changed
    }

    void aHeuristicSaysThatItIsOne() {
        const QString saved = save("soft.sparkout", softShaft());
        const json exact = answerOf({saved, "--json"});
        QVERIFY(exact.at("method") == "search" && exact.at("heuristic") == false);
        const json answer = answerOf({saved, "--method", "labels", "--json"});
        QVERIFY(answer.at("status") == "found");
        QVERIFY(answer.at("method") == "labels" && answer.at("heuristic") == true);
        QVERIFY(answer.at("cycle_time_min") > exact.at("cycle_time_min"));
        QVERIFY(answer.at("bound_time_min") == answer.at("limit_time_min")); // proved for any cycle
        const std::string text = optimize({saved, "--method", "labels"}).out;
        QVERIFY(has(text, "a heuristic: the cycle is fit, but"));
        QVERIFY(!has(text, ", proved"));
    }

    void theRuleAsPublishedSaysThatThereMayBeACycle() {
        const QString saved = save("soft.sparkout", softShaft());
        const ProcessOutcome outcome = optimize({saved, "--method", "dp"});
        QCOMPARE(outcome.status, 6);
        QVERIFY(outcome.out.empty());
        QVERIFY(has(outcome.err, "The heuristic found no cycle that meets every requirement"));
        const json answer = json::parse(optimize({saved, "--method", "dp", "--json"}).out);
        QVERIFY(answer.at("status") == "not_found" && answer.at("cycle").is_null());
    }

    void theMethodsForPlungeRefuseTraverseCycles() {
        for (const char* method : {"dp", "labels"}) {
            const ProcessOutcome outcome = optimize({m_shaft, "--method", method});
            QCOMPARE(outcome.status, 1);
            QVERIFY(outcome.out.empty());
            QVERIFY2(has(outcome.err, "/operation: --method " + std::string(method)
                                          + ": This method is for plunge grinding"),
                     outcome.err.c_str());
        }
    }

    void refinedIsQuickerAndHoldsAsWritten() {
        json file = shaft();
        file["optimisation"]["radial_feed_mm"] = {0.001, 0.01};
        file["optimisation"]["axial_feed_mm_min"] = {600, 3000};
        const QString saved = save("coarse.sparkout", file);
        const json grid = answerOf({saved, "--json"});
        QVERIFY(!grid.contains("refined"));
        const QString written = m_folder.filePath("refined.sparkout");
        const json answer = answerOf({saved, "--refine", "--json", "-o", written});
        QVERIFY(answer.at("status") == "found"); // not proved; the grid's is
        QVERIFY(answer.at("refined").at("grid_status") == "proved");
        QVERIFY(grid.at("status") == "proved");
        QVERIFY(answer.at("refined").at("is_quicker") == true);
        QVERIFY(answer.at("refined").at("grid_time_min") == grid.at("cycle_time_min"));
        QVERIFY(answer.at("refined").at("grid_bound_time_min") == grid.at("bound_time_min"));
        QVERIFY(answer.at("cycle_time_min") < grid.at("cycle_time_min"));
        QVERIFY(answer.at("bound_time_min") == answer.at("limit_time_min"));
        const ProcessOutcome alone = run({"simulate", written, "--check", "--json"});
        QCOMPARE(alone.status, 0);
        const double time_min = json::parse(alone.out).at("cycle_time_min").get<double>();
        QVERIFY(time_min == answer.at("cycle_time_min")); // to the last digit
        file["cycle"] = answer.at("cycle");
        const Project found = projectOf(file);
        json binding = json::array();
        const auto kinds =
            bindingRequirements(found, *found.cycle, std::llround(simulate(found).time_s * 1e6));
        for (const ConstraintKind kind : kinds.value()) {
            binding.push_back(requirementOf(kind).key);
        }
        QVERIFY(answer.at("binding") == binding);
        const std::string text = optimize({saved, "--refine"}).out;
        QVERIFY(has(text, "it is not proved to be the quickest"));
    }

    void theMachineFoundIsToldAndWritten() {
        json file = shaft();
        file["optimisation"]["work_speed_rpm"] = {120, 180, 240};
        file["optimisation"]["dwell_entry_s"] = {0.333, 0.666};
        file["optimisation"]["spark_out"] = {0, 1};
        const QString saved = save("free.sparkout", file);
        const QString written = m_folder.filePath("found.sparkout");
        const json usual = answerOf({m_shaft, "--json"});
        const json answer = answerOf({saved, "--json", "-o", written});
        QVERIFY(!usual.contains("machine"));
        QVERIFY(answer.at("grid_size")
                == 6 * (usual.at("grid_size").get<long long>() + 3 * (9 * 15 + 81 * 105)));
        QVERIFY(answer.at("cycle_time_min") <= usual.at("cycle_time_min"));
        QVERIFY(answer.at("machine").at("work_speed_rpm") != 180); // else nothing was free
        QVERIFY(!answer.at("machine").contains("dwell_exit_s"));
        const json best = json::parse(samples::readText(written.toStdString()));
        for (const char* key : {"work_speed_rpm", "dwell_entry_s"}) {
            QVERIFY(best.at("machine").at(key) == answer.at("machine").at(key));
        }
        const ProcessOutcome alone = run({"simulate", written, "--check", "--json"});
        QCOMPARE(alone.status, 0);
        const double time_min = json::parse(alone.out).at("cycle_time_min").get<double>();
        QVERIFY(time_min == answer.at("cycle_time_min")); // to the last digit
        const std::string text = optimize({saved}).out;
        QVERIFY(has(text, "  Work speed: "));
    }

    // Machine rate times cycle, handling and share of dressing, and the wheel's share.
    void theCostIsToldBesideTheTime() {
        json file = shaft();
        QVERIFY(answerOf({m_shaft, "--json"}).at("cost_per_part").is_null());
        file["optimisation"]["cost"] = {
            {"machine_per_h", 60}, {"handling_s", 30}, {"dressing_s", 100}, {"dressing_cost", 8}};
        const auto cost = [&file, this] {
            const json answer = answerOf({save("cost.sparkout", file), "--json"});
            return answer.at("cost_per_part").get<double>()
                   - answer.at("cycle_time_min").get<double>();
        };
        QVERIFY(std::abs(cost() - (0.5 + 4.0 / 60 + 8.0 / 25)) < 1e-9); // the batch's 25 parts
        file["optimisation"]["cost"]["parts_between_dressings"] = 10;
        QVERIFY(std::abs(cost() - (0.5 + 10.0 / 60 + 0.8)) < 1e-9);
        file["optimisation"]["cost"].erase("parts_between_dressings");
        file["batch"] = nullptr;
        QVERIFY(std::abs(cost() - 0.5) < 1e-9);
    }

    /// With a wheel that wears: the answer is the engine's, and the cheapest cycle is not the
    /// quickest.
    void theLeastCostAndTheLongestLifeAreAskedForByTheFile() {
        Setup setup = plainSetup(projectOf(shaft()));
        Project& project = setup.surfaces[0].project;
        project.optimisation->cost = Cost{60, 30, 100, 8, {}};
        setup.wear.dulling_per_mm2 = 3e-5;
        const auto saved = [&](SearchObjective objective) {
            project.optimisation->objective = objective;
            return save("worn.sparkout", json::parse(writeSetup(setup)));
        };
        const json quickest = answerOf({saved(SearchObjective::time), "--json"});
        QVERIFY(quickest.at("dressing").is_null());
        for (const SearchObjective objective :
             {SearchObjective::cost, SearchObjective::wheel_life}) {
            const bool isCost = objective == SearchObjective::cost;
            const QString file = saved(objective);
            const ProcessOutcome outcome = optimize({file, "--json"});
            QVERIFY2(outcome.status == 0, outcome.err.c_str());
            const json answer = json::parse(outcome.out);
            const IntervalSummary engine = searchInterval(project, SurfaceWear(setup, 0), {});
            QVERIFY(answer.at("status") == "proved");
            QVERIFY(answer.at("aim") == (isCost ? "least_cost" : "longest_wheel_life"));
            const json& dressing = answer.at("dressing");
            QVERIFY(dressing.at("parts") == engine.held->parts && engine.held->parts > 1);
            QVERIFY(dressing.at("endless") == false && dressing.at("at_least") == false);
            QVERIFY(dressing.at("mean_time_min") == engine.held->meanTime_s / 60);
            QVERIFY(answer.at("cost_per_part") == *engine.cost);
            QVERIFY(answer.at("cycle_time_min") == engine.search.best->time_s / 60);
            QVERIFY(answer.at("cycle_time_min") >= quickest.at("cycle_time_min"));
            const std::string text = optimize({file}).out;
            QVERIFY2(has(text, isCost ? "the minimum cost, proved"
                                      : " is fit for more parts between dressings, proved"),
                     text.c_str());
            const std::string parts = std::to_string(engine.held->parts);
            QVERIFY2(has(text, "Parts per dressing: " + parts + ";") && has(text, "The next part "),
                     text.c_str());
            const ProcessOutcome robust = optimize({file, "--robust"});
            QVERIFY(robust.status != 0);
            QVERIFY2(has(robust.err, "/optimisation/objective: "), robust.err.c_str());
        }
        setup.wear = {};
        const json unworn = answerOf({saved(SearchObjective::cost), "--json"});
        QVERIFY(unworn.at("cycle") == quickest.at("cycle") && unworn.at("dressing").is_null());
        QVERIFY(has(optimize({saved(SearchObjective::wheel_life)}).out, "not searched"));
    }

    void stagesReplaceTheFiles() {
        const json one = answerOf({m_shaft, "--stages", "1", "--json"});
        const json three = answerOf({m_shaft, "--stages", "3,2,1", "--json"});
        QVERIFY(one.at("grid_size") == 9);
        QVERIFY(one.at("cycle").at("stages").size() == 1);
        QVERIFY(three.at("grid_size") == 9 + 81 * 14 + 729 * 91);
        QVERIFY(three.at("cycle_time_min") <= one.at("cycle_time_min"));
    }

    void nothingFeasibleExits5AndNamesWhatCuts() {
        json file = shaft();
        file["machine"]["wheel_drive_kw"] = 0.001;
        const QString saved = save("weak.sparkout", file);
        const QString written = m_folder.filePath("never.sparkout");
        const ProcessOutcome outcome = optimize({saved, "-o", written});
        QCOMPARE(outcome.status, 5);
        QVERIFY(outcome.out.empty());
        QVERIFY2(has(outcome.err, "No cycle of the grid meets every requirement. Excluded most "
                                  "often by: wheel_power ("),
                 outcome.err.c_str());
        QVERIFY(!QFile::exists(written));
        const json answer = answerTo({"optimize", saved, "--json"}, 5);
        QVERIFY(answer.at("status") == "infeasible");
        QVERIFY(answer.at("cycle").is_null() && answer.at("gap").is_null());
    }

    void theEdgeOfTheGridIsNamed() {
        json file = shaft();
        file["optimisation"]["radial_feed_mm"] = {0.001, 0.002};
        file["optimisation"]["axial_feed_mm_min"] = {900, 1200};
        file["machine"]["limits"]["radial_feed_mm"] = {0.0005, 0.02, 0.0005};
        file["machine"]["limits"]["axial_feed_mm_min"] = {50, 5000, 50};
        const QString saved = save("edge.sparkout", file);
        const json fixed = answerOf({saved, "--json"});
        QVERIFY(!fixed.at("edges").empty() && fixed.at("level_rounds") == 1);
        QVERIFY(fixed.at("edges").at(0).at("is_allowed_end") == false);
        const std::string text = optimize({saved}).out;
        QVERIFY2(has(text, "has the maximum level, "), text.c_str());
        QVERIFY2(has(text, "no level of the search is beyond; the machine allows "), text.c_str());
        json bound = file;
        const std::size_t stages = bound["cycle"]["stages"].size();
        bound["optimisation"]["stage_axial_feed_mm_min"] =
            std::vector<std::vector<double>>(stages, {900, 1200});
        const std::string own = optimize({save("bound.sparkout", bound)}).out;
        QVERIFY2(has(own, "the limits of the search, “stage_axial_feed_mm_min”, end there; "
                          "the machine allows "),
                 own.c_str());
        bound["machine"]["limits"]["axial_feed_mm_min"] = {900, 1200, 50};
        const std::string end = optimize({save("end.sparkout", bound)}).out;
        QVERIFY2(has(end, "the machine's range ends there."), end.c_str());
        file["optimisation"]["adaptive"] = true;
        const QString following = save("adaptive.sparkout", file);
        const json adaptive = answerOf({following, "--json"});
        QVERIFY(adaptive.at("level_rounds") > 1);
        QVERIFY(adaptive.at("cycle_time_min") < fixed.at("cycle_time_min"));
        QVERIFY(adaptive.at("levels").at("radial_feed_mm").size() > 2);
        for (const json& edge : adaptive.at("edges")) {
            QVERIFY(edge.at("is_allowed_end") == true);
        }
        QVERIFY(has(optimize({following}).out, "around the answer"));
    }

    /// The limit says what makes it: stretches of the stock, from the deepest on, whose shares of
    /// the time add up to it.
    void theLimitNamesWhatBindsWhere() {
        for (const json& file : {shaft(), softShaft()}) {
            const json answer = answerOf({save("bounds.sparkout", file), "--json"});
            const std::string by = answer.at("limit_by");
            QVERIFY(by == "steps" || by == "rates" || by == "passes");
            const json& bounds = answer.at("limit_bounds");
            QVERIFY(!bounds.empty());
            double sum_min = 0;
            for (std::size_t i = 0; i < bounds.size(); ++i) {
                QVERIFY(bounds[i].at("from_mm") > bounds[i].at("to_mm"));
                QVERIFY(i == 0 || bounds[i].at("from_mm") == bounds[i - 1].at("to_mm"));
                QVERIFY(i == 0 || bounds[i].at("bound") != bounds[i - 1].at("bound"));
                QVERIFY(bounds[i].at("cut_mm") > 0);
                sum_min += bounds[i].at("time_min").get<double>();
            }
            const double limit_min = answer.at("limit_time_min");
            QVERIFY(std::abs(sum_min - limit_min) < 1e-9 * limit_min);
        }
    }

    void theLargestMarginWithinATimeIsAskedForByTheFile() {
        json file = shaft();
        file["optimisation"]["radial_feed_mm"] = {0.001, 0.002, 0.004};
        const json quickest = answerOf({save("least.sparkout", file), "--json"});
        QVERIFY(quickest.at("aim") == "least_time" && quickest.at("margin_within_min").is_null());
        const double least_min = quickest.at("cycle_time_min");
        file["optimisation"]["margin_within_min"] = 1.5 * least_min;
        const QString saved = save("within.sparkout", file);
        const json answer = answerOf({saved, "--json"});
        QVERIFY(answer.at("aim") == "greatest_margin" && answer.at("status") == "proved");
        QVERIFY(answer.at("margin_within_min") == 1.5 * least_min);
        QVERIFY(answer.at("cycle_time_min") <= 1.5 * least_min);
        QVERIFY(answer.at("least_relative_margin") > quickest.at("least_relative_margin"));
        QVERIFY(answer.at("bound_time_min") == answer.at("limit_time_min"));
        QVERIFY(!answer.at("binding").empty());
        const std::string text = optimize({saved}).out;
        QVERIFY2(has(text, "the largest within "), text.c_str());
        QVERIFY2(has(text, "The minimum margin is that of: "), text.c_str());
        const json robust = answerOf({saved, "--robust", "--json"});
        QVERIFY(robust.at("status") == "proved" && robust.at("holds_in_sample") == true);
        QVERIFY(robust.at("least_relative_margin") < answer.at("least_relative_margin"));
        const std::string robustText = optimize({saved, "--robust"}).out;
        QVERIFY2(has(robustText, "over all required cases, in "), robustText.c_str());
        const ProcessOutcome refined = optimize({saved, "--refine"});
        QVERIFY(refined.status != 0);
        QVERIFY2(has(refined.err, "/optimisation/margin_within_min"), refined.err.c_str());
        file["optimisation"]["margin_within_min"] = 0.99 * least_min;
        const ProcessOutcome none = optimize({save("short.sparkout", file)});
        QVERIFY(none.status != 0);
        QVERIFY2(has(none.err, "that takes at most"), none.err.c_str());
    }

    void robustHoldsInThePhasesOfTheStock() {
        json file = shaft();
        file["optimisation"]["radial_feed_mm"] = {0.001, 0.002, 0.004, 0.006};
        const QString saved = save("phases.sparkout", file);
        const json nominal = answerOf({saved, "--json"});
        const json answer = answerOf({saved, "--robust", "--json"});
        QVERIFY(answer.at("holds_in_sample") == true);
        QVERIFY(answer.at("scenarios_added") > 0); // else the part as it is would have done
        QVERIFY(answer.at("nominal_time_min") == nominal.at("cycle_time_min"));
        QVERIFY(answer.at("cycle_time_min") >= nominal.at("cycle_time_min"));
        const json& stocks = answer.at("decided_stock_mm"); // half an infeed on either side
        const double stock_mm = file["part"]["stock_mm"];
        QVERIFY(stocks.at(0) < stock_mm && stocks.at(1) > stock_mm);
        QVERIFY(answer.at("decided_corners") == 0);          // of no batch
        QVERIFY(answer.at("fresh_phases").at("tried") == 0); // none was drawn
        const std::string text = optimize({saved, "--robust"}).out;
        QVERIFY2(has(text, "The cycle is fit for every stock of "), text.c_str());
        QVERIFY(!has(text, "nominal part only"));
        QVERIFY(has(optimize({saved}).out, " for the nominal part only, proved."));
        QVERIFY(!has(text, "stocks drawn at random"));
    }

    void underPositionControlAConfidenceIsStated() {
        json file = shaft();
        file["optimisation"]["radial_feed_mm"] = {0.001, 0.002, 0.004, 0.006};
        file["gauge"]["control"] = "position";
        const QString saved = save("position.sparkout", file);
        const json answer = answerOf({saved, "--robust", "--json"});
        QVERIFY(answer.at("decided_stock_mm").is_null());
        const json& fresh = answer.at("fresh_phases");
        QVERIFY(fresh.at("tried") == 500 && fresh.at("failed") == 0);
        const int candidate = fresh.at("candidate");
        QVERIFY(candidate == fresh.at("cycles_that_failed").get<int>() + 1);
        const double share = std::log(candidate * (candidate + 1) / 0.05) / 500;
        QVERIFY(std::abs(fresh.at("failing_share_at_most").get<double>() - share) < 1e-15);
        QVERIFY(fresh.at("confidence") == 0.95);
        const std::string text = optimize({saved, "--robust"}).out; // a confidence, no proof
        QVERIFY(has(text, "proved for these."));
        const std::string stated =
            QString::number(std::ceil(share * 1e4) / 1e2, 'f', 2).toStdString(); // never less
        QVERIFY(has(text, "(cycle no. " + std::to_string(candidate)
                              + " tried in this way): with 95 % confidence it is unfit for at most "
                              + stated + " % of all stocks"));
    }

    // 5 is for what was decided.
    void aStopBeforeACycleIsFoundHasAStatusOfItsOwn() {
        const QString saved = save("undecided.sparkout", undecided());
        for (const int signal : {SIGINT, SIGTERM}) {
            QProcess process;
            process.start(SPARKOUT_CLI, {"optimize", saved, "--json"});
            QVERIFY(process.waitForStarted());
            QTest::qWait(500);
            QCOMPARE(process.state(), QProcess::Running);
            endBySignal(process, signal);
            const ProcessOutcome outcome = outcomeOf(process);
            QCOMPARE(outcome.status, 128 + signal);
            QVERIFY2(has(outcome.err, "Stopped before a cycle that meets every"),
                     outcome.err.c_str());
            QVERIFY(json::parse(outcome.out).at("status") == "stopped");
        }
        const ProcessOutcome late = optimize({saved, "--time-limit", "0.5", "--json"});
        QCOMPARE(late.status, 6);
        QVERIFY(json::parse(late.out).at("status") == "stopped");
    }

    void theLimitSaysOfWhichCyclesItIs() {
        json file = shaft();
        const auto limitOf = [&](const json& asked) {
            return answerOf({save("limit.sparkout", asked), "--json"});
        };
        const json usual = limitOf(file);
        QVERIFY(usual.at("limit_cycles").at("continuous_feed_mm_min") == 0);
        QVERIFY(usual.at("limit_cycles").at("draw_back") == false);
        QVERIFY(usual.at("limit_cycles").at("spark_out_by_count") == false);
        file["machine"]["limits"]["continuous_feed_mm_min"] = {0, 0.4, 0.01};
        const json wider = limitOf(file);
        QVERIFY(wider.at("limit_cycles").at("continuous_feed_mm_min") == 0.4);
        QVERIFY(wider.at("cycle_time_min") == usual.at("cycle_time_min"));
        QVERIFY(wider.at("limit_time_min") < usual.at("limit_time_min"));
        const std::string text = optimize({save("limit.sparkout", file)}).out;
        QVERIFY2(has(text, "cycles with a continuous infeed of up to 0.4 mm/min.")
                     && has(text, "cycles that end at size."),
                 text.c_str());
    }

    void interruptKeepsTheBestAndTheBound() {
        checkStopped(interruptedWithAnAnswer({save("endless.sparkout", endless()), "--json"}));
    }

    void theTimeLimitKeepsTheBestAndTheBound() {
        checkStopped(
            optimize({save("endless.sparkout", endless()), "--time-limit", "2", "--json"}));
    }

    // Thousands of cycles differ in one setting, and each takes its time: the moment that is left
    // after a stop is not enough to run them.
    void whatBindsIsNotKnownOfAStoppedSearch() {
        json file = endless();
        file["part"]["radii_per_section"] = 360;
        const QString saved = save("endless-fine.sparkout", file);
        const json answer = json::parse(interruptedWithAnAnswer({saved, "--json"}).out);
        QVERIFY(!answer.at("cycle").is_null() && answer.at("binding").is_null());
        const std::string text = interruptedWithAnAnswer({saved}).out;
        QVERIFY2(has(text, "is not known: the search was stopped first"), text.c_str());
    }

    // A refinement takes some thousand runs: without a limit of its own it takes far longer.
    void theTimeLimitIsThatOfTheRefinementToo() {
        RunningTimer took;
        checkStopped(optimize(
            {save("endless.sparkout", endless()), "--time-limit", "1", "--refine", "--json"}));
        QVERIFY2(took.elapsed() < 3000, QByteArray::number(took.elapsed()));
    }

private:
    /// Of which no cycle holds, and there are too many to say so within minutes.
    static json undecided() {
        json file = endless();
        file["part"]["tolerance"]["roughness_ra_um"] = 0.001;
        file["wheel"]["roughness_factor"] = 2;
        return file;
    }

    static ProcessOutcome optimize(const QStringList& arguments) {
        return run(QStringList{"optimize"} + arguments);
    }
    static json answerOf(const QStringList& arguments) {
        return answerTo(QStringList{"optimize"} + arguments);
    }

    [[nodiscard]] QString save(const QString& name, const json& file) const {
        return FolderTest::save(name, file.dump());
    }
    static void checkStopped(const ProcessOutcome& outcome) {
        QCOMPARE(outcome.status, 0);
        const json answer = json::parse(outcome.out);
        QVERIFY(answer.at("status") == "stopped");
        QVERIFY(answer.at("bound_time_min") > 0);
        QVERIFY(answer.at("bound_time_min") <= answer.at("cycle_time_min"));
        json file = endless();
        file["cycle"] = answer.at("cycle");
        const Project best = projectOf(file);
        const SimulationResult alone = simulate(best);
        for (const ConstraintResult& each : evaluateConstraints(alone)) {
            QVERIFY(each.holds);
        }
        QVERIFY(std::abs(alone.time_s / 60 - answer.at("cycle_time_min").get<double>()) <= 1e-8);
    }

    QString m_shaft;
};

} // namespace test_cli_optimise

SPARKOUT_TEST(test_cli_optimise, TestCliOptimise)
#include "test_cli_optimise.moc"
