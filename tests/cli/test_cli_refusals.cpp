// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line refuses, and in which words: usage, unreadable and faulty files.
#include "core/file/safe_file.h"
#include "core/project/batch.h"
#include "core/version.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <sys/stat.h>
#include <unistd.h>

namespace test_cli_refusals {

using namespace sparkout;
using namespace cli;

class TestCliRefusals : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void usageErrors_data() {
        QTest::addColumn<QStringList>("arguments");
        addRow("empty", QStringList{""});
        addRow("no file", QStringList{"simulate"});
        addRow("no file to validate", QStringList{"validate"});
        addRow("no folder", QStringList{"examples"});
        addRow("no trace file", QStringList{"simulate", "a", "--trace"});
        addRow("empty trace file", QStringList{"simulate", "a", "--trace", ""});
    }

    void usageErrors() {
        QFETCH(QStringList, arguments);
        const ProcessOutcome outcome = run(arguments);
        QVERIFY2(isUsageError(outcome), outcome.text().c_str());
    }

    void helpAndVersionSucceed() {
        const ProcessOutcome help = run({"--help"});
        QCOMPARE(help.status, 0);
        for (const char* word : {"simulate", "validate", "examples", "--trace", "Exit status"}) {
            QVERIFY2(has(help.out, word), word);
        }
        QCOMPARE(run({"--version"}).out, "sparkout-cli " + std::string(version) + "\n");
    }

    void validFilesPass_data() {
        QTest::addColumn<QString>("file");
        for (const std::string& name : samples::names()) {
            addRow(name.c_str(), samplePath(name));
        }
    }

    void validFilesPass() {
        QFETCH(QString, file);
        const ProcessOutcome outcome = run({"validate", file});
        const ReadResult read = readProject(samples::readText(file.toStdString()));
        QCOMPARE(outcome.status, batchFaults(*read.project).empty() ? 0 : 1);
        QVERIFY(outcome.out.empty());
        QCOMPARE(lines(outcome.err), read.issues.size());
    }

    void aFileThatIsNoProjectIsSaidToBeNone() {
        const ProcessOutcome picture = run({"validate", save("a.png", "\x89PNG\r\n\x1a\n")});
        QCOMPARE(picture.status, 1);
        QVERIFY2(has(picture.err, "this is not a Sparkout project: the text is not valid JSON"),
                 picture.err.c_str());
        const ProcessOutcome slip = run({"validate", save("slip.sparkout", "{\n  \"part\": }")});
        QVERIFY2(has(slip.err, "slip.sparkout: the text is not valid JSON in UTF-8: line 2"),
                 slip.err.c_str());
    }

    void refusedFileNamesPathValueAndRange() {
        json file = samples::sample("smallest-plunge");
        file["wheel"]["width_mm"] = 2000;
        file["part"]["profile"] = "square";
        file["machine"].erase("work_speed_rpm");
        const QString path = save("three.sparkout", file.dump());
        for (const char* command : {"validate", "simulate"}) {
            const ProcessOutcome outcome = run({command, path});
            QCOMPARE(outcome.status, 1);
            QVERIFY(outcome.out.empty());
            QCOMPARE(lines(outcome.err), std::size_t{3});
            for (const char* expected :
                 {": /wheel/width_mm: 2000 mm is out of range; allowed: 0.5…1000 mm\n",
                  ": /part/profile: \"square\" is not one of the choices; allowed: \"ellipse\", "
                  "\"eccentric\", \"lobes\", \"measured\"\n",
                  ": /machine/work_speed_rpm: value missing; allowed: 0.1…10000 "
                  "rev/min\n"}) {
                QVERIFY2(has(outcome.err, path.toStdString() + expected), outcome.err.c_str());
            }
        }
    }

    void unreadableFilesExit1_data() {
        QTest::addColumn<QString>("file");
        addRow("missing", m_folder.filePath("no such file"));
        addRow("no such folder", m_folder.filePath("no/such/file"));
        addRow("directory", m_folder.path());
        addRow("device", "/dev/null");
        addRow("endless device", "/dev/zero");
        addRow("name too long", m_folder.filePath(QString(300, 'x')));
        addRow("a dash", "-");
        const QString fifo = m_folder.filePath("fifo");
        mkfifo(fifo.toUtf8(), 0600);
        addRow("FIFO", fifo);
        if (geteuid() != 0) {
            const QString locked = save("locked.sparkout", "{}");
            chmod(locked.toUtf8(), 0);
            addRow("not permitted", locked);
        }
    }

    void unreadableFilesExit1() {
        QFETCH(QString, file);
        for (const char* command : {"validate", "simulate"}) {
            const ProcessOutcome outcome = run({command, file});
            QCOMPARE(outcome.status, 1);
            QCOMPARE(lines(outcome.err), std::size_t{1});
            QVERIFY2(outcome.err.starts_with(file.toStdString() + ": "), outcome.err.c_str());
        }
    }

    void hostileFilesAreRefusedLineByLine_data() {
        QTest::addColumn<QString>("file");
        for (const auto& entry :
             std::filesystem::directory_iterator(samples::sourcePath("tests/data/hostile"))) {
            addRow(entry.path().filename().c_str(), QString::fromStdString(entry.path()));
        }
        addRow("10 MB of [", save("nested.sparkout", std::string(10'000'000, '[')));
        addRow("32 MB + 1", save("large.sparkout", std::string(limits::fileBytes + 1, ' ')));
    }

    void hostileFilesAreRefusedLineByLine() {
        QFETCH(QString, file);
        const ProcessOutcome outcome = run({"validate", file});
        const std::string content = samples::readText(file.toStdString());
        const bool accepted = file.contains("/accepted");
        QCOMPARE(outcome.status, accepted ? 0 : 1);
        const bool tooLarge = content.size() > limits::fileBytes;
        QCOMPARE(lines(outcome.err), tooLarge ? 1 : readProject(content).issues.size());
        for (const std::string& line : split(outcome.err, '\n')) {
            QVERIFY2(line.starts_with(file.toStdString() + ": "), line.c_str());
            QVERIFY2(std::none_of(line.begin(), line.end(),
                                  [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
                     line.c_str());
            QVERIFY2(!has(line, "\u202e"), line.c_str());
        }
    }

    void aFloodOfFaultsIsCutAndSaysSo() {
        json file = samples::sample("smallest-plunge");
        for (int i = 0; i < 5000; ++i) {
            file["k" + std::to_string(i)] = i;
        }
        const ProcessOutcome outcome = run({"validate", save("flood.sparkout", file.dump())});
        QCOMPARE(outcome.status, 1);
        QCOMPARE(lines(outcome.err), limits::issues + 1);
        QVERIFY(outcome.err.ends_with("no further faults are listed\n"));
    }
};

} // namespace test_cli_refusals

SPARKOUT_TEST(test_cli_refusals, TestCliRefusals)
#include "test_cli_refusals.moc"
