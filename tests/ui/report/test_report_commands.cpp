// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Reports from the window: preview, printing into a file, export, and none without a result.
#include "core/study/new_project.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/logo_samples.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "tests/whole_project.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/report/paper_writer.h"
#include "ui/views/study/batch_text.h"
#include "ui/views/study/batch_view.h"
#include "ui/window/dialogs/company_dialog.h"
#include "ui/window/dialogs/report_commands.h"
#include "ui/window/file_commands.h"

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QPrintPreviewWidget>
#include <QProgressBar>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <utility>

namespace sparkout::test_report_commands {

using on_disk::bytesOf;

QString batchExample() {
    const QStringList found = examplePaths().filter(QStringLiteral("30h6-factory"));
    return found.value(0);
}

class TestReportCommands : public QObject {
    Q_OBJECT

private slots:
    void theCompanyIsFilledInOnceAndPrinted() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        const QTemporaryDir folder;
        const QString drawing = folder.filePath(QStringLiteral("logo.svg"));
        QVERIFY(QFile(QStringLiteral(":/icons/sparkout.svg")).copy(drawing));
        const QString picture = folder.filePath(QStringLiteral("logo.png"));
        const QByteArray bytes = samples::picture({160, 40}, "PNG");
        QFile file(picture);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        QString english;
        QStringList faults;
        DialogAnswers answers({QStringLiteral("keepCompany")});
        answers.seen = [&](QDialog& dialog) {
            auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("/name"));
            name->setFocus();
            QTest::keyClicks(name, QStringLiteral("Stankomash"));
            english = englishIn(dialog.windowTitle());
            auto& company = dynamic_cast<CompanyDialog&>(dialog);
            const auto* fault = dialog.findChild<QLabel*>(QStringLiteral("logoFault"));
            for (const QString& path : {examplePaths().front(), picture, drawing}) {
                company.takeLogo(path);
                faults << fault->text();
            }
        };
        bench.action("company")->trigger();
        QCOMPARE(english, QString());
        QVERIFY(!faults.at(0).isEmpty());
        QCOMPARE(faults.at(1), QString());
        QVERIFY2(faults.at(2).contains(QStringLiteral("rsvg-convert")), qPrintable(faults.at(2)));
        for (const QString& fault : faults) {
            QCOMPARE(englishIn(QString(fault)
                                   .remove(QStringLiteral("rsvg-convert -w 1200 -o "
                                                          "logo.png logo.svg"))
                                   .remove(QStringLiteral("Inkscape"))),
                     QString());
        }
        QCOMPARE(bench.settings.company().name, std::string("Stankomash"));
        QCOMPARE(bench.settings.company().logo, bytes); // the refused ones left it as it was
    }

    /// A drawing that an earlier version put into the settings: said until another takes its place.
    void aRefusedLogoOfTheSettingsIsSaidUntilItIsReplaced() {
        Settings settings = Settings::transient();
        Company company;
        company.logo = "<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
        settings.setCompany(company);
        Language language;
        MainWindow window(settings, language);
        const QString key = QStringLiteral("logoFault");
        const NoticeBar& notices = window.files().notices();
        QVERIFY(notices.textOf(key).contains(QStringLiteral("rsvg-convert")));
        DialogAnswers answers({QStringLiteral("keepCompany")});
        QString said;
        answers.seen = [&said](QDialog& dialog) {
            said = dialog.findChild<QLabel*>(QStringLiteral("logoFault"))->text();
            QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("removeLogo")),
                              Qt::LeftButton);
        };
        window.findChild<QAction*>(QStringLiteral("company"))->trigger();
        QVERIFY(said.contains(QStringLiteral("rsvg-convert")));
        QVERIFY(settings.company().logo.isEmpty());
        QVERIFY(!notices.holds(key));
    }

    void theTitlePageIsFilledInOnce() {
        Bench bench(QStringLiteral("ru"));
        QString english;
        DialogAnswers answers({QStringLiteral("keepTitlePage")});
        answers.seen = [&](QDialog& dialog) {
            auto* place = dialog.findChild<QLineEdit*>(QStringLiteral("/place"));
            place->setFocus();
            QTest::keyClicks(place, QStringLiteral("Miass "));
            english = englishIn(dialog.windowTitle());
        };
        bench.action("titlePage")->trigger();
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(english, QString());
        const auto kept = report::Institution::fromKept(bench.settings.titlePage());
        QCOMPARE(kept.place, std::string("Miass"));
        QCOMPARE(kept.ministry, std::string());
    }

    void theHandoutIsAWorksheetOrItsKey() {
        const QTemporaryDir folder;
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        for (const auto& [form, title] :
             {std::pair(1, QStringLiteral("# Рабочий лист")),
              std::pair(2, QStringLiteral("# Ключ к рабочему листу"))}) {
            const QString path = folder.filePath(QStringLiteral("%1.md").arg(form));
            DialogAnswers answers({QStringLiteral("makeHandout"), QStringLiteral("file:") + path});
            answers.seen = [form = form](QDialog& dialog) {
                if (auto* box = dialog.findChild<QComboBox*>(QStringLiteral("handoutForm"))) {
                    box->setCurrentIndex(form);
                }
            };
            bench.action("markdown-handout")->trigger();
            QCOMPARE(answers.fault(), QString());
            const QString text = QString::fromUtf8(bytesOf(path));
            QVERIFY2(text.startsWith(title), qPrintable(text.left(200)));
            QCOMPARE(text.contains(QStringLiteral("Ответы на вопросы")), form == 2);
        }
    }

    void thePreviewShowsEveryPageInTheWindowsLanguage() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        DialogAnswers answers({QStringLiteral("Escape")});
        int pages = 0;
        QString title, english;
        answers.seen = [&](QDialog& dialog) {
            pages = dialog.findChild<QPrintPreviewWidget*>()->pageCount();
            title = dialog.windowTitle();
            for (const QAction* action : dialog.findChildren<QAction*>()) {
                english += action->isVisible() ? englishIn(action->text()) : QString();
            }
        };
        bench.action("preview-card")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY2(pages >= 2, qPrintable(QString::number(pages)));
        QCOMPARE(englishIn(title), QString());
        QCOMPARE(english, QString());
    }

    /// The sheets of a form lie on the whole of a page across.
    void theOperationCardIsPreviewedOnSheetsAcross() {
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        for (const auto& [action, sheets] :
             {std::pair("preview-operation-card", 2), std::pair("preview-sketch-sheet", 1)}) {
            DialogAnswers answers({QStringLiteral("Escape")});
            int pages = 0;
            bool across = false;
            answers.seen = [&](QDialog& dialog) {
                const auto* preview = dialog.findChild<QPrintPreviewWidget*>();
                pages = preview->pageCount();
                across = preview->orientation() == QPageLayout::Landscape;
            };
            bench.action(action)->trigger();
            QCOMPARE(answers.fault(), QString());
            QCOMPARE(pages, sheets);
            QVERIFY(across);
        }
    }

    void whatCannotBeChosenWithoutAPrinterIsNotOffered() {
        WarningCatcher warnings;
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        DialogAnswers answers({QStringLiteral("Escape")});
        answers.seen = [](QDialog& dialog) {
            for (QAction* action : dialog.findChildren<QAction*>()) {
                if (action->isVisible() && action->text() == QStringLiteral("Page setup")) {
                    action->trigger();
                }
            }
        };
        bench.action("preview-card")->trigger();
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(warnings.take(), QStringList());
    }

    void theCardIsExportedAsItsEndingSays_data() {
        addColumns<QString, QString, QByteArray>("action", "name", "beginning");
        addRow("PDF", "pdf-card", "card.pdf", QByteArray("%PDF-"));
        addRow("HTML", "html-card", "card.html", QByteArray("<!DOCTYPE html>"));
        addRow("Markdown", "markdown-card", "card.md", QByteArray("# "));
        addRow("ODT", "odt-operation-card", "card.odt", QByteArray("PK"));
        addRow("form", "pdf-operation-card", "sheets.pdf", QByteArray("%PDF-"));
    }

    void theCardIsExportedAsItsEndingSays() {
        QFETCH(QString, action);
        QFETCH(QString, name);
        QFETCH(QByteArray, beginning);
        const QTemporaryDir folder;
        const QString path = folder.filePath(name);
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const DialogAnswers answers({QStringLiteral("file:") + path});
        bench.action(qPrintable(action))->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY(bytesOf(path).startsWith(beginning));
    }

    void theCardIsOfTheInputsAsTheyAreNow() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("card.md"));
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        Project project = bench.window->document().project();
        project.part->name = "Sleeve 4711";
        bench.window->document().edit(project, {"Input", "Name"});
        const DialogAnswers answers({QStringLiteral("file:") + path});
        bench.action("markdown-card")->trigger(); // before the run has ended
        QCOMPARE(answers.fault(), QString());
        QVERIFY(bytesOf(path).contains("Sleeve 4711"));
    }

    void thePassportTakesTheBatchThatIsShown() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("passport.md"));
        OpenBench bench(QStringLiteral("en"), batchExample());
        QVERIFY(bench.window->showView(QStringLiteral("batch")));
        const auto* view = bench.window->findChild<BatchView*>();
        QTRY_VERIFY_WITH_TIMEOUT(!view->busy() && view->batch() && !view->stale(), 60'000);
        const DialogAnswers answers({QStringLiteral("file:") + path}); // no other dialog comes up
        bench.action("markdown-passport")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY(bytesOf(path).startsWith("# Accuracy passport"));
        QVERIFY(bytesOf(path).contains(BatchText::share(view->batch()->summary.bad).toUtf8()));
    }

    void aBatchThatTakesLongIsStoppedAndNothingIsWritten() {
        OpenBench bench(QStringLiteral("en"), batchExample());
        Project project = bench.window->document().project();
        project.batch->parts = 1'000'000;
        bench.window->document().edit(project, {"Input", "Parts"});
        DialogAnswers answers({QStringLiteral("stopWaiting")});
        QString text;
        answers.seen = [&text](QDialog& dialog) {
            text = dialog.findChild<QProgressBar*>()->format();
        };
        RunningTimer clock;
        bench.action("pdf-passport")->trigger(); // no file dialog follows
        QCOMPARE(answers.fault(), QString());
        QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
        QVERIFY2(text.contains(QStringLiteral("of 1000000 parts")), qPrintable(text));
    }

    void whatIsWaitedForIsTheWholeBatchWhileTheWindowLives() {
        OpenBench bench(QStringLiteral("en"), batchExample());
        Project project = bench.window->document().project();
        project.batch->parts = 300;
        int beats = 0;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&beats] { ++beats; });
        timer.start(5);
        RunningTimer clock;
        const BatchOutcomePtr batch =
            BatchWait(project, QStringLiteral("Batch"), bench.window.get()).wait();
        const qint64 took_ms = clock.elapsed();
        QVERIFY(batch && batch->ran());
        QVERIFY(batch->result.statistics == runBatch(project, {}).statistics);
        QVERIFY2(beats > took_ms / 50, qPrintable(QString::number(beats)));
    }

    void aBatchThatCannotBeRunIsToldAndNotReported() {
        OpenBench bench(QStringLiteral("en"), batchExample());
        Project project = bench.window->document().project();
        project.batch->factors.dullness->grows = {0.5, 2};
        bench.window->document().edit(project, {"Input", "Dullness"});
        QTRY_VERIFY(bench.window->studies().outcome && bench.window->studies().outcome->ran());
        const DialogAnswers answers({QStringLiteral("Escape")});
        bench.action("pdf-passport")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY2(answers.text().contains(QStringLiteral("cannot be run")),
                 qPrintable(answers.text()));
    }

    void theHandoutAsksWhatItIsToHave() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("handout.md"));
        OpenBench bench(QStringLiteral("ru"), examplePaths().front());
        bench.window->cursor().toStroke(7);
        DialogAnswers answers({QStringLiteral("makeHandout"), QStringLiteral("file:") + path,
                               QStringLiteral("Escape")});
        QString english;
        answers.seen = [&english](QDialog& dialog) {
            if (const auto* step = dialog.findChild<QComboBox*>(QStringLiteral("handoutStep"))) {
                english = englishIn(dialog.windowTitle() + step->currentText());
            }
        };
        bench.action("markdown-handout")->trigger();
        QCOMPARE(english, QString());
        const QString text = QString::fromUtf8(bytesOf(path));
        QVERIFY(text.startsWith(QStringLiteral("# Раздаточный материал")));
        static const QRegularExpression count(
            QStringLiteral("\\* (Двойной ход|Оборот): \\*\\*7\\*"));
        QVERIFY2(text.contains(count), qPrintable(text.left(3000)));
        bench.action("pdf-handout")->trigger(); // left by Escape, no file dialog follows
        QCOMPARE(answers.fault(), QString());
    }

    void withoutAResultItSaysWhy() {
        Bench bench(QStringLiteral("en"));
        Project project = newProject(Operation::traverse);
        project.part->diameter_mm = -2;
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(bench.window->studies().outcome && !bench.window->studies().outcome->ran());
        for (const char* name :
             {"preview-card", "print-card", "pdf-card", "pdf-passport", "pdf-handout"}) {
            const DialogAnswers answers({QStringLiteral("Escape")});
            bench.action(name)->trigger();
            QCOMPARE(answers.fault(), QString());
            QVERIFY(answers.text().contains(QStringLiteral("There is no result")));
        }
    }
};

} // namespace sparkout::test_report_commands

SPARKOUT_TEST(test_report_commands, TestReportCommands)
#include "test_report_commands.moc"
