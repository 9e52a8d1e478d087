// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The view "Compare": the table holds what differs and nothing else, and the list keeps, restores,
// renames and deletes.
#include "core/file/project_file.h"
#include "core/quality/roughness.h"
#include "tests/registry.h"
#include "tests/ui/support/window_bench.h"
#include "tests/ui/views/cycle/compare_bench.h"
#include "ui/dialogs/copy_table.h"
#include "ui/dialogs/notice_bar.h"
#include "ui/results/verdict_table.h"
#include "ui/session/project_io.h"
#include "ui/text/example_texts.h"
#include "ui/text/judgement_text.h"
#include "ui/text/language.h"
#include "ui/text/names.h"
#include "ui/views/cycle/runs_panel.h"
#include "ui/window/file_commands.h"

#include <QAction>
#include <QClipboard>
#include <QHeaderView>
#include <QIcon>
#include <QImage>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <QTemporaryDir>

#include <algorithm>
#include <variant>

namespace sparkout::test_compare_view {

using namespace compare_bench;

/// The light of a run in the list.
QImage markOf(const QModelIndex& row) {
    const QPixmap mark = row.data(Qt::DecorationRole).value<QIcon>().pixmap(RunsModel::sample);
    const int side = RunsModel::sample.height();
    return mark.toImage()
        .copy(RunsModel::sample.width() - side, 0, side, side)
        .convertToFormat(QImage::Format_ARGB32);
}

class TestCompareView : public QObject {
    Q_OBJECT

private slots:
    void theTableHoldsWhatDiffersAndNothingElse() {
        Desk desk;
        const Project first = desk.document.project();
        desk.keep();
        QCOMPARE(desk.view.table()->rowCount(), 0);
        QVERIFY(desk.text("compareEmpty").contains(QStringLiteral("have the same inputs")));
        desk.change(quicker);
        const Project& now = desk.document.project();
        QStringList inputs;
        for (const RunRow& row : desk.view.rows()) {
            QCOMPARE(row.shown.size(), 2);
            QVERIFY2(row.shown[0] != row.shown[1], qPrintable(row.what));
            inputs += row.isResult ? QStringList() : QStringList{row.what};
        }
        QCOMPARE(inputs, (QStringList{QStringLiteral("Wheel › Dullness"),
                                      QStringLiteral("Cycle › Stages › Stage 1 › Axial feed")}));
        const RunRow* feed = desk.find(inputs[1]);
        QCOMPARE(std::get<double>(feed->cells[0]), *now.cycle->stages[0].axial_feed_mm_min);
        QCOMPARE(std::get<double>(feed->cells[1]), *first.cycle->stages[0].axial_feed_mm_min);
        QCOMPARE(feed->unit, QStringLiteral("mm/min"));
        const RunRow* time = desk.find(QStringLiteral("Cycle time"));
        QVERIFY(time && time->isResult);
        QCOMPARE(std::get<double>(time->cells[0]) * 60, desk.outcome->result.time_s);
        const RunRow* largest = desk.find(QStringLiteral("NZ › Maximum diameter, deviation"));
        QVERIFY(largest);
        QCOMPARE(std::get<double>(largest->cells[0]),
                 desk.outcome->result.sections[1].diameterDeviationMax_mm * 1e3);
    }

    /// As in all other tables: the ratio to the nearer end of the machine's range, without a unit.
    void theMarginOfASettingIsARatio() {
        Project project = fixtures::traverseProject();
        project.machine->limits.axial_feed_mm_min = std::vector<double>{100, 10'000, 1};
        project.cycle->stages[1].axial_feed_mm_min = 300;
        Desk desk(project);
        desk.keep();
        desk.change([](Project& of) { of.cycle->stages[1].axial_feed_mm_min = 400; });
        const QString name =
            QStringLiteral("Margin › ") + Names::constraint(ConstraintKind::rangeAxialFeed);
        const RunRow* const margin = desk.find(name);
        QVERIFY(margin);
        QCOMPARE(margin->shown, (QStringList{QStringLiteral("4×"), QStringLiteral("3×")}));
        QCOMPARE(margin->unit, QString());
        QCOMPARE(std::get<double>(margin->cells[0]), 4.0);
        QCOMPARE(std::get<double>(margin->cells[1]), 3.0);
        const std::vector<ConstraintResult> worst = worstByKind(desk.outcome->constraints);
        const auto present =
            std::ranges::find(worst, ConstraintKind::rangeAxialFeed, &ConstraintResult::kind);
        QCOMPARE(Names::margin(*present), margin->shown[0]);
        // Where only more digits differ than are stated, there is no row.
        desk.change([](Project& of) { of.cycle->stages[1].axial_feed_mm_min = 301; });
        QVERIFY(!desk.find(name));
        QVERIFY(desk.find(QStringLiteral("Cycle › Stages › Stage 2 › Axial feed")));
    }

    void aStageThatOnlyOneRunHasStandsBesideADash() {
        KeptDesk desk;
        desk.change([](Project& project) {
            Stage last = project.cycle->stages.back();
            project.cycle->stages.back().stock_mm /= 2;
            last.stock_mm = project.cycle->stages.back().stock_mm;
            last.axial_feed_mm_min = 250;
            project.cycle->stages.push_back(last);
        });
        const RunRow* feed = desk.find(QStringLiteral("Cycle › Stages › Stage 3 › Axial feed"));
        QVERIFY(feed);
        QCOMPARE(feed->shown, (QStringList{QStringLiteral("250"), QStringLiteral("–")}));
        const RunRow* stages = desk.find(QStringLiteral("Cycle › Stages"));
        QVERIFY(stages);
        QCOMPARE(stages->shown, (QStringList{QStringLiteral("3"), QStringLiteral("2")}));
    }

    void theValuesThatDifferAreInSight() {
        KeptDesk desk;
        auto* table = desk.view.findChild<CopyTable*>(QStringLiteral("compareTable"));
        auto* curves = desk.view.plot();
        const int alone = curves->height();
        QVERIFY(!table->isVisible());
        desk.change(quicker);
        desk.keep();
        desk.change([](Project& project) { project.cycle->stages[1].axial_feed_mm_min = 450; });
        QVERIFY(table->isVisible() && curves->height() < alone - 80);
        const QHeaderView* head = table->horizontalHeader();
        QCOMPARE(head->count(), 4); // what, present, two kept
        QVERIFY(head->length() <= table->viewport()->width());
        const QModelIndex longest = desk.view.table()->index(1, 0);
        QVERIFY(table->rowHeight(1) >= table->sizeHintForIndex(longest).height());
    }

    void theTableGoesToASpreadsheetWithAllDigits() {
        KeptDesk desk;
        desk.change(quicker);
        auto* table = desk.view.findChild<CopyTable*>(QStringLiteral("compareTable"));
        table->setFocus();
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines =
            QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(desk.view.rows().size()) + 1);
        QVERIFY(lines[0].contains(QStringLiteral("Run 1")));
        QVERIFY(lines[1].startsWith(QStringLiteral("Wheel › Dullness\t")));
        const QString numbers = QStringLiteral("0.03\t0.02");
        QVERIFY(lines[1].trimmed().endsWith(QString(numbers).replace(
            QStringLiteral("."), QLocale().decimalPoint()))); // of this computer
    }

    void aRunIsDeletedWhileItsNameIsTyped() {
        KeptDesk desk;
        auto* list = desk.view.list();
        list->setCurrentIndex(list->model()->index(1, 0));
        list->setFocus();
        list->edit(list->currentIndex());
        auto* editor = list->findChild<QLineEdit*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral("half typed"));
        desk.view.findChild<QAction*>(QStringLiteral("compareDelete"))->trigger();
        QCoreApplication::processEvents();
        QCOMPARE(list->model()->rowCount(), 1); // the present run
    }

    void renamingTwiceGoesOnWithTheNameBeingTyped() {
        KeptDesk desk;
        auto* list = desk.view.list();
        list->setCurrentIndex(list->model()->index(1, 0));
        WarningCatcher warnings;
        auto* rename = desk.view.findChild<QAction*>(QStringLiteral("compareRename"));
        rename->trigger();
        auto* editor = list->findChild<QLineEdit*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral("dull"));
        rename->trigger();
        QCOMPARE(list->findChild<QLineEdit*>(), editor);
        QCOMPARE(editor->text(), QStringLiteral("dull"));
        QCOMPARE(warnings.take(), QStringList());
    }

    void theEmptyStateSaysWhatToDoAndDoesIt() {
        Desk desk;
        QVERIFY(desk.text("compareEmpty").contains(QStringLiteral("No run is kept yet")));
        QCOMPARE(desk.plot().runs().size(), 1u); // the present one
        QSignalSpy wanted(&desk.view, &CompareView::keepWanted);
        auto* start = desk.view.findChild<QPushButton*>(QStringLiteral("compareStart"));
        QVERIFY(start->isVisible());
        QTest::mouseClick(start, Qt::LeftButton);
        QCOMPARE(wanted.count(), 1);
        desk.keep();
        QVERIFY(!start->isVisible());
    }

    void spaceTakesARunOutOfThePlotAndBackIn() {
        KeptDesk desk;
        desk.change(quicker);
        desk.keep();
        QCOMPARE(desk.plot().runs().size(), 3u);
        desk.view.list()->setFocus();
        desk.view.list()->setCurrentIndex(desk.row(0));
        QTest::keyClick(desk.view.list(), Qt::Key_Space);
        desk.settle();
        QVERIFY(!desk.kept.isChosen(0));
        QCOMPARE(desk.plot().runs().size(), 2u);
        QCOMPARE(desk.plot().runs()[1].name, QStringLiteral("Run 2"));
        QTest::keyClick(desk.view.list(), Qt::Key_Space);
        desk.settle();
        QCOMPARE(desk.plot().runs().size(), 3u);
        desk.view.list()->setCurrentIndex(desk.view.list()->model()->index(0, 0));
        QTest::keyClick(desk.view.list(), Qt::Key_Space); // the present one stays
        desk.settle();
        QCOMPARE(desk.plot().runs().size(), 3u);
    }

    void theListRenamesDeletesAndRestoresByKeys() {
        Desk desk;
        QVERIFY(QTest::qWaitForWindowActive(&desk.view));
        desk.keep();
        desk.change(quicker);
        QListView* const list = desk.view.list();
        list->setFocus();
        list->setCurrentIndex(desk.row(0));
        QTest::keyClick(list, Qt::Key_F2);
        auto* editor = list->findChild<QLineEdit*>();
        QVERIFY(editor);
        QCOMPARE(editor->text(), QStringLiteral("Run 1"));
        QTest::keyClicks(editor, QStringLiteral("slow"));
        QTest::keyClick(editor, Qt::Key_Return);
        desk.settle();
        QCOMPARE(desk.kept.all()[0].name, std::string("slow"));
        QCOMPARE(desk.plot().runs()[1].name, QStringLiteral("slow"));
        QTest::keyClick(list, Qt::Key_Return, Qt::ControlModifier);
        QCOMPARE(*desk.document.project().cycle->stages[0].axial_feed_mm_min, 1800.0);
        QCOMPARE(desk.kept.count(), 1);
        QTest::keyClick(list, Qt::Key_Delete);
        desk.settle();
        QCOMPARE(desk.kept.count(), 0);
        desk.document.undo();
        desk.settle();
        QCOMPARE(desk.kept.count(), 1);
    }

    void theNameTheProgramGaveFollowsTheLanguage() {
        Language language;
        language.apply(QStringLiteral("en"));
        KeptDesk desk;
        desk.keep();
        desk.kept.rename(1, QStringLiteral("Run 2 of mine"));
        QVERIFY(desk.kept.keep(*desk.outcome, QString::fromStdString(givenRunName(
                                                  GivenName::worstPart, QStringLiteral("12"))))
                == KeptRuns::Kept::yes);
        desk.settle();
        const std::vector<KeptRun> before = desk.kept.all();
        const auto shown = [&desk](int run) { return desk.row(run).data(Qt::EditRole).toString(); };
        QCOMPARE(shown(0), QStringLiteral("Run 1"));
        language.apply(QStringLiteral("ru"));
        desk.settle();
        QCOMPARE(shown(0), QStringLiteral("Расчёт 1"));
        QCOMPARE(shown(1), QStringLiteral("Run 2 of mine"));
        QCOMPARE(shown(2), QStringLiteral("Худшая деталь, № 12"));
        QCOMPARE(desk.plot().runs()[1].name, QStringLiteral("Расчёт 1"));
        desk.view.list()->model()->setData(desk.row(0), shown(0), Qt::EditRole); // nothing typed
        QVERIFY(desk.kept.all() == before);
        desk.kept.rename(1, QStringLiteral("Расчёт 4"));
        desk.keep(); // under no name that is shown already
        QCOMPARE(shown(3), QStringLiteral("Расчёт 5"));
        language.apply(QStringLiteral("en"));
        desk.settle();
        QCOMPARE(shown(0), QStringLiteral("Run 1"));
        QCOMPARE(shown(1), QStringLiteral("Расчёт 4")); // as it was typed
    }

    void refusedInputsLeaveThePresentRunDimmed() {
        KeptDesk desk;
        desk.view.setOutcome(fixtures::refused());
        desk.settle();
        QVERIFY(desk.text("compareNotice").contains(QStringLiteral("refused")));
        QCOMPARE(desk.plot().runs().size(), 2u);
    }

    void theWindowKeepsTheRunOfTheInputsJustTyped() {
        OpenBench bench(QStringLiteral("en"), examplePaths().front());
        Project project = bench.window->document().project();
        const std::size_t before = project.runs.size();
        project.part->initial_runout_mm *= 0.5;
        bench.window->document().edit(project, editText);
        QVERIFY(bench.window->runs().running());
        bench.action("keepRun")->trigger();
        QTRY_COMPARE(bench.window->document().project().runs.size(), before + 1);
        const ReadResult kept =
            readProject(bench.window->document().project().runs.back().inputs.text);
        QCOMPARE(kept.project->part->initial_runout_mm, project.part->initial_runout_mm);
    }

    /// The present run has the mark and the words of the headline, whatever its summary says.
    void thePresentRunIsMarkedAsTheHeadlineIs_data() {
        QTest::addColumn<int>("state");
        for (const JudgedState state :
             {JudgedState::fails, JudgedState::stocksFail, JudgedState::undecided,
              JudgedState::stocksHold, JudgedState::nominal}) {
            QTest::newRow(stateKey(state)) << static_cast<int>(state);
        }
    }

    void thePresentRunIsMarkedAsTheHeadlineIs() {
        QFETCH(int, state);
        KeptDesk desk;
        const QImage kept = markOf(desk.row(0)), before = markOf(desk.row(-1));
        JudgedRun judged;
        judged.outcome = desk.outcome;
        judged.judgement = judge(desk.outcome->result, desk.outcome->constraints, JudgedStocks{});
        judged.judgement.state = static_cast<JudgedState>(state);
        desk.view.setJudged(judged);
        const auto told = [&desk] { return desk.row(-1).data(Qt::ToolTipRole).toString(); };
        const QImage wanted =
            judgedPixmap(judged.judgement.state, RunsModel::sample.height(), 1, false)
                .toImage()
                .convertToFormat(QImage::Format_ARGB32);
        QCOMPARE(markOf(desk.row(-1)), wanted);
        QVERIFY(told().contains(JudgementText::headline(judged.judgement)));
        QCOMPARE(markOf(desk.row(0)), kept);
        desk.view.setOutcome(fixtures::refused()); // the last one stands, with its mark
        desk.view.setJudged({.outcome = fixtures::refused(), .judgement = {}});
        desk.settle();
        QCOMPARE(markOf(desk.row(-1)), wanted);
        desk.compute(); // the same inputs, but nobody has judged the run yet
        QCOMPARE(markOf(desk.row(-1)), before);
    }

    /// The summary was kept by another version and one value of it is another.
    void aRunWithoutItsResultsHasNoLight_data() {
        QTest::addColumn<QByteArray>("summary");
        addRow("empty", QByteArray("{}"));
        addRow("no requirement", QByteArray(R"({"status":"completed","requirements":[]})"));
        addRow("nonsense", QByteArray(R"({"status":7})"));
    }

    void aRunWithoutItsResultsHasNoLight() {
        QFETCH(QByteArray, summary);
        Project project = fixtures::traverseProject();
        const OutcomePtr outcome = fixtures::run(project);
        project.runs = {keptRun(outcome->result,
                                summarise(outcome->result, outcome->accuracy, outcome->constraints),
                                "whole", "2026-03-04T05:06:07Z")};
        project.runs.push_back(project.runs[0]);
        project.runs[1].name = "bare";
        project.runs[1].summary.text = summary.toStdString();
        Desk desk(project);
        const auto told = [&](int run) { return desk.row(run).data(Qt::ToolTipRole).toString(); };
        const auto light = [&](int run) { return markOf(desk.row(run)); };
        const auto isBlank = [](const QImage& image) {
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (image.pixelColor(x, y).alpha() > 0) {
                        return false;
                    }
                }
            }
            return true;
        };
        QVERIFY(!isBlank(light(0)));
        QVERIFY(isBlank(light(1)));
        for (const Light each : {Light::holds, Light::close, Light::undecided, Light::fails}) {
            QVERIFY2(!told(1).split(u'\n').contains(lightName(each)), qPrintable(told(1)));
        }
        QVERIFY2(!told(1).contains(QStringLiteral("0 min")), qPrintable(told(1)));
    }

    /// A kept run stores one Ra and whether it holds: its inputs tell that the wheel's is not
    /// known.
    void aKeptRunWithAnOpenRaIsNotDecided() {
        Project project = fixtures::traverseProject();
        project.part->upper_deviation_um = 200;
        project.part->lower_deviation_um = -200;
        project.part->tolerance.radial_runout_um.reset();
        project.part->tolerance.roughness_ra_um = 1;
        const OutcomePtr first = fixtures::run(project);
        const auto rough = std::ranges::find(first->constraints, ConstraintKind::roughness,
                                             &ConstraintResult::kind);
        project.part->tolerance.roughness_ra_um = (rough->value + rough->mostValue.value()) / 2;
        const auto keep = [&project](const char* name) {
            const OutcomePtr outcome = fixtures::run(project);
            return keptRun(outcome->result,
                           summarise(outcome->result, outcome->accuracy, outcome->constraints),
                           name, "2026-03-04T05:06:07Z");
        };
        const KeptRun before = keep("before");
        project.wheel->roughness_factor = roughnessFactor(project).least; // as if measured
        const KeptRun after = keep("after");
        project.runs = {before, after};
        Desk desk(project);
        const auto told = [&](int run) {
            return desk.row(run).data(Qt::ToolTipRole).toString().split(u'\n');
        };
        QVERIFY2(told(0).contains(lightName(Light::undecided)), qPrintable(told(0).join(u';')));
        QVERIFY2(!told(1).contains(lightName(Light::undecided)), qPrintable(told(1).join(u';')));
    }

    void reopeningSaysPlainlyWhatComesOutDifferently() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("older.sparkout"));
        Project project = fixtures::traverseProject();
        const OutcomePtr outcome = fixtures::run(project);
        RunSummary summary = summarise(outcome->result, outcome->accuracy, outcome->constraints);
        const double now_um = summary.zones[0].roundness_um;
        summary.zones[0].roundness_um += 0.5;
        project.runs = {keptRun(outcome->result, summary, "spring", "2026-03-04T05:06:07Z")};
        project.runs[0].engine_version = "0.0.1";
        QVERIFY(!saveContent([&project] { return projectText(plainSetup(project)); }, path).error);

        OpenBench bench(QStringLiteral("en"), path);
        NoticeBar& notices = bench.window->files().notices();
        QTRY_VERIFY(notices.holds(QStringLiteral("changed-runs")));
        QVERIFY(notices.textOf(QStringLiteral("changed-runs")).contains(QStringLiteral("spring")));
        QVERIFY(bench.window->showView(QStringLiteral("compare")));
        bench.settle();
        const QString told =
            bench.window->findChild<QLabel*>(QStringLiteral("compareNotice"))->text();
        QVERIFY2(told.contains(QStringLiteral("0.0.1")), qPrintable(told));
        const QString change = QStringLiteral("RZ1 › Roundness: %1 → %2")
                                   .arg(now_um + 0.5, 0, 'f', 2)
                                   .arg(now_um, 0, 'f', 2);
        QVERIFY2(told.contains(change), qPrintable(told));
        auto* view = bench.window->findChild<CompareView*>();
        QCOMPARE(view->table()->columnCount(), 4); // present, as kept, computed now
        QVERIFY(bench.open(examplePaths().front()));
        QVERIFY(!notices.holds(QStringLiteral("changed-runs")));
    }
};

} // namespace sparkout::test_compare_view

SPARKOUT_TEST(test_compare_view, TestCompareView)
#include "test_compare_view.moc"
