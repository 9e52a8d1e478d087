// SPDX-License-Identifier: GPL-3.0-or-later
// `remedies` as a user meets it: the real program, what it prints, and that its patch does it.
#include "core/remedies/remedies.h"
#include "core/simulation/simulate.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

namespace test_cli_remedies {

using namespace sparkout;
using namespace cli;

namespace {

QString examplePath(const char* name) {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/%1.sparkout")
        .arg(QString::fromUtf8(name));
}

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
        const QString file = examplePath("slender-shaft");
        const Outcome outcome = run({"remedies", file, "--json"});
        QCOMPARE(outcome.status, 0);
        const json answer = json::parse(outcome.out);
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
            QCOMPARE(told.at("value").get<double>(), found.remedies[i].value);
            QCOMPARE(told.at("time_min").get<double>(), found.remedies[i].time_s / 60);
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
        const Outcome outcome = run({"remedies", examplePath("slender-shaft")});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.starts_with("diameter_min fails in rz1\n  "), outcome.out.c_str());
        QVERIFY2(outcome.out.find(" of stage ") != std::string::npos, outcome.out.c_str());
        QVERIFY2(outcome.out.find("everything holds; the cycle takes ") != std::string::npos,
                 outcome.out.c_str());
        QVERIFY2(outcome.out.find(" settings tried in ") != std::string::npos, outcome.out.c_str());
    }

    void aCycleThatHoldsGetsNone() {
        const QString file = examplePath("shaft-30h6-factory");
        QCOMPARE(run({"remedies", file}).out, std::string("everything holds, with room\n"));
        const json answer = json::parse(run({"remedies", file, "--json"}).out);
        QVERIFY(answer.at("goal") == "none" && answer.at("remedies").empty());
    }

    void whereNoneHelpsTheRequirementIsNamed() {
        json untrue = samples::sample("complete");
        untrue["machine"]["geometric_runout_um"] = 6; // more than the tolerance alone
        untrue["part"]["tolerance"]["radial_runout_um"] = 5;
        const QString file = save("untrue.sparkout", untrue.dump());
        const Outcome outcome = run({"remedies", file});
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.find("Radial runout") != std::string::npos, outcome.out.c_str());
        const json answer = json::parse(run({"remedies", file, "--json"}).out);
        QVERIFY(answer.at("conflict").at("first") == "radial_runout");
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
        QVERIFY(run({"--help"}).out.find("sparkout-cli remedies FILE") != std::string::npos);
    }
};

} // namespace test_cli_remedies

SPARKOUT_TEST(test_cli_remedies, TestCliRemedies)
#include "test_cli_remedies.moc"
