// SPDX-License-Identifier: GPL-3.0-or-later
// Checks 4 and 25: random edits, runs, saves, undos and redos. All of it undone is the beginning,
// all of it redone the end, step by step; and what is saved opens as the same.
#include "core/study/operation.h"
#include "core/study/outcome.h"
#include "ui/session/document.h"
#include "ui/text/file_error_text.h"

#include "tests/check_line.h"
#include "tests/core/support/project_mutator.h"
#include "tests/registry.h"

#include <QCryptographicHash>
#include <QTemporaryDir>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace sparkout::test_edit_sequences {

constexpr int commands = 100;

QByteArray hashOf(const Document& document) {
    const std::string text = writeProject(document.project());
    return QCryptographicHash::hash({text.data(), qsizetype(text.size())},
                                    QCryptographicHash::Sha256);
}

/// One command after the other, as a user might give them in no order at all.
class Sequence {
public:
    explicit Sequence(std::uint64_t seed)
        : m_pick(samples::fromSeed(seed)), m_mutator(samples::fromSeed(seed + 1)) {
        const auto names = samples::names();
        const std::string& name = names[seed % names.size()];
        document.startUntitled(readProject(samples::text(name)).project.value());
    }

    void command() {
        switch (m_pick(12)) {
        case 0:
        case 1: document.undo(); break;
        case 2: document.redo(); break;
        case 3: document.endMerge(); break;
        case 4: turn(); break;
        case 5: run(); break;
        case 6: save(); break;
        default: edit(); break;
        }
    }

    Document document;
    int runs = 0, failedRuns = 0, saves = 0;

private:
    void edit() {
        Project project = document.project();
        m_mutator.mutate(project, 1 + m_pick(3));
        const bool typed = m_pick(2) == 0; // merges with the edit before it
        document.edit(std::move(project), {"Input", "Notes"},
                      typed ? QStringLiteral("/notes") : QString());
    }
    void turn() {
        const bool plunge = document.project().operation == Operation::plunge;
        const Operation other = plunge ? Operation::traverse : Operation::plunge;
        document.edit(withOperation(document.project(), other, document.lastWith(other)), {});
    }
    /// A run changes nothing, whatever comes of it: some inputs are refused, some ask for minutes.
    void run() {
        const QByteArray before = hashOf(document);
        std::stop_source stop;
        const std::jthread clock([&stop](const std::stop_token& ended) {
            std::mutex mutex;
            std::unique_lock lock(mutex);
            std::condition_variable_any never;
            never.wait_for(lock, ended, std::chrono::milliseconds(100), [] { return false; });
            stop.request_stop();
        });
        const OutcomePtr outcome = evaluate(document.project(), stop.get_token());
        ++runs;
        failedRuns += !outcome || !outcome->ran();
        QCOMPARE(hashOf(document), before);
    }
    void save() {
        const QString path = m_folder.filePath(QStringLiteral("saved.sparkout"));
        const auto error = document.saveAs(path);
        if (error) {
            const ReadResult read = readProject(writeProject(document.project()));
            QFAIL((saveErrorText(*error).toStdString() + samples::listed(read.issues)).c_str());
        }
        Document again;
        QVERIFY(again.open(path).opened());
        QCOMPARE(hashOf(again), hashOf(document));
        QVERIFY(!document.modified());
        ++saves;
    }

    QTemporaryDir m_folder;
    decltype(samples::fromSeed(0)) m_pick;
    samples::Mutator<decltype(samples::fromSeed(0))> m_mutator;
};

class TestEditSequences : public QObject {
    Q_OBJECT

private slots:
    void allUndoneIsTheBeginningAndAllRedoneTheEnd() {
        const int sequences = samples::sized(15, 4, 1000);
        int steps = 0, runs = 0, failedRuns = 0, saves = 0;
        for (int seed = 0; seed < sequences; ++seed) {
            Sequence sequence(static_cast<std::uint64_t>(seed));
            Document& document = sequence.document;
            const QByteArray first = hashOf(document);
            for (int i = 0; i < commands; ++i) {
                sequence.command();
                if (QTest::currentTestFailed()) {
                    qWarning("sequence %d, command %d", seed, i);
                    return;
                }
            }
            while (document.canRedo()) {
                document.redo();
            }
            std::vector<QByteArray> states{hashOf(document)};
            while (document.canUndo()) {
                document.undo();
                states.push_back(hashOf(document));
            }
            QCOMPARE(states.back(), first);
            for (std::size_t i = states.size() - 1; i-- > 0;) {
                QVERIFY(document.canRedo());
                document.redo();
                QCOMPARE(hashOf(document), states[i]);
            }
            QVERIFY(!document.canRedo());
            steps += static_cast<int>(states.size()) - 1;
            runs += sequence.runs;
            failedRuns += sequence.failedRuns;
            saves += sequence.saves;
        }
        qInfo("%d sequences of %d commands: %d steps undone and redone, %d saves, %d runs, %d of "
              "them without a result; hashes equal both ways",
              sequences, commands, steps, saves, runs, failedRuns);
        checkLine("04", sequences, asked(1000, sequences),
                  sequences >= asked(1000, sequences) && saves > sequences && failedRuns > 0,
                  QStringLiteral("random sequences of %1 edits, runs (%2, %3 of them without a "
                                 "result), undos and saves: %4 saves opened as the same")
                      .arg(commands)
                      .arg(runs)
                      .arg(failedRuns)
                      .arg(saves));
        checkLine(
            "25", sequences, asked(100, sequences), sequences >= asked(100, sequences),
            QStringLiteral("sequences of %1 commands: %2 steps all undone and all redone, the "
                           "same hash at each, both ways")
                .arg(commands)
                .arg(steps));
        QVERIFY(steps > 15 * sequences && saves > sequences && failedRuns > 0 && failedRuns < runs);
    }
};

} // namespace sparkout::test_edit_sequences

SPARKOUT_TEST(test_edit_sequences, TestEditSequences)
#include "test_edit_sequences.moc"
