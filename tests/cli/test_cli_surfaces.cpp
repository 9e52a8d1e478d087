// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Commands on a file of several surfaces: all of them, or the one that --surface names.
#include "core/setup/worn_project.h"
#include "tests/cli/cli_bench.h"
#include "tests/cli/search_samples.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/registry.h"

namespace test_cli_surfaces {

using namespace sparkout;
using namespace cli;
using nlohmann::json;

class TestCliSurfaces : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        m_one = samples::sample("complete");
        json other = m_one;
        other["machine"]["work_speed_rpm"] = 150;
        other["sweep"]["inputs"] = {
            {{"input", "/part/stock_mm"}, {"from", 0.14}, {"to", 0.16}, {"points", 3}}};
        json file = setup_samples::setupOf({m_one, other});
        file["times"] = {{"handling_s", 30}, {"approach_s", 3}};
        m_file = save("two.sparkout", file.dump());
        m_first = save("first.sparkout", m_one.dump());
        m_second = save("second.sparkout", other.dump());
    }

    void oneSurfaceIsWhatItsOwnFileGives_data() {
        QTest::addColumn<QStringList>("command");
        QTest::addRow("simulate") << QStringList{"simulate"};
        QTest::addRow("simulate json") << QStringList{"simulate", "--json"};
        QTest::addRow("remedies") << QStringList{"remedies", "--json"};
        QTest::addRow("batch") << QStringList{"batch", "--parts", "20", "--json"};
        QTest::addRow("sweep") << QStringList{"sweep", "--json"};
        QTest::addRow("optimize") << QStringList{"optimize", "--json"};
    }
    void oneSurfaceIsWhatItsOwnFileGives() {
        QFETCH(QStringList, command);
        const auto on = [&command](const QString& file, const QStringList& more) {
            QStringList arguments = command;
            arguments.insert(1, file);
            return run(arguments + more);
        };
        const ProcessOutcome own = on(m_second, {});
        for (const char* name : {"2", "surface B"}) {
            const ProcessOutcome one = on(m_file, {"--surface", QString::fromUtf8(name)});
            QCOMPARE(one.status, own.status);
            QCOMPARE(withoutTimes(one.out), withoutTimes(own.out));
        }
    }

    void allSurfacesInOneAnswer() {
        const json answer = answerTo({"simulate", m_file, "--json"});
        QCOMPARE(answer.at("surfaces").size(), 2u);
        double sum_min = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            json one = answer.at("surfaces").at(i);
            sum_min += one.at("cycle_time_min").get<double>();
            QVERIFY(one.at("name") == (i == 0 ? "surface A" : "surface B"));
            one.erase("name");
            const ProcessOutcome own = run({"simulate", i == 0 ? m_first : m_second, "--json"});
            QVERIFY(one == json::parse(own.out));
        }
        const json part = answer.at("part");
        QVERIFY(std::abs(part.at("main_time_min").get<double>() - sum_min) < 1e-12 * sum_min);
        QVERIFY(std::abs(part.at("auxiliary_time_min").get<double>() - 0.6) < 1e-12);
        QVERIFY(part.at("completed") == true);
    }

    void textsOfAllHaveHeadings() {
        const ProcessOutcome all = run({"simulate", m_file});
        const auto first = all.out.find("surface 1  surface A"),
                   second = all.out.find("surface 2  surface B");
        QVERIFY(first != std::string::npos && second != std::string::npos && first < second);
        QVERIFY(all.out.find("auxiliary time Ta") > second);
        QVERIFY(has(all.out, run({"simulate", m_first}).out));
    }

    void everySurfaceIsOptimisedIntoOneFile() {
        const QString out = m_folder.filePath("best.sparkout");
        const ProcessOutcome all = run({"optimize", m_file, "--json", "-o", out});
        QCOMPARE(all.status, 0);
        const json answers = json::parse(all.out).at("surfaces");
        const ReadSetup best = readSetup(samples::readText(out.toStdString()));
        QVERIFY(best.setup && best.setup->surfaces.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            const ProcessOutcome again =
                run({"simulate", out, "--surface", QString::number(i + 1), "--json", "--check"});
            QCOMPARE(again.status, 0);
            QVERIFY(json::parse(again.out).at("cycle_time_min")
                    == answers.at(i).at("cycle_time_min"));
        }
        QCOMPARE(best.setup->times.handling_s, 30.0);
    }

    void aSurfaceWithoutAnAnswerKeepsItsCycle() {
        json strict = m_one;
        strict["part"]["tolerance"]["radial_runout_um"] = 1e-6;
        const QString file = save("hard.sparkout", setup_samples::setupOf({m_one, strict}).dump());
        const QString out = m_folder.filePath("half.sparkout");
        const ProcessOutcome half = run({"optimize", file, "-o", out});
        QCOMPARE(half.status, 5);
        QVERIFY2(has(half.err, "surface 2 surface B"), half.err.c_str());
        const json saved = json::parse(samples::readText(out.toStdString())).at("surfaces");
        QVERIFY(saved.at(0).at("cycle") != m_one.at("cycle"));
        QVERIFY(saved.at(1).at("cycle") == strict.at("cycle"));
    }

    void ctrlCEndsWithTheSurfaceThatItInterrupts() {
        const json first = endless();
        json second = first;
        second["part"]["stock_mm"] = 0.14;
        const QString file =
            save("endless.sparkout", setup_samples::setupOf({first, second}).dump());
        const QString out = m_folder.filePath("found.sparkout");
        const ProcessOutcome stopped = interruptedWithAnAnswer({file, "-o", out});
        QCOMPARE(stopped.status, 0);
        QVERIFY(has(stopped.out, "surface 1  surface A"));
        QVERIFY(!has(stopped.out, "surface 2  surface B"));
        const json saved = json::parse(samples::readText(out.toStdString())).at("surfaces");
        QVERIFY(saved.at(0).at("cycle") != first.at("cycle"));
        QVERIFY(saved.at(1).at("cycle") == second.at("cycle"));
    }

    /// A name or times make a set-up even of one surface.
    void oneSurfaceWithTimesStatesThem() {
        json file = setup_samples::setupOf({m_one});
        file["times"] = {{"handling_s", 30}};
        const QString saved = save("single.sparkout", file.dump());
        const json answer = json::parse(run({"simulate", saved, "--json"}).out);
        QCOMPARE(answer.at("surfaces").size(), 1u);
        QCOMPARE(answer.at("part").at("auxiliary_time_min").get<double>(), 0.5);
        const ProcessOutcome alone = run({"simulate", saved, "--surface", "1", "--json"});
        QCOMPARE(alone.out, run({"simulate", m_first, "--json"}).out);
    }

    void aSurfaceThatFailsDecidesTheStatus() {
        json strict = m_one;
        strict["part"]["tolerance"]["radial_runout_um"] = 1e-6;
        const QString file =
            save("strict.sparkout", setup_samples::setupOf({m_one, strict, m_one}).dump());
        QCOMPARE(run({"simulate", file}).status, 0);
        const ProcessOutcome checked = run({"simulate", file, "--check", "--json"});
        QCOMPARE(checked.status, 4);
        QVERIFY(json::parse(checked.out).at("part").at("holds") == false);
    }

    void whatCannotBeOfSeveralSaysSo() {
        const QString csv = m_folder.filePath("out.csv");
        for (const QStringList& arguments :
             {QStringList{"simulate", m_file, "--trace", csv},
              QStringList{"batch", m_file, "--rows", csv}, QStringList{"batch", m_file, "--csv"},
              QStringList{"sweep", m_file, "--csv"}}) {
            const ProcessOutcome outcome = run(arguments);
            QCOMPARE(outcome.status, 2);
            QVERIFY2(has(outcome.err, "--surface"), outcome.err.c_str());
        }
        QVERIFY(!QFile::exists(csv));
        const ProcessOutcome strange = run({"simulate", m_file, "--surface", "seat"});
        QCOMPARE(strange.status, 2);
        QVERIFY2(has(strange.err, "1 surface A, 2 surface B"), strange.err.c_str());
        QCOMPARE(run({"simulate", m_first, "--surface", "1"}).status, 0);
        QCOMPARE(run({"simulate", m_first, "--surface", "2"}).status, 2);
        QCOMPARE(run({"validate", m_file}).status, 0);
    }

private:
    /// The text of an answer without how long the computer took.
    static std::string withoutTimes(const std::string& text) {
        json answer = json::parse(text, nullptr, false);
        if (!answer.is_object()) {
            return text;
        }
        for (const char* key : {"seconds", "elapsed_s"}) {
            answer.erase(key);
        }
        return answer.dump();
    }

    json m_one;
    QString m_file, m_first, m_second;
};

} // namespace test_cli_surfaces

SPARKOUT_TEST(test_cli_surfaces, TestCliSurfaces)
#include "test_cli_surfaces.moc"
