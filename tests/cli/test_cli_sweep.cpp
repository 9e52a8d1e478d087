// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `sweep` as a user meets it: the real program, its exit status, what it prints.
#include "core/batch/sweep_run.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

namespace test_cli_sweep {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

class TestCliSweep : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        json project =
            json::parse(samples::readText(samplePath("smallest-traverse").toStdString()));
        project["sweep"] = {
            {"inputs",
             {{{"input", "/machine/overrun_entry_mm"}, {"from", 5}, {"to", 60}, {"points", 6}},
              {{"input", "/wheel/dullness"}, {"from", 0.01}, {"to", 0.04}, {"points", 3}}}}};
        m_file = save("swept.sparkout", project.dump());
        project["sweep"]["inputs"][1]["input"] = "/wheel/sharpness";
        m_faulty = save("faulty.sparkout", project.dump());
    }

    void jsonSaysWhatTheEngineComputes() {
        const json answer = answerTo({"sweep", m_file, "--json"});
        const SweepResult sweep = runSweep(projectOf(m_file));
        QVERIFY(answer.at("status") == "completed");
        QVERIFY(answer.at("inputs")[1].at("input") == "/wheel/dullness");
        QCOMPARE(answer.at("points").size(), sweep.points.size());
        bool refused = false;
        for (std::size_t i = 0; i < sweep.points.size(); ++i) {
            const json& told = answer.at("points")[i];
            QVERIFY(told.at("values").get<std::vector<double>>() == sweep.valuesAt(i));
            QVERIFY(told.at("ok").get<bool>() == sweep.points[i].good);
            for (const json& result : told.at("results")) {
                QVERIFY(result.at("value").is_number());
            }
            if (sweep.points[i].status == SweepStatus::refused) {
                refused = true;
                QVERIFY(told.at("status") == "refused" && told.at("results").empty());
                QVERIFY(!told.at("refused").empty());
            } else {
                QVERIFY(told.at("results")[0].at("value").get<double>()
                        == sweep.points[i].values[0].value);
            }
        }
        QVERIFY(refused);
    }

    void csvHasARowForEveryPoint() {
        const ProcessOutcome outcome = run({"sweep", m_file, "--csv", "--threads", "1"});
        QCOMPARE(outcome.status, 0);
        QCOMPARE(lines(outcome.out), std::size_t{19});
        QVERIFY(outcome.out.starts_with("/machine/overrun_entry_mm [mm],/wheel/dullness,status,ok,"
                                        "time part [s],time part margin,"));
        QCOMPARE(run({"sweep", m_file, "--csv", "--threads", "3"}).out, outcome.out);
    }

    void aFaultySweepIsRefusedByPathAndValue() {
        const ProcessOutcome outcome = run({"sweep", m_faulty});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.out.empty());
        QVERIFY(has(outcome.err, "/sweep/inputs/1/input: \"/wheel/sharpness\""));
        // A single cycle does not read it.
        QCOMPARE(run({"simulate", m_faulty}).status, 0);
        QCOMPARE(run({"sweep", samplePath("smallest-traverse")}).status, 1);
    }

    void usageErrors() {
        for (const QStringList& arguments :
             {QStringList{"sweep"}, QStringList{"sweep", "a", "b"},
              QStringList{"sweep", "a", "--threads", "0"},
              QStringList{"sweep", "a", "--json", "--csv"}, QStringList{"sweep", "a", "--check"}}) {
            const ProcessOutcome outcome = run(arguments);
            QVERIFY2(isUsageError(outcome), outcome.text().c_str());
        }
        QVERIFY(has(run({"--help"}).out, "sparkout-cli sweep FILE"));
    }

private:
    QString m_file, m_faulty;
};

} // namespace test_cli_sweep

SPARKOUT_TEST(test_cli_sweep, TestCliSweep)
#include "test_cli_sweep.moc"
