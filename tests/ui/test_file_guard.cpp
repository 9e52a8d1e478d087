// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tries.h"
#include "tests/ui/file_trouble.h"
#include "ui/session/document.h"
#include "ui/session/file_guard.h"
#include "ui/session/operation.h"

#include "core/project/project_file.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>

using namespace sparkout;
using State = FileLock::State;
using Access = FileGuard::Access;

namespace {

constexpr EditText editText{"Input", "Diameter"};
QString smallDisk; ///< a file system of 64 KB; empty: not allowed here

void setDiameter(Document& document, double diameter_mm) {
    Project project = document.project();
    project.part.diameter_mm = diameter_mm;
    document.edit(project, editText);
}

QByteArray textWith(double diameter_mm) {
    Project project = newProject(Operation::traverse);
    project.part.diameter_mm = diameter_mm;
    return QByteArray::fromStdString(writeProject(project));
}

/// A document that guards its file, in a folder of its own.
struct Bench {
    Bench() {
        guard.protect(state.path());
        trouble::write(path, textWith(30));
    }
    void open() {
        access = guard.claim(path);
        LoadedProject loaded = loadProject(path);
        QVERIFY(loaded.project);
        document.take(*loaded.project, path, loaded.hash, access != Access::write);
    }
    QTemporaryDir state;
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("вал.sparkout"));
    QString lock = FileLock::lockPath(path);
    Document document;
    FileGuard guard{document};
    Access access = Access::conflict;
};

/// The lock file as a program on another computer writes it.
QByteArray foreignLock() {
    return "1234\nsparkout\nanother-host\n0123456789abcdef\n00000000-0000-0000-0000-000000000000\n";
}

} // namespace

class TestFileGuard : public QObject {
    Q_OBJECT

private slots:
    void aLockIsAHiddenFileBesideTheProjectAndGoesWithIt() {
        Bench bench;
        QCOMPARE(bench.lock, bench.folder.filePath(QStringLiteral(".~вал.sparkout.lock")));
        FileLock lock;
        QCOMPARE(lock.acquire(bench.path), State::held);
        QVERIFY(QFileInfo::exists(bench.lock));
        QVERIFY(lock.stillOurs());
        lock.release();
        QVERIFY(!QFileInfo::exists(bench.lock));
        QCOMPARE(lock.state(), State::none);
    }

    void theSecondOpenerIsToldWhoHasTheFile() {
        Bench bench;
        FileLock first;
        FileLock second;
        QCOMPARE(first.acquire(bench.path), State::held);
        QCOMPARE(second.acquire(bench.path), State::conflict);
        const LockHolder& holder = second.holder();
        QVERIFY(holder.readable);
        QCOMPARE(holder.process, QCoreApplication::applicationPid());
        QCOMPARE(holder.host, QSysInfo::machineHostName());
        QVERIFY(!holder.user.isEmpty());
        QVERIFY(qAbs(holder.since.secsTo(QDateTime::currentDateTime())) < 60);
        second.release();
        QVERIFY2(first.stillOurs(), "asking takes nothing away");
    }

    void oneLockServesAllTheWaysToAFile() {
        Bench bench;
        const QString link = bench.folder.filePath(QStringLiteral("link.sparkout"));
        QVERIFY(QFile::link(bench.path, link));
        FileLock first;
        FileLock second;
        QCOMPARE(first.acquire(bench.path), State::held);
        QCOMPARE(second.acquire(link), State::conflict);
    }

    void theLockOfADeadProgramIsTakenOverWithItsHelper() {
        Bench bench;
        QProcess gone;
        gone.start(QStringLiteral("true"), QStringList());
        QVERIFY(gone.waitForFinished());
        trouble::write(bench.lock,
                       "999999999\nsparkout\n" + QSysInfo::machineHostName().toUtf8() + "\n\n\n");
        trouble::write(bench.lock + QStringLiteral(".rmlock"),
                       "999999999\nsparkout\n" + QSysInfo::machineHostName().toUtf8() + "\n\n\n");
        FileLock lock;
        QCOMPARE(lock.acquire(bench.path), State::held);
        lock.release();
        QCOMPARE(trouble::entries(bench.folder.path()),
                 QStringList{QStringLiteral("вал.sparkout")});
    }

    void theLockOfAnotherComputerIsRespectedHoweverOld() {
        Bench bench;
        trouble::write(bench.lock, foreignLock());
        QFile file(bench.lock);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addDays(-400),
                                 QFile::FileModificationTime));
        file.close();
        FileLock lock;
        QCOMPARE(lock.acquire(bench.path), State::conflict);
        QCOMPARE(lock.holder().host, QStringLiteral("another-host"));
        QCOMPARE(lock.holder().process, 1234);
        QCOMPARE(trouble::bytesOf(bench.lock), foreignLock());
        QCOMPARE(lock.takeOver(), State::held);
        QVERIFY(lock.stillOurs());
    }

    void aLockWithoutSenseIsRespectedUntilItIsTakenOver() {
        for (const QByteArray& text :
             {QByteArray("garbage"), QByteArray(), QByteArray("\xff\x00\x01", 3)}) {
            Bench bench;
            trouble::write(bench.lock, text);
            FileLock lock;
            QCOMPARE(lock.acquire(bench.path), State::conflict);
            QVERIFY(!lock.holder().readable);
            QVERIFY(!lock.holder().user.isEmpty());
            QCOMPARE(trouble::bytesOf(bench.lock), text);
            QCOMPARE(lock.takeOver(), State::held);
        }
    }

    // QLockFile removes its file by name, whoever it belongs to by then.
    void whoLostTheLockDoesNotRemoveTheOneOfWhoTookIt() {
        Bench bench;
        FileLock first;
        FileLock second;
        QCOMPARE(first.acquire(bench.path), State::held);
        QCOMPARE(second.acquire(bench.path), State::conflict);
        QCOMPARE(second.takeOver(), State::held);
        QVERIFY(!first.stillOurs());
        QVERIFY(second.stillOurs());
        first.release();
        QVERIFY(second.stillOurs());
        FileLock third;
        QCOMPARE(third.acquire(bench.path), State::conflict);
        second.release();
        QVERIFY(!QFileInfo::exists(bench.lock));
    }

    void aFolderThatTakesNoFilesMeansReadOnly() {
        Bench bench;
        trouble::setMode(bench.folder.path(), 0555);
        {
            const trouble::Unprivileged user;
            FileLock lock;
            QCOMPARE(lock.acquire(bench.path), State::noRight);
            bench.open();
        }
        trouble::setMode(bench.folder.path(), 0755);
        QCOMPARE(bench.access, Access::readOnly);
        QVERIFY(bench.document.readOnly());
        QVERIFY(!QFileInfo::exists(bench.lock));
    }

    void aWriteProtectedFileMeansReadOnly() {
        Bench bench;
        trouble::setMode(bench.path, 0444);
        bench.open();
        QCOMPARE(bench.access, Access::readOnly);
        QVERIFY2(!QFileInfo::exists(bench.lock), "who only reads keeps nobody out");
    }

    void theLockFollowsTheDocument() {
        Bench bench;
        bench.open();
        QVERIFY(QFileInfo::exists(bench.lock));
        const QString other = bench.folder.filePath(QStringLiteral("other.sparkout"));
        QCOMPARE(bench.guard.claim(other), Access::write);
        QVERIFY2(QFileInfo::exists(bench.lock), "until the save has worked both are kept");
        QVERIFY(!bench.guard.save(other));
        QVERIFY(!QFileInfo::exists(bench.lock));
        QVERIFY(QFileInfo::exists(FileLock::lockPath(other)));
        bench.document.startUntitled(newProject(Operation::plunge));
        QVERIFY(!QFileInfo::exists(FileLock::lockPath(other)));
    }

    void aSaveThatFailsLeavesTheLockWhereItWas() {
        Bench bench;
        bench.open();
        setDiameter(bench.document, 31);
        const QString other = bench.folder.filePath(QStringLiteral("nowhere/other.sparkout"));
        (void)bench.guard.claim(other);
        QVERIFY(bench.guard.save(other).has_value());
        bench.guard.dropClaim();
        QVERIFY(QFileInfo::exists(bench.lock));
        QCOMPARE(bench.document.filePath(), bench.path);
        QVERIFY(bench.document.modified());
    }

    void aSaveKeepsThePreviousVersionBesideTheFileAndInTheHistory() {
        Bench bench;
        bench.open();
        setDiameter(bench.document, 31);
        (void)bench.guard.claim(bench.path);
        QVERIFY(!bench.guard.save(bench.path));
        QVERIFY(!bench.document.modified());
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QCOMPARE(trouble::bytesOf(bench.path + QStringLiteral(".bak")), textWith(30));
        const auto versions = bench.guard.history()->versions(bench.path);
        QCOMPARE(versions.size(), std::size_t{1});
        QCOMPARE(trouble::bytesOf(versions[0].file), textWith(30));
        const auto all = earlierVersions(*bench.guard.history(), bench.path);
        QCOMPARE(all.size(), std::size_t{2});
        QVERIFY(bench.document.canUndo());
        bench.document.undo(); // across the save
        QVERIFY(bench.document.modified());
        QCOMPARE(bench.document.project().part.diameter_mm, 30.0);
    }

    void theRecoveryFileGoesWithTheSave() {
        Bench bench;
        bench.open();
        setDiameter(bench.document, 31);
        bench.guard.autosave()->flush();
        QVERIFY(!bench.guard.autosave()->file().isEmpty());
        (void)bench.guard.claim(bench.path);
        QVERIFY(!bench.guard.save(bench.path));
        QVERIFY(bench.guard.autosave()->file().isEmpty());
        QVERIFY(bench.guard.recovery()->left().empty());
        QVERIFY(bench.guard.recovery()->discarded().empty());
    }

    void aSaveThatCannotBeWrittenChangesNothing_data() {
        QTest::addColumn<QString>("trouble");
        for (const char* name : {"no bytes", "full disk", "read-only folder", "a folder", "fifo"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void aSaveThatCannotBeWrittenChangesNothing() {
        QFETCH(QString, trouble);
        Bench bench;
        QString path = bench.path;
        FileStep expected = FileStep::write;
        if (trouble == u"full disk") {
            if (smallDisk.isEmpty()) {
                QSKIP("no right to mount a small disk here");
            }
            path = smallDisk + QStringLiteral("/part.sparkout");
            trouble::write(path, textWith(30));
            QFile filler(smallDisk + QStringLiteral("/filler"));
            QVERIFY(filler.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
            while (filler.write(QByteArray(4096, 'x')) == 4096) {
            }
        }
        bench.path = path;
        bench.open();
        setDiameter(bench.document, 31);
        const QByteArray before = trouble::bytesOf(path);
        std::optional<FileError> error;
        if (trouble == u"read-only folder") {
            expected = FileStep::create;
            trouble::giveAway(path);
            trouble::setMode(bench.folder.path(), 0555);
            const trouble::Unprivileged user;
            error = bench.guard.save(path);
        } else if (trouble == u"a folder" || trouble == u"fifo") {
            expected = FileStep::notRegular;
            QVERIFY(QFile::remove(path));
            const QByteArray name = QFile::encodeName(path);
            QCOMPARE(trouble == u"fifo" ? ::mkfifo(name.constData(), 0600)
                                        : ::mkdir(name.constData(), 0700),
                     0);
            error = bench.guard.save(path);
        } else if (trouble == u"no bytes") {
            const trouble::NoBytes disk;
            error = bench.guard.save(path);
        } else {
            error = bench.guard.save(path);
        }
        trouble::setMode(bench.folder.path(), 0700);
        QVERIFY(error.has_value());
        QCOMPARE(error->step, expected);
        QCOMPARE(error->path, QFile::encodeName(path).toStdString());
        QVERIFY(expected == FileStep::notRegular || error->systemError != 0);
        QVERIFY(bench.document.modified());
        QCOMPARE(bench.document.project().part.diameter_mm, 31.0);
        if (expected != FileStep::notRegular) {
            QVERIFY(error->freeBytes.has_value());
            QCOMPARE(trouble::bytesOf(path), before);
        } else {
            QVERIFY2(!QFileInfo(path).isFile(), "it was not replaced");
        }
        QFile::remove(smallDisk + QStringLiteral("/filler"));
    }

    void whatAnotherProgramWroteIsSeenBeforeASave() {
        Bench bench;
        bench.open();
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

    void ourOwnSaveIsNoChangeFromOutside() {
        Bench bench;
        bench.open();
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

    void aFileThatIsRewrittenReplacedOrRemovedIsReported_data() {
        QTest::addColumn<QString>("how");
        for (const char* name : {"in place", "replaced", "removed", "same size and time"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void aFileThatIsRewrittenReplacedOrRemovedIsReported() {
        QFETCH(QString, how);
        Bench bench;
        bench.open();
        QTest::qWait(400); // the first look
        QSignalSpy changed(&bench.guard, &FileGuard::changedOnDisk);
        QSignalSpy restored(&bench.guard, &FileGuard::restoredOnDisk);
        const QDateTime time = QFileInfo(bench.path).lastModified();
        if (how == u"replaced") {
            const QString other = bench.folder.filePath(QStringLiteral("new"));
            trouble::write(other, textWith(35));
            QCOMPARE(std::rename(QFile::encodeName(other).constData(),
                                 QFile::encodeName(bench.path).constData()),
                     0);
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

    void hardLinksAreCounted() {
        Bench bench;
        QCOMPARE(linkCount(bench.path), 1u);
        QCOMPARE(
            ::link(QFile::encodeName(bench.path).constData(),
                   QFile::encodeName(bench.folder.filePath(QStringLiteral("second"))).constData()),
            0);
        QCOMPARE(linkCount(bench.path), 2u);
        QCOMPARE(linkCount(QStringLiteral("/nowhere/at/all")), 1u);
    }

    void theHistoryKeepsToItsCaps() {
        const QTemporaryDir folder;
        const QString project = folder.filePath(QStringLiteral("a.sparkout"));
        const BackupHistory history(folder.path(),
                                    {6, 3, qint64{10'000}, std::chrono::seconds(300)});
        const QDateTime noon(QDate(2026, 3, 2), QTime(12, 0));
        const auto keep = [&](const QDateTime& when, const QByteArray& text) {
            QVERIFY(!history.keep(project, text.toStdString(), when.toUTC()));
        };
        const auto texts = [&] {
            QByteArrayList list;
            for (const EarlierVersion& version : history.versions(project)) {
                list += trouble::bytesOf(version.file);
            }
            return list;
        };
        keep(noon, "first of the day");
        keep(noon.addSecs(299), "too soon");
        QCOMPARE(texts(), QByteArrayList{"first of the day"});
        keep(noon.addSecs(400), "first of the day"); // the same again
        QCOMPARE(texts().size(), 1);
        keep(noon.addSecs(800), "2");
        keep(noon.addSecs(1200), "3");
        keep(noon.addSecs(1600), "4");
        QCOMPARE(texts(), (QByteArrayList{"4", "3", "first of the day"}));
        for (int day = 1; day <= 4; ++day) {
            keep(noon.addDays(day), "day " + QByteArray::number(day));
        }
        QCOMPARE(texts(), (QByteArrayList{"day 4", "day 3", "day 2", "day 1", "4", "3"}));
        keep(noon.addDays(5), QByteArray(9'995, 'x'));
        QCOMPARE(texts().size(), 2); // what fits into 10,000 bytes
        keep(noon.addDays(6), QByteArray(20'000, 'y'));
        QCOMPARE(texts().size(), 1); // the newest one in any case
        keep(noon.addDays(-300), "the clock was set back");
        QVERIFY(texts().contains(QByteArray("the clock was set back")));
    }

    void namesakesInTwoFoldersHaveHistoriesOfTheirOwn() {
        const QTemporaryDir folder;
        const BackupHistory history(folder.path());
        const QString one = history.folderOf(QStringLiteral("/tmp/a/вал.sparkout"));
        const QString two = history.folderOf(QStringLiteral("/tmp/b/вал.sparkout"));
        QVERIFY(one != two);
        QVERIFY(one.startsWith(folder.filePath(QStringLiteral("backups/вал-"))));
    }

    void whatWasReloadedCanBeUndone() {
        Bench bench;
        bench.open();
        setDiameter(bench.document, 31);
        trouble::write(bench.path, textWith(35));
        LoadedProject loaded = loadProject(bench.path);
        bench.document.reload(*loaded.project, loaded.hash);
        bench.guard.followDisk();
        QVERIFY(!bench.document.modified());
        QCOMPARE(bench.document.project().part.diameter_mm, 35.0);
        QVERIFY(!bench.guard.changedOutside(bench.path));
        bench.document.undo();
        QCOMPARE(bench.document.project().part.diameter_mm, 31.0);
        QVERIFY(bench.document.modified());
    }

    void theUnsavedEditsAreKnownByName() {
        Document document;
        document.startUntitled(newProject(Operation::traverse));
        QVERIFY(document.unsavedEdits().isEmpty());
        setDiameter(document, 31);
        setDiameter(document, 32);
        QCOMPARE(document.unsavedEdits().size(), 1); // the same field twice
        const QTemporaryDir folder;
        QVERIFY(!document.saveAs(folder.filePath(QStringLiteral("a.sparkout"))));
        QVERIFY(document.unsavedEdits().isEmpty());
        document.undo(); // what was undone since the save is unsaved, too
        QCOMPARE(document.unsavedEdits().size(), 1);
        document.markUnsaved();
        QVERIFY(document.modified());
        QVERIFY(document.unsavedEdits().isEmpty());
    }

    void withoutAFolderOfItsOwnNothingButTheFileIsWritten() {
        Bench bench;
        Document document;
        FileGuard guard(document);
        QCOMPARE(guard.claim(bench.path), Access::write);
        LoadedProject loaded = loadProject(bench.path);
        document.take(*loaded.project, bench.path, loaded.hash, false);
        QCOMPARE(trouble::entries(bench.folder.path()),
                 QStringList{QStringLiteral("вал.sparkout")});
        QVERIFY(trouble::entries(bench.state.path()).isEmpty());
    }

    void aProjectOfFiveMegabytesIsOpenedAndSavedAside() {
        Bench bench;
        Project project = newProject(Operation::traverse);
        const std::string inputs = writeProject(project);
        std::string radii = "0.123456789";
        for (int i = 0; i < 300; ++i) {
            radii += ",0.123456789";
        }
        const int runs = qEnvironmentVariableIsSet("SPARKOUT_QUICK") ? 100 : 1000;
        for (int i = 0; i < runs; ++i) {
            project.runs.push_back(
                {"run", "2026-01-01T00:00:00Z", "0.1", {inputs}, {"{\"radii\":[" + radii + "]}"}});
        }
        QElapsedTimer clock;
        clock.start();
        const SavedProject saved = saveProject(project, bench.path, {.keepBackup = true});
        const qint64 saving_ms = clock.restart();
        QVERIFY(!saved.error);
        const LoadedProject loaded = loadProject(bench.path);
        const qint64 loading_ms = clock.restart();
        QVERIFY(loaded.project.has_value());
        bench.open();
        double diameter_mm = 30;
        const double edit_ms = leastOfTries_ms(4 * 50, [&] {
            clock.restart();
            setDiameter(bench.document, ++diameter_mm);
            return clock.elapsed();
        });
        qInfo("SPEED project of %lld KB with %zu kept runs: saved and read back in %lld ms, read "
              "in %lld ms, both beside the window; an edit takes %.0f ms in it",
              QFileInfo(bench.path).size() / 1024, project.runs.size(), saving_ms, loading_ms,
              edit_ms);
        QVERIFY2(edit_ms <= 4 * 50, "an edit does not pay for the kept runs");
    }
};

int main(int argc, char** argv) {
    QTemporaryDir folder;
    if (trouble::mountSmallDisk(folder.path(), 64)) {
        smallDisk = folder.path();
    }
    int result = 0;
    {
        QCoreApplication app(argc, argv);
        TestFileGuard test;
        result = QTest::qExec(&test, argc, argv);
    }
    if (!smallDisk.isEmpty()) {
        ::umount(QFile::encodeName(smallDisk).constData());
    }
    return result;
}
#include "test_file_guard.moc"
