// SPDX-License-Identifier: GPL-3.0-or-later
// The earlier versions that a guarded file keeps.
#include "tests/registry.h"
#include "tests/ui/support/file_guard_bench.h"

#include <QByteArrayList>
#include <QDateTime>

#include <chrono>

namespace sparkout::test_file_guard_history {

using namespace file_guard_bench;

class TestFileGuardHistory : public QObject {
    Q_OBJECT

private slots:
    void aSaveKeepsThePreviousVersionBesideTheFileAndInTheHistory() {
        EditedBench bench;
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
        QCOMPARE(bench.document.project().part->diameter_mm, 30.0);
    }

    /// Two saves within a minute: the version of somebody else is in the history, not only in
    /// NAME.bak, which the second save takes.
    void foreignVersionIsKeptHoweverSoonItComes() {
        OpenBench bench;
        const auto save = [&](double diameter_mm) {
            setDiameter(bench.document, diameter_mm);
            (void)bench.guard.claim(bench.path);
            (void)bench.guard.changedOutside(bench.path);
            QVERIFY(!bench.guard.save(bench.path));
        };
        save(31);
        for (const double foreign : {50.0, 51.0}) {
            trouble::write(bench.path, textWith(foreign));
            save(32);
            save(33);
        }
        QByteArrayList kept;
        for (const EarlierVersion& version : bench.guard.history()->versions(bench.path)) {
            kept += trouble::bytesOf(version.file);
        }
        QVERIFY(kept.contains(textWith(50)) && kept.contains(textWith(51)));
        QVERIFY2(!kept.contains(textWith(32)), "one's own comes too soon");
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
};

} // namespace sparkout::test_file_guard_history

SPARKOUT_TEST(test_file_guard_history, TestFileGuardHistory)
#include "test_file_guard_history.moc"
