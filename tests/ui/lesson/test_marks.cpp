// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Marking works in the window: the same as the command line's.
#include "core/lesson/best_table.h"
#include "core/lesson/grading.h"
#include "tests/registry.h"
#include "tests/ui/lesson/lesson_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/xlsx_reader.h"
#include "ui/dialogs/copy_table.h"
#include "ui/lesson/marks_dialog.h"
#include "ui/text/language.h"

#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QUrl>

namespace sparkout::test_marks {

using namespace lesson_bench;

/// A folder of works: right, wrong and broken ones.
struct Class {
    Class() : lesson(givenOut().lesson), out(samples::giveOut(lesson, 4, 3)) {
        const auto write = [this](const QString& name, const std::string& text) {
            QVERIFY(!writeFileSafely(folder.filePath(name).toStdString(), text));
            files.push_back({name.toStdString(), text});
        };
        write(QStringLiteral("1.sparkout-work"), writeWork(samples::solved(out, 0)));
        write(QStringLiteral("2.sparkout-work"), writeWork(samples::solved(out, 1, {2, 7})));
        write(QStringLiteral("3.sparkout-work"), writeWork(out.works[2]));
        write(QStringLiteral("4.sparkout-work"), "no work");
    }
    QTemporaryDir folder;
    Lesson lesson;
    samples::GivenOut out;
    std::vector<HandedIn> files;
};

class TestMarks : public QObject {
    Q_OBJECT

private slots:
    void aDroppedFolderIsMarkedAsTheCommandLineDoes() {
        Class all;
        Settings settings = Settings::transient();
        settings.setLastFolder(all.folder.path());
        Language language;
        language.apply(QStringLiteral("en"));
        MarksDialog dialog(settings, nullptr);
        dialog.show();
        QMimeData dropped;
        dropped.setUrls(
            {QUrl::fromLocalFile(shippedLesson()), QUrl::fromLocalFile(all.folder.path())});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton,
                              Qt::NoModifier);
        QCoreApplication::sendEvent(&dialog, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&dialog, &drop);
        auto* mark = dialog.findChild<QPushButton*>(QStringLiteral("marksMark"));
        QTRY_VERIFY(mark->isEnabled());
        QSignalSpy marked(&dialog, &MarksDialog::marked);
        QTest::mouseClick(mark, Qt::LeftButton);
        QVERIFY(dialog.busy());
        QVERIFY(marked.wait(60'000));
        const std::vector<GradedWork> wanted = gradeClass(all.lesson, all.files, GradeWish());
        QCOMPARE(dialog.marks().size(), wanted.size());
        QCOMPARE(gradesCsv(dialog.lesson(), dialog.marks()), gradesCsv(all.lesson, wanted));
        QCOMPARE(dialog.findChild<CopyTable*>(QStringLiteral("marksTable"))->model()->rowCount(),
                 4);
        QVERIFY(wanted[0].points > wanted[1].points);
        // The file that is exported is the command line's, byte for byte.
        const QString csv = all.folder.filePath(QStringLiteral("marks.csv"));
        {
            DialogAnswers answers({QStringLiteral("file:") + csv});
            QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("marksExport")),
                              Qt::LeftButton);
            QCOMPARE(answers.fault(), QString());
        }
        QCOMPARE(std::get<std::string>(readFile(csv.toStdString(), 1u << 20)),
                 gradesCsv(all.lesson, wanted));
        // A workbook has the same numbers as numbers.
        const QString book = all.folder.filePath(QStringLiteral("marks.xlsx"));
        DialogAnswers bookAnswers({QStringLiteral("file:") + book});
        QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("marksBook")),
                          Qt::LeftButton);
        QCOMPARE(bookAnswers.fault(), QString());
        const XlsxReader xlsx(book);
        QCOMPARE(xlsx.fault(), QString());
        QCOMPARE(xlsx.rows(0), 6); // names and units above the works
        QCOMPARE(xlsx.text(0, 0, 3), QStringLiteral("Step 1"));
        for (int work = 0; work < 3; ++work) {
            const auto& of = wanted[std::size_t(work)];
            QCOMPARE(xlsx.number(0, work + 2, 3 + int(of.steps.size())), std::optional(of.points));
        }
        // The steps of the work in front, with the words that no engine reads.
        const QString detail =
            dialog.findChild<QTextBrowser*>(QStringLiteral("marksDetail"))->toPlainText();
        QVERIFY(detail.contains(QStringLiteral("Step 8")));
        QVERIFY(detail.contains(QStringLiteral("РЗ1 видит")));
    }

    void markingIsStopped() {
        Class all;
        Settings settings = Settings::transient();
        MarksDialog dialog(settings, nullptr);
        dialog.add({shippedLesson(), all.folder.path()});
        dialog.show();
        dialog.mark();
        QVERIFY(dialog.busy());
        QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("marksStop")),
                          Qt::LeftButton);
        QTRY_VERIFY(!dialog.busy());
        QVERIFY(dialog.marks().size() < all.files.size());
    }

    void stoppedMarkingShowsTheWorksMarkedByThen() {
        Class all;
        for (int i = 0; i < 60; ++i) {
            const QString name = QStringLiteral("more %1.sparkout-work").arg(i);
            QVERIFY(!writeFileSafely(all.folder.filePath(name).toStdString(),
                                     writeWork(samples::solved(all.out, 0))));
        }
        Settings settings = Settings::transient();
        Language language;
        language.apply(QStringLiteral("en"));
        MarksDialog dialog(settings, nullptr);
        dialog.add({shippedLesson(), all.folder.path()});
        dialog.show();
        dialog.mark();
        const auto* progress = dialog.findChild<QProgressBar*>();
        QTRY_VERIFY_WITH_TIMEOUT(progress->value() >= 2, 60'000);
        QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("marksStop")),
                          Qt::LeftButton);
        QTRY_VERIFY(!dialog.busy());
        const std::size_t marked = dialog.marks().size();
        QVERIFY(marked >= 2 && marked < 64);
        QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("marksInputs"))
                    ->text()
                    .contains(QStringLiteral("Stopped: %1 of 64").arg(marked)));
        for (const GradedWork& work : dialog.marks()) {
            QVERIFY(!work.flags.contains(WorkFlag::missing));
        }
    }

    void aListNamesWhoIsMissing() {
        Class all;
        const QString list = all.folder.filePath(QStringLiteral("group.csv"));
        QVERIFY(
            !writeFileSafely(list.toStdString(), "ФИО;группа\nСтудент 1;ТМ-31\nПетров;ТМ-31\n"));
        Settings settings = Settings::transient();
        MarksDialog dialog(settings, nullptr);
        dialog.add({shippedLesson(), all.folder.filePath(QStringLiteral("1.sparkout-work")), list});
        QSignalSpy marked(&dialog, &MarksDialog::marked);
        dialog.mark();
        QVERIFY(marked.wait(60'000));
        QCOMPARE(dialog.marks().size(), std::size_t(2));
        QVERIFY(dialog.marks()[1].flags.contains(WorkFlag::missing));
    }
};

} // namespace sparkout::test_marks

SPARKOUT_TEST(test_marks, TestMarks)
#include "test_marks.moc"
