// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `remedies` as a user meets it: the real program, what it prints, and that its patch does it.
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/simulate.h"
#include "core/study/operation.h"
#include "core/study/remedies.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <QProcess>

#include <csignal>

namespace test_cli_remedies {

using namespace sparkout;
using namespace cli;

namespace {

bool holds(const SimulationResult& result, const std::vector<ConstraintResult>& constraints) {
    return result.status == RunStatus::completed
           && std::ranges::all_of(constraints, &ConstraintResult::holds);
}

} // namespace

class TestCliRemedies : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void jsonSaysWhatTheEngineFindsAndItsPatchesHold() {
        const QString file = examplePath("wheel-dull");
        const json answer = answerTo({"remedies", file, "--json"});
        const SimulationResult before = simulate(projectOf(file));
        const RemedyResult found = findRemedies(before, evaluateConstraints(before));
        QVERIFY(answer.at("goal") == "holds" && answer.at("status") == "completed");
        QVERIFY(answer.at("conflict").is_null());
        QCOMPARE(answer.at("found").get<std::size_t>(), found.found);
        QCOMPARE(answer.at("runs").get<long long>(), found.runs);
        QCOMPARE(answer.at("remedies").size(), found.remedies.size());
        QVERIFY(!found.remedies.empty());
        for (std::size_t i = 0; i < found.remedies.size(); ++i) {
            const json& told = answer.at("remedies")[i];
            QCOMPARE(told.at("time_min").get<double>(), found.remedies[i].time_s / 60);
            QCOMPARE(told.at("before").is_null(), !found.remedies[i].before().has_value());
            QCOMPARE(told.at("holds_beyond").get<bool>(), found.remedies[i].holdsBeyond);
            QCOMPARE(told.at("time_change_min").get<double>(),
                     *found.remedies[i].timeChange_s / 60);
            const StockRange& stocks = found.remedies[i].stocks.value();
            QVERIFY(told.at("stock_mm") == json::array({stocks.from_mm, stocks.to_mm}));
            QVERIFY(told.at("phases").is_null() && told.at("batch").is_null()); // it has none
            const bool isCycle = told.at("kind") == "starting_cycle";
            QCOMPARE(told.at("value").is_null(), isCycle);
            QCOMPARE(told.at("interval").is_null(), isCycle);
            const Interval& interval = found.remedies[i].interval;
            QVERIFY(isCycle
                    || (told.at("value") == found.remedies[i].value
                        && told.at("interval") == json::array({interval.low, interval.high})
                        && interval.low <= told.at("value") && told.at("value") <= interval.high));
            QCOMPARE(told.at("values").get<int>(), found.remedies[i].values);
            QCOMPARE(told.at("rank").get<double>(), found.remedies[i].rank);
            for (const json& each : told.at("requirements")) {
                QVERIFY(each.at("ok").get<bool>());
            }
            const json whole = json::parse(writeProject(projectOf(file))).patch(told.at("patch"));
            const ReadResult changed = readProject(whole.dump());
            QVERIFY(changed.project.has_value());
            const SimulationResult result = simulate(*changed.project);
            QVERIFY(holds(result, evaluateConstraints(result)));
            QCOMPARE(told.at("time_min").get<double>(), result.time_s / 60);
        }
    }

    void peopleReadALineForEach() {
        Project dull = projectOf(examplePath("wheel-dull"));
        dull.machine->limits.work_speed_rpm = std::vector<double>{160, 160, 5}; // a feed is offered
        const ProcessOutcome outcome = run({"remedies", save("dull.sparkout", writeProject(dull))});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.starts_with("diameter_min is not met in "), outcome.out.c_str());
        QVERIFY2(has(outcome.out, " of stage "), outcome.out.c_str());
        QVERIFY2(has(outcome.out, "all requirements are met; the cycle takes "),
                 outcome.out.c_str());
        QVERIFY2(has(outcome.out, "The cycle is fit for every stock per side of "),
                 outcome.out.c_str());
        QVERIFY2(has(outcome.out, "; for every stock\n"), outcome.out.c_str());
        QVERIFY2(has(outcome.out, " settings tried in "), outcome.out.c_str());
    }

    void aCycleThatHoldsGetsNone() {
        const QString file = examplePath("shaft-30h6-factory");
        QCOMPARE(run({"remedies", file}).out,
                 std::string("all requirements are met with a sufficient margin\n"));
        const json answer = json::parse(run({"remedies", file, "--json"}).out);
        QVERIFY(answer.at("goal") == "none" && answer.at("remedies").empty());
    }

    void whereNoneHelpsTheRequirementIsNamed() {
        json untrue = samples::sample("complete");
        untrue["machine"]["geometric_runout_um"] = 6; // more than the tolerance alone
        untrue["part"]["tolerance"]["radial_runout_um"] = 5;
        const QString file = save("untrue.sparkout", untrue.dump());
        const ProcessOutcome outcome = run({"remedies", file});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(has(outcome.out, "Radial runout"), outcome.out.c_str());
        const json answer = json::parse(run({"remedies", file, "--json"}).out);
        const json& conflict = answer.at("conflict");
        QVERIFY(conflict.at("first") == "radial_runout" && conflict.at("kind") == "unmended");
        QCOMPARE(conflict.at("path").is_null(), conflict.at("value").is_null());
        QVERIFY2(has(outcome.out, "  Among the values tried, no single setting "),
                 outcome.out.c_str());
        const std::string help = run({"--help"}).out;
        QVERIFY(!has(help, "pull against each other")); // true of one kind
    }

    void aSearchThatIsEndedSaysSo() {
        Project slow = withSections(projectOf(examplePath("plunge-shaft-two-stage")), 50);
        slow.part->radii_per_section = 360;
        slow.part->tolerance.radial_runout_um = 1.5;
        const QString file = save("slow.sparkout", writeProject(slow));
        ProcessOutcome outcome;
        for (int delay_ms = 100; delay_ms < 20'000;
             delay_ms += delay_ms / 4) { // past the cycle itself
            QProcess process;
            process.start(SPARKOUT_CLI, {"remedies", file});
            QVERIFY(process.waitForStarted());
            QVERIFY2(!process.waitForFinished(delay_ms), "the search is too short to be ended");
            endBySignal(process, SIGINT);
            outcome = outcomeOf(process);
            if (!outcome.out.empty()) {
                break;
            }
        }
        QCOMPARE(outcome.status, 130);
        QVERIFY2(has(outcome.out, "  Stopped after "), outcome.out.c_str());
        QVERIFY2(!has(outcome.out, "no single setting"), outcome.out.c_str());
        QVERIFY(has(run({"--help"}).out, "ended by Ctrl+C or SIGTERM"));
    }

    void whatCannotBeRunIsRefused() {
        json file = samples::sample("smallest-plunge");
        file["wheel"]["width_mm"] = 2000;
        QCOMPARE(run({"remedies", save("wide.sparkout", file.dump())}).status, 1);
        for (const QStringList& arguments :
             {QStringList{"remedies"}, QStringList{"remedies", "a", "b"},
              QStringList{"remedies", "a", "--csv"}}) {
            QVERIFY(isUsageError(run(arguments)));
        }
        QVERIFY(has(run({"--help"}).out, "sparkout-cli remedies FILE"));
    }
};

} // namespace test_cli_remedies

SPARKOUT_TEST(test_cli_remedies, TestCliRemedies)
#include "test_cli_remedies.moc"
