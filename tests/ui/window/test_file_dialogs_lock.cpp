// SPDX-License-Identifier: GPL-3.0-or-later
// Files that somebody else has open, or that cannot be written: what the window asks and shows.
#include "tests/registry.h"
#include "tests/ui/window/file_dialogs_bench.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/window/dialogs/examples_dialog.h"

namespace sparkout::test_file_dialogs_lock {

using namespace file_dialogs_bench;

class TestFileDialogsLock : public QObject {
    Q_OBJECT

private slots:
    void theSecondOpenerIsToldAndCanRead_data() {
        QTest::addColumn<QString>("answer");
        for (const char* name : {"readOnly", "copy", "takeOver", "Escape", "Enter"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void theSecondOpenerIsToldAndCanRead() {
        QFETCH(QString, answer);
        Bench bench;
        FileLock other;
        QCOMPARE(other.acquire(bench.path), FileLock::State::held);
        DialogAnswers answers({answer});
        const bool opened = bench.open();
        ANSWERED(answers);
        const QString text = answers.text();
        QVERIFY2(text.contains(bench.path) && text.contains(QSysInfo::machineHostName())
                     && text.contains(other.holder().user)
                     && text.contains(QString::number(QCoreApplication::applicationPid())),
                 qPrintable(text));
        QCOMPARE(opened, answer != u"Escape");
        const bool readOnly = answer == u"readOnly" || answer == u"Enter";
        QCOMPARE(bench.document().readOnly(), readOnly);
        QCOMPARE(bench.document().filePath().isEmpty(), answer == u"copy" || answer == u"Escape");
        QCOMPARE(other.stillOurs(), answer != u"takeOver");
        QCOMPARE(bench.window->windowTitle().contains(QStringLiteral("read-only")), readOnly);
        QCOMPARE(bench.window->files().notices().holds(QStringLiteral("readOnly")), readOnly);
        QVERIFY(QFileInfo::exists(bench.lock));
    }

    void savingAReadOnlyDocumentAsksForAnotherName() {
        Bench bench;
        trouble::setMode(bench.path, 0444);
        QVERIFY(bench.open());
        QVERIFY(bench.document().readOnly());
        bench.edit(31);
        DialogAnswers answers({QStringLiteral("file:") + bench.other});
        QVERIFY(bench.window->files().save());
        ANSWERED(answers);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(30));
        QCOMPARE(trouble::bytesOf(bench.other), textWith(31));
        QVERIFY(!bench.document().readOnly());
        QVERIFY(!bench.window->windowTitle().contains(QStringLiteral("read-only")));
        QVERIFY(!bench.window->files().notices().holds(QStringLiteral("readOnly")));
        QVERIFY(QFileInfo::exists(FileLock::lockPath(bench.other)));
    }

    void aLockWithoutSenseCanBeTakenOver() {
        Bench bench;
        trouble::write(bench.lock, "garbage");
        DialogAnswers answers({QStringLiteral("takeOver")});
        QVERIFY(bench.open());
        ANSWERED(answers);
        QVERIFY(answers.text().contains(QStringLiteral("cannot be read")));
        QVERIFY(!bench.document().readOnly());
    }

    void anExampleOfTheShippedOnesLeavesNoLock() {
        Bench bench;
        const QByteArray example = ExamplesDialog::textOf(ExamplesDialog::paths().first());
        trouble::write(bench.path, example);
        QVERIFY(bench.open());
        QVERIFY(!QFileInfo::exists(bench.lock));
        bench.edit(31);
        QVERIFY(bench.window->files().save());
        QVERIFY2(QFileInfo::exists(bench.lock), "once it is saved to it is a file like others");
    }

    void aRefusedFileLeavesNoLockAndKeepsTheOneOfTheDocument() {
        Bench bench;
        QVERIFY(bench.open());
        trouble::write(bench.other, "{}");
        DialogAnswers answers({QStringLiteral("Escape")});
        QVERIFY(!bench.window->files().openFile(bench.other));
        ANSWERED(answers);
        QVERIFY(!QFileInfo::exists(FileLock::lockPath(bench.other)));
        QVERIFY(QFileInfo::exists(bench.lock));
    }
};

} // namespace sparkout::test_file_dialogs_lock

SPARKOUT_TEST(test_file_dialogs_lock, TestFileDialogsLock)
#include "test_file_dialogs_lock.moc"
