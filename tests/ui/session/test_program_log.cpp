// SPDX-License-Identifier: GPL-3.0-or-later
// The log of the session, the versions and the licences: complete, bounded, to be copied.
#include "core/study/engine_info.h"
#include "core/version.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "ui/session/program_log.h"
#include "ui/window/dialogs/about_dialog.h"
#include "ui/window/file_commands.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>

#include <thread>

#include <algorithm>

namespace sparkout::test_program_log {

class TestProgramLog : public QObject {
    Q_OBJECT

private slots:
    void whatQtAndTheProgramReportIsKeptInOrder() {
        const ProgramLog log;
        QTest::ignoreMessage(QtWarningMsg, "a warning");
        qWarning("a warning");
        ProgramLog::note(QStringLiteral("a note"));
        const auto lines = log.lines();
        QCOMPARE(lines.size(), std::size_t(2));
        QCOMPARE(lines[0].text, QStringLiteral("a warning"));
        QCOMPARE(lines[0].type, QtWarningMsg);
        QCOMPARE(lines[1].text, QStringLiteral("a note"));
        QVERIFY(lines[0].when <= lines[1].when);
    }

    void noLineSteersTheDisplay() {
        const ProgramLog log;
        ProgramLog::note(QStringLiteral("Opened: a\u202Eb\x1b[2J\x07"));
        QCOMPARE(log.lines().front().text, QStringLiteral("Opened: a\uFFFDb\uFFFD[2J\uFFFD"));
    }

    void itsSizeIsBounded() {
        const ProgramLog log;
        const QString line(ProgramLog::longestLine * 3, u'x');
        constexpr int more = 5;
        for (std::size_t i = 0; i < ProgramLog::mostLines + more; ++i) {
            ProgramLog::note(QString::number(i) + line);
        }
        const auto lines = log.lines();
        QCOMPARE(lines.size(), ProgramLog::mostLines);
        QCOMPARE(log.dropped(), more);
        QVERIFY(lines.front().text.startsWith(QStringLiteral("5x"))); // the newest are kept
        for (const LogLine& one : lines) {
            QVERIFY(one.text.size() <= ProgramLog::longestLine);
        }
    }

    void everyThreadIsHeard() {
        const ProgramLog log;
        constexpr int threads = 4;
        constexpr int notes = 50;
        std::vector<std::jthread> all;
        for (int t = 0; t < threads; ++t) {
            all.emplace_back([] {
                for (int i = 0; i < notes; ++i) {
                    ProgramLog::note(QStringLiteral("x"));
                }
            });
        }
        all.clear();
        QCOMPARE(log.lines().size(), std::size_t(threads * notes));
    }

    void withoutALogNothingHappens() {
        QVERIFY(!ProgramLog::current());
        ProgramLog::note(QStringLiteral("nobody listens"));
        const LogDialog dialog(ProgramLog::current());
        QVERIFY(!dialog.text().isEmpty());
    }

    void theDialogFollowsAndCopies() {
        const ProgramLog log;
        const Bench bench(QStringLiteral("ru"));
        ProgramLog::note(QStringLiteral("first"));
        bench.action("log")->trigger();
        auto* dialog = bench.window->findChild<LogDialog*>();
        QVERIFY(dialog && dialog->isVisible() && !dialog->isModal());
        QVERIFY(dialog->text().endsWith(QStringLiteral("first")));
        bench.settle(); // what the platform says of the window's size comes first
        QTest::ignoreMessage(QtWarningMsg, "second");
        qWarning("second");
        QTRY_VERIFY(dialog->text().endsWith(QStringLiteral("предупреждение: second")));
        QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("copyLog")),
                          Qt::LeftButton);
        QCOMPARE(QGuiApplication::clipboard()->text(), dialog->text());
        bench.action("log")->trigger(); // the same dialog, not another
        QCOMPARE(bench.window->findChildren<LogDialog*>().size(), 1);
    }

    void openedFilesAreNoted() {
        const ProgramLog log;
        Bench bench(QStringLiteral("en"));
        const QString path = examplePaths().front();
        bench.window->files().openInstead(path);
        QTRY_VERIFY(bench.window->studies().outcome != nullptr);
        const QString opened = QStringLiteral("Opened: ") + path; // Qt may have warned since
        const auto lines = log.lines();
        QVERIFY(std::any_of(lines.begin(), lines.end(),
                            [&](const auto& line) { return line.text == opened; }));
    }

    void theVersionsAreNamedAndCopied() {
        AboutDialog about;
        about.show();
        QTest::mouseClick(about.findChild<QPushButton*>(QStringLiteral("copyVersions")),
                          Qt::LeftButton);
        const QString text = QGuiApplication::clipboard()->text();
        QCOMPARE(text, AboutDialog::versions());
        const EngineInfo engine = engineInfo();
        for (const std::string& part : {std::string(version), std::string(qVersion()),
                                        engine.compiler, engine.eigen, engine.vectorUnit}) {
            QVERIFY2(!part.empty() && text.contains(QString::fromStdString(part)), part.c_str());
        }
    }

    void everyLicenceIsShownInFull() {
        LicencesDialog dialog;
        auto* list = dialog.findChild<QListWidget*>();
        const auto* text = dialog.findChild<QPlainTextEdit*>();
        const auto all = LicencesDialog::components();
        QVERIFY(all.size() > 10);
        QCOMPARE(static_cast<std::size_t>(list->count()), all.size());
        for (int row = 0; row < list->count(); ++row) {
            const auto& each = all[static_cast<std::size_t>(row)];
            const QString licence = LicencesDialog::textsOf(each.licence);
            list->setCurrentRow(row);
            QVERIFY2(licence.size() > 500, qPrintable(each.licence));
            QVERIFY(text->toPlainText().startsWith(each.name));
            QVERIFY(text->toPlainText().contains(each.copyright));
            QVERIFY(text->toPlainText().contains(licence.trimmed().right(100)));
        }
        QVERIFY(LicencesDialog::textsOf(QStringLiteral("GPL-3.0-or-later"))
                    .contains(QStringLiteral("END OF TERMS AND CONDITIONS")));
        QVERIFY(LicencesDialog::textsOf(QStringLiteral("MIT AND Unheard-of")).isEmpty());
    }

    void everyLibraryOfAboutHasItsLicence() {
        const auto all = LicencesDialog::components();
        const QString versions = AboutDialog::versions();
        for (const char* name :
             {"Qt", "QCustomPlot", "Eigen", "JSON", "Boost", "NLopt", "qpdf", "zlib", "Snowball"}) {
            const QString wanted = QString::fromUtf8(name);
            QVERIFY2(versions.contains(wanted), name);
            QVERIFY2(std::any_of(all.begin(), all.end(),
                                 [&](const auto& each) { return each.name.contains(wanted); }),
                     name);
        }
    }

    void aboutLeadsToTheLicences() {
        AboutDialog about;
        about.show();
        bool shown = false;
        QTimer::singleShot(0, &about, [&] {
            auto* licences = about.findChild<LicencesDialog*>();
            shown = licences && licences->isVisible();
            if (licences) {
                licences->reject();
            }
        });
        about.findChild<QPushButton*>(QStringLiteral("licences"))->click();
        QVERIFY(shown);
    }
};

} // namespace sparkout::test_program_log

SPARKOUT_TEST(test_program_log, TestProgramLog)
#include "test_program_log.moc"
