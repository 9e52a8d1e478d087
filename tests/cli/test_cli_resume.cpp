// SPDX-License-Identifier: GPL-3.0-or-later
// The full search of the real program, killed and gone on with.
#include "tests/cli/cli_process.h"
#include "tests/cli/search_samples.h"
#include "tests/registry.h"

#include <QElapsedTimer>
#include <QFile>
#include <QRandomGenerator>
#include <QTemporaryDir>

namespace test_cli_resume {

using namespace cli;

/// A grid whose full search takes some seconds.
json grid() {
    json file = shaft();
    file["optimisation"]["stock_step_mm"] = 0.005;
    file["optimisation"]["radial_feed_mm"] = {{"from", 0.002}, {"to", 0.008}, {"step", 0.00025}};
    file["optimisation"]["axial_feed_mm_min"] = {800, 1200, 1600, 2400};
    return file;
}

/// What the answer is, without what depends on the order of the threads.
json answerOf(const ProcessOutcome& outcome) {
    json answer = json::parse(outcome.out, nullptr, false);
    if (answer.is_object()) {
        answer.erase("visits");
        answer.erase("cut_by");
    }
    return answer;
}

json stateOf(const QString& file) {
    QFile state(file);
    return state.open(QIODevice::ReadOnly)
               ? json::parse(state.readAll().toStdString(), nullptr, false)
               : json();
}

long long evaluationsIn(const json& state) {
    const auto begun = state.is_object() ? state.find("begun") : state.end();
    return begun != state.end() && begun->is_object() ? begun->at("evaluations").get<long long>()
                                                      : 0;
}

class TestCliResume : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_project = m_folder.filePath("grid.sparkout");
        write(m_project, QByteArray::fromStdString(grid().dump()));
    }

    void killedAtAnyMomentItGivesTheSameAnswer() {
        QElapsedTimer timer;
        timer.start();
        const ProcessOutcome whole = run(command({}));
        QCOMPARE(whole.status, 0);
        const auto took_ms = static_cast<int>(timer.elapsed());
        const QString file = m_folder.filePath("progress.json");
        const int kills = sparkout::samples::sized(5, 2, 25);
        int gainedOn = 0, killed = 0;
        QRandomGenerator random(20261126);
        for (int i = 0; i < kills; ++i) {
            const long long before = evaluationsIn(stateOf(file));
            QProcess process;
            process.start(SPARKOUT_CLI, command({"--resume", file}));
            QVERIFY(process.waitForStarted());
            process.waitForFinished(100 + static_cast<int>(random.bounded(took_ms)));
            if (process.state() == QProcess::NotRunning) {
                QCOMPARE(process.exitCode(), 0);
                const ProcessOutcome done{0, process.readAllStandardOutput().toStdString(), {}};
                QVERIFY(answerOf(done) == answerOf(whole));
                QFile::remove(file); // from the beginning again
                continue;
            }
            endBySignal(process, SIGKILL);
            QVERIFY(process.waitForFinished());
            ++killed;
            const json state = stateOf(file);
            QVERIFY2(state.is_object(), "the file is cut off");
            QVERIFY(evaluationsIn(state) >= before);
            gainedOn += evaluationsIn(state) > before && before > 0;
        }
        const ProcessOutcome last = run(command({"--resume", file}));
        QCOMPARE(last.status, 0);
        QVERIFY(answerOf(last) == answerOf(whole));
        qInfo("killed %d times of %d, in %d of them behind what was done before", killed, kills,
              gainedOn);
        QVERIFY(killed > 0);
    }

    void stoppedByASignalItKeepsWhatWasDone() {
        const QString project = m_folder.filePath("endless.sparkout");
        write(project, QByteArray::fromStdString(endless().dump()));
        const QString file = m_folder.filePath("stopped.json");
        long long before = 0;
        for (const int signal : {SIGINT, SIGTERM}) { // the second goes on where the first ended
            QProcess process;
            process.setReadChannel(QProcess::StandardError);
            process.start(SPARKOUT_CLI,
                          {"optimize", project, "--method", "full", "--json", "--resume", file});
            QVERIFY(process.waitForReadyRead(60'000)); // its first progress
            endBySignal(process, signal);
            (void)outcomeOf(process);
            const long long now = evaluationsIn(stateOf(file));
            QVERIFY2(now > before, std::to_string(now).c_str());
            before = now;
        }
    }

    void whatIsOfSomethingElseIsRefusedAndStays_data() {
        addColumns<QStringList, QByteArray, bool>("options", "said", "other");
        addRow("options", QStringList{"--robust"}, QByteArray("other options"), false);
        addRow("stages", QStringList{"--stages", "1"}, QByteArray("other options"), false);
        addRow("project", QStringList{}, QByteArray("another project"), true);
    }

    void whatIsOfSomethingElseIsRefusedAndStays() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, said);
        QFETCH(bool, other);
        const QString file = m_folder.filePath("other.json"),
                      small = m_folder.filePath("s.sparkout");
        json changed = shaft();
        write(small, QByteArray::fromStdString(changed.dump()));
        QFile::remove(file);
        QCOMPARE(run({"optimize", small, "--method", "full", "--resume", file}).status, 0);
        const QByteArray kept = bytesIn(file);
        if (other) {
            changed["part"]["stock_mm"] = 0.13;
            write(small, QByteArray::fromStdString(changed.dump()));
        }
        const ProcessOutcome refused =
            run(QStringList{"optimize", small, "--method", "full", "--resume", file} + options);
        QCOMPARE(refused.status, 1);
        QVERIFY2(has(refused.err, said.toStdString()), refused.err.c_str());
        QCOMPARE(bytesIn(file), kept);
    }

    void aDamagedOrForeignFileIsRefusedAndStays() {
        const QString file = m_folder.filePath("damaged.json"),
                      small = m_folder.filePath("small.sparkout");
        write(small, QByteArray::fromStdString(shaft().dump()));
        const QStringList asked{"optimize", small, "--method", "full", "--resume", file};
        QCOMPARE(run(asked).status, 0);
        const QByteArray good = bytesIn(file);
        QByteArray changed = good;
        changed[changed.indexOf("\"evaluations\":") + 14] ^= 1;
        const auto answer = [&](const QByteArray& bytes) {
            write(file, bytes);
            const ProcessOutcome outcome = run(asked);
            const bool stays = bytesIn(file) == bytes;
            return outcome.status == 1 && stays ? outcome.err : "taken: " + outcome.text();
        };
        for (const QByteArray& damaged : {changed, good.left(good.size() / 2)}) {
            const std::string said = answer(damaged);
            QVERIFY2(has(said, "damaged"), said.c_str());
        }
        const std::string foreign = answer("my notes\n");
        QVERIFY2(has(foreign, "is not the progress of a search"), foreign.c_str());
        QByteArray build = good;
        const auto at = build.indexOf("\"engine\":\"") + 10;
        build.replace(at, 4, "0000"); // with a checksum that does not fit any more
        const std::string said = answer(build);
        QVERIFY2(has(said, "damaged"), said.c_str());
        write(file, good);
        QCOMPARE(run(asked).status, 0);
    }

    void whatMakesNoSenseIsAUsageError() {
        const QString file = m_folder.filePath("p.json");
        QCOMPARE(run({"optimize", m_project, "--resume", file}).status, 2);
        QCOMPARE(run({"optimize", m_project, "--method", "full", "--resume"}).status, 2);
        QCOMPARE(run({"optimize", m_project, "--method", "full", "--resume", m_project}).status, 2);
        QVERIFY(!QFile::exists(file));
        const ProcessOutcome nowhere = run({"optimize", m_project, "--method", "full", "--resume",
                                            m_folder.filePath("no/folder/p.json")});
        QCOMPARE(nowhere.status, 1); // before the search, not after it
        QVERIFY(!nowhere.err.empty());
    }

private:
    QStringList command(const QStringList& options) const {
        return QStringList{"optimize", m_project, "--method", "full", "--json"} + options;
    }
    static void write(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    static QByteArray bytesIn(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_folder;
    QString m_project;
};

} // namespace test_cli_resume

SPARKOUT_TEST(test_cli_resume, TestCliResume)
#include "test_cli_resume.moc"
