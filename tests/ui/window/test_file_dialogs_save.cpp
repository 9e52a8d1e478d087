// SPDX-License-Identifier: GPL-3.0-or-later
// What the window asks before it saves over something, and when saving fails.
#include "tests/registry.h"
#include "tests/ui/window/file_dialogs_bench.h"

#include <cerrno>
#include <cstring>

namespace sparkout::test_file_dialogs_save {

using namespace file_dialogs_bench;

class TestFileDialogsSave : public QObject {
    Q_OBJECT

private slots:
    void whatAnotherProgramWroteIsNotSavedOverUnasked_data() {
        QTest::addColumn<QString>("answer");
        for (const char* name : {"proceed", "elsewhere", "reload", "Escape"}) {
            addRow(name, name);
        }
    }

    void whatAnotherProgramWroteIsNotSavedOverUnasked() {
        QFETCH(QString, answer);
        EditedBench bench;
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

    void aNewFileIsNamedAfterThePart_data() {
        addColumns<QString, QString, QString>("part", "title", "name");
        const auto row = [](const char* part, const char* title, const char* name) {
            addRow(name, part, title, QString::fromUtf8(name) + QStringLiteral(".sparkout"));
        };
        row("Вал 30h6", "Exercise 3", "Вал 30h6");
        row("Вал: «КП»/1\\2 ", "", "Вал_ «КП»_1_2");
        row("", "Exercise 3", "Exercise 3");
        row("..\n", "", "30h6, traverse grinding"); // of its drawing
        row("", "", "30h6, traverse grinding");
    }
    void aNewFileIsNamedAfterThePart() {
        QFETCH(QString, part);
        QFETCH(QString, title);
        QFETCH(QString, name);
        Bench bench;
        Project project = newProject(Operation::traverse);
        project.part->name = part.toStdString();
        project.part->lower_deviation_um = -13; // 30h6
        project.title = title.toStdString();
        bench.document().startUntitled(project);
        DialogAnswers answers({QStringLiteral("Escape")});
        QString proposed;
        answers.seen = [&proposed](QDialog& dialog) {
            proposed = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->text();
        };
        QVERIFY(!bench.window->files().save());
        ANSWERED(answers);
        QCOMPARE(QFileInfo(proposed).fileName(), name);
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
        QVERIFY2(text.contains(bench.path)
                     && text.contains(QString::fromLocal8Bit(std::strerror(EACCES)))
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
        EditedBench bench;
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
            QVERIFY2(answers.text().contains(QStringLiteral("hard link")),
                     qPrintable(answers.text()));
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
        // The file dialog asks whether to replace it; then the window tells who has it open.
        DialogAnswers answers({QStringLiteral("file:") + bench.other, QStringLiteral("Yes"),
                               QStringLiteral("Escape")});
        QVERIFY(!bench.window->files().saveAs());
        ANSWERED(answers);
        QVERIFY(answers.texts().last().contains(QStringLiteral("open")));
        QCOMPARE(trouble::bytesOf(bench.other), textWith(40));
        QVERIFY(lock.stillOurs());
        QCOMPARE(bench.document().filePath(), bench.path);
    }
};

} // namespace sparkout::test_file_dialogs_save

SPARKOUT_TEST(test_file_dialogs_save, TestFileDialogsSave)
#include "test_file_dialogs_save.moc"
