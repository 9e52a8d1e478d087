// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog of an export: what it says, how it is stopped, what it leaves behind.
#include "core/file/project_file.h"
#include "tests/registry.h"
#include "tests/ui/report/export_bench.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/file_trouble.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/plot_tools.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/dialogs/watched_work.h"
#include "ui/kit/pdf_details.h"
#include "ui/session/project_io.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/window/dialogs/export_dialog.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QComboBox>
#include <QDeadlineTimer>
#include <QDesktopServices>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QFrame>
#include <QThread>
#include <QUrl>

#include <algorithm>
#include <atomic>
#include <utility>

namespace sparkout::test_export_dialog {

using namespace export_bench;

/// An outcome whose middle zone has more rows than a sheet takes.
OutcomePtr longOutcome() {
    const OutcomePtr small = fixtures::run(smallProject(Operation::traverse));
    auto outcome = std::make_shared<Outcome>(*small);
    auto& trajectory = outcome->trajectory;
    const auto nz = std::ranges::find_if(
        trajectory.passes, [](const Pass& pass) { return pass.place.zone == Zone::nz; });
    const Pass pass = *nz;
    trajectory.passes.insert(trajectory.passes.end(), xlsxRows / 4, pass);
    return outcome;
}

/// Takes what the system would open.
class OpenedUrls : public QObject {
    Q_OBJECT

public:
    OpenedUrls() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "take"); }
    ~OpenedUrls() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }

    QList<QUrl> urls;

public slots:
    void take(const QUrl& url) { urls << url; }
};

/// A button of the notice of the last file; null when there is none.
QPushButton* noticeButton(const Bench& bench, const char* text) {
    const QString name = QStringLiteral("notice ") + QString::fromLatin1(SavedFile::noticeKey);
    for (const QFrame* row : bench.window->findChildren<QFrame*>(name)) {
        for (QPushButton* button : row->findChildren<QPushButton*>()) {
            if (button->text() == QString::fromLatin1(text) && button->isVisible()) {
                return button;
            }
        }
    }
    return nullptr;
}

void click(QPushButton* button) {
    QVERIFY(button);
    QTest::mouseClick(button, Qt::LeftButton);
}

class TestExportDialog : public ExportTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void whatDoesNotFitIsSaidBeforeAnythingIsWritten() {
        const OutcomePtr outcome = longOutcome();
        ExportDialog dialog(outcome, ExportFormat::xlsx, nullptr);
        auto* go = dialog.findChild<QPushButton*>(QStringLiteral("exportGo"));
        auto* note = dialog.findChild<QLabel*>(QStringLiteral("exportNote"));
        auto* content = dialog.findChild<QComboBox*>(QStringLiteral("exportContent"));
        QVERIFY(!go->isEnabled());
        QVERIFY2(note->text().contains(QStringLiteral("Trace NZ"))
                     && note->text().contains(QLocale().toString(qulonglong(xlsxRows))),
                 qPrintable(note->text()));
        content->setCurrentIndex(1); // without the trace
        QVERIFY(go->isEnabled());
        dialog.findChild<QComboBox*>(QStringLiteral("exportFormat"))->setCurrentIndex(1);
        QVERIFY(go->isEnabled() && dialog.choice().hasTrace());
        auto unrecorded = std::make_shared<Outcome>(*outcome);
        unrecorded->trajectory = {};
        QVERIFY(
            !exportObstacle(unrecorded, {ExportFormat::csvEnglish, {ResultPart::trace}}).isEmpty());
        QVERIFY(exportObstacle(unrecorded, {ExportFormat::json, everyPart()}).isEmpty());
    }

    void theWindowExportsInItsLanguage_data() { languageRows(); }
    void theWindowExportsInItsLanguage() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        const QString path = m_folder.filePath(language + QStringLiteral(".xlsx"));
        DialogAnswers answers({QStringLiteral("exportGo"), QStringLiteral("file:") + path});
        QStringList english, cut;
        answers.seen = [&](QDialog& dialog) {
            auto* format = dialog.findChild<QComboBox*>(QStringLiteral("exportFormat"));
            for (int i = 0; format && i < format->count(); ++i) {
                format->setCurrentIndex(format->count() - 1 - i); // XLSX last
                QCoreApplication::processEvents();
                for (const ShownText& shown : textsOf(dialog)) {
                    english << englishIn(shown.text);
                }
                cut << textsWithoutRoom(dialog);
            }
            if (format) {
                dialog.findChild<QComboBox*>(QStringLiteral("exportContent"))->setCurrentIndex(1);
            }
        };
        bench.action("exportResults")->trigger();
        QCOMPARE(answers.fault(), QString());
        english.removeAll(QString());
        QVERIFY2(language == u"en" || english.isEmpty(), qPrintable(english.join(u'\n')));
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
        const XlsxReader read(path);
        QCOMPARE(read.fault(), QString());
        QCOMPARE(read.names().value(0),
                 language == u"ru" ? QStringLiteral("Исходные данные") : QStringLiteral("Inputs"));
        QCOMPARE(read.names().size(), 6);
    }

    void everyExportSaysWhereTheFileIs_data() { languageRows(); }
    void everyExportSaysWhereTheFileIs() {
        QFETCH(QString, language);
        OpenBench bench(language, examplePaths().front());
        const auto* bar = bench.window->findChild<NoticeBar*>();
        auto* feeds = bench.window->findChild<FeedsView*>();
        bench.window->viewTabs().detach(feeds); // a window of its own has no status bar
        const std::pair<QAction*, const char*> exports[] = {
            {bench.action("pdf-card"), "card.pdf"},
            {feeds->tools()->pdf, "plot.pdf"},
            {feeds->tools()->csvRussian, "curves.csv"},
            {bench.action("exportResults"), "results.xlsx"},
        };
        for (const auto& [action, name] : exports) {
            QVERIFY(action);
            const QString file = QString::fromLatin1(name);
            QStringList wanted{QStringLiteral("file:") + m_folder.filePath(language + file)};
            if (file.startsWith(u"results")) {
                wanted.prepend(QStringLiteral("exportGo"));
            }
            const DialogAnswers answers(wanted);
            action->trigger();
            QCOMPARE(answers.fault(), QString());
            QVERIFY(QFile::exists(m_folder.filePath(language + file)));
            const QString said = bar->textOf(QString::fromLatin1(SavedFile::noticeKey));
            QVERIFY2(said.contains(language + file) && said.contains(m_folder.path()),
                     qPrintable(file + QStringLiteral(": ") + said));
            QVERIFY2(language == u"en" || said.startsWith(QStringLiteral("Сохранено")),
                     qPrintable(said));
        }
    }

    void aDrawingCarriesItsProject() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QString path = m_folder.filePath(QStringLiteral("drawing.pdf"));
        const DialogAnswers answers({QStringLiteral("file:") + path});
        QVERIFY(bench.window->showView(QStringLiteral("feeds")));
        QAction* const drawing = bench.window->findChild<FeedsView*>()->tools()->pdf;
        QTRY_VERIFY(drawing->isEnabled());
        drawing->trigger();
        QCOMPARE(answers.fault(), QString());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto attached = attachmentOf(file.readAll(), QStringLiteral(".sparkout"), 10'000'000);
        QVERIFY(attached.has_value());
        const LoadedProject carried = parseProject(attached->data.toStdString());
        QVERIFY(carried.setup.has_value());
        Project expected = bench.window->document().project();
        expected.runs = {};
        QVERIFY(sameProject(carried.setup->surfaces.front().project, expected));
    }

    void anExportThatIsGivenUpConfirmsNothing() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const auto* bar = bench.window->findChild<NoticeBar*>();
        const DialogAnswers answers({QStringLiteral("Escape")});
        bench.action("pdf-card")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY(!bar->holds(QString::fromLatin1(SavedFile::noticeKey)));
    }

    void theFileAndItsFolderAreOpenedByTheSystem_data() {
        addColumns<QString, QString>("folder", "name");
        addRow("Cyrillic and spaces", "Карты цеха 2", "Карта 1.pdf");
        addRow("number sign", "line #3", "part #12 a.pdf");
        addRow("per cent", "50% done", "100%25 %41.pdf");
        addRow("others of URLs", "a&b;c", "what? yes: [1]+~'2'.pdf");
    }
    void theFileAndItsFolderAreOpenedByTheSystem() {
        QFETCH(QString, folder);
        QFETCH(QString, name);
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QDir place(m_folder.filePath(folder));
        QVERIFY(place.mkpath(QStringLiteral(".")));
        const QString path = place.filePath(name);
        OpenedUrls opened;
        for (const auto& [button, target] :
             {std::pair{"Open", path}, std::pair{"Show in folder", place.path()}}) {
            QFile::remove(path); // or it is asked whether to replace it
            const DialogAnswers answers({QStringLiteral("file:") + path});
            bench.action("pdf-card")->trigger();
            QCOMPARE(answers.fault(), QString());
            QTRY_VERIFY(noticeButton(bench, button)); // it is shown later in the event loop
            click(noticeButton(bench, button));
            QTRY_VERIFY(!opened.urls.isEmpty());
            const QUrl url = opened.urls.takeFirst();
            QCOMPARE(url.toLocalFile(), target);
            QVERIFY(QFileInfo::exists(url.toLocalFile()));
            // As another program reads it: all of it is the path, encoded once.
            const QUrl again = QUrl::fromEncoded(url.toEncoded(), QUrl::StrictMode);
            QVERIFY(!again.hasFragment() && !again.hasQuery());
            QCOMPARE(again.path(QUrl::FullyDecoded), target);
            QVERIFY(!noticeButton(bench, button)); // the notice has been answered
            QVERIFY(opened.urls.isEmpty());
        }
    }

    /// The platform of the tests has no programs to open files with.
    void withoutADesktopOneLineSaysSo() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QString path = m_folder.filePath(QStringLiteral("alone.pdf"));
        const auto* bar = bench.window->findChild<NoticeBar*>();
        const auto said = [bar] { return bar->textOf(QString::fromLatin1(SavedFile::noticeKey)); };
        for (const bool gone : {false, true}) {
            QFile::remove(path); // or it is asked whether to replace it
            const DialogAnswers answers({QStringLiteral("file:") + path});
            bench.action("pdf-card")->trigger();
            QCOMPARE(answers.fault(), QString());
            QVERIFY(!gone || QFile::remove(path));
            QTRY_VERIFY(noticeButton(bench, "Open")); // it is shown later in the event loop
            click(noticeButton(bench, "Open"));
            QTRY_VERIFY(said().contains(gone ? QStringLiteral("is no longer there")
                                             : QStringLiteral("No program opens")));
            QVERIFY(said().contains(path));
            QVERIFY(!QApplication::activeModalWidget());
        }
    }

    void aFullDiskLeavesTheOldFileWithAMessage() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        const QString path = m_folder.filePath(QStringLiteral("old.xlsx"));
        trouble::write(path, "what was there");
        const DialogAnswers answers({QStringLiteral("exportGo"), QStringLiteral("file:") + path,
                                     QStringLiteral("Yes"), QStringLiteral("Escape")});
        {
            const trouble::NoBytes full;
            bench.action("exportResults")->trigger();
        }
        QCOMPARE(answers.fault(), QString());
        QVERIFY2(answers.texts().last().contains(QStringLiteral("old.xlsx")),
                 qPrintable(answers.texts().join(u'\n')));
        QCOMPARE(trouble::bytesOf(path), QByteArray("what was there"));
        QVERIFY(trouble::entries(m_folder.path()).filter(QStringLiteral(".tmp")).isEmpty());
    }

    void aLongExportIsStoppedAtOnceAndLeavesNothing() {
        Bench bench(QStringLiteral("en"), Theme::light, [](const Project&, const auto&) {
            static const OutcomePtr outcome = longOutcome();
            return outcome;
        });
        bench.window->document().startUntitled(smallProject(Operation::traverse));
        QTRY_VERIFY(bench.window->studies().outcome);
        const QString path = m_folder.filePath(QStringLiteral("stopped.csv"));
        DialogAnswers answers({QStringLiteral("exportGo"), QStringLiteral("file:") + path,
                               QStringLiteral("stopWork")});
        QElapsedTimer clock;
        answers.seen = [&clock](QDialog& dialog) {
            if (auto* format = dialog.findChild<QComboBox*>(QStringLiteral("exportFormat"))) {
                format->setCurrentIndex(2);
            }
            clock.start();
        };
        bench.action("exportResults")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY2(clock.elapsed() < 400, qPrintable(QString::number(clock.elapsed())));
        QVERIFY(!QFile::exists(path));
    }

    void aLongWorkNamesItsFileWithoutControlCharacters() {
        QString title;
        std::atomic<bool> seen = false;
        QTimer watch;
        connect(&watch, &QTimer::timeout, &watch, [&] {
            if (const QWidget* shown = QApplication::activeModalWidget()) {
                title = shown->windowTitle() + u'|' + shown->findChild<QLabel*>()->text();
                seen = true;
            }
        });
        watch.start(10);
        const QDeadlineTimer tooLong(10'000);
        QVERIFY(runWatched(nullptr, QStringLiteral("Opening a\u202Eb\x1b.sparkout"),
                           [&](const KeepGoing&) {
                               while (!seen && !tooLong.hasExpired()) {
                                   QThread::msleep(10);
                               }
                           }));
        QCOMPARE(title, QStringLiteral("Opening a\\u202Eb\\u001B.sparkout|"
                                       "Opening a\\u202Eb\\u001B.sparkout"));
    }

    /// Its progress is shown, and asks nothing: the question after it gets the answer.
    void aLongWorkEndsByItself() {
        const DialogAnswers answers({QStringLiteral("Escape")});
        std::atomic<bool> progressSeen = false;
        QTimer watch;
        connect(&watch, &QTimer::timeout, &watch,
                [&] { progressSeen = progressSeen || QApplication::activeModalWidget(); });
        watch.start(10);
        const QDeadlineTimer tooLong(10'000);
        QVERIFY(runWatched(nullptr, QStringLiteral("work"), [&](const KeepGoing& keepGoing) {
            while (!progressSeen && !tooLong.hasExpired() && keepGoing(0.5)) {
                QThread::msleep(10);
            }
            QThread::msleep(50); // time for a wrong answer to it
        }));
        watch.stop();
        QVERIFY(progressSeen);
        QMessageBox question(QMessageBox::Warning, {}, QStringLiteral("after it"));
        question.exec();
        QCOMPARE(answers.fault(), QString());
        QCOMPARE(answers.text(), QStringLiteral("after it"));
    }

    void withoutAResultItSaysWhy() {
        Bench bench(QStringLiteral("en"));
        Project project = smallProject(Operation::traverse);
        project.part->diameter_mm = -2;
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(bench.window->studies().outcome && !bench.window->studies().outcome->ran());
        const DialogAnswers answers({QStringLiteral("Escape")});
        bench.action("exportResults")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY(answers.text().contains(QStringLiteral("There is no result")));
    }
};

} // namespace sparkout::test_export_dialog

SPARKOUT_TEST(test_export_dialog, TestExportDialog)
#include "test_export_dialog.moc"
