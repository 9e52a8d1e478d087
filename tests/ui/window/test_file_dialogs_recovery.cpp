// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved changes: the question about them, and what is offered of them later.
#include "tests/registry.h"
#include "tests/ui/window/file_dialogs_bench.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/form/number_field.h"
#include "ui/inputs/inputs_panel.h"

#include <QRegularExpression>
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
        EditedBench bench;
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
        EditedBench bench;
        QVERIFY(bench.window->files().save());
        DialogAnswers answers({QStringLiteral("Enter")});
        bench.window->files().openEarlierVersion();
        ANSWERED(answers);
        QCOMPARE(bench.diameter(), 30.0);
        QVERIFY(bench.document().filePath().isEmpty());
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
    }

    void openAsksForUnsavedChangesOnlyOnceAFileIsChosen() {
        OpenBench bench;
        trouble::write(bench.other, textWith(40));
        bench.edit(35);
        {
            DialogAnswers answers({QStringLiteral("Escape")}); // the file dialog, and no other
            bench.window->files().open();
            ANSWERED(answers);
        }
        QCOMPARE(bench.diameter(), 35.0);
        QVERIFY(bench.document().modified());
        DialogAnswers answers({QStringLiteral("file:") + bench.other, QStringLiteral("discard")});
        bench.window->files().open();
        ANSWERED(answers);
        QCOMPARE(bench.diameter(), 40.0);
    }

    void theUnsavedQuestionNamesTheFileAndTheEdits() {
        EditedBench bench;
        DialogAnswers answers({QStringLiteral("Escape")});
        bench.window->files().startNew(Operation::plunge);
        ANSWERED(answers);
        QVERIFY2(answers.text().contains(bench.path), qPrintable(answers.text()));
        QVERIFY2(answers.text().contains(QStringLiteral("• Diameter")), qPrintable(answers.text()));
        QCOMPARE(bench.diameter(), 31.0);
        QVERIFY(bench.document().modified());
    }

    void enterSavesBeforeSomethingElseIsOpened() {
        EditedBench bench;
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
        EditedBench bench;
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
        EditedBench bench;
        DialogAnswers answers({QStringLiteral("Escape")});
        QVERIFY(!bench.window->close());
        ANSWERED(answers);
        QVERIFY(QFileInfo::exists(bench.lock));
        QTRY_VERIFY(!bench.window->files().guard().autosave()->file().isEmpty());
        DialogAnswers end({QStringLiteral("discard")});
        bench.window->close();
    }

    void refusedTextsAreNotLostWithoutAQuestion() {
        OpenBench bench;
        QVERIFY(!bench.window->isWindowModified());
        bench.window->inputs().showPage(1);
        auto* field =
            bench.window->findChild<NumberField*>(QStringLiteral("/material/flow_stress_mpa"));
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("much"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(bench.window->isWindowModified());
        QVERIFY(!bench.document().modified());
        {
            DialogAnswers back({QStringLiteral("Escape")});
            QVERIFY(!bench.window->close());
            ANSWERED(back);
            QVERIFY2(back.text().contains(QStringLiteral("much")), qPrintable(back.text()));
        }
        QCOMPARE(field->text(), QStringLiteral("much"));
        bench.edit(31);
        {
            DialogAnswers save({QStringLiteral("save")});
            QVERIFY(bench.window->files().mayDiscard());
            ANSWERED(save);
            QVERIFY2(save.text().contains(QStringLiteral("much")), qPrintable(save.text()));
        }
        QCOMPARE(trouble::bytesOf(bench.path), textWith(31));
        QVERIFY(bench.window->isWindowModified());
        DialogAnswers away({QStringLiteral("discard")});
        QVERIFY(bench.window->close());
        ANSWERED(away);
    }

    void everyQuestionIsRussianInARussianWindow() {
        Bench bench(QStringLiteral("ru"));
        QVERIFY(bench.open());
        {
            DialogAnswers back({QStringLiteral("Escape")});
            QVERIFY(!mayLoseRefused(bench.window.get(), {}));
            ANSWERED(back);
            QVERIFY2(!back.text().contains(QStringLiteral("Continue")), qPrintable(back.text()));
        }
        bench.edit(31);
        trouble::write(bench.path, textWith(35));
        DialogAnswers answers({QStringLiteral("save"), QStringLiteral("Escape")});
        QStringList buttons;
        answers.seen = [&](QDialog& dialog) {
            for (const auto* button : dialog.findChildren<QAbstractButton*>()) {
                buttons += button->text();
            }
        };
        QVERIFY(!bench.window->files().mayDiscard());
        ANSWERED(answers);
        static const QRegularExpression english(QStringLiteral("[A-Za-z]{3,}"));
        for (const QString& text : buttons) {
            QVERIFY2(!text.contains(english), qPrintable(text));
        }
        for (QString text : answers.texts()) {
            text.remove(bench.path);
            QVERIFY2(!text.contains(english), qPrintable(text));
        }
    }
};

} // namespace sparkout::test_file_dialogs_recovery

SPARKOUT_TEST(test_file_dialogs_recovery, TestFileDialogsRecovery)
#include "test_file_dialogs_recovery.moc"
