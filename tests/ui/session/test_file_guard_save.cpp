// SPDX-License-Identifier: GPL-3.0-or-later
// A guarded file is saved: what it replaces, what it refuses, what stays when it fails.
#include "core/file/file_system.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/support/file_guard_bench.h"
#include "tests/ui/support/untitled.h"
#include "ui/session/project_io.h"

#include <cerrno>

namespace sparkout::test_file_guard_save {

using namespace file_guard_bench;

#ifdef Q_OS_WIN

constexpr const char* troubles[] = {"open elsewhere", "not to be replaced", "a folder"};

std::optional<FileError> saveInto(const QString& trouble, Bench& bench, FileStep& expected) {
    using trouble::Held;
    expected = trouble == u"open elsewhere" ? FileStep::open : FileStep::rename;
    const Held held(bench.path, trouble == u"open elsewhere" ? Held::Against::everything
                                                             : Held::Against::replacing);
    return bench.guard.save(bench.path);
}

#else

constexpr const char* troubles[] = {"no bytes", "full disk", "read-only folder", "a folder",
                                    "fifo"};

std::optional<FileError> saveInto(const QString& trouble, Bench& bench, FileStep& expected) {
    expected = FileStep::write;
    if (trouble == u"read-only folder") {
        expected = FileStep::create;
        trouble::giveAway(bench.path);
        trouble::setMode(bench.folder.path(), 0555);
        const trouble::Unprivileged user;
        return bench.guard.save(bench.path);
    }
    if (trouble == u"no bytes") {
        const trouble::NoBytes disk;
        return bench.guard.save(bench.path);
    }
    return bench.guard.save(bench.path);
}

#endif

class TestFileGuardSave : public QObject {
    Q_OBJECT

private slots:
    void theRecoveryFileGoesWithTheSave() {
        EditedBench bench;
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
        for (const char* name : troubles) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void aSaveThatCannotBeWrittenChangesNothing() {
        QFETCH(QString, trouble);
        Bench bench;
        QString path = bench.path;
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
        FileStep expected = FileStep::notRegular;
        std::optional<FileError> error;
        if (trouble == u"a folder" || trouble == u"fifo") {
            QVERIFY(QFile::remove(path));
            trouble::putStrange(
                trouble == u"fifo" ? QStringLiteral("pipe") : QStringLiteral("folder"), path);
            error = bench.guard.save(path);
        } else {
            error = saveInto(trouble, bench, expected);
        }
        trouble::setMode(bench.folder.path(), 0700);
        QVERIFY(error.has_value());
        QCOMPARE(error->step, expected);
        QCOMPARE(error->path, path.toStdString());
        QVERIFY(expected == FileStep::notRegular || error->systemError != 0);
        QVERIFY(bench.document.modified());
        QCOMPARE(bench.document.project().part->diameter_mm, 31.0);
        if (expected != FileStep::notRegular) {
            QVERIFY(error->freeBytes.has_value());
            QCOMPARE(trouble::bytesOf(path), before);
        } else {
            QVERIFY2(!QFileInfo(path).isFile(), "it was not replaced");
        }
        QFile::remove(smallDisk + QStringLiteral("/filler"));
    }

    void hardLinksAreCounted() {
        Bench bench;
        QCOMPARE(linkCount(bench.path), 1u);
        QCOMPARE(linkPath(systemPath(bench.path),
                          systemPath(bench.folder.filePath(QStringLiteral("second")))),
                 0);
        QCOMPARE(linkCount(bench.path), 2u);
        QCOMPARE(linkCount(QStringLiteral("/nowhere/at/all")), 1u);
    }

    void theUnsavedEditsAreKnownByName() {
        Untitled document(newProject(Operation::traverse));
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
        document.take(*loaded.setup, bench.path, loaded.hash, false);
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
        RunningTimer clock;
        const SavedContent saved =
            saveContent([&project] { return projectText(plainSetup(project)); }, bench.path,
                        {.keepBackup = true});
        const qint64 saving_ms = clock.restart();
        QVERIFY(!saved.error);
        const LoadedProject loaded = loadProject(bench.path);
        const qint64 loading_ms = clock.restart();
        QVERIFY(loaded.setup.has_value());
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

} // namespace sparkout::test_file_guard_save

SPARKOUT_TEST(test_file_guard_save, TestFileGuardSave)
#include "test_file_guard_save.moc"
