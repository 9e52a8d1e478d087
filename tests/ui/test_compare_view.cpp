// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Compare": the curves are those of the runs, the table holds what differs and nothing
// else, and the list keeps, restores, renames and deletes.
#include "core/project/project_file.h"
#include "tests/registry.h"
#include "tests/ui/view_fixtures.h"
#include "tests/ui/window_bench.h"
#include "ui/file_commands.h"
#include "ui/language.h"
#include "ui/notice_bar.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/project_io.h"
#include "ui/views/compare_plot.h"
#include "ui/views/compare_view.h"
#include "ui/views/copy_table.h"
#include "ui/views/legend_strip.h"
#include "ui/views/plot_tools.h"
#include "ui/views/run_table_model.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>

namespace test_compare_view {

using namespace sparkout;

namespace {

constexpr EditText editText{"Input", "Diameter"};

/// The view as it stands in the window, beside a document.
struct Desk {
    explicit Desk(const Project& project = fixtures::traverseProject()) {
        document.startUntitled(project);
        view.shareCycle(&cursor);
        view.resize(720, 640);
        view.show();
        compute();
    }
    void compute() {
        outcome = fixtures::run(document.project());
        cursor.setOutcome(outcome);
        view.setOutcome(outcome);
        settle();
    }
    void change(const std::function<void(Project&)>& how) {
        Project project = document.project();
        how(project);
        document.edit(std::move(project), editText);
        compute();
    }
    void keep() {
        QVERIFY(kept.keep(*outcome) == KeptRuns::Kept::yes);
        settle();
    }
    /// Kept runs are computed, and what they and the keys have queued is done.
    void settle() {
        QVERIFY(QTest::qWaitFor([this] { return !kept.busy(); }, 20'000));
        QTest::qWait(20);
        for (int i = 0; i < 6; ++i) {
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
    }
    [[nodiscard]] ComparePlot& plot() { return *view.plot(); }
    [[nodiscard]] QString text(const char* label) {
        return view.findChild<QLabel*>(QLatin1String(label))->text();
    }
    [[nodiscard]] QModelIndex row(int run) { return view.list()->model()->index(run + 1, 0); }
    [[nodiscard]] const RunRow* find(const QString& what) {
        for (const RunRow& row : view.table()->rows()) {
            if (row.what == what) {
                return &row;
            }
        }
        return nullptr;
    }

    Document document;
    KeptRuns kept{document};
    CycleCursor cursor;
    OutcomePtr outcome;
    CompareView view{kept};
};

void quicker(Project& project) {
    project.cycle.stages[0].axial_feed_mm_min = 2400;
    project.wheel.dullness = 0.03;
}

/// The curve of a quantity as the run's own feeds have it, by minutes.
void compareWithFeeds(const QCPGraph& graph, const FeedSeries& feeds, std::size_t column,
                      Quantity quantity) {
    for (const FeedPoint& p : feeds.columns[column].strokes) {
        const double end_min = p.end_s / 60;
        const auto at = graph.data()->findBegin(end_min * (1 - 1e-12), false);
        bool found = false;
        for (auto it = at; it != graph.data()->constEnd() && it->key <= end_min * (1 + 1e-12);
             ++it) {
            found = found || it->value == valueOf(p, quantity, Edge::mean);
        }
        QVERIFY(found);
    }
}

} // namespace

class TestCompareView : public QObject {
    Q_OBJECT

private slots:
    void theCurvesAreThoseOfTheRuns() {
        Desk desk;
        const OutcomePtr first = desk.outcome;
        desk.keep();
        desk.change(quicker);
        QCOMPARE(desk.plot().runs().size(), 2u);
        for (const Quantity quantity : desk.plot().quantities()) {
            compareWithFeeds(*desk.plot().curve(0, quantity), desk.outcome->feeds, 1, quantity);
            compareWithFeeds(*desk.plot().curve(1, quantity), first->feeds, 1, quantity);
        }
        const auto pen = [&](int run, Quantity q) { return desk.plot().curve(run, q)->pen(); };
        QCOMPARE(pen(0, Quantity::actual).color(), pen(1, Quantity::actual).color());
        QVERIFY(pen(0, Quantity::actual).color() != pen(0, Quantity::force).color());
        QCOMPARE(pen(0, Quantity::actual).style(), Qt::SolidLine);
        QVERIFY(pen(1, Quantity::actual).dashPattern() != pen(0, Quantity::actual).dashPattern());
        QCOMPARE(pen(1, Quantity::force).dashPattern(), pen(1, Quantity::actual).dashPattern());
    }

    /// Chosen from the menu: drawn, named, zoomed, read, exported on an axis of its own.
    void aSecondQuantityHasAnAxisOfItsOwn() {
        Desk desk;
        const OutcomePtr first = desk.outcome;
        desk.keep();
        desk.change(quicker);
        const QCPRange feeds = desk.plot().axisOf(Quantity::actual)->range();
        const auto choose = [&](Quantity quantity) {
            desk.view
                .findChild<QAction*>(QStringLiteral("second%1").arg(static_cast<int>(quantity)))
                ->trigger();
            desk.settle();
        };
        choose(Quantity::axialFeed);
        choose(Quantity::programmedSum);
        QVERIFY(!desk.plot().curve(0, Quantity::force) && !desk.plot().curve(0, Quantity::left));
        for (const Quantity quantity : desk.plot().quantities()) {
            compareWithFeeds(*desk.plot().curve(0, quantity), desk.outcome->feeds, 1, quantity);
            compareWithFeeds(*desk.plot().curve(1, quantity), first->feeds, 1, quantity);
        }
        QCPAxis* axis = desk.plot().axisOf(Quantity::axialFeed);
        QCOMPARE(axis->axisType(), QCPAxis::atRight);
        QVERIFY(axis->range().contains(2400)); // of the present run
        QCOMPARE(desk.plot().axisOf(Quantity::actual)->range(), feeds);
        const QCPGraph* curve = desk.plot().curve(0, Quantity::axialFeed);
        QCOMPARE(axis->labelColor(), curve->pen().color());
        QCOMPARE(axis->tickLabelColor(), curve->pen().color());
        QVERIFY(axis->label().contains(QStringLiteral("mm/min")));
        const QString name = QStringLiteral("axial feed");
        QVERIFY(std::ranges::any_of(desk.plot().legendEntries(),
                                    [&](const LegendEntry& e) { return e.text == name; }));
        const CsvTable table = desk.plot().table();
        const auto column = table.header.indexOf(QStringLiteral("axial feed, mm/min"));
        QVERIFY(column > 0);
        QCOMPARE(std::get<double>(table.rows[0][std::size_t(column)]), 2400.0);
        // The wheel over the axis zooms it alone.
        const QCPAxisRect* rect = axis->axisRect();
        const double before = axis->range().size();
        fixtures::wheel(&desk.plot(), QPointF(rect->right() + 12, rect->center().y()), 120);
        QVERIFY(axis->range().size() < before);
        QCOMPARE(desk.plot().axisOf(Quantity::actual)->range(), feeds);
        Language language; // what was chosen stays, in other words
        language.apply(QStringLiteral("ru"));
        desk.settle();
        QCOMPARE(desk.plot().second(0), Quantity::axialFeed);
        QVERIFY(axis->label().contains(QStringLiteral("мм/мин")));
        language.apply(QStringLiteral("en"));
        desk.settle();
        QVERIFY(axis->label().contains(QStringLiteral("mm/min")));
        choose(Quantity::force);
        QVERIFY(desk.plot().curve(0, Quantity::force)
                && !desk.plot().curve(0, Quantity::axialFeed));
    }

    void anotherZoneIsDrawnOfAllRuns() {
        Desk desk;
        const OutcomePtr first = desk.outcome;
        desk.keep();
        desk.change(quicker);
        auto* zone = desk.view.findChild<QComboBox*>(QStringLiteral("compareZone"));
        QCOMPARE(zone->count(), 3);
        zone->setFocus();
        QTest::keyClick(zone, Qt::Key_Home);
        QTest::qWait(20);
        compareWithFeeds(*desk.plot().curve(0, Quantity::actual), desk.outcome->feeds, 0,
                         Quantity::actual);
        compareWithFeeds(*desk.plot().curve(1, Quantity::actual), first->feeds, 0,
                         Quantity::actual);
    }

    /// A run of the other operation shows the section nearest to the zone, and says so.
    void aPlungeLiesOverATraverseByPlace() {
        Desk desk(fixtures::plungeProject(3));
        desk.keep();
        desk.document.edit(
            [&] {
                Project project = fixtures::traverseProject();
                project.runs = desk.document.project().runs;
                return project;
            }(),
            editText);
        desk.compute();
        QCOMPARE(desk.plot().runs().size(), 2u);
        QCOMPARE(desk.plot().runs()[1].column, 1u); // the middle one
        QCOMPARE(desk.plot().runs()[1].name, QStringLiteral("Run 1: Section 1"));
    }

    void theTableHoldsWhatDiffersAndNothingElse() {
        Desk desk;
        const Project first = desk.document.project();
        desk.keep();
        QCOMPARE(desk.view.table()->rowCount(), 0);
        QVERIFY(desk.text("compareEmpty").contains(QStringLiteral("have the inputs")));
        desk.change(quicker);
        const Project& now = desk.document.project();
        QStringList inputs;
        for (const RunRow& row : desk.view.table()->rows()) {
            QCOMPARE(row.shown.size(), 2);
            QVERIFY2(row.shown[0] != row.shown[1], qPrintable(row.what));
            inputs += row.isResult ? QStringList() : QStringList{row.what};
        }
        QCOMPARE(inputs, (QStringList{QStringLiteral("Wheel › Dullness"),
                                      QStringLiteral("Cycle › Stages › Stage 1 › Axial feed")}));
        const RunRow* feed = desk.find(inputs[1]);
        QCOMPARE(std::get<double>(feed->cells[0]), *now.cycle.stages[0].axial_feed_mm_min);
        QCOMPARE(std::get<double>(feed->cells[1]), *first.cycle.stages[0].axial_feed_mm_min);
        QCOMPARE(feed->unit, QStringLiteral("mm/min"));
        const RunRow* time = desk.find(QStringLiteral("Cycle time"));
        QVERIFY(time && time->isResult);
        QCOMPARE(std::get<double>(time->cells[0]) * 60, desk.outcome->result.time_s);
        const RunRow* largest = desk.find(QStringLiteral("NZ › Largest diameter, deviation"));
        QVERIFY(largest);
        QCOMPARE(std::get<double>(largest->cells[0]),
                 desk.outcome->result.sections[1].diameterDeviationMax_mm * 1e3);
    }

    void aStageThatOnlyOneRunHasStandsBesideADash() {
        Desk desk;
        desk.keep();
        desk.change([](Project& project) {
            Stage last = project.cycle.stages.back();
            project.cycle.stages.back().stock_mm /= 2;
            last.stock_mm = project.cycle.stages.back().stock_mm;
            last.axial_feed_mm_min = 250;
            project.cycle.stages.push_back(last);
        });
        const RunRow* feed = desk.find(QStringLiteral("Cycle › Stages › Stage 3 › Axial feed"));
        QVERIFY(feed);
        QCOMPARE(feed->shown, (QStringList{QStringLiteral("250"), QStringLiteral("–")}));
        const RunRow* stages = desk.find(QStringLiteral("Cycle › Stages"));
        QVERIFY(stages);
        QCOMPARE(stages->shown, (QStringList{QStringLiteral("3"), QStringLiteral("2")}));
    }

    void theValuesThatDifferAreInSight() {
        Desk desk;
        desk.keep();
        auto* table = desk.view.findChild<CopyTable*>(QStringLiteral("compareTable"));
        auto* curves = desk.view.plot();
        const int alone = curves->height();
        QVERIFY(!table->isVisible());
        desk.change(quicker);
        desk.keep();
        desk.change([](Project& project) { project.cycle.stages[1].axial_feed_mm_min = 450; });
        QVERIFY(table->isVisible() && curves->height() < alone - 80);
        const QHeaderView* head = table->horizontalHeader();
        QCOMPARE(head->count(), 4); // what, present, two kept
        QVERIFY(head->length() <= table->viewport()->width());
        const QModelIndex longest = desk.view.table()->index(1, 0);
        QVERIFY(table->rowHeight(1) >= table->sizeHintForIndex(longest).height());
    }

    void theTableGoesToASpreadsheetWithAllDigits() {
        Desk desk;
        desk.keep();
        desk.change(quicker);
        auto* table = desk.view.findChild<CopyTable*>(QStringLiteral("compareTable"));
        table->setFocus();
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        const QStringList lines =
            QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(desk.view.table()->rows().size()) + 1);
        QVERIFY(lines[0].contains(QStringLiteral("Run 1")));
        QVERIFY(lines[1].startsWith(QStringLiteral("Wheel › Dullness\t")));
        const QString numbers = QStringLiteral("0.03\t0.02");
        QVERIFY(lines[1].trimmed().endsWith(QString(numbers).replace(
            QStringLiteral("."), QLocale().decimalPoint()))); // of this computer
    }

    void aRunIsDeletedWhileItsNameIsTyped() {
        Desk desk;
        desk.keep();
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
        Desk desk;
        desk.keep();
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
        QCOMPARE(*desk.document.project().cycle.stages[0].axial_feed_mm_min, 1800.0);
        QCOMPARE(desk.kept.count(), 1);
        QTest::keyClick(list, Qt::Key_Delete);
        desk.settle();
        QCOMPARE(desk.kept.count(), 0);
        desk.document.undo();
        desk.settle();
        QCOMPARE(desk.kept.count(), 1);
    }

    void theLegendHidesAQuantityOrARun() {
        Desk desk;
        desk.keep();
        desk.change(quicker);
        auto* legend = desk.view.findChild<LegendStrip*>();
        QCOMPARE(legend->entries().size(), 6u);
        const auto click = [&](int entry) {
            QTest::mouseClick(legend, Qt::LeftButton, {}, legend->entryRect(entry).center());
            QTest::qWait(20);
        };
        click(0);
        QVERIFY(!desk.plot().curve(0, Quantity::actual)->visible());
        QVERIFY(!desk.plot().curve(1, Quantity::actual)->visible());
        QVERIFY(desk.plot().curve(1, Quantity::force)->visible());
        click(5);
        QVERIFY(!desk.plot().curve(1, Quantity::force)->visible());
        QVERIFY(desk.plot().curve(0, Quantity::force)->visible());
        for (const std::vector<CsvCell>& row : desk.plot().table().rows) {
            QCOMPARE(std::get<QString>(row[0]), QStringLiteral("Present run"));
        }
    }

    void theMouseReadsBothRunsAndAClickMovesTheCycle() {
        Desk desk;
        desk.keep();
        desk.change(quicker);
        const QRect rect = desk.plot().axisRects()[1]->rect();
        const QPoint at(rect.left() + rect.width() / 4, rect.center().y());
        fixtures::hover(&desk.plot(), at);
        const QString told = desk.text("compareValues");
        QVERIFY2(told.contains(QStringLiteral("Present run, double stroke")), qPrintable(told));
        QVERIFY2(told.contains(QStringLiteral("\nRun 1, double stroke")), qPrintable(told));
        QTest::mouseClick(&desk.plot(), Qt::LeftButton, {}, at);
        const double wanted_s =
            desk.plot().axisRects()[1]->axis(QCPAxis::atBottom)->pixelToCoord(at.x()) * 60;
        QVERIFY(std::abs(desk.cursor.time_s() - wanted_s) < 2);
        QCOMPARE(desk.plot().moment_s().value(), desk.cursor.time_s());
    }

    void zoomGoesBackAndFits() {
        Desk desk;
        desk.keep();
        QCPAxis* const time = desk.plot().axisRects()[0]->axis(QCPAxis::atBottom);
        const QCPRange all = time->range();
        fixtures::wheel(&desk.plot(), desk.plot().axisRects()[0]->rect().center(), 240);
        QVERIFY(time->range().size() < 0.9 * all.size());
        QCOMPARE(desk.plot().axisRects()[1]->axis(QCPAxis::atBottom)->range(), time->range());
        const QCPRange zoomed = time->range();
        desk.change(quicker); // a new run leaves what is in sight
        QCOMPARE(time->range(), zoomed);
        desk.view.tools()->fit->trigger();
        QVERIFY(time->range().size() > zoomed.size());
        desk.view.tools()->back->trigger();
        QCOMPARE(time->range(), zoomed);
    }

    void refusedInputsLeaveThePresentRunDimmed() {
        Desk desk;
        desk.keep();
        desk.view.setOutcome(fixtures::refused());
        desk.settle();
        QVERIFY(desk.text("compareNotice").contains(QStringLiteral("refused")));
        QCOMPARE(desk.plot().runs().size(), 2u);
    }

    // --- in the window --------------------------------------------------------------------------

    void theWindowKeepsTheRunOfTheInputsJustTyped() {
        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(examplePaths().front()));
        Project project = bench.window->document().project();
        const std::size_t before = project.runs.size();
        project.part.initial_runout_mm *= 0.5;
        bench.window->document().edit(project, editText);
        QVERIFY(bench.window->runs().running());
        bench.action("keepRun")->trigger();
        QTRY_COMPARE(bench.window->document().project().runs.size(), before + 1);
        const ReadResult kept =
            readProject(bench.window->document().project().runs.back().inputs.text);
        QCOMPARE(kept.project->part.initial_runout_mm, project.part.initial_runout_mm);
    }

    /// The summary was kept by another version and one value of it is another.
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
        QVERIFY(!saveProject(project, path).error);

        Bench bench(QStringLiteral("en"));
        QVERIFY(bench.open(path));
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

} // namespace test_compare_view

SPARKOUT_TEST(test_compare_view, TestCompareView)
#include "test_compare_view.moc"
