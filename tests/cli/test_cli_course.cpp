// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// `course` as a teacher meets it: variants for a list, works marked, faults named.
#include "core/lesson/work.h"
#include "tests/cli/cli_bench.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/registry.h"
#include "tests/ui/support/xlsx_reader.h"

#include <sys/resource.h>

namespace test_cli_course {

using namespace sparkout;
using namespace cli;

QString lessonPath() {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/lessons/02-actual-feed.sparkout-lesson");
}

std::string contentOf(const QString& file) {
    return samples::readText(file.toStdString());
}

class TestCliCourse : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        m_group = save("group.csv", "name,group\nИванов И.,ТМ-31\nПетров П.,ТМ-31\nSmith J.,B\n");
        m_class = m_folder.filePath("class");
        const ProcessOutcome outcome = run(variantsInto(m_class));
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QCOMPARE(lines(outcome.out), std::size_t{5});
    }

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        addRow("no file", QStringList{"course", "check"});
        addRow("two files", QStringList{"course", "check", "a", "b"});
        addRow("no lesson", QStringList{"course", "variants"});
        addRow("no seed", QStringList{"course", "variants", "a", "--group", "g", "-d", "d"});
        addRow("bad seed",
               QStringList{"course", "variants", "a", "--group", "g", "-d", "d", "--seed", "-1"});
        addRow("no folder", QStringList{"course", "grade", "a"});
        addRow("two outputs", QStringList{"course", "grade", "a", "b", "--csv", "--json"});
        for (const char* other : {"--csv", "--json"}) {
            addRow(other,
                   QStringList{"course", "grade", "a", "b", other, "--xlsx", "-o", "c.xlsx"});
        }
        addRow("book without a name", QStringList{"course", "grade", "a", "b", "--xlsx"});
        addRow("book of another kind",
               QStringList{"course", "grade", "a", "b", "--xlsx", "-o", "c.ods"});
        addRow("name without a book",
               QStringList{"course", "grade", "a", "b", "--csv", "-o", "c.xlsx"});
        addRow("force without a book",
               QStringList{"course", "grade", "a", "b", "--csv", "--force"});
        addRow("book of another command",
               QStringList{"course", "check", "a", "--xlsx", "-o", "c.xlsx"});
    }
    void usageErrors() {
        QFETCH(QStringList, arguments);
        const ProcessOutcome outcome = run(arguments);
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
    }

    void worksAreNotWrittenOver() {
        const QString file = m_class + "/001-Иванов_И_.sparkout-work";
        const std::string before = contentOf(file);
        QVERIFY(!before.empty());
        const ProcessOutcome outcome = run(variantsInto(m_class));
        QCOMPARE(outcome.status, 1);
        QVERIFY(has(outcome.err, "--force"));
        QCOMPARE(run(variantsInto(m_class) << "--force").status, 0);
        QCOMPARE(contentOf(file), before);
    }

    void whatIsWrongWithABookIsSaid() {
        const auto said = [](const QStringList& more) {
            return QString::fromStdString(run(QStringList{"course", "grade", "a", "b"} + more).err);
        };
        QVERIFY(said({"--xlsx"}).contains("--xlsx needs -o OUT.xlsx"));
        QVERIFY(said({"-o", "c.xlsx"}).contains("-o needs --xlsx"));
        QVERIFY(said({"--xlsx", "-o", "c"}).contains("a name that ends with .xlsx: c"));
        QVERIFY(said({"--xlsx", "--csv", "-o", "c.xlsx"})
                    .contains("only one of --json, --csv and --xlsx"));
    }

    void aClassIsMarked() {
        const QString marked = handedIn();
        const QStringList grade{
            "course",  "grade", lessonPath(), marked,
            "--group", m_group, "--answers",  m_class + "/teacher-best-answers.csv"};
        const ProcessOutcome outcome = run(grade + QStringList{"--json"});
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
        QVERIFY(has(outcome.err, "broken.sparkout-work"));
        const ProcessOutcome csv = run(grade + QStringList{"--csv"});
        QCOMPARE(lines(csv.out), std::size_t{6});
        const ProcessOutcome text = run(grade);
        QVERIFY2(has(text.out, "edited outside the program"), text.out.c_str());
        QCOMPARE(run({"course", "check", marked + "/edited.sparkout-work"}).status, 4);
    }

    /// Cell by cell as the table of commas has it, and the steps as they are printed.
    void marksGoIntoAWorkbook() {
        const QString group = save("hostile.csv", "name,group\nИванов И.,ТМ-31\n=1+1,B\n");
        const QStringList grade{
            "course",  "grade", lessonPath(), handedIn(),
            "--group", group,   "--answers",  m_class + "/teacher-best-answers.csv"};
        const QString path = m_folder.filePath("Журнал.xlsx");
        const QStringList book = grade + QStringList{"--xlsx", "-o", path};
        const ProcessOutcome outcome = run(book);
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QCOMPARE(QString::fromStdString(outcome.out), path + '\n');
        const XlsxReader read(path);
        QCOMPARE(read.fault(), QString());
        QCOMPARE(read.names(), QStringList({"Grades", "Steps"}));
        QCOMPARE(read.text("title"), QString("Work 2. Programmed and actual feed, steps E1…E5"));
        compareGrades(read, QString::fromStdString(run(grade + QStringList{"--csv"}).out));
        compareSteps(read, QString::fromStdString(run(grade).out));

        const std::string before = contentOf(path);
        const ProcessOutcome again = run(book);
        QCOMPARE(again.status, 1);
        QVERIFY2(has(again.err, "exists; --force replaces it"), again.err.c_str());
        QCOMPARE(contentOf(path), before);
        save("Журнал.xlsx", "old");
        QCOMPARE(run(book + QStringList{"--force"}).status, 0);
        QCOMPARE(XlsxReader(path).names(), read.names());
        QCOMPARE(run(grade + QStringList{"--xlsx", "-o", m_folder.filePath("none/c.xlsx")}).status,
                 1);
    }

    /// Lists as Russian Excel writes them; UTF-16 by its mark, Windows-1251 by its letters.
    void listsInAnyEncodingAreTaken_data() {
        QTest::addColumn<QByteArray>("list");
        addRow("Windows-1251",
               QByteArray("\xD4\xC8\xCE;\xC3\xF0\xF3\xEF\xEF\xE0\r\n\xC8\xE2\xE0\xED;\xC0-1\r\n"));
        addRow("UTF-16", QByteArray("\xFF\xFE\x24\x04\x18\x04\x1E\x04;\0\x13\x04\x40\x04"
                                    "\x43\x04\x3F\x04\x3F\x04\x30\x04\n\0\x18\x04\x32\x04"
                                    "\x30\x04\x3D\x04;\0\x10\x04-\0001\0\n\0",
                                    42));
        addRow("quotation marks", QByteArray("name;group\n\"Иван\";\"А-1\"\n"));
    }
    void listsInAnyEncodingAreTaken() {
        QFETCH(QByteArray, list);
        const QString group = save("encoded.csv", list.toStdString());
        const QString folder = m_folder.filePath("encoded");
        const ProcessOutcome outcome = run({"course", "variants", lessonPath(), "--group", group,
                                            "--seed", "1", "-d", folder, "--force"});
        QVERIFY2(outcome.status == 0, outcome.text().c_str());
        QVERIFY(has(contentOf(folder + "/assignments.csv"), "\n1,Иван,А-1,"));
        const ProcessOutcome graded =
            run({"course", "grade", lessonPath(), folder, "--group", group, "--answers",
                 folder + "/teacher-best-answers.csv", "--csv"});
        QVERIFY2(graded.status == 0, graded.text().c_str());
        QVERIFY2(has(graded.out, "sparkout-work,Иван,А-1,1,,,"), graded.out.c_str());
    }

    /// The long run has as many as the largest class may hand in, each as large as is read.
    void worksAreHeldInMemoryOneAtATime() {
        if (qEnvironmentVariableIsSet("SPARKOUT_QUICK")) {
            QSKIP("The sanitizers keep memory that was freed.");
        }
        const bool isLong = qEnvironmentVariableIsSet("SPARKOUT_LONG");
        const std::size_t bytes = isLong ? 31'000'000 : 4'000'000;
        const int works = isLong ? 140 : 8;
        std::string content = contentOf(firstWork());
        content.insert(1, bytes, ' ');
        const QString large = save("large.sparkout-work", content);
        const QString folder = m_folder.filePath("large");
        double peak_mb = 0;
        for (const int count : {1, works}) {
            QDir().mkpath(folder);
            for (int i = 0; i < count; ++i) {
                QFile::link(large, folder + QStringLiteral("/%1.sparkout-work").arg(i));
            }
            const ProcessOutcome outcome = run({"course", "grade", lessonPath(), folder, "--csv"});
            QVERIFY2(outcome.status == 0, outcome.err.c_str());
            QCOMPARE(lines(outcome.out), static_cast<std::size_t>(count) + 1);
            rusage used{};
            getrusage(RUSAGE_CHILDREN, &used);
            const double now_mb = static_cast<double>(used.ru_maxrss) / 1024;
            QVERIFY2(now_mb < 512, qPrintable(QString::number(now_mb)));
            QVERIFY2(count == 1 || now_mb - peak_mb < 2e-6 * static_cast<double>(bytes),
                     qPrintable(QStringLiteral("%1 MB, then %2").arg(peak_mb).arg(now_mb)));
            peak_mb = now_mb;
        }
    }

    void ctrlCLeavesTheTableOfTheWorksMarked() {
        const QString folder = m_folder.filePath("many");
        QDir().mkpath(folder);
        constexpr int works = 3000;
        for (int i = 0; i < works; ++i) {
            QFile::link(firstWork(), folder + QStringLiteral("/%1.sparkout-work").arg(i));
        }
        QProcess process;
        process.start(SPARKOUT_CLI, {"course", "grade", lessonPath(), folder, "--csv"});
        QTest::qWait(1500);
        endBySignal(process, SIGINT);
        const ProcessOutcome outcome = outcomeOf(process);
        QCOMPARE(outcome.status, 130);
        QVERIFY2(outcome.out.starts_with("file,name,group,"), outcome.text().c_str());
        const std::size_t marked = lines(outcome.out) - 1;
        QVERIFY(marked < works);
        QVERIFY2(has(outcome.err, "ended after " + std::to_string(marked) + " of 3000 works"),
                 outcome.err.c_str());
    }

    void aFileMayHaveAnyName() {
        const QString folder = m_folder.filePath("bytes");
        QVERIFY(QDir().mkpath(folder));
        std::ofstream(folder.toStdString() + "/a\xFF.sparkout-work") << "no work";
        for (const char* format : {"--csv", "--json"}) {
            const ProcessOutcome outcome = run({"course", "grade", lessonPath(), folder, format});
            QVERIFY2(outcome.status == 0, outcome.text().c_str());
        }
        const QString path = m_folder.filePath("bytes.xlsx");
        QCOMPARE(run({"course", "grade", lessonPath(), folder, "--xlsx", "-o", path}).status, 0);
        QCOMPARE(XlsxReader(path).text(0, 1, 0), QString("a\\xFF.sparkout-work"));
        std::filesystem::remove_all(folder.toStdString()); // Qt cannot name it
    }

    void impossibleDemandsNameTheirCondition() {
        json file = samples::lessonJsonOf();
        file["variants"]["inputs"] = {{{"path", "/wheel/dullness"}, {"list", {0.02}}}};
        const QString lesson = save("one.sparkout-lesson", file.dump());
        const QString folder = m_folder.filePath("impossible");
        const ProcessOutcome outcome =
            run({"course", "variants", lesson, "--group", m_group, "--seed", "1", "-d", folder});
        QCOMPARE(outcome.status, 5);
        QVERIFY2(has(outcome.err, "refused: another variant has the same inputs"),
                 outcome.err.c_str());
        QVERIFY(!QDir(folder).exists());
    }

    void faultsAreNamedLineByLine() {
        json file = samples::lessonJsonOf();
        file["steps"][0]["points"] = -1;
        file["steps"][5]["inputs"][0]["path"] = "/x";
        const QString lesson = save("faults.sparkout-lesson", file.dump());
        const ProcessOutcome outcome = run({"course", "check", lesson});
        QCOMPARE(outcome.status, 1);
        QVERIFY(has(outcome.err, ": /steps/0/points: -1 is out of range"));
        const QString twice = save("twice.csv", "A\nB\nA\n");
        const ProcessOutcome list = run({"course", "variants", lessonPath(), "--group", twice,
                                         "--seed", "1", "-d", m_folder.filePath("none")});
        QCOMPARE(list.status, 1);
        QVERIFY2(has(list.err, "twice.csv:3: A: "), list.err.c_str());
        QCOMPARE(run({"course", "grade", lessonPath(), m_folder.filePath("no folder")}).status, 1);
        QCOMPARE(run({"course", "grade", lessonPath(), m_class, "--answers", twice}).status, 1);
    }

    void aLessonIsCheckedAsGiven() {
        const ProcessOutcome outcome = run({"course", "check", lessonPath(), "--json"});
        QCOMPARE(outcome.status, 0);
        const json steps = json::parse(outcome.out).at("steps");
        QCOMPARE(steps.size(), std::size_t{8});
        QVERIFY(steps[5].at("finding") == json("failed"));
        QVERIFY(steps[5].at("value").get<double>() > 2.3); // the spread of the zones [µm]
        QCOMPARE(lines(run({"course", "check", lessonPath()}).out), std::size_t{8});
    }

    void keptRunsThatAreNotTheEnginesAreNamed() {
        const QString example = examplePath("shaft-38-74h6");
        QCOMPARE(run({"course", "check", example}).status, 0);
        QVERIFY(!has(run({"simulate", example}).err, "kept run"));
        json file = json::parse(contentOf(example));
        file["runs"][0]["summary"]["cycle_time_min"] = 1.5;
        const QString edited = save("edited.sparkout", file.dump());
        const ProcessOutcome outcome = run({"course", "check", edited});
        QCOMPARE(outcome.status, 4);
        QVERIFY2(has(outcome.err, "kept run \"Factory\": 1 number is not the engine's: "
                                  "/cycle_time_min 1.5, by the engine 4.5"),
                 outcome.err.c_str());
        const json answer = json::parse(run({"course", "check", edited, "--json"}).out);
        const json& surface = answer.at("surfaces").at(0);
        QVERIFY(surface.at("kept_runs") == file["runs"].size());
        QVERIFY(surface.at("untrue_runs") == json::array({"Factory"}));
        const json whole = json::parse(run({"course", "check", example, "--json"}).out);
        QVERIFY(whole.at("surfaces").at(0).at("untrue_runs").empty());
        const ProcessOutcome simulated = run({"simulate", edited});
        QCOMPARE(simulated.status, 0);
        QVERIFY(has(simulated.err, "kept run \"Factory\""));
    }

private:
    [[nodiscard]] QString firstWork() const { return m_class + "/003-Smith_J_.sparkout-work"; }

    [[nodiscard]] QStringList variantsInto(const QString& folder) const {
        return {"course", "variants", lessonPath(), "--group", m_group,
                "--seed", "731902",   "-d",         folder};
    }

    /// A folder of works: one answered, the same edited outside the program, and one torn.
    QString handedIn() {
        Work work = readWork(contentOf(m_class + "/003-Smith_J_.sparkout-work")).work.value();
        Answer answer;
        answer.chosen = {{1}};
        WorkEntry entry;
        entry.when = "2026-11-26T10:00:00Z";
        entry.answer = answer;
        addEntry(work, entry);
        QDir(m_folder.path()).mkpath("marked");
        save("marked/smith.sparkout-work", writeWork(work));
        work.entries[0].when = "2026-11-26T09:00:00Z";
        save("marked/edited.sparkout-work", writeWork(work));
        save("marked/broken.sparkout-work", "no work");
        return m_folder.filePath("marked");
    }

    static void compareGrades(const XlsxReader& read, const QString& csv) {
        const QStringList table = csv.split('\n', Qt::SkipEmptyParts);
        QCOMPARE(read.frozen(0), QString("A2"));
        QCOMPARE(read.rows(0), int(table.size()));
        QCOMPARE(read.text(0, 0, 6), QString("step 1"));
        int numbers = 0;
        for (int row = 1; row < table.size(); ++row) {
            const QStringList cells = table[row].split(',');
            QCOMPARE(read.columns(0), int(cells.size()));
            for (int i = 0; i < cells.size(); ++i) {
                const bool isText = i < 6 && i != 3; // all but the variant
                if (cells[i].isEmpty()) {
                    QCOMPARE(read.type(0, row, i), QString());
                } else if (isText && i != 4) {
                    const bool isFormula = cells[i].startsWith('\'');
                    QCOMPARE(read.text(0, row, i), cells[i].mid(isFormula ? 1 : 0));
                    QCOMPARE(read.type(0, row, i), QString("s"));
                    QCOMPARE(read.quoted(0, row, i), isFormula);
                } else if (!isText) {
                    QCOMPARE(read.number(0, row, i), std::optional(cells[i].toDouble()));
                    ++numbers;
                }
            }
        }
        QVERIFY(numbers > 30);
        QVERIFY2(read.text(0, 2, 4).startsWith("edited outside the program"),
                 qPrintable(read.text(0, 2, 4)));
        QCOMPARE(read.text(0, 5, 1), QString("=1+1"));
    }

    static void compareSteps(const XlsxReader& read, const QString& printed) {
        QCOMPARE(read.frozen(1), QString("A2"));
        QCOMPARE(read.rows(1), 1 + 2 * 8);
        QStringList lines;
        for (int row = 1; row < read.rows(1); ++row) {
            QCOMPARE(read.text(1, row, 1), QString("Smith J."));
            lines << QString("  step %1  %2/%3  %4")
                         .arg(*read.number(1, row, 2))
                         .arg(*read.number(1, row, 3))
                         .arg(*read.number(1, row, 4))
                         .arg(read.text(1, row, 5));
        }
        QCOMPARE(lines, printed.split('\n').filter("  step "));
    }

    QString m_group, m_class;
};

} // namespace test_cli_course

SPARKOUT_TEST(test_cli_course, TestCliCourse)
#include "test_cli_course.moc"
