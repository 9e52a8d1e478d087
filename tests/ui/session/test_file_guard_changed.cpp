// SPDX-License-Identifier: GPL-3.0-or-later
// The guarded file is changed by another program: seen before a save, reported, asked for.
#include "core/file/file_system.h"
#include "tests/registry.h"
#include "tests/ui/support/file_guard_bench.h"
#include "ui/session/project_io.h"

#include <QDateTime>
#include <QSignalSpy>

namespace sparkout::test_file_guard_changed {

using namespace file_guard_bench;

class TestFileGuardChanged : public QObject {
    Q_OBJECT

private slots:
    void whatAnotherProgramWroteIsSeenBeforeASave() {
        OpenBench bench;
        QVERIFY(!bench.guard.changedOutside(bench.path));
        trouble::write(bench.path, textWith(35));
        const auto changed = bench.guard.changedOutside(bench.path);
        QVERIFY(changed && changed->kind == DiskState::Kind::file);
        trouble::write(bench.path, textWith(30));
        QVERIFY2(!bench.guard.changedOutside(bench.path), "the same text again is no change");
        QVERIFY(QFile::remove(bench.path));
        const auto gone = bench.guard.changedOutside(bench.path);
        QVERIFY(gone && gone->kind == DiskState::Kind::missing);
        QVERIFY2(!bench.guard.changedOutside(QStringLiteral("/tmp/elsewhere")), "not its file");
    }

    /// The user has seen one version; another one has come since.
    void onlyTheVersionThatWasLookedAtIsReplaced() {
        EditedBench bench;
        (void)bench.guard.claim(bench.path);
        trouble::write(bench.path, textWith(35));
        auto error = bench.guard.save(bench.path); // nobody has looked
        QVERIFY(error && error->step == FileStep::changed && !error->replaced);
        QVERIFY(bench.guard.changedOutside(bench.path));
        trouble::write(bench.path, textWith(36));
        error = bench.guard.save(bench.path);
        QVERIFY(error && error->step == FileStep::changed);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(36));
        QVERIFY(bench.document.modified());
        QVERIFY(bench.guard.changedOutside(bench.path));
        QVERIFY(!bench.guard.save(bench.path));
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QCOMPARE(trouble::bytesOf(bench.path + QStringLiteral(".bak")), textWith(36));
        // One that is gone is written again once that was seen, and one that is back is not.
        QVERIFY(QFile::remove(bench.path));
        QVERIFY(bench.guard.changedOutside(bench.path));
        trouble::write(bench.path, textWith(37));
        error = bench.guard.save(bench.path);
        QVERIFY(error && error->step == FileStep::changed);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(37));
    }

    void ourOwnSaveIsNoChangeFromOutside() {
        OpenBench bench;
        QSignalSpy changed(&bench.guard, &FileGuard::changedOnDisk);
        for (int i = 1; i <= 3; ++i) {
            setDiameter(bench.document, 30 + i);
            (void)bench.guard.claim(bench.path);
            QVERIFY(!bench.guard.save(bench.path));
            QVERIFY(!bench.guard.changedOutside(bench.path));
        }
        QTest::qWait(600);
        QCOMPARE(changed.count(), 0);
    }

#ifndef Q_OS_WIN // nobody else's rights are at hand there
    // The bytes are in place, but could not be read back: the next try must not ask whose they are.
    void whatAFailedSavePutInPlaceIsNoChangeFromOutside() {
        if (!trouble::mayBecomeAnother()) {
            QSKIP("no right to become another user here");
        }
        EditedBench bench;
        // Its group may write and read it; the file that replaces it becomes the user's own, whom
        // the same mode forbids both.
        trouble::setMode(bench.folder.path(), 0777);
        trouble::setMode(bench.path, 0066);
        std::optional<FileError> error;
        {
            const trouble::Unprivileged user;
            error = bench.guard.save(bench.path);
        }
        QVERIFY(error && error->replaced);
        QCOMPARE(error->step, FileStep::verify);
        QVERIFY(bench.document.modified());
        trouble::setMode(bench.path, 0644);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QVERIFY2(!bench.guard.changedOutside(bench.path), "they are the document's own");
        trouble::write(bench.path, textWith(35));
        QVERIFY(bench.guard.changedOutside(bench.path));
    }
#endif

    void aFileThatIsRewrittenReplacedOrRemovedIsReported_data() {
        QTest::addColumn<QString>("how");
        for (const char* name : {"in place", "replaced", "removed", "same size and time"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void aFileThatIsRewrittenReplacedOrRemovedIsReported() {
        QFETCH(QString, how);
        OpenBench bench;
        QTest::qWait(400); // the first look
        QSignalSpy changed(&bench.guard, &FileGuard::changedOnDisk);
        QSignalSpy restored(&bench.guard, &FileGuard::restoredOnDisk);
        const QDateTime time = QFileInfo(bench.path).lastModified();
        if (how == u"replaced") {
            const QString other = bench.folder.filePath(QStringLiteral("new"));
            trouble::write(other, textWith(35));
            QCOMPARE(renamePath(systemPath(other), systemPath(bench.path)), 0);
        } else if (how == u"removed") {
            QVERIFY(QFile::remove(bench.path));
        } else {
            trouble::write(bench.path, textWith(35));
        }
        if (how == u"same size and time") {
            QFile file(bench.path);
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(time, QFile::FileModificationTime));
        }
        QTRY_COMPARE(changed.count(), 1);
        bench.guard.watch().check();
        QTest::qWait(300);
        QCOMPARE(changed.count(), 1); // told once
        trouble::write(bench.path, textWith(30));
        QTRY_COMPARE(restored.count(), 1);
    }

    // A network disk tells nothing: coming back to the window has to do.
    void aChangeNobodyTellsOfIsSeenWhenAsked() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.sparkout"));
        trouble::write(path, "one");
        FileWatch watch;
        QSignalSpy changed(&watch, &FileWatch::changed);
        watch.follow(path, contentHash("another")); // changed between loading and watching
        QTRY_COMPARE(changed.count(), 1);
        watch.follow({}, {});
        trouble::write(path, "two");
        watch.check();
        QTest::qWait(300);
        QCOMPARE(changed.count(), 1);
    }

    void whatWasReloadedCanBeUndone() {
        EditedBench bench;
        trouble::write(bench.path, textWith(35));
        LoadedProject loaded = loadProject(bench.path);
        bench.document.reload(*loaded.setup, loaded.hash);
        bench.guard.followDocument();
        QVERIFY(!bench.document.modified());
        QCOMPARE(bench.document.project().part->diameter_mm, 35.0);
        QVERIFY(!bench.guard.changedOutside(bench.path));
        bench.document.undo();
        QCOMPARE(bench.document.project().part->diameter_mm, 31.0);
        QVERIFY(bench.document.modified());
    }
};

} // namespace sparkout::test_file_guard_changed

SPARKOUT_TEST(test_file_guard_changed, TestFileGuardChanged)
#include "test_file_guard_changed.moc"
