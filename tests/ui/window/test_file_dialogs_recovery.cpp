// SPDX-License-Identifier: GPL-3.0-or-later
// Work of a crash, work that was discarded and earlier versions, offered by the window.
#include "tests/registry.h"
#include "tests/ui/window/file_dialogs_bench.h"
#include "ui/dialogs/notice_bar.h"

#include <QTreeWidget>

namespace sparkout::test_file_dialogs_recovery {

using namespace file_dialogs_bench;

class TestFileDialogsRecovery : public QObject {
    Q_OBJECT

private slots:
    void unsavedWorkOfACrashIsOfferedAtTheStart_data() {
        QTest::addColumn<QString>("answer");
        for (const char* name : {"recover", "later", "discard", "Escape", "Enter"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }

    void unsavedWorkOfACrashIsOfferedAtTheStart() {
        QFETCH(QString, answer);
        const QTemporaryDir state;
        Bench bench(QStringLiteral("en"), state.path());
        Project project = newProject(Operation::traverse);
        project.title = "Lost <b>work</b>";
        project.part->diameter_mm = 33;
        const RecoveryStore store(state.path());
        QVERIFY(makePrivateFolder(store.folder()));
        trouble::write(
            store.folder() + QStringLiteral("/1.recovery"),
            QByteArray::fromStdString(recoveryText(
                {QStringLiteral("Lost <b>work</b>"), bench.path, QDateTime::currentDateTimeUtc(),
                 contentHash(textWith(30).toStdString()), false, true},
                plainSetup(project))));
        DialogAnswers answers({answer}); // with its last item the dialog closes by itself
        QStringList columns;
        answers.seen = [&](QDialog& dialog) {
            if (auto* row = dialog.findChild<QTreeWidget*>()->topLevelItem(0)) {
                columns = {row->text(0), row->text(1), row->text(3)};
            }
        };
        bench.window->files().start({});
        ANSWERED(answers);
        QCOMPARE(columns.value(0),
                 answer == u"discard" ? columns.value(0) : QStringLiteral("Lost <b>work</b>"));
        const bool recovered = answer == u"recover" || answer == u"Enter";
        QCOMPARE(bench.diameter() == 33, recovered);
        QCOMPARE(bench.document().modified(), recovered);
        QCOMPARE(bench.document().filePath(), recovered ? bench.path : QString());
        QCOMPARE(QFileInfo::exists(bench.lock), recovered);
        QCOMPARE(trouble::bytesOf(bench.path), textWith(30));
        QCOMPARE(store.discarded().size(), std::size_t(answer == u"discard"));
        QCOMPARE(store.left().size(), std::size_t(answer == u"later" || answer == u"Escape"));
        if (recovered) {
            QVERIFY(bench.window->files().notices().holds(QStringLiteral("recovered")));
            QVERIFY(bench.window->files().save());
            QCOMPARE(bench.diameter(), 33.0);
            QVERIFY(store.left().empty() && store.discarded().empty());
            QCOMPARE(loadProject(bench.path).setup->surfaces.front().project.part->diameter_mm,
                     33.0);
        }
    }

    void aDamagedRecoveryFileCannotBeRecoveredOnlyPutOffOrDiscarded() {
        const QTemporaryDir state;
        const RecoveryStore store(state.path());
        QVERIFY(makePrivateFolder(store.folder()));
        trouble::write(store.folder() + QStringLiteral("/1.recovery"), "nonsense");
        Bench bench(QStringLiteral("en"), state.path());
        DialogAnswers answers({QStringLiteral("Enter"), QStringLiteral("later")});
        QString shown;
        answers.seen = [&](QDialog& dialog) {
            QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("recover"))->isEnabled());
            for (const QLabel* label : dialog.findChildren<QLabel*>()) {
                shown += label->text();
            }
        };
        bench.window->files().start(bench.path);
        ANSWERED(answers);
        QVERIFY2(shown.contains(store.folder()), qPrintable(shown));
        QCOMPARE(bench.document().filePath(), bench.path); // the start went on
        QVERIFY(QFileInfo::exists(store.folder() + QStringLiteral("/1.recovery")));
    }

    void workThatAnotherWindowIsOfferingIsNotSaidToBeNone() {
        const QTemporaryDir state;
        const RecoveryStore store(state.path());
        QVERIFY(makePrivateFolder(store.folder()));
        trouble::write(store.folder() + QStringLiteral("/1.recovery"), "nonsense");
        std::vector<RecoveryItem> offered = store.left(); // as that window's dialog holds them
        QCOMPARE(offered.size(), std::size_t{1});
        Bench bench(QStringLiteral("en"), state.path());
        {
            DialogAnswers answers({QStringLiteral("Enter")});
            bench.window->files().recoverWork();
            ANSWERED(answers);
            QVERIFY2(answers.text().startsWith(QStringLiteral("Another window")),
                     qPrintable(answers.text()));
        }
        QVERIFY(bench.open()); // discarded work is there all the same
        bench.edit(31);
        {
            DialogAnswers answers({QStringLiteral("discard")});
            bench.window->files().startNew(Operation::plunge);
            ANSWERED(answers);
        }
        const auto shown = [&bench] {
            QString text;
            DialogAnswers answers({QStringLiteral("later")});
            answers.seen = [&](QDialog& dialog) {
                for (const QLabel* label : dialog.findChildren<QLabel*>()) {
                    text += label->text();
                }
            };
            bench.window->files().recoverWork();
            return answers.fault() + text;
        };
        QVERIFY2(shown().contains(QStringLiteral("Another window")), qPrintable(shown()));
        offered.clear();
        QVERIFY(!shown().contains(QStringLiteral("Another window")));
    }

    void discardedWorkCanStillBeRecovered() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        {
            DialogAnswers answers({QStringLiteral("discard")});
            bench.window->files().startNew(Operation::plunge);
            ANSWERED(answers);
        }
        DialogAnswers answers({QStringLiteral("recover")});
        bench.window->files().recoverWork();
        ANSWERED(answers);
        QCOMPARE(bench.diameter(), 31.0);
        QVERIFY(bench.document().modified());
        QCOMPARE(bench.document().filePath(), bench.path);
        DialogAnswers end({QStringLiteral("discard")});
        bench.window->close();
    }

    void anEarlierVersionIsOpenedAsACopy() {
        Bench bench;
        QVERIFY(bench.open());
        bench.edit(31);
        QVERIFY(bench.window->files().save());
        DialogAnswers answers({QStringLiteral("Enter")});
        bench.window->files().openEarlierVersion();
        ANSWERED(answers);
        QCOMPARE(bench.diameter(), 30.0);
        QVERIFY(bench.document().filePath().isEmpty());
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
    }
};

} // namespace sparkout::test_file_dialogs_recovery

SPARKOUT_TEST(test_file_dialogs_recovery, TestFileDialogsRecovery)
#include "test_file_dialogs_recovery.moc"
