// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Batch, sweep and search as workbooks, all parts as rows: by the window's own ways and by
// sparkout --export.
#include "core/batch/batch_summary.h"
#include "core/batch/judgement.h"
#include "core/setup/setup_run.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/ui/support/dialog_answers.h"
#include "tests/ui/support/on_disk.h"
#include "tests/ui/support/search_fixtures.h"
#include "tests/ui/support/setup_fixtures.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/xlsx_reader.h"
#include "ui/report/export_file.h"
#include "ui/text/language.h"
#include "ui/text/number_text.h"
#include "ui/views/study/batch_text.h"
#include "ui/views/study/batch_view.h"
#include "ui/views/study/found_table.h"
#include "ui/views/study/optimise_text.h"
#include "ui/window/dialogs/export_dialog.h"
#include "words/judgement_words.h"

#include <QComboBox>
#include <QTemporaryDir>

#include <bit>
#include <clocale>
#include <csignal>

using namespace sparkout;

namespace {

bool sameBits(std::optional<double> read, double value) {
    return read && std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(value + 0.0);
}

/// The row whose first cell is this; −1: none.
int rowOf(const XlsxReader& book, int sheet, const QString& first) {
    for (int row = 0; row < book.rows(sheet); ++row) {
        if (book.text(sheet, row, 0) == first) {
            return row;
        }
    }
    return -1;
}

/// The column of that head.
int columnOf(const XlsxReader& book, int sheet, const QString& head) {
    for (int column = 0; column < book.columns(sheet); ++column) {
        if (book.text(sheet, 0, column) == head) {
            return column;
        }
    }
    return -1;
}

SweepAxis axis(const char* input, double low, double high, int points) {
    SweepAxis axis;
    axis.input = input;
    axis.from = low;
    axis.to = high;
    axis.points = points;
    return axis;
}

Study sweepOf(Project project, std::vector<SweepAxis> axes) {
    project.sweep = Sweep{};
    project.sweep->inputs = std::move(axes);
    return {.sweep = std::make_shared<SweepResult>(runSweep(project, {}))};
}

struct Run {
    int status = -1;
    QString said;
};

Run endOf(QProcess& process) {
    process.waitForFinished(120'000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardError())};
}

Run exported(const QString& part, const QString& output, const QString& file,
             const QStringList& more = {}) {
    QProcess process;
    process.start(QStringLiteral(SPARKOUT_PROGRAM),
                  QStringList{QStringLiteral("--export"), part, QStringLiteral("-o"), output,
                              QStringLiteral("--lang"), QStringLiteral("en"), file}
                      + more);
    return endOf(process);
}

} // namespace

class TestExportStudies : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_english.apply(QStringLiteral("en"));
    }

    void aBatchAsAWorkbook() {
        const Project project = fixtures::shaftBatch(60);
        const Study study{.batch = runWholeBatch(project, {})};
        const BatchOutcome& outcome = *study.batch;
        const XlsxReader book(written(study));
        QCOMPARE(book.fault(), QString());
        QCOMPARE(book.names().mid(0, 3),
                 (QStringList{QStringLiteral("Batch"), QStringLiteral("Statistics"),
                              QStringLiteral("Rejects by cause")}));
        QVERIFY(book.names().contains(QStringLiteral("Rank regression")));
        QCOMPARE(book.frozen(1), QStringLiteral("A2"));
        const auto value = [&book](const char* what) {
            return rowOf(book, 0, QString::fromLatin1(what));
        };
        QVERIFY(sameBits(book.number(0, value("Parts run"), 1), 60));
        QVERIFY(sameBits(book.number(0, value("Seed"), 1), project.batch->seed));
        QCOMPARE(book.text(0, value("Deciding result"), 1), BatchText::decision(outcome));
        QCOMPARE(book.text(0, value("Verdict: the cycle"), 1),
                 BatchText::fitness(weigh(outcome.summary, outcome.result).fitness));
        QVERIFY(book.text(0, value("Factor: Stock per side"), 1)
                    .contains(QStringLiteral("uniform, 0.13")));
        const std::pair<const char*, double (*)(const CharacteristicSummary&)> figures[] = {
            {"Mean", [](const CharacteristicSummary& of) { return of.moments.mean; }},
            {"s", [](const CharacteristicSummary& of) { return of.moments.deviation; }},
            {"Minimum", [](const CharacteristicSummary& of) { return of.least.value; }},
            {"Maximum", [](const CharacteristicSummary& of) { return of.most.value; }},
        };
        const auto& all = outcome.summary.characteristics;
        QCOMPARE(book.rows(1), static_cast<int>(all.size()) + 1);
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const auto& [head, figure] : figures) {
                const int column = columnOf(book, 1, QString::fromLatin1(head));
                QVERIFY2(column > 0
                             && (all[i].count == 0
                                 || sameBits(book.number(1, static_cast<int>(i) + 1, column),
                                             figure(all[i]))),
                         head);
            }
        }
        const int histograms = static_cast<int>(book.names().indexOf(QStringLiteral("Histograms")));
        double parts = 0, expected = 0;
        for (int row = 1; row < book.rows(histograms); ++row) {
            parts += *book.number(histograms, row, 5);
        }
        for (const CharacteristicSummary& of : all) {
            expected += static_cast<double>(of.count);
        }
        QCOMPARE(parts, expected);
        const int worst = static_cast<int>(book.names().indexOf(QStringLiteral("Worst part")));
        const auto drawn = ScenarioSource(project).values(outcome.summary.worstPart);
        QVERIFY(
            sameBits(book.number(worst, 1, 1), static_cast<double>(outcome.summary.worstPart + 1)));
        for (std::size_t f = 0; f < drawn.size(); ++f) {
            QVERIFY(sameBits(book.number(worst, static_cast<int>(f) + 2, 1), drawn[f]));
        }
    }

    void aSweepAsAWorkbook() {
        const Study study = sweepOf(fixtures::traverse(), {axis("/wheel/dullness", 0.01, 0.03, 4),
                                                           axis("/part/stock_mm", 0.14, 0.16, 3)});
        const SweepResult& sweep = *study.sweep;
        QVERIFY(study.sweep->ran());
        const XlsxReader book(written(study));
        QCOMPARE(book.fault(), QString());
        QCOMPARE(book.names().mid(0, 2),
                 (QStringList{QStringLiteral("Sweep"), QStringLiteral("Points")}));
        QCOMPARE(book.names().size(), static_cast<int>(sweep.quantities.size()) + 2);
        QVERIFY(sameBits(
            book.number(0, rowOf(book, 0, QStringLiteral("Wheel › Dullness: from")), 1), 0.01));
        QVERIFY(sameBits(
            book.number(0, rowOf(book, 0, QStringLiteral("Wheel › Dullness: values")), 1), 4));
        const int heads = 2; // names and units
        QCOMPARE(book.frozen(1), QStringLiteral("A3"));
        QCOMPARE(book.rows(1), static_cast<int>(sweep.points.size()) + heads);
        for (std::size_t i = 0; i < sweep.points.size(); ++i) {
            const int row = static_cast<int>(i) + heads;
            QVERIFY(sameBits(book.number(1, row, 0), sweep.valuesAt(i)[0]));
            QVERIFY(sameBits(book.number(1, row, 1), sweep.valuesAt(i)[1]));
            for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
                const double value = sweep.points[i].values[q].value;
                QVERIFY(std::isnan(value)
                        || sameBits(book.number(1, row, 3 + 4 * static_cast<int>(q)), value));
            }
        }
        for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
            const int sheet = static_cast<int>(q) + 2;
            QCOMPARE(book.columns(sheet), 4);
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 3; ++j) {
                    const double value = sweep.points[sweep.index(i, j)].values[q].value;
                    QVERIFY(
                        std::isnan(value)
                        || sameBits(book.number(sheet, book.rows(sheet) - 4 + int(i), 1 + int(j)),
                                    value));
                }
            }
        }
    }

    void aSearchAsAWorkbook() {
        Study study{.search = search(fixtures::searchedShaft(), {.front = true})};
        study.before_s = 600;
        const SearchOutcome& outcome = *study.search;
        QVERIFY(outcome.best() && outcome.proved());
        const XlsxReader book(written(study));
        QCOMPARE(book.fault(), QString());
        QCOMPARE(book.names(),
                 (QStringList{QStringLiteral("Search"), QStringLiteral("Answer"),
                              QStringLiteral("Settings"), QStringLiteral("Cycle found"),
                              QStringLiteral("Best cycles"), QStringLiteral("Time by stages"),
                              QStringLiteral("Margin by time"),
                              QStringLiteral("Binding requirements")}));
        QCOMPARE(book.text(0, rowOf(book, 0, QStringLiteral("Notes")), 1),
                 OptimiseText::notes(outcome));
        const ValueTable answer = answerTable(outcome, study.before_s);
        const int answerHeads = book.rows(1) - static_cast<int>(answer.rows.size());
        QVERIFY(answer.rows.size() >= 3); // yours, the quickest and the limit
        for (std::size_t i = 0; i < answer.rows.size(); ++i) {
            const int row = answerHeads + static_cast<int>(i);
            QCOMPARE(book.text(1, row, 0), answer.rows[i].fullName());
            QVERIFY(sameBits(book.number(1, row, 1), std::get<double>(answer.cells[i][1].value)));
        }
        QVERIFY(
            sameBits(book.number(0, rowOf(book, 0, QStringLiteral("Time of the cycle found")), 1),
                     outcome.best()->time_s / 60));
        const auto& stages = outcome.best()->cycle.stages;
        for (std::size_t z = 0; z < stages.size(); ++z) {
            bool found = false;
            for (int row = 0; row < book.rows(3); ++row) {
                found =
                    found
                    || (book.text(3, row, 4) == QStringLiteral("/cycle/stages/%1/stock_mm").arg(z)
                        && sameBits(book.number(3, row, 3), stages[z].stock_mm));
            }
            QVERIFY(found);
        }
        const int rows = static_cast<int>(outcome.found.size());
        const int heads = book.rows(4) - rows;
        QVERIFY(heads == 1 || heads == 2);
        for (int row = 0; row < rows; ++row) {
            QVERIFY(sameBits(book.number(4, heads + row, 0),
                             outcome.found[static_cast<std::size_t>(row)].time_s / 60));
        }
        const std::vector<const FoundCycle*> front = outcome.front();
        QVERIFY(front.size() > 1);
        const int frontHeads = book.rows(6) - static_cast<int>(front.size());
        const TimeUnit unit(front.back()->time_s);
        for (std::size_t i = 0; i < front.size(); ++i) {
            const int row = frontHeads + static_cast<int>(i);
            QVERIFY(sameBits(book.number(6, row, 0), unit.of(front[i]->time_s)));
            QVERIFY(sameBits(book.number(6, row, 1), 100 * front[i]->leastRelativeMargin));
        }
        for (int row = 1; row < book.rows(2); ++row) {
            QVERIFY(book.text(2, row, 4).startsWith(QStringLiteral("/optimisation/")));
        }
        QVERIFY(book.rows(2) > 5);
    }

    void theMainTableAsCsv() {
        const Study study{.batch = runWholeBatch(fixtures::shaftBatch(30), {})};
        const QByteArray csv = studyWork(study, ExportFormat::csvEnglish)({});
        const auto& all = study.batch->summary.characteristics;
        QCOMPARE(csv.count('\n'), static_cast<qsizetype>(all.size()) + 1);
        QVERIFY(csv.contains(
            QByteArray::number(all[0].moments.mean, 'g', QLocale::FloatingPointShortest)));
    }

    void theDialogOffersWhatIsOfTheInputsOfNow() {
        const OutcomePtr outcome = evaluate(fixtures::shaftBatch(20), {});
        const Study study{.batch = runWholeBatch(fixtures::shaftBatch(20), {})};
        ExportDialog dialog(outcome, ExportFormat::xlsx, nullptr,
                            {{study, {}}, {study, QStringLiteral("too old")}});
        auto* go = dialog.findChild<QPushButton*>(QStringLiteral("exportGo"));
        auto* note = dialog.findChild<QLabel*>(QStringLiteral("exportNote"));
        auto* content = dialog.findChild<QComboBox*>(QStringLiteral("exportContent"));
        auto* format = dialog.findChild<QComboBox*>(QStringLiteral("exportFormat"));
        QVERIFY(!dialog.study() && go->isEnabled());
        QCOMPARE(content->count(), 4);
        content->setCurrentIndex(2);
        QVERIFY(dialog.study() && go->isEnabled() && dialog.choice().parts.empty());
        QCOMPARE(note->text(), studyNote(StudyKind::batch));
        content->setCurrentIndex(3);
        QVERIFY(!go->isEnabled());
        QCOMPARE(note->text(), QStringLiteral("too old"));
        format->setCurrentIndex(static_cast<int>(ExportFormat::csvEnglish));
        QCOMPARE(content->count(), static_cast<int>(allResultParts.size()) + 2);
        format->setCurrentIndex(static_cast<int>(ExportFormat::json));
        QCOMPARE(content->count(), 1);
    }

    void aViewThatShowsOtherInputsSaysSo() {
        const Project project = fixtures::shaftBatch(20);
        Studies studies;
        Document document;
        BatchView view(nullptr, nullptr, &studies);
        view.resize(700, 520);
        view.show();
        QVERIFY(studiesOffered(studies, project, document).empty());
        view.setOutcome(evaluate(project, {}));
        QTRY_VERIFY_WITH_TIMEOUT(view.batch() && !view.busy(), 60'000);
        auto offers = studiesOffered(studies, project, document);
        QCOMPARE(offers.size(), std::size_t{1});
        QCOMPARE(offers[0].obstacle, QString());
        Project other = project;
        other.wheel->dullness += 0.001;
        offers = studiesOffered(studies, other, document);
        QVERIFY2(offers[0].obstacle.contains(QStringLiteral("before the last edit")),
                 qPrintable(offers[0].obstacle));
    }

    void theViewSavesARowForEveryPart() {
        const Project project = fixtures::shaftBatch(40);
        const QString file = m_folder.filePath(QStringLiteral("rows.csv"));
        DialogAnswers answers({QStringLiteral("file:") + file});
        QVERIFY(savePartRows(nullptr, nullptr, project, TableFormat::csvRussian));
        QCOMPARE(answers.fault(), QString());
        const QByteArray bytes = on_disk::bytesOf(file);
        QVERIFY(bytes.startsWith("\xEF\xBB\xBFPart;State;Good;"));
        QCOMPARE(bytes.count("\r\n"), qsizetype(41));
        QVERIFY(!bytes.contains("0."));
        const QList<QByteArray> cells = bytes.split('\n')[1].split(';');
        const double stock = ScenarioSource(project).values(0)[0];
        QCOMPARE(QByteArray(cells[4]).replace(',', '.').toDouble(), stock);
    }

    void rowsThatAreStoppedLeaveNoFile() {
        const QString file = m_folder.filePath(QStringLiteral("stopped.csv"));
        DialogAnswers answers({QStringLiteral("file:") + file, QStringLiteral("stopWork")});
        QVERIFY(!savePartRows(nullptr, nullptr, fixtures::shaftBatch(1'000'000),
                              TableFormat::csvEnglish));
        QCOMPARE(answers.fault(), QString());
        QVERIFY(!QFile::exists(file));
        QVERIFY(QDir(m_folder.path())
                    .entryList({QStringLiteral(".sparkout-*")}, QDir::Hidden | QDir::Files)
                    .isEmpty());
    }

    void theProgramRunsAndWritesThem() {
        Project project = fixtures::searchedShaft();
        project.batch = fixtures::shaftBatch(30).batch;
        project.sweep = Sweep{};
        project.sweep->inputs = {axis("/wheel/dullness", 0.01, 0.03, 4)};
        const QString file = saved(project, "all.sparkout");
        const std::pair<const char*, const char*> parts[] = {
            {"batch", "Batch"}, {"sweep", "Sweep"}, {"search", "Search"}};
        for (const auto& [part, first] : parts) {
            const QString book = m_folder.filePath(QLatin1String(part) + QStringLiteral(".xlsx"));
            const Run run = exported(QLatin1String(part), book, file);
            QVERIFY2(run.status == 0, qPrintable(run.said));
            const XlsxReader reader(book);
            QCOMPARE(reader.fault(), QString());
            QCOMPARE(reader.names().value(0), QLatin1String(first));
            const QString csv = m_folder.filePath(QLatin1String(part) + QStringLiteral(".csv"));
            QCOMPARE(exported(QLatin1String(part), csv, file).status, 0);
            QVERIFY(on_disk::bytesOf(csv).count('\n') > 1);
        }
    }

    void theProgramRefusesWhatIsNotThere() {
        const QString plain = saved(fixtures::traverse(), "plain.sparkout");
        const QString book = m_folder.filePath(QStringLiteral("none.xlsx"));
        const std::pair<const char*, const char*> parts[] = {
            {"batch", "/batch"}, {"sweep", "/sweep"}, {"search", "/optimisation"}};
        for (const auto& [part, key] : parts) {
            const Run run = exported(QLatin1String(part), book, plain);
            QCOMPARE(run.status, 1);
            QVERIFY2(run.said.contains(QLatin1String(key)), qPrintable(run.said));
            QCOMPARE(
                exported(QLatin1String(part), m_folder.filePath(QStringLiteral("none.json")), plain)
                    .status,
                2);
        }
        Project infeasible = fixtures::searchedShaft();
        infeasible.part->tolerance.radial_runout_um = 1e-6;
        const Run run =
            exported(QStringLiteral("search"), book, saved(infeasible, "infeasible.sparkout"));
        QVERIFY2(run.status == 5 && run.said.contains(QStringLiteral("No cycle of the grid")),
                 qPrintable(run.said));
        QVERIFY(!QFile::exists(book));
    }

    void theProgramThatIsStoppedLeavesNoFile_data() {
        QTest::addColumn<QString>("part");
        QTest::newRow("batch") << "batch";
        QTest::newRow("search") << "search";
    }
    void theProgramThatIsStoppedLeavesNoFile() {
        QFETCH(QString, part);
        Project project = fixtures::endlessSearch();
        project.batch = fixtures::shaftBatch(1'000'000).batch;
        const QString book = m_folder.filePath(part + QStringLiteral("-stopped.xlsx"));
        QProcess process;
        process.setReadChannel(QProcess::StandardError);
        process.start(QStringLiteral(SPARKOUT_PROGRAM),
                      {QStringLiteral("--export"), part, QStringLiteral("-o"), book,
                       saved(project, "endless.sparkout")});
        QVERIFY(process.waitForReadyRead(60'000)); // its progress
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QCOMPARE(endOf(process).status, 130);
        QVERIFY(!QFile::exists(book));
    }

    /// With the wheel as the surfaces before have left it.
    void aSurfaceOfSeveralIsNamed() {
        const Setup setup = setup_fixtures::steppedShaft();
        const QString file = m_folder.filePath(QStringLiteral("three.sparkout"));
        setup_fixtures::writeSetupFile(setup, file);
        const QString all = m_folder.filePath(QStringLiteral("surface.json"));
        const Run unnamed = exported(QStringLiteral("all"), all, file);
        QCOMPARE(unnamed.status, 1);
        QVERIFY2(unnamed.said.contains(QStringLiteral("2 Seat")), qPrintable(unnamed.said));
        QVERIFY(!QFile::exists(all));
        const Run strange = exported(QStringLiteral("all"), all, file,
                                     {QStringLiteral("--surface"), QStringLiteral("Cone")});
        QCOMPARE(strange.status, 1);
        QVERIFY(strange.said.contains(QStringLiteral("3 Journal B")));
        const Run named = exported(QStringLiteral("all"), all, file,
                                   {QStringLiteral("--surface"), QStringLiteral("Journal B")});
        QCOMPARE(named.status, 0);
        QFile json(all);
        QVERIFY(json.open(QIODevice::ReadOnly));
        const SurfaceRun run = runSetup(setup).surfaces[2];
        const std::string wanted = judgedResultJson(
            run.result, run.constraints,
            judge(run.result, run.constraints, judgeStocks(run.result), std::nullopt));
        QCOMPARE(json.readAll().trimmed().toStdString(),
                 QByteArray::fromStdString(wanted).trimmed().toStdString());
    }

private:
    QString written(const Study& study) {
        const QString path = m_folder.filePath(QStringLiteral("book.xlsx"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) {
            return {};
        }
        file.write(studyWork(study, ExportFormat::xlsx)({}));
        return path;
    }
    QString saved(const Project& project, const char* name) {
        const QString path = m_folder.filePath(QLatin1String(name));
        on_disk::write(path, QByteArray::fromStdString(writeProject(project)));
        return path;
    }
    QTemporaryDir m_folder;
    Language m_english;
};

int main(int argc, char** argv) {
    const QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    TestExportStudies test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_export_studies.moc"
