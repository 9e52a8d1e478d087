// SPDX-License-Identifier: GPL-3.0-or-later
// The lock beside a project: who has it, who may take it over, and how it follows the document.
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/ui/support/file_guard_bench.h"

#include <QDateTime>

namespace sparkout::test_file_guard_lock {

using namespace file_guard_bench;

/// The lock file as a program on another computer writes it.
QByteArray foreignLock() {
    return "1234\nsparkout\nanother-host\n0123456789abcdef\n00000000-0000-0000-0000-000000000000\n";
}

class TestFileGuardLock : public QObject {
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
        QVERIFY2(isThisComputer(holder.host), qPrintable(holder.host));
        QVERIFY(!holder.user.isEmpty());
        QVERIFY(qAbs(holder.since.secsTo(QDateTime::currentDateTime())) < 60);
        second.release();
        QVERIFY2(first.stillOurs(), "asking takes nothing away");
    }

    void oneLockServesAllTheWaysToAFile() {
        Bench bench;
#ifdef Q_OS_WIN
        const QString link = bench.folder.filePath(QStringLiteral("ВАЛ.SparkOut"));
#else
        const QString link = bench.folder.filePath(QStringLiteral("link.sparkout"));
        QVERIFY(QFile::link(bench.path, link));
#endif
        FileLock first;
        FileLock second;
        QCOMPARE(first.acquire(bench.path), State::held);
        QCOMPARE(second.acquire(link), State::conflict);
    }

    void theLockOfADeadProgramIsTakenOverWithItsHelper() {
        Bench bench;
        trouble::write(bench.lock, trouble::deadLock());
        trouble::write(bench.lock + QStringLiteral(".rmlock"), trouble::deadLock());
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

    // To open a pipe is to wait for a writer, and /dev/zero has no end.
    void whatIsNoLockIsNamedAndPassedOver_data() {
        addColumns<QString, QString>("kind", "ending");
        for (const QString& kind : trouble::strangeKinds()) {
            for (const char* ending : {"", ".rmlock"}) {
                QTest::addRow("%s%s", qPrintable(kind), ending)
                    << kind << QString::fromLatin1(ending);
            }
        }
    }

    void whatIsNoLockIsNamedAndPassedOver() {
        QFETCH(QString, kind);
        QFETCH(QString, ending);
        Bench bench;
        const QString path = bench.lock + ending;
        if (!ending.isEmpty()) { // the helper counts when a dead lock is to be removed
            trouble::write(bench.lock, trouble::deadLock());
        }
        trouble::putStrange(kind, path);
        const auto before = stampOf(path);
        RunningTimer clock;
        bench.open();
        QVERIFY2(clock.elapsed() < 1000, qPrintable(QString::number(clock.elapsed())));
        QCOMPARE(bench.access, Access::write);
        QCOMPARE(bench.guard.strangeLock(), path);
        QVERIFY(stampOf(path) == before);
        setDiameter(bench.document, 31);
        QCOMPARE(bench.guard.claim(bench.path), Access::write);
        QVERIFY(!bench.guard.save(bench.path));
        QCOMPARE(bench.guard.strangeLock(), path);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        bench.document.startUntitled(newProject(Operation::traverse));
        QVERIFY(bench.guard.strangeLock().isEmpty());
        QVERIFY(stampOf(path) == before);
    }

#ifdef Q_OS_WIN
    // There a lock stays open as long as it is held.
    void aLockThatIsHeldIsTakenFromNobody() {
        Bench bench;
        FileLock first;
        FileLock second;
        QCOMPARE(first.acquire(bench.path), State::held);
        QCOMPARE(second.acquire(bench.path), State::conflict);
        QCOMPARE(second.takeOver(), State::conflict);
        QVERIFY(first.stillOurs());
        QVERIFY(!second.stillOurs());
        QVERIFY(!QFile::remove(bench.lock));
        QFile file(bench.lock);
        QVERIFY2(!file.open(QIODevice::ReadWrite), "nobody writes it, nor its times");
        bench.open();
        QCOMPARE(bench.access, Access::conflict);
        QVERIFY(bench.document.readOnly());
        first.release();
        QVERIFY(!QFileInfo::exists(bench.lock));
        QCOMPARE(second.takeOver(), State::held);
        QVERIFY(second.stillOurs());
    }
#else
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

    // A file system gives the number of a removed file to the next one.
    void aLockLikeOursOfAnotherTimeIsNotOurs() {
        Bench bench;
        FileLock lock;
        QCOMPARE(lock.acquire(bench.path), State::held);
        const auto before = stampOf(bench.lock);
        QFile file(bench.lock);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(60),
                                 QFile::FileModificationTime));
        file.close();
        const auto now = stampOf(bench.lock);
        QVERIFY(before && now && now->inode == before->inode && now->size == before->size);
        QVERIFY(!lock.stillOurs());
        lock.release();
        QVERIFY2(QFileInfo::exists(bench.lock), "it is whose it is by now");
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
#endif

    void aWriteProtectedFileMeansReadOnly() {
        Bench bench;
        trouble::setMode(bench.path, 0444);
        bench.open();
        QCOMPARE(bench.access, Access::readOnly);
        QVERIFY2(!QFileInfo::exists(bench.lock), "who only reads keeps nobody out");
    }

    void theLockFollowsTheDocument() {
        OpenBench bench;
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
        EditedBench bench;
        const QString other = bench.folder.filePath(QStringLiteral("nowhere/other.sparkout"));
        (void)bench.guard.claim(other);
        QVERIFY(bench.guard.save(other).has_value());
        bench.guard.dropClaim();
        QVERIFY(QFileInfo::exists(bench.lock));
        QCOMPARE(bench.document.filePath(), bench.path);
        QVERIFY(bench.document.modified());
    }
};

} // namespace sparkout::test_file_guard_lock

SPARKOUT_TEST(test_file_guard_lock, TestFileGuardLock)
#include "test_file_guard_lock.moc"
