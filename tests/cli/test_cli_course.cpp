// SPDX-License-Identifier: GPL-3.0-or-later
// `course` as a teacher meets it: variants for a list, works marked, faults named.
#include "core/course/best_table.h"
#include "core/course/work_file.h"
#include "core/course/work_seal.h"
#include "tests/cli/cli_bench.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/registry.h"

#include <QDir>

namespace test_cli_course {

using namespace sparkout;
using namespace cli;

namespace {

QString lessonPath() {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons/02-actual-feed.sparkout-lesson");
}

std::string contentOf(const QString& file) {
    return samples::readText(file.toStdString());
}

} // namespace

class TestCliCourse : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        m_group = save("group.csv", "name,group\nИванов И.,ТМ-31\nПетров П.,ТМ-31\nSmith J.,B\n");
        m_class = m_folder.filePath("class");
        const Outcome outcome = run(variantsInto(m_class));
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QCOMPARE(lines(outcome.out), std::size_t{5});
    }

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("nothing") << QStringList{"course"};
        QTest::newRow("unknown") << QStringList{"course", "teach", "a"};
        QTest::newRow("no file") << QStringList{"course", "check"};
        QTest::newRow("two files") << QStringList{"course", "check", "a", "b"};
        QTest::newRow("no lesson") << QStringList{"course", "variants"};
        QTest::newRow("no seed") << QStringList{"course", "variants", "a", "--group",
                                                "g",      "-d",       "d"};
        QTest::newRow("bad seed") << QStringList{"course", "variants", "a",      "--group", "g",
                                                 "-d",     "d",        "--seed", "-1"};
        QTest::newRow("no folder") << QStringList{"course", "grade", "a"};
        QTest::newRow("two outputs") << QStringList{"course", "grade", "a", "b", "--csv", "--json"};
        QTest::newRow("unknown option") << QStringList{"course", "grade", "a", "b", "--xml"};
        QTest::newRow("option of another") << QStringList{"course", "check", "a", "--force"};
    }
    void usageErrors() {
        QFETCH(QStringList, arguments);
        const Outcome outcome = run(arguments);
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
    }

    void theSameSeedWritesTheSameFiles() {
        const QString again = m_folder.filePath("again");
        QCOMPARE(run(variantsInto(again)).status, 0);
        const QStringList files = QDir(m_class).entryList(QDir::Files);
        QCOMPARE(files.size(), 5);
        QCOMPARE(QDir(again).entryList(QDir::Files), files);
        for (const QString& file : files) {
            QCOMPARE(contentOf(again + '/' + file), contentOf(m_class + '/' + file));
        }
    }

    void worksAreNotWrittenOver() {
        const QString file = m_class + "/001-Иванов_И_.sparkout-work";
        const std::string before = contentOf(file);
        QVERIFY(!before.empty());
        const Outcome outcome = run(variantsInto(m_class));
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.err.find("--force") != std::string::npos);
        QCOMPARE(run(variantsInto(m_class) << "--force").status, 0);
        QCOMPARE(contentOf(file), before);
    }

    void theStudentsFilesHoldNoAnswersAndNoSeed() {
        for (const QString& name : QDir(m_class).entryList({"*.sparkout-work"})) {
            const std::string text = contentOf(m_class + '/' + name);
            for (const char* word : {"\"right\"", "seed", "731902", "\"variants\""}) {
                QVERIFY2(text.find(word) == std::string::npos, word);
            }
            QCOMPARE(run({"course", "check", m_class + '/' + name}).status, 0);
        }
        const std::string best = contentOf(m_class + "/teacher-best-answers.csv");
        QVERIFY(best.starts_with("\"For the teacher only") || best.starts_with("For the teacher"));
        QCOMPARE(readBestTable(best).rows.size(), std::size_t{3});
    }

    void aClassIsMarked() {
        const QString file = m_class + "/003-Smith_J_.sparkout-work";
        Work work = readWork(contentOf(file)).work.value();
        Answer answer;
        answer.chosen = {{1}};
        WorkEntry entry;
        entry.when = "2026-11-26T10:00:00Z";
        entry.answer = answer;
        addEntry(work, entry);
        const QString marked = m_folder.filePath("marked");
        QVERIFY(QDir().mkpath(marked));
        save("marked/smith.sparkout-work", writeWork(work));
        work.entries[0].when = "2026-11-26T09:00:00Z";
        save("marked/edited.sparkout-work", writeWork(work));
        save("marked/broken.sparkout-work", "no work");
        const QStringList grade{
            "course",  "grade", lessonPath(), marked,
            "--group", m_group, "--answers",  m_class + "/teacher-best-answers.csv"};
        const Outcome outcome = run(grade + QStringList{"--json"});
        QCOMPARE(outcome.status, 0);
        const json works = json::parse(outcome.out).at("works");
        QCOMPARE(works.size(), std::size_t{5}); // three files, two missing
        QVERIFY(works[0].at("flags") == json({"unreadable"}));
        QVERIFY(works[1].at("flags") == json({"edited", "handed_in_twice"}));
        QVERIFY(works[2].at("flags") == json({"handed_in_twice"}));
        QCOMPARE(works[2].at("points").get<double>(), 1.0);
        QVERIFY(works[2].at("steps")[0].at("finding") == json("passed"));
        QVERIFY(works[3].at("name") == json("Иванов И."));
        QVERIFY(works[3].at("flags") == json({"missing"}));
        QVERIFY(outcome.err.find("broken.sparkout-work") != std::string::npos);
        const Outcome csv = run(grade + QStringList{"--csv"});
        QCOMPARE(lines(csv.out), std::size_t{6});
        const Outcome text = run(grade);
        QVERIFY2(text.out.find("edited outside the program") != std::string::npos,
                 text.out.c_str());
        QCOMPARE(run({"course", "check", marked + "/edited.sparkout-work"}).status, 4);
    }

    void impossibleDemandsNameTheirCondition() {
        json file = samples::lessonJsonOf();
        file["variants"]["inputs"] = {{{"path", "/wheel/dullness"}, {"list", {0.02}}}};
        const QString lesson = save("one.sparkout-lesson", file.dump());
        const QString folder = m_folder.filePath("impossible");
        const Outcome outcome =
            run({"course", "variants", lesson, "--group", m_group, "--seed", "1", "-d", folder});
        QCOMPARE(outcome.status, 5);
        QVERIFY2(outcome.err.find("refused: another variant has the same inputs")
                     != std::string::npos,
                 outcome.err.c_str());
        QVERIFY(!QDir(folder).exists());
    }

    void faultsAreNamedLineByLine() {
        json file = samples::lessonJsonOf();
        file["steps"][0]["points"] = -1;
        file["steps"][5]["inputs"][0]["path"] = "/x";
        const QString lesson = save("faults.sparkout-lesson", file.dump());
        const Outcome outcome = run({"course", "check", lesson});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.err.find(": /steps/0/points: -1 is out of range") != std::string::npos);
        const QString twice = save("twice.csv", "A\nB\nA\n");
        const Outcome list = run({"course", "variants", lessonPath(), "--group", twice, "--seed",
                                  "1", "-d", m_folder.filePath("none")});
        QCOMPARE(list.status, 1);
        QVERIFY2(list.err.find("twice.csv:3: A: ") != std::string::npos, list.err.c_str());
        QCOMPARE(run({"course", "grade", lessonPath(), m_folder.filePath("no folder")}).status, 1);
        QCOMPARE(run({"course", "grade", lessonPath(), m_class, "--answers", twice}).status, 1);
    }

    void aLessonIsCheckedAsGiven() {
        const Outcome outcome = run({"course", "check", lessonPath(), "--json"});
        QCOMPARE(outcome.status, 0);
        const json steps = json::parse(outcome.out).at("steps");
        QCOMPARE(steps.size(), std::size_t{8});
        QVERIFY(steps[5].at("finding") == json("failed"));
        QVERIFY(steps[5].at("value").get<double>() > 2.3); // the spread of the zones [µm]
        QCOMPARE(lines(run({"course", "check", lessonPath()}).out), std::size_t{8});
    }

    void keptRunsThatAreNotTheEnginesAreNamed() {
        const QString example =
            QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/shaft-38-74h6.sparkout");
        QCOMPARE(run({"course", "check", example}).status, 0);
        QVERIFY(run({"simulate", example}).err.find("kept run") == std::string::npos);
        json file = json::parse(contentOf(example));
        file["runs"][0]["summary"]["cycle_time_min"] = 1.5;
        const QString edited = save("edited.sparkout", file.dump());
        const Outcome outcome = run({"course", "check", edited});
        QCOMPARE(outcome.status, 4);
        QVERIFY2(outcome.err.find("kept run \"Factory\": 1 number is not the engine's: "
                                  "/cycle_time_min 1.5, by the engine 5.1")
                     != std::string::npos,
                 outcome.err.c_str());
        const Outcome simulated = run({"simulate", edited});
        QCOMPARE(simulated.status, 0);
        QVERIFY(simulated.err.find("kept run \"Factory\"") != std::string::npos);
    }

private:
    [[nodiscard]] QStringList variantsInto(const QString& folder) const {
        return {"course", "variants", lessonPath(), "--group", m_group,
                "--seed", "731902",   "-d",         folder};
    }

    QString m_group, m_class;
};

} // namespace test_cli_course

SPARKOUT_TEST(test_cli_course, TestCliCourse)
#include "test_cli_course.moc"
