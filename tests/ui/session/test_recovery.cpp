// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/file_system.h"
#include "core/project/part.h"
#include "core/study/new_project.h"
#include "tests/processor_time.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/support/diameters.h"
#include "tests/ui/support/file_trouble.h"
#include "ui/session/document.h"
#include "ui/session/file_guard.h"
#include "ui/session/project_io.h"

#include "core/file/project_file.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QSignalSpy>

#include <atomic>
#include <thread>

namespace sparkout::test_recovery {

using namespace std::chrono_literals;

/// A document with a recovery file in a folder of its own.
struct Bench {
    explicit Bench(Autosave::Times times = {20ms, 300ms}) {
        document.startUntitled(newProject(Operation::traverse));
        autosave = std::make_unique<Autosave>(document, store, times);
    }
    /// An edit that is in the recovery file at once.
    void keep(double diameter_mm) {
        setDiameter(document, diameter_mm);
        autosave->flush();
    }
    QTemporaryDir folder;
    RecoveryStore store{folder.path() + QStringLiteral("/state")};
    Document document;
    std::unique_ptr<Autosave> autosave;
};

RecoveryContent contentOf(const QString& file) {
    return readRecovery(trouble::bytesOf(file).toStdString());
}

double diameterIn(const QString& file) {
    return contentOf(file).setup->surfaces.front().project.part->diameter_mm;
}

class TestRecovery : public QObject {
    Q_OBJECT

private slots:
    void theRecoveryFileHoldsTheProjectAndAllThatBelongsToIt() {
        Project project = newProject(Operation::plunge);
        project.title = "Вал \"30h6\"\n<b>";
        const RecoveryHeader header{QString::fromStdString(project.title),
                                    QStringLiteral("/tmp/вал [*].sparkout"),
                                    QDateTime::currentDateTimeUtc(),
                                    QByteArray::fromHex("00ff"),
                                    true,
                                    true,
                                    {"/part/length_mm", "/part/stock_mm"}};
        const RecoveryContent content = readRecovery(recoveryText(header, plainSetup(project)));
        QVERIFY(content.setup && sameProject(content.setup->surfaces.front().project, project));
        QCOMPARE(content.header.title, header.title);
        QCOMPARE(content.header.path, header.path);
        QCOMPARE(content.header.when.toMSecsSinceEpoch(), header.when.toMSecsSinceEpoch());
        QCOMPARE(content.header.diskHash, header.diskHash);
        QVERIFY(content.header.readOnly);
        QVERIFY(content.header.modified);
        QCOMPARE(content.header.open, header.open);
    }

    void aProjectIsKeptBeforeItsDrawingIsComplete() {
        Bench bench;
        bench.document.startIncomplete(undrawnProject(Operation::traverse), drawingInputs());
        bench.autosave->flush();
        QVERIFY(bench.autosave->file().isEmpty()); // nothing has been given yet
        setDiameter(bench.document, 31);
        QTRY_VERIFY(!bench.autosave->file().isEmpty());
        const RecoveryContent content = contentOf(bench.autosave->file());
        QVERIFY(content.setup && content.setup->surfaces.front().project.part->diameter_mm == 31);
        QCOMPARE(content.header.open, bench.document.openInputs());
        QCOMPARE(content.header.open.size(), drawingInputs().size() - 1);
        Document after;
        after.recover(*content.setup, {}, {}, false, content.header.open);
        QVERIFY(after.modified());
        QCOMPARE(after.openInputs(), bench.document.openInputs());
        QCOMPARE(after.newFaults().size(), content.header.open.size());
        Project given = after.project();
        given.part->length_mm = 80;
        after.edit(given, editText);
        QVERIFY(!after.isOpen("/part/length_mm"));
        // Names that are no number of a project are left out.
        after.recover(*content.setup, {}, {}, false,
                      {"/part/length_mm", "/part", "/nothing", "", "/cycle/stages/9/stock_mm"});
        QCOMPARE(after.openInputs(), std::vector<std::string>{"/part/length_mm"});
    }

    void damagedNamesOfOpenInputsAreNoticed() {
        std::string text = recoveryText(
            {{}, {}, QDateTime::currentDateTimeUtc(), {}, false, true, {"/part/length_mm"}},
            plainSetup(newProject(Operation::plunge)));
        QVERIFY(readRecovery(text).setup);
        text.replace(text.find("length"), 6, "xength");
        QVERIFY(!readRecovery(text).setup);
    }

    // Cut at every byte, every bit of every byte turned: never a crash, never another project.
    void noDamageOfTheTextGoesUnnoticed() {
        const Project project = newProject(Operation::plunge);
        const std::string whole = recoveryText({}, plainSetup(project));
        for (std::size_t length = 0; length < whole.size(); ++length) {
            QVERIFY(!readRecovery(std::string_view(whole).substr(0, length)).setup);
        }
        int told = 0;
        for (std::size_t at = 0; at < whole.size(); ++at) {
            std::string damaged = whole;
            damaged[at] = char(damaged[at] ^ (1 << (at % 8)));
            const RecoveryContent content = readRecovery(damaged);
            told += !content.setup;
            QVERIFY(!content.setup
                    || sameProject(content.setup->surfaces.front().project, project));
        }
        QVERIFY2(std::size_t(told) + 400 > whole.size(),
                 "only the header's plain words may differ");
    }

    void anEditIsKeptAfterAPauseAndNeverInTheUsersFile() {
        Bench bench;
        const QString path = bench.folder.filePath(QStringLiteral("part.sparkout"));
        QVERIFY(!bench.document.saveAs(path));
        const QByteArray before = trouble::bytesOf(path);
        QVERIFY(bench.autosave->file().isEmpty());
        setDiameter(bench.document, 31);
        QTRY_VERIFY(!bench.autosave->file().isEmpty());
        const RecoveryContent content = contentOf(bench.autosave->file());
        QVERIFY(content.setup
                && sameProject(content.setup->surfaces.front().project, bench.document.project()));
        QCOMPARE(content.header.path, path);
        QCOMPARE(content.header.diskHash, contentHash(before.toStdString()));
        QCOMPARE(trouble::bytesOf(path), before);
        // Nobody else can read it, and nothing is left beside the user's file.
#ifndef Q_OS_WIN // there it is as private as the user's folder around it
        const QFileInfo folder(bench.store.folder());
        QVERIFY(!(folder.permissions() & (QFile::ReadGroup | QFile::ReadOther)));
#endif
        QCOMPARE(trouble::entries(bench.folder.path()),
                 (QStringList{QStringLiteral("part.sparkout"), QStringLiteral("state")}));
    }

    void typingWithoutAPauseIsKeptAllTheSame() {
        Bench bench({50ms, 250ms});
        QSignalSpy written(bench.autosave.get(), &Autosave::written);
        QElapsedTimer clock, sinceEdit;
        clock.start();
        sinceEdit.start();
        int pauses = 0; // where the machine was busy with others: each is worth a file
        for (int i = 0; clock.elapsed() < 1000; ++i) {
            pauses += sinceEdit.restart() >= 40;
            setDiameter(bench.document, 30 + 0.001 * i);
            QTest::qWait(10);
        }
        const QString found =
            QStringLiteral("%1 files, %2 pauses").arg(written.count()).arg(pauses);
        QVERIFY2(written.count() >= 2 && written.count() <= 5 + pauses, qPrintable(found));
    }

    void anUntouchedDocumentLeavesNothing() {
        Bench bench;
        QTest::qWait(100);
        bench.autosave.reset();
        QVERIFY(!QFileInfo::exists(bench.store.folder()));
    }

    void theRecoveryFileGoesWithASaveAndOnlyThen() {
        Bench bench;
        bench.keep(31);
        const QString file = bench.autosave->file();
        QVERIFY(QFileInfo::exists(file));
        QVERIFY(bench.document.saveAs(QStringLiteral("/nowhere/at/all.sparkout")).has_value());
        QVERIFY(QFileInfo::exists(file));
        QVERIFY(!bench.document.saveAs(bench.folder.filePath(QStringLiteral("a.sparkout"))));
        bench.autosave->saved();
        QVERIFY(!QFileInfo::exists(file));
        QVERIFY(trouble::entries(bench.store.folder()).isEmpty());
        // After a save undo still goes back, and that is unsaved work again.
        bench.document.undo();
        bench.autosave->flush();
        const RecoveryContent content = contentOf(bench.autosave->file());
        QVERIFY(content.setup && content.setup->surfaces.front().project.part->diameter_mm == 30);
        QVERIFY(content.header.modified);
    }

    void editsThatAreGivenUpStayAmongTheDiscardedOnes() {
        Bench bench({1h, 1h});
        setDiameter(bench.document, 31); // a moment ago: not written yet
        bench.autosave->discard();
        QVERIFY(bench.autosave->file().isEmpty());
        QVERIFY(bench.store.left().empty());
        const auto discarded = bench.store.discarded();
        QCOMPARE(discarded.size(), std::size_t{1});
        QVERIFY(discarded[0].state == RecoveryItem::State::discarded);
        QCOMPARE(diameterIn(discarded[0].file), 31.0);
    }

    void anotherDocumentNeverOverwritesTheRecoveryFileOfTheLast() {
        Bench bench;
        bench.keep(31);
        bench.document.startUntitled(newProject(Operation::plunge));
        bench.keep(50);
        QCOMPARE(diameterIn(bench.autosave->file()), 50.0);
        QCOMPARE(bench.store.discarded().size(), std::size_t{1});
        QCOMPARE(contentOf(bench.store.discarded()[0].file)
                     .setup->surfaces.front()
                     .project.part->diameter_mm,
                 31.0);
    }

    void aProgramThatEndsWithoutAskingKeepsTheLastKeystroke() {
        Bench bench({1h, 1h});
        setDiameter(bench.document, 31);
        bench.autosave.reset();
        const auto left = bench.store.left();
        QCOMPARE(left.size(), std::size_t{1});
        QCOMPARE(diameterIn(left[0].file), 31.0);
    }

    void editsThatWereUndoneAreNotOffered() {
        Bench bench;
        bench.keep(31);
        bench.document.undo();
        bench.autosave->flush();
        bench.autosave.reset();
        QVERIFY(bench.store.left().empty());
        QCOMPARE(bench.store.discarded().size(), std::size_t{1});
    }

    void workOfARunningSessionIsNotOfferedToAnother() {
        Bench bench;
        bench.keep(31);
        QVERIFY(bench.store.left().empty());
        // What one instance is just offering, another does not offer as well.
        bench.autosave.reset();
        const auto left = bench.store.left();
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(bench.store.left().empty());
    }

    /// Two windows that start together both keep their work: none fails because the other has made
    /// the folder between its look and its attempt.
    void instancesThatMakeTheFolderTogetherBothHaveIt() {
        const QTemporaryDir folder;
        constexpr int rounds = 300;
        std::atomic<int> waiting = 0;
        std::atomic<int> made = 0;
        const auto instance = [&] {
            for (int round = 0; round < rounds; ++round) {
                ++waiting;
                while (waiting < 2 * (round + 1)) { // both at once
                }
                made += makePrivateFolder(folder.filePath(QStringLiteral("%1/a/b").arg(round)));
            }
        };
        std::thread other(instance);
        instance();
        other.join();
        QCOMPARE(made.load(), 2 * rounds);
    }

    void whatIsLeftIsOfferedTheNewestFirst() {
        const Bench bench;
        QVERIFY(makePrivateFolder(bench.store.folder()));
        const QDateTime now(QDate(2026, 11, 22), QTime(12, 0), Qt::UTC);
        for (const int hours : {5, 1, 3}) { // in another order by name
            RecoveryHeader header;
            header.title = QString::number(hours);
            header.when = now.addSecs(-3600 * hours);
            const std::string text =
                recoveryText(header, plainSetup(newProject(Operation::plunge)));
            const QString name = QStringLiteral("/%1.recovery").arg(9 - hours);
            trouble::write(bench.store.folder() + name, QByteArray::fromStdString(text));
        }
        const auto titles = [](const std::vector<RecoveryItem>& items) {
            QStringList list;
            for (const RecoveryItem& item : items) {
                list << item.header.title;
            }
            return list;
        };
        const QStringList newestFirst{QStringLiteral("1"), QStringLiteral("3"),
                                      QStringLiteral("5")};
        const std::vector<RecoveryItem> left = bench.store.left();
        QCOMPARE(titles(left), newestFirst);
        for (const std::size_t i : {1, 0, 2}) {
            QVERIFY(bench.store.discard(left[i].file));
        }
        QCOMPARE(titles(bench.store.discarded()), newestFirst);
    }

    // The times of the files are turned around: they must not matter.
    void whatIsOfferedIsDecidedByContentAndNotByTime() {
        Bench bench;
        setDiameter(bench.document, 31);
        bench.autosave.reset();
        const QString path = bench.folder.filePath(QStringLiteral("newer.sparkout"));
        trouble::write(path, "newer than the recovery file");
        auto left = bench.store.left();
        QCOMPARE(left.size(), std::size_t{1});
        QFile file(left[0].file);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::fromSecsSinceEpoch(1000), QFile::FileModificationTime));
        file.close();
        left.clear();
        QCOMPARE(bench.store.left().size(), std::size_t{1});
    }

    void damagedFilesAreListedAsSuchAndStopNothing() {
        Bench bench;
        bench.keep(31);
        const QByteArray good = trouble::bytesOf(bench.autosave->file());
        bench.autosave->discard();
        const QList<QByteArray> bad{
            {},
            "x",
            "{}",
            "{}\n",
            QByteArray(1000, '\0'),
            good.left(good.size() / 2),
            good.left(good.size() - 1),
            QByteArray(good).replace("\"diameter_mm\": 31", "\"diameter_mm\": 32"),
            QByteArray(good).replace("sparkout-recovery", "sparkout-something"),
            QByteArray(200'000, '['),
        };
        for (qsizetype i = 0; i < bad.size(); ++i) {
            trouble::write(bench.store.folder() + QStringLiteral("/%1.recovery").arg(i), bad[i]);
        }
        QVERIFY(QDir(bench.store.folder()).mkdir(QStringLiteral("folder.recovery")));
        const bool links = trouble::strangeKinds().contains(u"zero");
        trouble::putStrange(links ? QStringLiteral("zero") : QStringLiteral("huge"),
                            bench.store.folder() + QStringLiteral("/strange.recovery"));
        const auto left = bench.store.left();
        for (const RecoveryItem& item : left) {
            QVERIFY2(item.state == RecoveryItem::State::damaged, qPrintable(item.file));
        }
        QCOMPARE(left.size(),
                 std::size_t(bad.size()) + 1);       // and the strange one, which is not read
        for (qsizetype i = 0; i < bad.size(); ++i) { // looking changes nothing
            QCOMPARE(trouble::bytesOf(bench.store.folder() + QStringLiteral("/%1.recovery").arg(i)),
                     bad[i]);
        }
    }

    void whatIsNoOrdinaryFileIsListedAndNeverOpened() {
        Bench bench;
        bench.keep(31);
        const QByteArray good = trouble::bytesOf(bench.autosave->file());
        bench.autosave->saved();
        const QString folder = bench.store.folder() + u'/';
        QStringList kinds = trouble::strangeKinds();
        kinds.removeOne(QStringLiteral("folder")); // no file at all
        for (const QString& name : kinds) {
            trouble::putStrange(name, folder + name + QStringLiteral(".recovery"));
            // And a good one whose lock is none.
            trouble::write(folder + QStringLiteral("locked-") + name + QStringLiteral(".recovery"),
                           good);
            trouble::putStrange(name, folder + QStringLiteral("locked-") + name
                                          + QStringLiteral(".lock"));
        }
        RunningTimer clock;
        auto left = bench.store.left();
        QVERIFY2(clock.elapsed() < 1000, qPrintable(QString::number(clock.elapsed())));
        QCOMPARE(left.size(), 2 * std::size_t(kinds.size()));
        for (const RecoveryItem& item : left) {
            const bool locked = QFileInfo(item.file).fileName().startsWith(u"locked-");
            QCOMPARE(item.state == RecoveryItem::State::ready, locked);
            if (locked) {
                QVERIFY(!bench.store.claim(item) && !bench.store.inUse(item));
            }
            QVERIFY2(bench.store.discard(item.file), qPrintable(item.file));
        }
        left.clear();
        QVERIFY(bench.store.left().empty());
        QCOMPARE(bench.store.discarded().size(), 2 * std::size_t(kinds.size()));
        QVERIFY(clock.elapsed() < 2000);
    }

    void manyRecoveryFilesAreListedWithinASecond_data() {
        QTest::addColumn<bool>("locked");
        QTest::newRow("without locks") << false;
        QTest::newRow("with the locks of dead programs") << true;
    }

    void manyRecoveryFilesAreListedWithinASecond() {
        QFETCH(bool, locked);
#ifdef Q_OS_WIN // Wine goes through all the names for each that is not there: 9 s for 5,000
        constexpr int files = 250;
#else
        constexpr int files = 5000;
#endif
        Bench bench;
        bench.keep(31);
        const QByteArray good = trouble::bytesOf(bench.autosave->file());
        bench.autosave->saved();
        const QString first = bench.store.folder() + QStringLiteral("/0");
        trouble::write(first + QStringLiteral(".recovery"), good);
        trouble::write(first + QStringLiteral(".lock"), trouble::deadLock());
        for (int i = 1; i < files; ++i) { // other names of the same file cost nothing to make
            const QString name = bench.store.folder() + QStringLiteral("/%1").arg(i);
            for (const QString& ending : {QStringLiteral(".recovery"), QStringLiteral(".lock")}) {
                QVERIFY((!locked && ending == u".lock")
                        || linkPath(systemPath(first + ending), systemPath(name + ending)) == 0);
            }
        }
        std::vector<RecoveryItem> left;
        // The time of the processor: what the disk and other programs take is not the window's.
        const double time_ms = leastOfTries_ms(1000, [&] {
            left.clear(); // the offer ends
            const double before_ms = processorTime_ms();
            left = bench.store.left();
            return processorTime_ms() - before_ms;
        });
        qInfo("%d recovery files are listed in %.0f ms", files, time_ms);
        QCOMPARE(left.size(), std::size_t(files));
        constexpr double target_ms = 1000;
        QVERIFY2(time_ms < 4 * target_ms, qPrintable(QString::number(time_ms)));
        QVERIFY(bench.store.claim(left.back())); // the last of them can be recovered, too
    }

    void recoveredWorkIsOfferedToNobodyElse() {
        Bench bench;
        setDiameter(bench.document, 31);
        bench.autosave.reset();
        auto left = bench.store.left();
        QCOMPARE(left.size(), std::size_t{1});
        const RecoveryClaimPtr claim = bench.store.claim(left[0]);
        QVERIFY(claim);
        QCOMPARE(claim->file(), left[0].file);
        QVERIFY(bench.store.inUse(left[0]));
        QVERIFY(!bench.store.claim(left[0]));
        left.clear();
        QVERIFY2(bench.store.left().empty(), "its session runs");
    }

    void discardedFilesAreKeptFourteenDays() {
        Bench bench;
        setDiameter(bench.document, 31);
        bench.autosave->discard();
        const QDateTime now = QDateTime::currentDateTimeUtc();
        bench.store.removeOldDiscarded(now.addDays(14));
        QCOMPARE(bench.store.discarded().size(), std::size_t{1});
        bench.store.removeOldDiscarded(now.addDays(16));
        QVERIFY(bench.store.discarded().empty());
    }

    void recoveredWorkGoesOnInTheSameFile() {
        Bench bench;
        setDiameter(bench.document, 31);
        bench.autosave.reset();
        const auto left = bench.store.left();
        QCOMPARE(left.size(), std::size_t{1});
        const RecoveryContent content = contentOf(left[0].file);

        Document document;
        Autosave autosave(document, bench.store, {20ms, 300ms});
        document.recover(*content.setup, content.header.path, content.header.diskHash, true);
        autosave.adopt(bench.store.claim(left[0]));
        QVERIFY(document.modified());
        QVERIFY(document.readOnly());
        QVERIFY(!document.canUndo());
        setDiameter(document, 32);
        QTRY_COMPARE(diameterIn(left[0].file), 32.0);
        QCOMPARE(autosave.file(), left[0].file);
        document.undo();
        QVERIFY2(document.modified(), "the state that was recovered is saved nowhere");
        autosave.saved();
        QVERIFY(!QFileInfo::exists(left[0].file));
    }

#ifdef Q_OS_WIN
    void aFileInPlaceOfTheFolderIsReportedAndLosesNothing() {
        Bench bench;
        const QString state = bench.folder.filePath(QStringLiteral("state"));
        trouble::write(state, {});
        QSignalSpy failed(bench.autosave.get(), &Autosave::failed);
        bench.keep(31);
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed[0][0].value<FileError>().step, FileStep::create);
        QVERIFY(bench.document.modified());
        QVERIFY(QFile::remove(state));
        bench.keep(32); // tried again with the next edit
        QVERIFY(!bench.autosave->file().isEmpty());
    }

    void aFileOpenElsewhereStaysAsItWas() {
        Bench bench;
        bench.keep(31);
        QSignalSpy failed(bench.autosave.get(), &Autosave::failed);
        {
            const trouble::Held held(bench.autosave->file(), trouble::Held::Against::replacing);
            bench.keep(32);
        }
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed[0][0].value<FileError>().step, FileStep::rename);
        QCOMPARE(diameterIn(bench.autosave->file()), 31.0);
        QVERIFY(bench.document.modified());
        bench.keep(33);
        QCOMPARE(diameterIn(bench.autosave->file()), 33.0);
    }
#else
    void aFolderThatTakesNoFilesIsReportedAndLosesNothing() {
        Bench bench;
        QVERIFY(QDir(bench.folder.path()).mkdir(QStringLiteral("state")));
        trouble::setMode(bench.folder.path(), 0755);
        trouble::setMode(bench.folder.filePath(QStringLiteral("state")), 0555);
        QSignalSpy failed(bench.autosave.get(), &Autosave::failed);
        {
            const trouble::Unprivileged user;
            bench.keep(31);
        }
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed[0][0].value<FileError>().step, FileStep::create);
        QVERIFY(bench.document.modified());
        trouble::setMode(bench.folder.filePath(QStringLiteral("state")), 0755);
        bench.keep(32); // tried again with the next edit
        QVERIFY(!bench.autosave->file().isEmpty());
    }

    void aFullDiskKeepsTheRecoveryFileBefore() {
        Bench bench;
        bench.keep(31);
        QSignalSpy failed(bench.autosave.get(), &Autosave::failed);
        {
            const trouble::NoBytes disk;
            bench.keep(32);
        }
        QCOMPARE(failed.count(), 1);
        QCOMPARE(diameterIn(bench.autosave->file()), 31.0);
    }
#endif

    void whatAKilledSessionLeftHalfWrittenIsTidiedAway() {
        Bench bench;
        QVERIFY(makePrivateFolder(bench.store.folder()));
        trouble::write(bench.store.folder() + QStringLiteral("/abc.lock"), trouble::deadLock());
        QVERIFY(bench.store.left().empty());
        QVERIFY(trouble::entries(bench.store.folder()).isEmpty());
    }
};

} // namespace sparkout::test_recovery

SPARKOUT_TEST(test_recovery, TestRecovery)
#include "test_recovery.moc"
