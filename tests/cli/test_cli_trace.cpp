// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The trace of a cycle that simulate writes.
#include "core/simulation/simulate.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <QFile>

#include <cmath>
#include <map>

#include <sys/stat.h>
#include <unistd.h>

namespace test_cli_trace {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

class TestCliTrace : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void traceHoldsEveryVisit_data() { runnableRows(); }
    void traceHoldsEveryVisit() {
        QFETCH(QString, file);
        const QString trace = m_folder.filePath("trace.csv");
        QCOMPARE(run({"simulate", file, "--trace", trace}).status, 0);
        Trajectory trajectory;
        const SimulationResult result = simulate(projectOf(file), &trajectory);
        const auto rows = split(samples::readText(trace.toStdString()), '\n');
        const bool traverse = result.project.operation == Operation::traverse;
        const std::string columns =
            "programmed_mm,actual_mm,accumulated_mm,radius_um,normal_force_n";
        QCOMPARE(rows.at(0), (traverse ? "time_min,double_stroke,stage,zone,step,revolution,radius,"
                                       : "time_min,revolution,stage,section,radius,")
                                 + columns);
        QCOMPARE(static_cast<long long>(rows.size() - 1), result.visits);
        std::map<std::string, double> sums;
        std::map<std::string, double> accumulated;
        const std::size_t place = 3;
        const std::size_t radius = traverse ? 6 : 4;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const auto cells = split(rows[i], ',');
            QCOMPARE(cells.size(), radius + 6);
            const std::string key = cells[place] + ' ' + cells[radius];
            sums[key] += QByteArray::fromStdString(cells[radius + 2]).toDouble();
            accumulated[key] = QByteArray::fromStdString(cells[radius + 3]).toDouble();
        }
        for (const auto& [key, sum] : sums) {
            QVERIFY2(std::abs(sum - accumulated[key]) <= 1e-12, key.c_str());
        }
        QCOMPARE(sums.size(), result.sections.size() * static_cast<std::size_t>(trajectory.radii));
    }

    void traceThatCannotBeWrittenExits1() {
        for (const QString& trace :
             {m_folder.path(), m_folder.filePath("no/such/folder.csv"), QString("/dev/full")}) {
            const ProcessOutcome outcome =
                run({"simulate", samplePath("smallest-plunge"), "--trace", trace});
            QCOMPARE(outcome.status, 1);
            QVERIFY2(outcome.err.starts_with(trace.toStdString() + ": "), outcome.err.c_str());
        }
        if (geteuid() != 0) {
            const QString locked = save("read-only.csv", "old");
            chmod(locked.toUtf8(), 0444);
            QCOMPARE(run({"simulate", samplePath("smallest-plunge"), "--trace", locked}).status, 1);
            QCOMPARE(samples::readText(locked.toStdString()), std::string("old"));
        }
    }

    void traceOfMillionsOfRowsIsRefused() {
        json file = samples::sample("smallest-plunge");
        file["sections"] = 200;
        file["part"]["radii_per_section"] = 360;
        file["machine"]["compliance_mm_per_n"] = std::vector<double>(200, 2e-5);
        file["cycle"]["stages"][0]["radial_feed_mm_min"] = 0.1;
        const QString trace = m_folder.filePath("huge.csv");
        const ProcessOutcome outcome =
            run({"simulate", save("huge.sparkout", file.dump()), "--trace", trace});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(has(outcome.err, "rows; allowed: at most"), outcome.err.c_str());
        QVERIFY(!std::filesystem::exists(trace.toStdString()));
    }

    void traceNeverReplacesAProject() {
        const std::string text = samples::readText(samplePath("smallest-plunge").toStdString());
        const QString project = save("kept.sparkout", text);
        const QString plain = save("kept.json", text);
        QVERIFY(QFile::link(plain, m_folder.filePath("link.csv")));
        for (const auto& [file, trace] : std::vector<std::pair<QString, QString>>{
                 {samplePath("complete"), project},
                 {plain, plain},
                 {plain, m_folder.filePath("link.csv")},
                 {samplePath("complete"), m_folder.filePath("new.sparkout")}}) {
            const ProcessOutcome outcome = run({"simulate", file, "--trace", trace});
            QCOMPARE(outcome.status, 2);
            QVERIFY2(has(outcome.err, trace.toStdString()), outcome.err.c_str());
        }
        QCOMPARE(samples::readText(project.toStdString()), text);
        QCOMPARE(samples::readText(plain.toStdString()), text);
        QVERIFY(!QFile::exists(m_folder.filePath("new.sparkout")));
    }
};

} // namespace test_cli_trace

SPARKOUT_TEST(test_cli_trace, TestCliTrace)
#include "test_cli_trace.moc"
