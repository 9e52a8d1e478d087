// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `sweep` as a user meets it: the real program, its exit status, what it prints.
#include "core/sweep/sweep_run.h"
#include "tests/cli/cli_process.h"
#include "tests/registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <cmath>
#include <fstream>

namespace test_cli_sweep {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

class TestCliSweep : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        std::setlocale(LC_NUMERIC, "C"); // the application object took the environment's
        QVERIFY(m_folder.isValid());
        json project =
            json::parse(samples::readText(samplePath("smallest-traverse").toStdString()));
        project["sweep"] = {
            {"inputs",
             {{{"input", "/machine/overrun_entry_mm"}, {"from", 5}, {"to", 60}, {"points", 6}},
              {{"input", "/wheel/dullness"}, {"from", 0.01}, {"to", 0.04}, {"points", 3}}}}};
        m_file = write("swept", project);
        project["sweep"]["inputs"][1]["input"] = "/wheel/sharpness";
        m_faulty = write("faulty", project);
    }

    void jsonSaysWhatTheEngineComputes() {
        const Outcome outcome = run({"sweep", m_file, "--json"});
        QCOMPARE(outcome.status, 0);
        const json answer = json::parse(outcome.out);
        const SweepResult sweep =
            runSweep(*readProject(samples::readText(m_file.toStdString())).project);
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
        const Outcome outcome = run({"sweep", m_file, "--csv", "--threads", "1"});
        QCOMPARE(outcome.status, 0);
        QCOMPARE(lines(outcome.out), std::size_t{19});
        QVERIFY(outcome.out.starts_with("/machine/overrun_entry_mm [mm],/wheel/dullness,status,ok,"
                                        "time part [s],time part margin,"));
        QCOMPARE(run({"sweep", m_file, "--csv", "--threads", "3"}).out, outcome.out);
    }

    void aFaultySweepIsRefusedByPathAndValue() {
        const Outcome outcome = run({"sweep", m_faulty});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.out.empty());
        QVERIFY(outcome.err.find("/sweep/inputs/1/input: \"/wheel/sharpness\"")
                != std::string::npos);
        // A single cycle does not read it.
        QCOMPARE(run({"simulate", m_faulty}).status, 0);
        QCOMPARE(run({"sweep", samplePath("smallest-traverse")}).status, 1);
    }

    void usageErrors() {
        for (const QStringList& arguments :
             {QStringList{"sweep"}, QStringList{"sweep", "a", "b"},
              QStringList{"sweep", "a", "--threads", "0"},
              QStringList{"sweep", "a", "--json", "--csv"}, QStringList{"sweep", "a", "--check"}}) {
            const Outcome outcome = run(arguments);
            QVERIFY2(isUsageError(outcome), outcome.text().c_str());
        }
        QVERIFY(run({"--help"}).out.find("sparkout-cli sweep FILE") != std::string::npos);
    }

private:
    QString write(const char* name, const json& project) {
        const QString path = m_folder.filePath(QString::fromLatin1(name) + ".sparkout");
        std::ofstream(path.toStdString()) << project.dump();
        return path;
    }

    QTemporaryDir m_folder;
    QString m_file, m_faulty;
};

} // namespace test_cli_sweep

SPARKOUT_TEST(test_cli_sweep, TestCliSweep)
#include "test_cli_sweep.moc"
