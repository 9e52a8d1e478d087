// SPDX-License-Identifier: GPL-3.0-or-later
// What others do to the files of the window: they change, remove, lock or forbid them.
#include "tests/registry.h"
#include "tests/ui/window/file_dialogs_bench.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/window/dialogs/examples_dialog.h"

namespace sparkout::test_file_dialogs_changed {

using namespace file_dialogs_bench;

/// Another program writes into the file of the window, which tells so.
[[nodiscard]] bool changedOnDisk(Bench& bench) {
    QTest::qWait(400);
    trouble::write(bench.path, textWith(35));
    return QTest::qWaitFor(
        [&] { return bench.window->files().notices().holds(QStringLiteral("disk")); });
}

class TestFileDialogsChanged : public QObject {
    Q_OBJECT

private slots:
    void damagedSettingsAreReportedAtTheNextStart_data() {
        addColumns<QString, QString>("language", "begins");
        QTest::newRow("en") << QStringLiteral("en") << QStringLiteral("The settings ");
        QTest::newRow("ru") << QStringLiteral("ru") << QStringLiteral("Файл настроек ");
    }

    void damagedSettingsAreReportedAtTheNextStart() {
        QFETCH(QString, language);
        QFETCH(QString, begins);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("settings.json"));
        trouble::write(file, "damaged");
        { const Settings settings(file); } // put aside at the end of a session, say
        Settings settings(file);
        Language words;
        words.apply(language);
        MainWindow window(settings, words);
        window.files().start({});
        const auto notice = [&window] {
            return window.files().notices().textOf(QStringLiteral("settings"));
        };
        QVERIFY2(notice().startsWith(begins), qPrintable(notice()));
        QVERIFY2(notice().contains(file + QStringLiteral(".damaged")), qPrintable(notice()));
        // A further one, found while the window is open.
        trouble::write(file, "damaged again");
        settings.setTheme(QStringLiteral("dark"));
        QVERIFY(!settings.flush());
        QTRY_VERIFY2(notice().contains(file + QStringLiteral(".damaged-2")), qPrintable(notice()));
        QCOMPARE(trouble::bytesOf(file + QStringLiteral(".damaged")), QByteArray("damaged"));
        // What could not be read again is refused, and said.
        settings.setHandout(QString(qsizetype(limits::settingsBytes), u'x'));
        QVERIFY2(notice().contains(language == u"ru" ? QStringLiteral("Настройки не сохранены")
                                                     : QStringLiteral("were not kept")),
                 qPrintable(notice()));
    }

    void aChangedFileIsOfferedForReloading() {
        OpenBench bench;
        QVERIFY(changedOnDisk(bench));
        NoticeBar& notices = bench.window->files().notices();
        QVERIFY(notices.isVisible());
        QTest::mouseClick(bench.noticeButton("disk", 0), Qt::LeftButton);
        QTRY_COMPARE(bench.diameter(), 35.0);
        QVERIFY(!bench.document().modified());
        QVERIFY(!notices.holds(QStringLiteral("disk")));
    }

    void reloadingInsteadOfSavingTakesTheNoticeAway() {
        EditedBench bench;
        QVERIFY(changedOnDisk(bench));
        NoticeBar& notices = bench.window->files().notices();
        DialogAnswers answers({QStringLiteral("reload")});
        QVERIFY(!bench.window->files().save());
        ANSWERED(answers);
        QVERIFY(!notices.holds(QStringLiteral("disk")));
    }

    void keepingOnesOwnVersionCountsAsUnsaved() {
        OpenBench bench;
        QVERIFY(changedOnDisk(bench));
        QTest::keyClick(bench.noticeButton("disk", 1), Qt::Key_Space);
        QTRY_VERIFY(bench.document().modified());
        QCOMPARE(bench.diameter(), 30.0);
    }

    void aFileThatIsRemovedCountsAsUnsaved() {
        OpenBench bench;
        QTest::qWait(400);
        QVERIFY(QFile::remove(bench.path));
        QTRY_VERIFY(bench.window->files().notices().holds(QStringLiteral("disk")));
        QVERIFY(bench.document().modified());
        DialogAnswers answers({QStringLiteral("proceed")});
        QTest::mouseClick(bench.noticeButton("disk", 0), Qt::LeftButton);
        QTRY_COMPARE(trouble::bytesOf(bench.path), textWith(30));
        ANSWERED(answers);
        QVERIFY(!bench.document().modified());
    }

    void aChangeUnderUnsavedEditsIsTold() {
        Bench bench(QStringLiteral("ru"));
        QVERIFY(bench.open());
        bench.edit(31);
        QVERIFY(changedOnDisk(bench));
        NoticeBar& notices = bench.window->files().notices();
        QCOMPARE(bench.diameter(), 31.0);
        const QString russian = notices.textOf(QStringLiteral("disk"));
        bench.language.apply(QStringLiteral("en"));
        QVERIFY(notices.textOf(QStringLiteral("disk")).contains(QStringLiteral("unsaved changes")));
        QVERIFY(notices.textOf(QStringLiteral("disk")) != russian);
        const auto shown = [&] {
            const auto* row = bench.window->findChild<QWidget*>(QStringLiteral("notice disk"));
            return row ? row->findChildren<QLabel*>().last()->text() : QString();
        };
        QTRY_VERIFY(shown().contains(QStringLiteral("unsaved changes")));
    }

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
        OpenBench bench;
        trouble::write(bench.other, "{}");
        DialogAnswers answers({QStringLiteral("Escape")});
        QVERIFY(!bench.window->files().openFile(bench.other));
        ANSWERED(answers);
        QVERIFY(!QFileInfo::exists(FileLock::lockPath(bench.other)));
        QVERIFY(QFileInfo::exists(bench.lock));
    }
};

} // namespace sparkout::test_file_dialogs_changed

SPARKOUT_TEST(test_file_dialogs_changed, TestFileDialogsChanged)
#include "test_file_dialogs_changed.moc"
