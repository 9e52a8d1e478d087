// SPDX-License-Identifier: GPL-3.0-or-later
// Results and traces on their way to other programs: the numbers of the engine, to the last bit.
#include "core/project/project_file.h"
#include "core/simulation/progress.h"
#include "tests/registry.h"
#include "tests/ui/dialog_answers.h"
#include "tests/ui/file_trouble.h"
#include "tests/ui/text_checks.h"
#include "tests/ui/view_fixtures.h"
#include "tests/ui/window_bench.h"
#include "tests/ui/xlsx_reader.h"
#include "ui/dialogs/watched_work.h"
#include "ui/export/export_dialog.h"
#include "ui/export/export_file.h"
#include "ui/view_tabs.h"
#include "ui/views/copy_table.h"
#include "ui/views/plot_tools.h"
#include "ui/views/view.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <atomic>
#include <bit>

namespace test_export {

using namespace sparkout;

namespace {

/// Few radii: another program reads every row.
Project smallProject(Operation operation) {
    Project project =
        operation == Operation::traverse ? fixtures::traverseProject() : fixtures::plungeProject(3);
    project.part.radii_per_section = 4;
    project.title = "=Вал <30h6>";
    project.author = "А. Иванов";
    return project;
}

QByteArray bytesOf(const OutcomePtr& outcome, const ExportChoice& choice) {
    return exportWork(outcome, choice, QDateTime(QDate(2026, 11, 22), QTime(12, 0)))({});
}

std::vector<ResultPart> everyPart() {
    return {allResultParts.begin(), allResultParts.end()};
}

bool sameBits(std::optional<double> read, double value) {
    return read && std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(value + 0.0);
}

QList<QStringList> linesOf(QByteArray csv, QChar separator) {
    QList<QStringList> lines;
    csv.replace("\xEF\xBB\xBF", "").replace("\r", "");
    for (const QByteArray& line : csv.trimmed().split('\n')) {
        lines << QString::fromUtf8(line).split(separator);
    }
    return lines;
}

QString traverseExample() {
    return examplePaths().filter(QStringLiteral("30h6-factory")).value(0);
}

/// What sparkout-cli prints of a project.
QByteArray fromCommandLine(const QStringList& arguments) {
    QProcess program;
    program.start(QStringLiteral(SPARKOUT_BUILD_DIR "/app/sparkout-cli"), arguments);
    program.waitForFinished(60'000);
    return program.readAllStandardOutput();
}

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

} // namespace

class TestExport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_english = std::make_unique<Language>();
        m_english->apply(QStringLiteral("en"));
    }

    void theWorkbookHoldsTheResultBitForBit_data() {
        QTest::addColumn<bool>("traverse");
        QTest::newRow("traverse") << true;
        QTest::newRow("plunge") << false;
    }
    void theWorkbookHoldsTheResultBitForBit() {
        QFETCH(bool, traverse);
        const OutcomePtr outcome =
            fixtures::run(smallProject(traverse ? Operation::traverse : Operation::plunge));
        const XlsxReader read = reread(bytesOf(outcome, {ExportFormat::xlsx, everyPart()}));
        QCOMPARE(read.fault(), QString());
        QCOMPARE(read.text("title"), QStringLiteral("=Вал <30h6>"));
        QCOMPARE(read.text("author"), QStringLiteral("А. Иванов"));
        QVERIFY(read.text("program").startsWith(QStringLiteral("Sparkout ")));
        const QStringList names = {QStringLiteral("Inputs"),
                                   QStringLiteral("Whole cycle"),
                                   QStringLiteral("Stages"),
                                   traverse ? QStringLiteral("Zones") : QStringLiteral("Sections"),
                                   QStringLiteral("Final profiles"),
                                   QStringLiteral("Requirements")};
        QCOMPARE(read.names().mid(0, 6), names);
        QCOMPARE(read.names().size(), 9);
        QCOMPARE(read.names()[6],
                 traverse ? QStringLiteral("Trace RZ1") : QStringLiteral("Trace Section 0"));
        checkRequirements(read, *outcome);
        checkZones(read, *outcome);
        checkTrace(read, *outcome);
        checkNoFormula(read);
    }

    void theInputsStandWithSymbolUnitValueAndKey() {
        Project project = smallProject(Operation::traverse);
        project.part.stock_mm = 0.1 + 0.05; // no short decimal
        const XlsxReader read =
            reread(bytesOf(fixtures::run(project), {ExportFormat::xlsx, {ResultPart::inputs}}));
        int seen = 0;
        for (int row = 1; row < read.rows(0); ++row) {
            const QString key = read.text(0, row, 4);
            if (key == u"/part/stock_mm") {
                QVERIFY(sameBits(read.number(0, row, 3), project.part.stock_mm));
                QCOMPARE(read.text(0, row, 2), QStringLiteral("mm"));
                QVERIFY(!read.text(0, row, 1).isEmpty());
                ++seen;
            } else if (key == u"/title") { // a text that a spreadsheet would calculate
                QCOMPARE(read.type(0, row, 3), QStringLiteral("s"));
                QCOMPARE(read.text(0, row, 3), QStringLiteral("=Вал <30h6>"));
                QVERIFY(read.quoted(0, row, 3));
                ++seen;
            }
        }
        QCOMPARE(seen, 2);
    }

    void theTraceInCsvIsThatOfTheCommandLine_data() {
        QTest::addColumn<bool>("russian");
        QTest::newRow("Russian Excel") << true;
        QTest::newRow("English") << false;
    }
    void theTraceInCsvIsThatOfTheCommandLine() {
        QFETCH(bool, russian);
        const QString trace = m_folder.filePath(QStringLiteral("trace.csv"));
        const QString project = projectFile();
        (void)fromCommandLine(
            {QStringLiteral("simulate"), project, QStringLiteral("--trace"), trace});
        const QList<QStringList> wanted = linesOf(trouble::bytesOf(trace), u',');
        const auto format = russian ? ExportFormat::csvRussian : ExportFormat::csvEnglish;
        const QByteArray bytes =
            bytesOf(fixtures::run(projectOf(project)), {format, {ResultPart::trace}});
        QVERIFY(bytes.startsWith("\xEF\xBB\xBF"));
        QList<QStringList> lines = linesOf(bytes, russian ? u';' : u',');
        QVERIFY(wanted.size() > 1000);
        QCOMPARE(lines.size(), wanted.size());
        for (qsizetype row = 1; row < lines.size(); ++row) {
            QCOMPARE(lines[row].size(), wanted[row].size());
            for (qsizetype i = 0; i < wanted[row].size(); ++i) {
                if (i == 3) { // the section, which the table names
                    QVERIFY(lines[row][i].endsWith(wanted[row][i]));
                    continue;
                }
                bool isNumber = false;
                const double value = wanted[row][i].toDouble(&isNumber);
                QString cell = lines[row][i];
                QVERIFY(!isNumber || !cell.contains(russian ? u'.' : u','));
                QVERIFY(!isNumber || sameBits(cell.replace(u',', u'.').toDouble(), value));
            }
        }
    }

    void everyPartGoesIntoCsvOfItsOwn() {
        const OutcomePtr outcome = fixtures::run(smallProject(Operation::traverse));
        for (const ResultPart part : allResultParts) {
            const QByteArray bytes = bytesOf(outcome, {ExportFormat::csvRussian, {part}});
            const auto lines = bytes.count("\r\n");
            QCOMPARE(lines, qsizetype(partSheet(outcome, part).rows) + 1);
            QVERIFY2(lines > 2, partKey(part));
        }
    }

    void jsonIsTheObjectOfTheCommandLine() {
        const QString project = projectFile();
        const QByteArray wanted =
            fromCommandLine({QStringLiteral("simulate"), project, QStringLiteral("--json")});
        QVERIFY(wanted.size() > 1000);
        QCOMPARE(bytesOf(fixtures::run(projectOf(project)), {ExportFormat::json, {}}), wanted);
    }

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

    void theWindowExportsInItsLanguage_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("Russian") << "ru";
        QTest::newRow("English") << "en";
    }
    void theWindowExportsInItsLanguage() {
        QFETCH(QString, language);
        Bench bench(language);
        QVERIFY(bench.open(examplePaths().front()));
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

    void aFullDiskLeavesTheOldFileWithAMessage() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()));
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
        QTRY_VERIFY(bench.window->outcome());
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

    /// Its progress is shown, and asks nothing: the question after it gets the answer.
    void aLongWorkEndsByItself() {
        const DialogAnswers answers({QStringLiteral("Escape")});
        std::atomic<bool> progressSeen = false;
        QTimer watch;
        connect(&watch, &QTimer::timeout, &watch,
                [&] { progressSeen = QApplication::activeModalWidget() != nullptr; });
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
        project.part.diameter_mm = -2;
        bench.window->document().startUntitled(project);
        QTRY_VERIFY(bench.window->outcome() && !bench.window->outcome()->ran());
        const DialogAnswers answers({QStringLiteral("Escape")});
        bench.action("exportResults")->trigger();
        QCOMPARE(answers.fault(), QString());
        QVERIFY(answers.text().contains(QStringLiteral("There is no result")));
    }

    void everyPlotIsSavedAsAWorkbookWithItsUnitsApart_data() {
        theWindowExportsInItsLanguage_data();
    }
    void everyPlotIsSavedAsAWorkbookWithItsUnitsApart() {
        QFETCH(QString, language);
        Bench bench(language);
        QVERIFY(bench.open(traverseExample()));
        int saved = 0, units = 0;
        for (View* view : bench.window->views()) {
            bench.window->viewTabs().showView(view);
            bench.settle();
            for (const PlotTools* tools : view->findChildren<PlotTools*>()) {
                if (!tools->xlsx->isEnabled() || view->objectName() == u"batch"
                    || view->objectName() == u"compare") { // nothing in them yet
                    continue;
                }
                const QString path =
                    m_folder.filePath(QStringLiteral("%1-%2.xlsx").arg(language).arg(++saved));
                const DialogAnswers answers({QStringLiteral("file:") + path});
                tools->xlsx->trigger();
                QCOMPARE(answers.fault(), QString());
                const XlsxReader read(path);
                QCOMPARE(read.fault(), QString());
                checkNoFormula(read);
                units += checkUnits(read);
                if (view->objectName() == u"feeds") { // a grid of zones
                    QCOMPARE(read.names(),
                             language == u"ru"
                                 ? QStringList({QStringLiteral("РЗ1"), QStringLiteral("НЗ"),
                                                QStringLiteral("РЗ2")})
                                 : QStringList({QStringLiteral("RZ1"), QStringLiteral("NZ"),
                                                QStringLiteral("RZ2")}));
                }
            }
        }
        QVERIFY2(saved >= 5 && units >= 20, qPrintable(QString::number(units)));
    }

    void tablesAreSavedFromTheirMenu() {
        Bench bench(QStringLiteral("ru"));
        QVERIFY(bench.open(examplePaths().front()));
        QVERIFY(bench.window->showView(QStringLiteral("constraints")));
        bench.settle();
        for (const char* name : {"requirements", "shop", "margins"}) {
            auto* table = bench.window->findChild<CopyTable*>(QLatin1StringView(name));
            const QStringList texts = saveTableByMenu(*table, 0, "table.xlsx");
            QCOMPARE(texts.size(), 5); // copy, save as, and three formats
            for (const QString& text : texts) {
                QCOMPARE(englishIn(text), QString());
            }
            const XlsxReader read(m_folder.filePath(QStringLiteral("table.xlsx")));
            QCOMPARE(read.fault(), QString());
            QVERIFY(read.rows(0) > 3);
            checkNoFormula(read);
            (void)saveTableByMenu(*table, 1, "table.csv");
            const QByteArray csv = trouble::bytesOf(m_folder.filePath(QStringLiteral("table.csv")));
            QVERIFY(csv.startsWith("\xEF\xBB\xBF") && csv.count(';') > 10);
        }
        // To the last bit, which the table on the screen does not show.
        auto* margins = bench.window->findChild<CopyTable*>(QStringLiteral("requirements"));
        (void)saveTableByMenu(*margins, 0, "table.xlsx");
        const XlsxReader read(m_folder.filePath(QStringLiteral("table.xlsx")));
        const auto& constraints = bench.window->outcome()->constraints;
        const int head = read.rows(0) - static_cast<int>(constraints.size());
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            QVERIFY(sameBits(read.number(0, head + int(i), 2), constraints[i].value));
            QVERIFY(sameBits(read.number(0, head + int(i), 4), constraints[i].margin));
        }
    }

    void anEmptyTableIsNotOffered() {
        CopyTable table([] { return QString(); });
        table.setSaving([] { return CsvTable(); }, [] { return QString(); }, nullptr);
        table.show();
        QMenu* menu = menuOf(table);
        QVERIFY(menu);
        QVERIFY(!menu->actions().last()->isEnabled());
        menu->close();
    }

private:
    XlsxReader reread(const QByteArray& bytes) {
        const QString path = m_folder.filePath(QStringLiteral("book.xlsx"));
        trouble::write(path, bytes);
        return XlsxReader(path);
    }

    QString projectFile() {
        return QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/projects/smallest-plunge.sparkout");
    }

    static Project projectOf(const QString& path) {
        const QByteArray bytes = trouble::bytesOf(path);
        return readProject(bytes.toStdString()).project.value();
    }

    static void checkRequirements(const XlsxReader& read, const Outcome& outcome) {
        const int head = read.rows(5) - static_cast<int>(outcome.constraints.size());
        QCOMPARE(head, 2); // names and units: of what is used up
        for (std::size_t i = 0; i < outcome.constraints.size(); ++i) {
            const ConstraintResult& c = outcome.constraints[i];
            const int row = head + static_cast<int>(i);
            QVERIFY(sameBits(read.number(5, row, 2), c.value));
            QVERIFY(sameBits(read.number(5, row, 3), c.limit));
            QVERIFY(sameBits(read.number(5, row, 4), c.margin));
            QVERIFY(!read.text(5, row, 1).isEmpty());
        }
    }

    static void checkZones(const XlsxReader& read, const Outcome& outcome) {
        QCOMPARE(read.text(3, 1, 1), QStringLiteral("mm"));
        QCOMPARE(read.text(3, 1, 3), QStringLiteral("µm"));
        for (std::size_t i = 0; i < outcome.result.sections.size(); ++i) {
            const SectionResult& section = outcome.result.sections[i];
            const int row = 2 + static_cast<int>(i);
            QVERIFY(sameBits(read.number(3, row, 1), section.position_mm));
            QVERIFY(sameBits(read.number(3, row, 2), section.compliance_mm_per_n));
            QVERIFY(sameBits(read.number(3, row, 3), section.diameterDeviationMin_mm * 1000));
            QVERIFY(sameBits(read.number(3, row, 5), section.radialRunout_mm * 1000));
        }
    }

    /// Every visit of every zone, in their order.
    static void checkTrace(const XlsxReader& read, const Outcome& outcome) {
        const bool traverse = outcome.result.project.operation == Operation::traverse;
        const int first = traverse ? 7 : 5; // column of the programmed feed
        std::vector<int> rows(outcome.result.sections.size(), 2);
        for (const Pass& pass : outcome.trajectory.passes) {
            const auto section = sectionOf(pass.place);
            const int sheet = 6 + static_cast<int>(section);
            for (int k = 0; k < outcome.trajectory.radii; ++k) {
                const int row = rows[section]++;
                const Visit& visit = outcome.trajectory.visits[pass.firstVisit + std::size_t(k)];
                QVERIFY(sameBits(read.number(sheet, row, 0), visit.time_s / 60));
                QVERIFY(sameBits(read.number(sheet, row, first), visit.programmed_mm));
                QVERIFY(sameBits(read.number(sheet, row, first + 1), visit.actual_mm));
                QVERIFY(sameBits(read.number(sheet, row, first + 2), visit.accumulated_mm));
                QVERIFY(sameBits(read.number(sheet, row, first + 4), visit.normalForce_n));
            }
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QCOMPARE(read.rows(6 + static_cast<int>(i)), rows[i]);
            QCOMPARE(read.text(6, 1, first), QStringLiteral("mm"));
            QCOMPARE(read.frozen(6), QStringLiteral("A3"));
        }
    }

    static void checkNoFormula(const XlsxReader& read) {
        for (int sheet = 0; sheet < read.names().size(); ++sheet) {
            QVERIFY(!QJsonDocument(read.sheet(sheet)).toJson().contains("\"f\""));
        }
    }

    /// No name of a column ends in a unit; returns how many have one of their own.
    static int checkUnits(const XlsxReader& read) {
        static const QRegularExpression tail(
            QStringLiteral(", ([^ ,]+/[^ ,]+|[µмmcс%°НNWВтkкВJДж]{1,3}³?|min|мин|мкм|кВт)$"));
        int units = 0;
        for (int sheet = 0; sheet < read.names().size(); ++sheet) {
            for (int i = 0; i < read.columns(sheet); ++i) {
                const QString name = read.text(sheet, 0, i);
                if (tail.match(name).hasMatch()) {
                    QTest::qFail(qPrintable(name), __FILE__, __LINE__);
                }
                units += read.frozen(sheet) == u"A3" && !read.text(sheet, 1, i).isEmpty() ? 1 : 0;
            }
        }
        return units;
    }

    static QMenu* menuOf(CopyTable& table) {
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, table.mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(table.viewport(), &event);
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }

    /// Saves it in one of the formats of its menu; returns the texts of that.
    QStringList saveTableByMenu(CopyTable& table, int format, const char* name) {
        QMenu* menu = menuOf(table);
        if (!menu) {
            return {};
        }
        QMenu* formats = menu->actions().last()->menu();
        QStringList texts;
        for (const QAction* action : menu->actions() + formats->actions()) {
            texts << action->text();
        }
        const QString path = m_folder.filePath(QLatin1StringView(name));
        QFile::remove(path);
        const DialogAnswers answers({QStringLiteral("file:") + path});
        QAction* save = formats->actions().at(format);
        menu->hide();
        save->trigger();
        if (!answers.fault().isEmpty()) {
            QTest::qFail(qPrintable(answers.fault()), __FILE__, __LINE__);
        }
        return texts;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Language> m_english;
};

} // namespace test_export

SPARKOUT_TEST(test_export, TestExport)
#include "test_export.moc"
