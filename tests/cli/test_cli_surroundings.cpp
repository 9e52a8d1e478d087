// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Whatever the program is called with and wherever: outputs, environments, folders, arguments.
#include "tests/check_line.h"
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

#include <QDir>
#include <QFile>

#include <map>
#include <random>

#include <sys/stat.h>

namespace test_cli_surroundings {

using namespace sparkout;
using namespace cli;

class TestCliSurroundings : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void outputThatIsNotTakenExits1() {
        QProcess full;
        full.setStandardOutputFile("/dev/full");
        full.start(SPARKOUT_CLI, {"simulate", samplePath("complete"), "--json"});
        const ProcessOutcome outcome = outcomeOf(full);
        QCOMPARE(outcome.status, 1);
        QVERIFY(has(outcome.err, "standard output cannot be written"));
        // A closed pipe: the reader is gone before the program starts.
        const QString status = m_folder.filePath("status");
        QProcess shell;
        shell.start("/bin/sh",
                    {"-c", R"({ sleep 0.3; "$0" simulate "$1" --json; echo $? >"$2"; } | :)",
                     SPARKOUT_CLI, samplePath("complete"), status});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(samples::readText(status.toStdString()), std::string("1\n"));
    }

    void environmentChangesNothing_data() {
        QTest::addColumn<QStringList>("environment");
        QTest::newRow("ru_RU") << QStringList{"LC_ALL=ru_RU.UTF-8", "LANG=ru_RU.UTF-8"};
        QTest::newRow("de_DE") << QStringList{"LC_ALL=de_DE.UTF-8"};
        QTest::newRow("tr_TR") << QStringList{"LC_ALL=tr_TR.UTF-8"};
        QTest::newRow("ar_EG") << QStringList{"LC_ALL=ar_EG.UTF-8"};
        QTest::newRow("C") << QStringList{"LC_ALL=C"};
        QTest::newRow("next to nothing") << QStringList{"X=1"};
        QTest::newRow("no HOME, odd TZ")
            << QStringList{"HOME=/nonexistent", "TZ=Asia/Kathmandu", "TMPDIR=/nonexistent"};
    }

    void environmentChangesNothing() {
        QFETCH(QStringList, environment);
        const QString bad =
            QString::fromStdString(samples::sourcePath("tests/data/hostile/many-faults.sparkout"));
        const QString here = m_folder.filePath("here.csv");
        const QString there = m_folder.filePath("there.csv");
        for (QStringList arguments : {QStringList{"simulate", samplePath("complete"), "--json"},
                                      QStringList{"simulate", samplePath("internal-plunge")},
                                      QStringList{"validate", bad}}) {
            QCOMPARE(run(arguments, environment).text(), run(arguments).text());
        }
        run({"simulate", samplePath("smallest-plunge"), "--trace", here});
        run({"simulate", samplePath("smallest-plunge"), "--trace", there}, environment);
        QVERIFY(samples::readText(here.toStdString()) == samples::readText(there.toStdString()));
    }

    void examplesAreWrittenAndRun() {
        const QString folder = m_folder.filePath("examples");
        const ProcessOutcome outcome = run({"examples", folder});
        QCOMPARE(outcome.status, 0);
        std::size_t shipped = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(
                 samples::sourcePath("resources/examples"))) {
            if (entry.path().extension() != ".sparkout") {
                continue;
            }
            ++shipped;
            const QString file = folder + '/' + QString::fromStdString(entry.path().filename());
            QCOMPARE(samples::readText(file.toStdString()), samples::readText(entry.path()));
            const ProcessOutcome valid = run({"validate", file});
            QVERIFY2(valid.status == 0, valid.err.c_str());
            const ProcessOutcome simulated = run({"simulate", file});
            QVERIFY2(simulated.status == 0, simulated.err.c_str());
        }
        QCOMPARE(lines(outcome.out), shipped);
        QVERIFY(shipped > 0);
        QCOMPARE(run({"examples", m_folder.filePath("no/such/folder")}).status, 1);
        QCOMPARE(run({"examples", samplePath("complete")}).status, 1);
    }

    void examplesThatWereEditedAreNotReplaced() {
        const QString folder = m_folder.filePath("edited");
        QCOMPARE(run({"examples", folder}).status, 0);
        const ProcessOutcome again = run({"examples", folder});
        QVERIFY2(again.status == 0 && again.out.empty() && again.err.empty(), again.text().c_str());
        const QStringList names = QDir(folder).entryList(QDir::Files);
        const QString edited = folder + '/' + names.at(names.size() / 2);
        const std::string shipped = samples::readText(edited.toStdString());
        std::ofstream(edited.toStdString()) << "mine";
        QVERIFY(QFile::remove(folder + '/' + names.front()));
        const ProcessOutcome kept = run({"examples", folder});
        QCOMPARE(kept.status, 1);
        QVERIFY2(has(kept.err, edited.toStdString()) && has(kept.err, "--force")
                     && lines(kept.err) == 2,
                 kept.err.c_str());
        QCOMPARE(samples::readText(edited.toStdString()), std::string("mine"));
        QVERIFY(!QFile::exists(folder + '/' + names.front()));
        const ProcessOutcome forced = run({"examples", folder, "--force"});
        QCOMPARE(forced.status, 0);
        QCOMPARE(lines(forced.out), std::size_t{2});
        QCOMPARE(samples::readText(edited.toStdString()), shipped);
        QVERIFY(QFile::exists(folder + '/' + names.front()));
        QVERIFY(isUsageError(run({"validate", edited, "--force"})));
    }

    /// To open a pipe is to wait for who writes into it.
    void whatIsNoOrdinaryFileIsRefusedAtOnce() {
        const QString pipe = m_folder.filePath("pipe.sparkout");
        QCOMPARE(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
        const QString complete = samplePath("complete");
        for (const QStringList& arguments :
             {QStringList{"validate", pipe}, QStringList{"simulate", pipe},
              QStringList{"optimize", pipe}, QStringList{"sweep", pipe}, QStringList{"batch", pipe},
              QStringList{"batch-merge", pipe}, QStringList{"batch", complete, "--measured", pipe},
              QStringList{"validate", "/dev/zero"}, QStringList{"batch-merge", "/dev/zero"}}) {
            const ProcessOutcome outcome = run(arguments);
            QVERIFY2(outcome.status == 1,
                     (arguments.join(' ').toStdString() + outcome.text()).c_str());
        }
        std::filesystem::remove(pipe.toStdString());
    }

    void noFileNameSteersTheTerminal() {
        const QByteArray name = QByteArray("a\x1b[31m\nb\xc2\x9b\xe0x\x1b\xe2\x80\xae.sparkout");
        for (const char* command : {"validate", "simulate", "optimize", "sweep", "batch-merge"}) {
            for (const std::string& text : {std::string(), std::string("{}")}) {
                const QString file =
                    m_folder.filePath(QString::fromLatin1(command)) + QString::number(text.size());
                QVERIFY(QDir().mkpath(file));
                const std::string path = file.toStdString() + '/' + name.toStdString();
                if (!text.empty()) {
                    std::ofstream(path) << text;
                }
                QProcess process; // the name is no UTF-8: a shell passes it on
                process.start("sh",
                              {"-c", QString("\"%1\" %2 '%3/'\"$(printf "
                                             "'a\\033[31m\\nb\\302\\233\\340x\\033\\342\\200\\256."
                                             "sparkout')\"")
                                         .arg(SPARKOUT_CLI, command, file)});
                const ProcessOutcome outcome = outcomeOf(process);
                QVERIFY2(outcome.status == 1, outcome.text().c_str());
                QVERIFY2(has(outcome.err, "\\u001B[31m\\u000Ab\\u009B\\xE0x\\u001B\\u202E"),
                         outcome.err.c_str());
                QVERIFY(!has(outcome.err, "\x1b"));
                std::filesystem::remove_all(file.toStdString()); // Qt cannot remove that name
            }
        }
    }

    void randomArgumentsEndInADocumentedStatus() {
        std::map<QString, std::string> projects; // copies: whatever is done to them shows
        for (const char* name : {"smallest-plunge", "complete", "internal-plunge"}) {
            const std::string text = samples::readText(samplePath(name).toStdString());
            projects[save(QString("random-%1.sparkout").arg(name), text)] = text;
        }
        const auto copy = [this](const char* name) {
            return m_folder.filePath(QString("random-%1.sparkout").arg(name));
        };
        QStringList words =
            QString(
                "simulate|simulate|simulate|validate|validate|examples|batch|batch-merge|"
                "--json|--json|--csv|--shard|1/2|--measured|--scenarios|corners|--check|"
                "--trace|--help|--version|-|--|-o|--parts|| |.|..|/dev/null|Ж|磨🛠|\x01\x02|"
                "%s%n|-1")
                .split('|');
        words += QStringList{
            QString(5000, 'x'),
            "a b",
            "$(id)",
            copy("smallest-plunge"),
            copy("smallest-plunge"),
            copy("complete"),
            copy("internal-plunge"),
            m_stuck,
            m_strict,
            m_folder.path(),
            m_folder.filePath("out.csv"),
            QString::fromStdString(samples::sourcePath("tests/data/hostile/truncated.sparkout"))};
        std::mt19937 random(20250101);
        std::map<int, int> statuses;
        const int jobs = samples::sized(1000, 100, 10'000);
        for (int i = 0; i < jobs; ++i) {
            QStringList arguments;
            if (random() % 2 == 0) { // half of them begin well
                arguments << words[static_cast<qsizetype>(random() % 8)]
                          << words[words.size() - 1 - static_cast<qsizetype>(random() % 9)];
            }
            for (unsigned n = random() % 4; n > 0; --n) {
                arguments << words[static_cast<qsizetype>(random()
                                                          % static_cast<unsigned>(words.size()))];
            }
            QProcess process;
            process.setWorkingDirectory(m_folder.path());
            process.setStandardInputFile(QProcess::nullDevice());
            process.start(SPARKOUT_CLI, arguments);
            const ProcessOutcome outcome = outcomeOf(process);
            QVERIFY2(outcome.status >= 0 && outcome.status <= 4, qPrintable(arguments.join('|')));
            QVERIFY2(outcome.status == 0 || outcome.status == 4 || !outcome.err.empty(),
                     qPrintable(arguments.join('|')));
            QVERIFY2(outcome.status != 2 || outcome.out.empty(), qPrintable(arguments.join('|')));
            ++statuses[outcome.status];
        }
        for (const auto& [path, text] : projects) {
            QCOMPARE(samples::readText(path.toStdString()), text);
        }
        checkLine("28", jobs, asked(1000, jobs), jobs >= asked(1000, jobs),
                  QStringLiteral("random command lines: done %1, refused %2, usage %3, no size %4, "
                                 "cannot be done %5; none killed, no file changed")
                      .arg(statuses[0])
                      .arg(statuses[1])
                      .arg(statuses[2])
                      .arg(statuses[3])
                      .arg(statuses[4]));
    }

private:
    const QString m_stuck = save("stuck.sparkout", stuckProject().dump());
    const QString m_strict = save("strict.sparkout", strictProject().dump());
};

} // namespace test_cli_surroundings

SPARKOUT_TEST(test_cli_surroundings, TestCliSurroundings)
#include "test_cli_surroundings.moc"
