// SPDX-License-Identifier: GPL-3.0-or-later
// The window's questions when files are opened and saved, answered with real clicks and keys.
#include "tests/ui/file_bench.h"

#include <QLabel>
#include <QRegularExpression>
#include <QStyleFactory>

#include <clocale>

using namespace filebench;

class TestFileDialogs : public QObject {
    Q_OBJECT

private slots:
    void theUnsavedQuestionNamesTheFileAndTheEdits() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        DialogAnswers answers({QStringLiteral("Escape")});
        bench.window->files().startNew(Operation::plunge);
        ANSWERED(answers);
        QVERIFY2(answers.text().contains(bench.path), qPrintable(answers.text()));
        QVERIFY2(answers.text().contains(QStringLiteral("• Diameter")), qPrintable(answers.text()));
        QCOMPARE(bench.diameter(), 31.0);
        QVERIFY(bench.document().modified());
    }

    void enterSavesBeforeSomethingElseIsOpened() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        DialogAnswers answers({QStringLiteral("Enter")});
        bench.window->files().startNew(Operation::plunge);
        ANSWERED(answers);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QVERIFY(bench.document().filePath().isEmpty());
        QVERIFY2(!QFileInfo::exists(bench.lock), "a new project needs no lock");
        QVERIFY(
            trouble::entries(bench.state.path() + QStringLiteral("/recovery/discarded")).isEmpty());
    }

    void changesGivenUpOnClosingStayAmongTheDiscardedOnes() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        DialogAnswers answers({QStringLiteral("discard")});
        QVERIFY(bench.window->close());
        ANSWERED(answers);
        bench.window.reset();
        QCOMPARE(trouble::bytesOf(bench.path), textWith(30));
        QVERIFY2(!QFileInfo::exists(bench.lock), "the lock goes with the window");
        const RecoveryStore store(bench.state.path());
        QVERIFY(store.left().empty());
        QCOMPARE(store.discarded().size(), std::size_t{1});
    }

    void aWindowThatStaysBecauseOfEscapeKeepsEverything() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        DialogAnswers answers({QStringLiteral("Escape")});
        QVERIFY(!bench.window->close());
        ANSWERED(answers);
        QVERIFY(QFileInfo::exists(bench.lock));
        QTRY_VERIFY(!bench.window->files().guard().autosave()->file().isEmpty());
        DialogAnswers end({QStringLiteral("discard")});
        bench.window->close();
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

    void aLockWithoutSenseCanBeTakenOver() {
        Bench bench;
        trouble::write(bench.lock, "garbage");
        DialogAnswers answers({QStringLiteral("takeOver")});
        QVERIFY(bench.open());
        ANSWERED(answers);
        QVERIFY(answers.text().contains(QStringLiteral("cannot be understood")));
        QVERIFY(!bench.document().readOnly());
    }

    void whatAnotherProgramWroteIsNotSavedOverUnasked_data() {
        QTest::addColumn<QString>("answer");
        for (const char* name : {"proceed", "elsewhere", "reload", "Escape"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void whatAnotherProgramWroteIsNotSavedOverUnasked() {
        QFETCH(QString, answer);
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        trouble::write(bench.path, textWith(35));
        QStringList list{answer};
        if (answer == u"elsewhere") {
            list += QStringLiteral("file:") + bench.other;
        }
        DialogAnswers answers(list);
        const bool saved = bench.window->files().save();
        ANSWERED(answers);
        QVERIFY(answers.text().contains(bench.path));
        QCOMPARE(saved, answer == u"proceed" || answer == u"elsewhere");
        QCOMPARE(trouble::bytesOf(bench.path), textWith(answer == u"proceed" ? 31 : 35));
        if (answer == u"proceed") {
            QCOMPARE(trouble::bytesOf(bench.path + QStringLiteral(".bak")), textWith(35));
        } else if (answer == u"elsewhere") {
            QCOMPARE(trouble::bytesOf(bench.other), textWith(31));
        } else if (answer == u"reload") {
            QCOMPARE(bench.diameter(), 35.0);
            QVERIFY(!bench.document().modified());
            bench.document().undo();
            QCOMPARE(bench.diameter(), 31.0);
        } else {
            QCOMPARE(bench.diameter(), 31.0);
            QVERIFY(bench.document().modified());
        }
    }

    void aChangedFileIsOfferedForReloading() {
        Bench bench;
        QVERIFY(bench.open());
        QTest::qWait(400);
        trouble::write(bench.path, textWith(35));
        NoticeBar& notices = bench.window->files().notices();
        QTRY_VERIFY(notices.holds(QStringLiteral("disk")));
        QVERIFY(notices.isVisible());
        QTest::mouseClick(bench.noticeButton("disk", 0), Qt::LeftButton);
        QTRY_COMPARE(bench.diameter(), 35.0);
        QVERIFY(!bench.document().modified());
        QVERIFY(!notices.holds(QStringLiteral("disk")));
    }

    void keepingOnesOwnVersionCountsAsUnsaved() {
        Bench bench;
        QVERIFY(bench.open());
        QTest::qWait(400);
        trouble::write(bench.path, textWith(35));
        NoticeBar& notices = bench.window->files().notices();
        QTRY_VERIFY(notices.holds(QStringLiteral("disk")));
        QTest::keyClick(bench.noticeButton("disk", 1), Qt::Key_Space);
        QTRY_VERIFY(bench.document().modified());
        QCOMPARE(bench.diameter(), 30.0);
    }

    void aFileThatIsRemovedCountsAsUnsaved() {
        Bench bench;
        QVERIFY(bench.open());
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
        QTest::qWait(400);
        trouble::write(bench.path, textWith(35));
        NoticeBar& notices = bench.window->files().notices();
        QTRY_VERIFY(notices.holds(QStringLiteral("disk")));
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

    void aFailedSaveNamesPathCauseAndSpaceAndCanBeTriedAgain() {
        Bench bench;
        trouble::giveAway(bench.path);
        trouble::giveAway(bench.folder.path());
        QVERIFY(bench.open());
        bench.edit(31);
        trouble::setMode(bench.folder.path(), 0555);
        auto user = std::make_unique<trouble::Unprivileged>();
        auto answers = std::make_unique<DialogAnswers>(QStringList{QStringLiteral("Escape")});
        QVERIFY(!bench.window->files().save());
        ANSWERED(*answers);
        const QString text = answers->text();
        answers.reset();
        QVERIFY2(text.contains(bench.path) && text.contains(QStringLiteral("Permission denied"))
                     && text.contains(QStringLiteral("free space: ")),
                 qPrintable(text));
        QVERIFY(bench.document().modified());
        QCOMPARE(bench.diameter(), 31.0);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(30));

        DialogAnswers again({QStringLiteral("again"), QStringLiteral("again")});
        int asked = 0;
        again.seen = [&](QDialog&) {
            if (++asked == 2) { // somebody has put it right meanwhile
                user.reset();
                trouble::setMode(bench.folder.path(), 0755);
            }
        };
        QVERIFY(bench.window->files().save());
        ANSWERED(again);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QVERIFY(!bench.document().modified());
    }

    void aFailedSaveCanGoElsewhere() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        QVERIFY(QFile::remove(bench.path));
        QVERIFY(QDir().mkdir(bench.path)); // something else stands there now
        DialogAnswers answers({QStringLiteral("elsewhere"), QStringLiteral("file:") + bench.other});
        QVERIFY(bench.window->files().save());
        ANSWERED(answers);
        QCOMPARE(trouble::bytesOf(bench.other), textWith(31));
        QVERIFY(QFileInfo(bench.path).isDir());
        QCOMPARE(bench.document().filePath(), bench.other);
    }

    void otherNamesOfAFileAreAskedAboutOnce() {
        Bench bench;
        QCOMPARE(::link(QFile::encodeName(bench.path).constData(),
                        QFile::encodeName(bench.other).constData()),
                 0);
        QVERIFY(bench.open());
        bench.edit(31);
        {
            DialogAnswers answers({QStringLiteral("Escape")});
            QVERIFY(!bench.window->files().save());
            ANSWERED(answers);
            QVERIFY(answers.text().contains(QStringLiteral("hard links")));
            QCOMPARE(trouble::bytesOf(bench.path), textWith(30));
        }
        DialogAnswers answers({QStringLiteral("proceed")});
        QVERIFY(bench.window->files().save());
        ANSWERED(answers);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QCOMPARE(trouble::bytesOf(bench.other), textWith(30));
        bench.edit(32);
        DialogAnswers none({});
        QVERIFY(bench.window->files().save());
        ANSWERED(none);
    }

    void savingOverAFileSomebodyHasOpenIsAsked() {
        Bench bench;
        trouble::write(bench.other, textWith(40));
        FileLock lock;
        QCOMPARE(lock.acquire(bench.other), FileLock::State::held);
        QVERIFY(bench.open());
        // The file dialog asks whether to replace it, then the lock is seen.
        DialogAnswers answers({QStringLiteral("file:") + bench.other, QStringLiteral("yes"),
                               QStringLiteral("Escape")});
        QVERIFY(!bench.window->files().saveAs());
        ANSWERED(answers);
        QVERIFY(answers.texts().last().contains(QStringLiteral("open in another window")));
        QCOMPARE(trouble::bytesOf(bench.other), textWith(40));
        QVERIFY(lock.stillOurs());
        QCOMPARE(bench.document().filePath(), bench.path);
    }
};

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    TestFileDialogs test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_file_dialogs.moc"
