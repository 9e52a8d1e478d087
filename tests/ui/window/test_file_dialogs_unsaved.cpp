// SPDX-License-Identifier: GPL-3.0-or-later
// The question about unsaved changes, answered with real clicks and keys.
#include "tests/registry.h"
#include "tests/ui/window/file_dialogs_bench.h"
#include "ui/fields/number_field.h"
#include "ui/inputs/inputs_panel.h"

#include <QRegularExpression>

namespace sparkout::test_file_dialogs_unsaved {

using namespace file_dialogs_bench;

class TestFileDialogsUnsaved : public QObject {
    Q_OBJECT

private slots:
    void openAsksForUnsavedChangesOnlyOnceAFileIsChosen() {
        Bench bench;
        QVERIFY(bench.open());
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

    void refusedTextsAreNotLostWithoutAQuestion() {
        Bench bench;
        QVERIFY(bench.open());
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

} // namespace sparkout::test_file_dialogs_unsaved

SPARKOUT_TEST(test_file_dialogs_unsaved, TestFileDialogsUnsaved)
#include "test_file_dialogs_unsaved.moc"
