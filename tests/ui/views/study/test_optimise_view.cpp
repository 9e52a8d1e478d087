// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Optimise" by mouse and keys: what it shows is the engine's, a cycle is taken by one
// edit, and it says when it is of other inputs.
#include "core/project/cycle.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/search/robust.h"
#include "core/setup/interval_search.h"
#include "core/setup/worn_project.h"
#include "core/study/search_edits.h"
#include "tests/registry.h"
#include "tests/ui/support/search_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/compare_plot.h"
#include "ui/dialogs/copy_table.h"
#include "ui/inputs/inputs_panel.h"
#include "ui/session/studies.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/study/found_table.h"
#include "ui/views/study/margin_front_plot.h"
#include "ui/views/study/optimise_text.h"
#include "ui/views/study/optimise_view.h"
#include "ui/window/view_tabs.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFont>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollBar>
#include <QStatusBar>
#include <QTest>

#include <algorithm>
#include <memory>
#include <string_view>
#include <variant>

namespace sparkout::test_optimise_view {

constexpr int patience_ms = 120'000;
constexpr int searchPage = 7;

template <typename List>
std::size_t placeOf(const List& heads, const char* key) {
    const auto at = std::ranges::find(heads, std::string_view(key), [](const ValueHead& head) {
        return std::string_view(head.key);
    });
    return static_cast<std::size_t>(at - heads.begin());
}

/// Empty where there is none.
ValueCell wholeCellOf(const ValueTable& table, const char* row, const char* column) {
    const std::size_t line = placeOf(table.rows, row), at = placeOf(table.columns, column);
    return line < table.rows.size() && at < table.columns.size() ? table.cells[line][at]
                                                                 : ValueCell();
}

/// As it is spoken and copied.
QString cellOf(const ValueTable& table, const char* row, const char* column) {
    const ValueCell cell = wholeCellOf(table, row, column);
    return cell.said.isEmpty() ? cell.text : cell.said;
}

/// A proved answer for the corners of a batch, with the Ppk of its parts.
SearchOutcome robustAnswer() {
    SearchOutcome outcome;
    outcome.project = outcome.searched = fixtures::searchedShaft();
    outcome.search.status = SearchStatus::proved;
    outcome.binding.emplace().push_back(ConstraintKind::diameterMin);
    outcome.limit.time_s = 30;
    outcome.limit.cycles.sparkOut = true;
    RobustSummary& robust = outcome.robust.emplace();
    robust.holdsInSample = true;
    robust.nominalTime_s = 40;
    robust.added.resize(3);
    FoundCycle& found = outcome.found.emplace_back();
    found.cycle = *outcome.project.cycle;
    found.machine = machineSettings(outcome.project);
    found.time_s = 50;
    found.isBest = true;
    found.candidate = 2;
    found.decided = PhaseCases{{0.149, 0.151}, 8};
    found.freshParts = {.tried = 500, .ppk = 1.234};
    return outcome;
}

/// The head of the column of times.
QString timeHead(const ValueTable& table) {
    return table.columns[placeOf(table.columns, "time")].text;
}

/// A time as a table writes it whose longest time is the other one.
QString timeBeside(double time_s, double longest_s) {
    return Names::significant(TimeUnit(longest_s).of(time_s), 4);
}

/// A window with the view in sight.
struct Desk {
    explicit Desk(const Project& project, const QString& language = QStringLiteral("en"))
        : bench(language) {
        bench.window->document().startUntitled(project);
        bench.window->showView(QStringLiteral("optimise"));
        bench.window->inputs().showPage(searchPage);
        bench.settle();
        view = bench.window->findChild<OptimiseView*>();
        const auto drawn = [this] { return !view->curves()->runs().empty(); };
        if (!QTest::qWaitFor(drawn, patience_ms)) {
            qWarning("the present run was not drawn");
        }
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) const {
        return *view->findChild<Widget*>(QString::fromLatin1(name));
    }
    void click(const char* button) const {
        QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton);
    }
    /// Searches, and waits until the best cycle is drawn.
    [[nodiscard]] bool searched() const {
        click("optimiseRun");
        return QTest::qWaitFor(
            [this] {
                return view->search() && !view->busy() && view->curves()->runs().size() == 2;
            },
            patience_ms);
    }
    /// Chooses the method that is the so many-th of the list, by keys.
    void choose(int method) const {
        auto& box = part<QComboBox>("optimiseMethod");
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_Home);
        for (int i = 0; i < method; ++i) {
            QTest::keyClick(&box, Qt::Key_Down);
        }
        QCOMPARE(box.currentIndex(), method);
    }
    [[nodiscard]] QString cell(int row, FoundColumn column) const {
        const QAbstractItemModel* model = part<CopyTable>("optimiseFound").model();
        return model->index(row, static_cast<int>(column)).data().toString();
    }
    /// Of the answer: the cell of a row and a column by their keys; nothing: there is none.
    [[nodiscard]] QString answered(const char* row, const char* column) const {
        const auto* model =
            qobject_cast<const ValueModel*>(part<CopyTable>("optimiseAnswer").model());
        return cellOf(model->table(), row, column);
    }
    /// Of the cycle compared with and those found.
    [[nodiscard]] double longest_s() const {
        double longest_s = view->before_s().value_or(0);
        for (const FoundCycle& found : view->search()->found) {
            longest_s = std::max(longest_s, found.time_s);
        }
        return longest_s;
    }
    [[nodiscard]] QString told() const { return part<QLabel>("optimiseNotice").text(); }
    [[nodiscard]] const Project& project() const { return bench.window->document().project(); }
    /// Types a text into a line of the page "Search" and leaves it.
    void type(const char* path, const QString& text) const {
        const FormPage& page = *bench.window->inputs().pages()[searchPage];
        auto* line = page.findChild<QLineEdit*>(QString::fromLatin1(path));
        QVERIFY2(line, path);
        line->setFocus();
        QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
        QGuiApplication::clipboard()->setText(text); // keys of a test are ASCII
        QTest::keyClick(line, text.isEmpty() ? Qt::Key_Delete : Qt::Key_V,
                        text.isEmpty() ? Qt::NoModifier : Qt::ControlModifier);
        QTest::keyClick(line, Qt::Key_Return);
        bench.settle();
    }
    Bench bench;
    OptimiseView* view;
};

/// Of the times across it, by its title.
double unitOf_s(const MarginFrontPlot& plot) {
    return plot.across().label().endsWith(QStringLiteral(", s")) ? 1 : 60;
}

/// What is drawn as one of the legend; none: nothing.
std::vector<XY> pointsOf(const MarginFrontPlot& plot, MarginFrontPlot::Key key) {
    const ChartSeries* const of = plot.chart().find(key);
    return of ? of->points : std::vector<XY>();
}

class TestOptimiseView : public QObject {
    Q_OBJECT

private slots:
    void countsOfCyclesAreGrouped() {
        const QLocale before;
        const auto back = qScopeGuard([&before] { QLocale::setDefault(before); });
        QLocale english(QLocale::English, QLocale::UnitedStates);
        english.setNumberOptions(QLocale::OmitGroupSeparator); // as the program sets it
        QLocale::setDefault(english);
        QCOMPARE(OptimiseText::gridSize(1'072'512), QStringLiteral("1,072,512 cycles"));
    }

    void theQuickestCycleOfTheEngineIsFirstAndIsDrawnBesideThePresentOne() {
        const Project project = fixtures::searchedShaft();
        const SearchSummary engine = optimise(project);
        const Desk desk(project);
        QVERIFY(desk.searched());
        const auto text = [&desk](double time_s) { return timeBeside(time_s, desk.longest_s()); };
        QCOMPARE(desk.cell(0, FoundColumn::time), text(engine.best->time_s));
        QCOMPARE(desk.cell(0, FoundColumn::cycle), OptimiseText::cycle(engine.cycle));
        QCOMPARE(desk.answered("best", "time"), desk.cell(0, FoundColumn::time));
        QCOMPARE(desk.answered("best", "change"), desk.cell(0, FoundColumn::change));
        QCOMPARE(desk.answered("best", "margin"), desk.cell(0, FoundColumn::margin));
        QVERIFY2(desk.answered("best", "basis").contains(QStringLiteral("none is quicker, proved")),
                 qPrintable(desk.answered("best", "basis")));
        QVERIFY(desk.answered("best", "basis").contains(QStringLiteral("nominal part only")));
        QCOMPARE(desk.answered("yours", "time"), text(desk.view->before_s().value()));
        QCOMPARE(desk.answered("limit", "time"), text(desk.view->search()->limit.time_s));
        QVERIFY(!desk.told().contains(OptimiseText::time(engine.best->time_s))); // only there
        const ComparedFeeds& found = desk.view->curves()->runs().back();
        QVERIFY(std::abs(found.feeds->end_s - engine.best->time_s) < 1e-5);
        const BarChart& times = desk.view->times()->chart();
        QCOMPARE(times.categories.size(), 2);
        QCOMPARE(times.value(0, 1),
                 engine.best->time_s / (times.unit == QStringLiteral("s") ? 1 : 60));
    }

    void everyMethodIsSearchedByOrRefusedWithASentence() {
        const Project project = fixtures::searchedShaft();
        const SearchSummary engine = optimise(project);
        const Desk desk(project);
        const auto& method = desk.part<QComboBox>("optimiseMethod");
        const QString proves = method.toolTip();
        desk.choose(3); // for plunge grinding
        QVERIFY(!method.toolTip().isEmpty() && method.toolTip() != proves);
        desk.click("optimiseRun");
        QTRY_VERIFY_WITH_TIMEOUT(!desk.view->busy(), patience_ms);
        QTRY_VERIFY2(desk.told().contains(QStringLiteral("traverse cycles (“Pruned search”)")),
                     qPrintable(desk.told()));
        desk.choose(1);
        QVERIFY2(desk.told().contains(QStringLiteral("finds the quickest cycle")),
                 qPrintable(desk.told()));
        QVERIFY(desk.searched());
        QVERIFY(desk.view->search()->method == SearchMethod::full && desk.view->search()->proved());
        QCOMPARE(desk.cell(0, FoundColumn::cycle), OptimiseText::cycle(engine.cycle));
        QCOMPARE(desk.part<QPushButton>("optimiseRun").text(), QStringLiteral("Search"));
    }

    void whatAHeuristicFoundIsNotCalledProved() {
        Project project = fixtures::plunge();
        project.optimisation = Optimisation{};
        project.optimisation->stages = {1, 2};
        project.optimisation->stock_step_mm = 0.05;
        project.optimisation->radial_feed_mm_min = std::vector<double>{0.1, 0.3, 0.9};
        const Desk desk(project);
        for (const int method : {2, 3}) {
            desk.choose(method);
            desk.click("optimiseRun");
            QTRY_VERIFY_WITH_TIMEOUT(!desk.view->busy() && desk.view->search(), patience_ms);
            QVERIFY(isHeuristic(desk.view->search()->method) && !desk.view->search()->proved());
            const QString basis = desk.answered("best", "basis");
            QVERIFY2(basis.contains(QStringLiteral("heuristic")) && !basis.contains(u"proved"),
                     qPrintable(basis));
        }
    }

    void aFullSearchThatWasStoppedIsContinuedByItsButton() {
        const Desk desk(fixtures::endlessSearch());
        const auto& run = desk.part<QPushButton>("optimiseRun");
        const auto stopped = [&desk] {
            desk.click("optimiseRun");
            const auto judged = [&desk] {
                return desk.part<QProgressBar>("optimiseProgress")
                    .format()
                    .contains(QStringLiteral("judged"));
            };
            const bool begun = QTest::qWaitFor(judged, patience_ms);
            desk.click("optimiseStop");
            return begun && QTest::qWaitFor([&desk] { return !desk.view->busy(); }, patience_ms);
        };
        desk.choose(1);
        QCOMPARE(run.text(), QStringLiteral("Search"));
        QVERIFY(stopped());
        QCOMPARE(run.text(), QStringLiteral("Continue"));
        const long long before = desk.view->search()->search.evaluations;
        QVERIFY(before > 0);
        desk.choose(0);
        QCOMPARE(run.text(), QStringLiteral("Search"));
        desk.choose(1);
        QCOMPARE(run.text(), QStringLiteral("Continue"));
        QTest::keyClick(&desk.part<QCheckBox>("optimisePhases"), Qt::Key_Space);
        QCOMPARE(run.text(), QStringLiteral("Search"));
        QTest::keyClick(&desk.part<QCheckBox>("optimisePhases"), Qt::Key_Space);
        QCOMPARE(run.text(), QStringLiteral("Continue"));
        QVERIFY(stopped());
        QVERIFY(desk.view->search()->search.evaluations >= before);
        Project edited = desk.project();
        edited.wheel->dullness *= 1.5;
        desk.bench.window->document().edit(edited, {"Edit", ""});
        desk.bench.settle();
        QTRY_COMPARE(run.text(), QStringLiteral("Search"));
        QVERIFY(desk.told().contains(QStringLiteral("Press “Search”")));
        desk.bench.window->document().undo();
        desk.bench.settle();
        QTRY_COMPARE(run.text(), QStringLiteral("Continue"));
    }

    /// The margins by time are the engine's; a click chooses a cycle, the arrows go from point to
    /// point, Enter takes the one chosen.
    void aPointOfTheMarginsByTimeIsChosenByMouseAndKeysAndTaken() {
        const Project project = fixtures::searchedShaft();
        const TradeOff engine = tradeOff(project, optimise(project), {}, 40);
        const Desk desk(project);
        QVERIFY(!desk.view->margins()->hasFront());
        QVERIFY(desk.searched());
        desk.part<QComboBox>("optimiseContent").setCurrentIndex(2);
        desk.bench.settle();
        MarginFrontPlot& plot = *desk.view->margins();
        QVERIFY(plot.isVisible() && plot.hasFront() && engine.cycles.size() > 1);
        QCOMPARE(desk.view->search()->isFrontWhole, engine.isComplete);
        const std::vector<XY> curve = pointsOf(plot, MarginFrontPlot::frontKey);
        QCOMPARE(curve.size(), engine.cycles.size());
        const CsvTable table = plot.table();
        QCOMPARE(table.rows.size(), engine.cycles.size());
        const TimeUnit unit(engine.cycles.back().best->time_s);
        QCOMPARE(table.header[0], unit.titled(QStringLiteral("Time")));
        for (std::size_t i = 0; i < engine.cycles.size(); ++i) {
            const FeasibleCycle& best = *engine.cycles[i].best;
            QCOMPARE(std::get<double>(table.rows[i][0]), unit.of(best.time_s));
            QCOMPARE(std::get<double>(table.rows[i][1]), 100 * best.leastRelativeMargin);
            QCOMPARE(curve[i].x, best.time_s / unitOf_s(plot));
        }
        QCOMPARE(pointsOf(plot, MarginFrontPlot::yoursKey).at(0).x,
                 *desk.view->before_s() / unitOf_s(plot));
        QVERIFY(plot.chart().rules.empty());
        const std::size_t last = engine.cycles.size() - 1;
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.pixelOf(curve[last]).toPoint());
        const auto cycleAt = [&] {
            const int row = desk.part<CopyTable>("optimiseFound").currentIndex().row();
            return desk.cell(row, FoundColumn::cycle);
        };
        QCOMPARE(cycleAt(), OptimiseText::cycle(engine.cycles[last].cycle));
        QCOMPARE(pointsOf(plot, MarginFrontPlot::chosenKey).at(0).y,
                 100 * engine.cycles[last].best->leastRelativeMargin);
        plot.setFocus();
        const QCPRange before = plot.across().range();
        for (int i = 0; i < 60; ++i) {
            QTest::keyClick(&plot, Qt::Key_Left);
        }
        for (std::size_t i = 0; i < engine.cycles.size(); ++i) {
            const SearchSummary& point = engine.cycles[i];
            QCOMPARE(cycleAt(), OptimiseText::cycle(point.cycle));
            QCOMPARE(pointsOf(plot, MarginFrontPlot::chosenKey).at(0).x,
                     point.best->time_s / unitOf_s(plot));
            QVERIFY(plot.accessibleDescription().contains(OptimiseText::time(point.best->time_s)));
            QVERIFY(plot.hasFocus());
            QTest::keyClick(&plot, Qt::Key_Right);
        }
        QCOMPARE(cycleAt(), OptimiseText::cycle(engine.cycles.back().cycle)); // the last stays
        QVERIFY(plot.across().range() == before);                             // nothing moved
        QTest::keyClick(&plot, Qt::Key_Left);
        QTest::keyClick(&plot, Qt::Key_Return);
        desk.bench.settle();
        QCOMPARE(OptimiseText::cycle(*desk.project().cycle),
                 OptimiseText::cycle(engine.cycles[engine.cycles.size() - 2].cycle));
        QVERIFY(!desk.view->stale());
    }

    /// Over every stock of the range: the answer is its quickest point, and none is better.
    void aRobustSearchHasMarginsByTime() {
        Project project = fixtures::searchedShaft();
        const Desk desk(project);
        desk.part<QCheckBox>("optimisePhases").setChecked(true);
        QVERIFY(desk.searched());
        const SearchOutcome& search = *desk.view->search();
        QVERIFY(search.robust && search.best() && search.proved());
        const std::vector<const FoundCycle*> front = search.front();
        QVERIFY(!front.empty());
        double margin = -1;
        for (const FoundCycle* each : front) {
            QVERIFY(each->decided && each->leastRelativeMargin > margin);
            margin = each->leastRelativeMargin;
            QVERIFY(each->time_s >= search.best()->time_s - 1e-6);
        }
        desk.part<QComboBox>("optimiseContent").setCurrentIndex(2);
        desk.bench.settle();
        QVERIFY(desk.view->margins()->hasFront());
        QVERIFY(OptimiseText::front(search).contains(QStringLiteral("least over all")));
    }

    /// The wheel of the set-up wears: the answer has its parts and its cost, and an edit of the
    /// wear makes it old.
    void theCheapestCycleIsAnsweredWithItsInterval() {
        Setup setup = plainSetup(fixtures::searchedShaft());
        Project& project = setup.surfaces[0].project;
        project.optimisation->cost = Cost{60, 30, 100, 8, {}};
        project.optimisation->objective = SearchObjective::cost;
        setup.wear.dulling_per_mm2 = 3e-5;
        const IntervalSummary engine = searchInterval(project, SurfaceWear(setup, 0), {});
        const Desk desk(project);
        desk.bench.window->document().startUntitled(setup);
        desk.bench.settle();
        QVERIFY(!desk.part<QCheckBox>("optimiseRefine").isEnabled());
        QVERIFY(!desk.part<QCheckBox>("optimisePhases").isEnabled());
        QVERIFY(desk.told().contains(QStringLiteral("minimum cost")));
        QVERIFY(desk.searched());
        QCOMPARE(desk.cell(0, FoundColumn::cycle), OptimiseText::cycle(engine.search.cycle));
        QCOMPARE(desk.cell(0, FoundColumn::parts), OptimiseText::parts(*engine.held));
        QCOMPARE(desk.cell(0, FoundColumn::cost), OptimiseText::cost(*engine.cost));
        QCOMPARE(desk.answered("best", "name"), QStringLiteral("Minimum cost"));
        QCOMPARE(desk.answered("best", "parts"), OptimiseText::parts(*engine.held));
        QCOMPARE(desk.answered("best", "cost"), OptimiseText::cost(*engine.cost));
        QVERIFY2(desk.answered("best", "basis").contains(QStringLiteral("none is cheaper, proved")),
                 qPrintable(desk.answered("best", "basis")));
        QVERIFY(!desk.view->stale());
        SetupState worn = desk.bench.window->document().state();
        worn.wear.dulling_per_mm2 = 4e-5;
        desk.bench.window->document().editSetup(worn, {"Edit", ""});
        desk.bench.settle();
        QTRY_VERIFY(desk.view->stale());
    }

    /// With a time in the project the answer is the cycle of the largest margin within it.
    void theLargestMarginWithinATimeIsAnswered() {
        Project project = fixtures::searchedShaft();
        const SearchSummary quickest = optimise(project);
        project.optimisation->margin_within_min = 1.3 * quickest.best->time_s / 60;
        SearchOptions options;
        options.marginWithin_us = marginWithinOf(project);
        const SearchSummary engine = optimise(project, options);
        QVERIFY(engine.best->leastRelativeMargin > quickest.best->leastRelativeMargin);
        const Desk desk(project);
        QVERIFY(!desk.part<QCheckBox>("optimiseRefine").isEnabled());
        QVERIFY(desk.searched());
        QCOMPARE(desk.cell(0, FoundColumn::cycle), OptimiseText::cycle(engine.cycle));
        QCOMPARE(desk.cell(0, FoundColumn::margin),
                 OptimiseText::percent(engine.best->leastRelativeMargin));
        QCOMPARE(desk.answered("best", "name"), QStringLiteral("Maximum margin"));
        QCOMPARE(desk.answered("best", "margin"), desk.cell(0, FoundColumn::margin));
        QVERIFY(desk.answered("best", "basis").contains(QStringLiteral("the largest within")));
        desk.part<QComboBox>("optimiseContent").setCurrentIndex(2);
        desk.bench.settle();
        MarginFrontPlot& plot = *desk.view->margins();
        QCOMPARE(plot.chart().rules.size(), std::size_t{1});
        // To the microsecond that times are compared in.
        QVERIFY(std::abs(plot.chart().rules[0].at * unitOf_s(plot)
                         - *project.optimisation->margin_within_min * 60)
                < 1e-6);
        bool isOnFront = false; // the answer is one of its points
        for (const XY& point : pointsOf(plot, MarginFrontPlot::frontKey)) {
            isOnFront |= point.x == engine.best->time_s / unitOf_s(plot)
                         && point.y == 100 * engine.best->leastRelativeMargin;
        }
        QVERIFY(isOnFront);
    }

    void theCycleBeforeStaysForComparisonUntilTheNextSearch() {
        const Desk desk(fixtures::searchedShaft());
        QVERIFY(desk.searched());
        const double before_s = desk.view->curves()->runs().front().feeds->end_s;
        const QString gained = desk.cell(0, FoundColumn::change);
        const QString yours = desk.answered("yours", "time");
        desk.click("optimiseTake");
        const double best_s = desk.view->search()->best()->time_s;
        const auto present_s = [&] { return desk.bench.window->studies().outcome->result.time_s; };
        QTRY_VERIFY(std::abs(present_s() - best_s) < 1e-5);
        desk.bench.settle();
        QCOMPARE(desk.view->curves()->runs().front().feeds->end_s, before_s);
        QCOMPARE(desk.cell(0, FoundColumn::change), gained);
        QCOMPARE(desk.answered("yours", "time"), yours);
        Project larger = desk.project();
        larger.part->stock_mm += 0.05;
        desk.bench.window->document().edit(larger, {"Edit", ""});
        desk.bench.settle();
        desk.bench.window->document().undo();
        desk.bench.settle();
        QCOMPARE(desk.view->curves()->runs().front().feeds->end_s, before_s);
        QCOMPARE(desk.cell(0, FoundColumn::change), gained);
        QVERIFY(desk.searched()); // for the cycle taken
        QVERIFY(std::abs(desk.view->curves()->runs().front().feeds->end_s - best_s) < 1e-5);
        QVERIFY(std::abs(desk.cell(0, FoundColumn::change).toDouble()) < 0.05);
    }

    void theEndOfASearchIsToldInOtherViews() {
        const Desk desk(fixtures::searchedShaft());
        desk.click("optimiseRun");
        desk.bench.window->showView(QStringLiteral("feeds"));
        QTRY_COMPARE_WITH_TIMEOUT(desk.bench.window->statusBar()->currentMessage(),
                                  QStringLiteral("Optimise: ended."), patience_ms);
    }

    void anotherRowIsDrawnAndTakenByEnter() {
        const Desk desk(fixtures::searchedShaft());
        QVERIFY(desk.searched());
        QVERIFY(desk.view->search()->found.size() > 1);
        auto& table = desk.part<CopyTable>("optimiseFound");
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_Down);
        const FoundCycle second = desk.view->search()->found[1];
        const Cycle before = *desk.project().cycle;
        QTRY_VERIFY(std::abs(desk.view->curves()->runs().back().feeds->end_s - second.time_s)
                    < 1e-5);
        QTest::keyClick(&table, Qt::Key_Return);
        desk.bench.settle();
        QCOMPARE(OptimiseText::cycle(*desk.project().cycle), OptimiseText::cycle(second.cycle));
        desk.bench.window->document().undo(); // one edit
        desk.bench.settle();
        QCOMPARE(OptimiseText::cycle(*desk.project().cycle), OptimiseText::cycle(before));
    }

    void afterAnEditTheAnswerIsOfOtherInputsAndCannotBeTaken() {
        const Desk desk(fixtures::searchedShaft());
        QVERIFY(desk.searched());
        Project duller = desk.project();
        duller.wheel->dullness *= 1.5;
        desk.bench.window->document().edit(duller, {"Edit", ""});
        desk.bench.settle();
        QTRY_VERIFY(desk.view->stale());
        QVERIFY(!desk.part<QPushButton>("optimiseTake").isEnabled());
        QVERIFY(desk.told().contains(QStringLiteral("before the last edit")));
        desk.bench.window->document().undo();
        desk.bench.settle();
        QTRY_VERIFY(!desk.view->stale());
        QVERIFY(desk.part<QPushButton>("optimiseTake").isEnabled());
    }

    void theChosenRowStaysWhenThePresentCycleChanges() {
        const Desk desk(fixtures::searchedShaft());
        QVERIFY(desk.searched());
        auto& table = desk.part<CopyTable>("optimiseFound");
        table.selectRow(1);
        const QString before = desk.cell(1, FoundColumn::change);
        Project other = desk.project();
        other.cycle->stages.back().axial_feed_mm_min.value() *= 0.9;
        desk.bench.window->document().edit(other, {"Edit", ""});
        QTRY_VERIFY(desk.cell(1, FoundColumn::change) != before);
        QCOMPARE(table.currentIndex().row(), 1);
        QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
    }

    void anotherDocumentHasNoResultYet() {
        const Desk desk(fixtures::searchedShaft());
        QVERIFY(desk.searched());
        desk.bench.window->document().startUntitled(fixtures::searchedShaft());
        QVERIFY(!desk.view->search());
        QVERIFY(!desk.part<CopyTable>("optimiseFound").isVisible());
        QTRY_COMPARE(desk.view->curves()->runs().size(), std::size_t{1});
    }

    void whyAGridCannotBeSearchedIsOfThatGridAlone() {
        Project project = fixtures::searchedShaft();
        project.optimisation->stock_step_mm = 1e-9;
        const Desk desk(project);
        desk.click("optimiseRun");
        QTRY_VERIFY_WITH_TIMEOUT(!desk.view->busy(), patience_ms);
        QTRY_VERIFY2(desk.told().contains(QStringLiteral("use a larger step")),
                     qPrintable(desk.told()));
        desk.bench.window->document().edit(fixtures::searchedShaft(), {"Edit", ""});
        desk.bench.settle();
        QTRY_VERIFY2(desk.told().contains(QStringLiteral("finds the quickest cycle")),
                     qPrintable(desk.told()));
    }

    void roundsThatRanOutProveNothing() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        RobustSummary& robust = outcome.robust.emplace();
        outcome.search.best.emplace().time_s = outcome.search.bound_s = 60;
        outcome.search.status = SearchStatus::proved; // for the scenarios of the last round
        QVERIFY(outcome.unresolved() && !outcome.proved());
        const QString none = OptimiseText::notes(outcome);
        QVERIFY2(none.contains(QStringLiteral("every scenario")), qPrintable(none));
        QVERIFY(answerTable(outcome, {}).rows.empty());
        robust.holdsInSample = true;
        FoundCycle& found = outcome.found.emplace_back();
        found.time_s = 50;
        found.isBest = true;
        outcome.search.status = SearchStatus::stopped;
        QVERIFY(!outcome.unresolved() && !outcome.proved());
        const ValueTable some = answerTable(outcome, {});
        QVERIFY(cellOf(some, "best", "basis").startsWith(QStringLiteral("the best so far")));
        QCOMPARE(cellOf(some, "bound", "time"), timeBeside(60, 50));
        outcome.search.status = SearchStatus::proved;
        QVERIFY(outcome.proved());
        robust.nominalTime_s = 40;
        robust.added.resize(3);
        const ValueTable proved = answerTable(outcome, 100, 0.25);
        QCOMPARE(cellOf(proved, "bound", "time"), QString());
        QCOMPARE(cellOf(proved, "yours", "margin"), OptimiseText::percent(0.25));
        QCOMPARE(cellOf(proved, "nominal", "time"), timeBeside(40, 100));
        QCOMPARE(cellOf(proved, "nominal", "change"), OptimiseText::percent(-0.6));
        QVERIFY(cellOf(proved, "nominal", "basis").contains(QStringLiteral("25.0 % of time")));
        QCOMPARE(cellOf(proved, "nominal", "stocks"), QStringLiteral("–"));
        QCOMPARE(cellOf(proved, "best", "name"), QStringLiteral("Robust answer"));
        QCOMPARE(cellOf(proved, "best", "stocks"), QStringLiteral("0.74"));
        const QString basis = cellOf(proved, "best", "basis");
        QVERIFY2(basis.contains(QStringLiteral("proved for the part and the scenarios added (3)"))
                     && basis.contains(QStringLiteral("fit for 500 random stocks, cycle no. 1")),
                 qPrintable(basis));
    }

    void theShareThatMayFailGrowsWithTheCyclesTried() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        RobustSummary& robust = outcome.robust.emplace();
        robust.holdsInSample = true;
        FoundCycle& found = outcome.found.emplace_back();
        found.time_s = 50;
        found.isBest = true;
        found.candidate = 3;
        const ValueTable third = answerTable(outcome, {});
        QCOMPARE(cellOf(third, "best", "stocks"), QStringLiteral("1.10"));
        QVERIFY(cellOf(third, "best", "basis").contains(QStringLiteral("cycle no. 3 tried")));
        QVERIFY(!cellOf(third, "best", "basis").contains(QStringLiteral("nominal part only")));
        QVERIFY(cellOf(third, "best", "batch").isEmpty()); // no batch is searched
        found.decided = PhaseCases{{0.149, 0.151}, 8};
        found.freshParts = {.tried = 500, .ppk = 1.234};
        found.candidate = 2;
        const ValueTable decided = answerTable(outcome, {});
        QCOMPARE(placeOf(decided.columns, "stocks"), decided.columns.size());
        QCOMPARE(cellOf(decided, "best", "batch"), QStringLiteral("0.96"));
        const QString basis = cellOf(decided, "best", "basis");
        QVERIFY2(basis.contains(QStringLiteral("every stock of 0.149000…0.151000 mm, also at 8"))
                     && basis.contains(QStringLiteral("all 500 random parts are good"))
                     && basis.contains(QStringLiteral("Ppk at least 1.23"))
                     && !basis.contains(QStringLiteral("no cycle found")),
                 qPrintable(basis));
        found.freshParts.isCapable = false;
        const QString missed = cellOf(answerTable(outcome, {}), "best", "basis");
        QVERIFY2(missed.contains(QStringLiteral("Ppk at least 1.23, too low for the batch")),
                 qPrintable(missed));
    }

    /// The tip, speech and copies have the whole of it; only the name and numbers are bold.
    void theBasisIsShownBriefly() {
        SearchOutcome outcome = robustAnswer();
        const ValueTable table = answerTable(outcome, 100);
        const ValueCell basis = wholeCellOf(table, "best", "basis");
        QCOMPARE(basis.text, QStringLiteral("proved; every stock and corner; parts good; "
                                            "Ppk\u00a0≥\u00a01.23"));
        QVERIFY2(
            basis.said.contains(QStringLiteral("also at 8 corners of the batch"))
                && basis.said.startsWith(QStringLiteral("proved for the part and the scenarios"))
                && basis.said.endsWith(QStringLiteral("Ppk at least 1.23")),
            qPrintable(basis.said));
        QCOMPARE(std::get<QString>(basis.value), basis.said);
        const ValueCell limit = wholeCellOf(table, "limit", "basis");
        QCOMPARE(limit.text, QStringLiteral("a stepless cycle"));
        QVERIFY(limit.said.contains(QStringLiteral("by a count of steps without feed")));
        QCOMPARE(wholeCellOf(table, "nominal", "basis").text,
                 cellOf(table, "nominal", "basis")); // there is room for it
        ValueModel model;
        model.setTable(table);
        const auto best = static_cast<int>(placeOf(table.rows, "best"));
        const auto at = [&](const char* column, int role) {
            return model.index(best, static_cast<int>(placeOf(table.columns, column))).data(role);
        };
        QVERIFY(at("basis", Qt::ToolTipRole).toString().contains(QStringLiteral("8 corners")));
        QVERIFY(at("basis", Qt::AccessibleTextRole).toString().endsWith(basis.said));
        QVERIFY(!at("basis", Qt::FontRole).isValid());
        QVERIFY(at("name", Qt::FontRole).value<QFont>().bold());
        outcome.found[0].decided.reset();
        outcome.found[0].freshParts.isCapable = false;
        outcome.search.status = SearchStatus::stopped;
        QCOMPARE(wholeCellOf(answerTable(outcome, 100), "best", "basis").text,
                 QStringLiteral("not proved; 500 random stocks; parts good; "
                                "Ppk\u00a0≥\u00a01.23, too low"));
    }

    /// In Russian, which is longer, every row of a robust answer is seen in the usual window.
    void aRobustAnswerIsNotScrolled() {
        const QLocale before;
        const auto back = qScopeGuard([&before] { QLocale::setDefault(before); });
        const Desk desk(fixtures::searchedShaft(), QStringLiteral("ru"));
        QCOMPARE(desk.bench.window->size(), QSize(1366, 768));
        Studies studies;
        OptimiseView view(nullptr, nullptr, &studies); // with an answer that took no search
        view.resize(desk.view->size());
        view.setOutcome(desk.bench.window->studies().outcome);
        view.show();
        QTRY_VERIFY(!view.curves()->runs().empty());
        studies.search.take(std::make_shared<const SearchOutcome>(robustAnswer()));
        emit studies.search.job().answered();
        desk.bench.rest();
        QCOMPARE(view.size(), desk.view->size());
        auto& table = *view.findChild<CopyTable*>(QStringLiteral("optimiseAnswer"));
        QVERIFY(table.isVisible() && !view.stale());
        QCOMPARE(table.model()->rowCount(), 4);
        QTRY_COMPARE(table.verticalScrollBar()->maximum(), 0);
        QTRY_COMPARE(table.horizontalScrollBar()->maximum(), 0);
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            QTRY_VERIFY(table.rowHeight(row) < 3 * table.fontMetrics().lineSpacing());
        }
    }

    /// What was found between the levels is the answer, in bold, and stands beside the grid's best.
    void theRefinedCycleHasARowOfItsOwn() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        outcome.search.status = SearchStatus::proved;
        outcome.refinement.emplace();
        FoundCycle& best = outcome.found.emplace_back();
        best.time_s = 50;
        best.isBest = true;
        const ValueTable without = answerTable(outcome, 100);
        QCOMPARE(cellOf(without, "refined", "basis"), QStringLiteral("nothing quicker was found"));
        QVERIFY(without.rows[placeOf(without.rows, "best")].isStrong);
        FoundCycle refined;
        refined.by = FoundBy::refinement;
        refined.time_s = 45;
        outcome.found.insert(outcome.found.begin(), refined);
        const ValueTable with = answerTable(outcome, 100);
        QCOMPARE(cellOf(with, "best", "time"), timeBeside(50, 100));
        QCOMPARE(cellOf(with, "refined", "time"), timeBeside(45, 100));
        QCOMPARE(cellOf(with, "refined", "change"), OptimiseText::percent(-0.55));
        QVERIFY(cellOf(with, "refined", "basis").contains(QStringLiteral("not proved")));
        QVERIFY(!with.rows[placeOf(with.rows, "best")].isStrong);
        QVERIFY(with.rows[placeOf(with.rows, "refined")].isStrong);
    }

    /// On the screen and in a copy; seconds below two minutes.
    void aColumnOfTimesHasTheUnitOfTheLongest() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        outcome.search.status = SearchStatus::proved;
        FoundCycle& best = outcome.found.emplace_back();
        best.time_s = 90;
        best.isBest = true;
        struct Case {
            double before_s;
            const char *head, *best, *yours;
            double copied;
        };
        for (const Case& each : {Case{119, "Time, s", "90.00", "119.0", 90},
                                 Case{120, "Time, min", "1.500", "2.000", 1.5}}) {
            const QString head = QString::fromLatin1(each.head);
            const ValueTable answer = answerTable(outcome, each.before_s);
            QCOMPARE(timeHead(answer), head);
            QCOMPARE(cellOf(answer, "best", "time"), QString::fromLatin1(each.best));
            QCOMPARE(cellOf(answer, "yours", "time"), QString::fromLatin1(each.yours));
            const CsvTable copy = answer.asTable();
            QCOMPARE(copy.header[1], head);
            QCOMPARE(std::get<double>(copy.rows[1][1]), each.copied);
            const ValueTable found = foundTable(outcome, each.before_s);
            QCOMPARE(timeHead(found), head);
            QCOMPARE(found.cells[0][0].text, QString::fromLatin1(each.best));
            QCOMPARE(found.asTable().header[0], head);
            QCOMPARE(std::get<double>(found.asTable().rows[0][0]), each.copied);
        }
    }

    void copiedTablesOfPlotsHaveTheUnitOfTheLongestTime() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        FoundCycle& found = outcome.found.emplace_back();
        found.by = FoundBy::margin;
        SearchedNumber& number = outcome.numbers.emplace_back();
        struct Case {
            double time_s;
            const char* unit;
            double copied;
        };
        for (const Case& each : {Case{90, "s", 90}, Case{150, "min", 2.5}}) {
            found.time_s = each.time_s;
            number.best_s = each.time_s;
            const CsvTable margins = MarginFrontPlot::tableOf(outcome);
            QCOMPARE(margins.header[0],
                     QStringLiteral("Time, %1").arg(QLatin1StringView(each.unit)));
            QCOMPARE(std::get<double>(margins.rows[0][0]), each.copied);
            const CsvTable numbers = StageCountPlot::tableOf(outcome);
            QCOMPARE(
                numbers.header[1],
                QStringLiteral("Time of the quickest cycle, %1").arg(QLatin1StringView(each.unit)));
            QCOMPARE(std::get<double>(numbers.rows[0][1]), each.copied);
        }
    }

    /// With its heads and all digits, under a name that a screen reader speaks.
    void theAnswerIsCopiedAsATable() {
        const Desk desk(fixtures::searchedShaft());
        QVERIFY(!desk.part<CopyTable>("optimiseAnswer").isVisible());
        QVERIFY(desk.searched());
        auto& table = desk.part<CopyTable>("optimiseAnswer");
        QVERIFY(table.isVisible() && !table.accessibleName().isEmpty());
        const QString head = TimeUnit(desk.longest_s()).titled(QStringLiteral("Time"));
        QCOMPARE(table.model()->index(1, 1).data(Qt::AccessibleTextRole).toString(),
                 head + QStringLiteral(", Quickest cycle: ") + desk.answered("best", "time"));
        table.setFocus();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        const QStringList lines =
            QGuiApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 1 + table.model()->rowCount());
        QVERIFY2(lines[0].startsWith(QStringLiteral("Cycle\t%1\tAgainst yours, %\t").arg(head)),
                 qPrintable(lines[0]));
        QVERIFY2(lines[2].startsWith(QStringLiteral("Quickest cycle\t")), qPrintable(lines[2]));
    }

    // What was not worked out is not known; it does not read as if nothing were in the way.
    void whatBindsIsNotKnownWhereItWasStopped() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        FoundCycle& found = outcome.found.emplace_back();
        found.time_s = 50;
        found.isBest = true;
        outcome.search.status = SearchStatus::proved;
        const auto says = [&](const char* words) {
            return OptimiseText::notes(outcome).contains(QString::fromLatin1(words));
        };
        QVERIFY(says("The limit of the time is not known: the search was stopped"));
        outcome.binding.emplace();
        QVERIFY(!says("not known") && says("No cycle of the grid that differs in one setting"));
        outcome.search.status =
            SearchStatus::stopped; // of the best so far nothing of the kind is proved
        QVERIFY(!says("not known") && !says("No cycle of the grid that differs"));
        outcome.binding->push_back(ConstraintKind::wheelPower);
        QVERIFY(!says("not known") && says("Limited by: "));
    }

    /// The words above the plots begin with what the verdict excepts.
    void whatIsNotDecidedIsNamedFirst() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        FoundCycle& found = outcome.found.emplace_back();
        found.time_s = 50;
        found.isBest = true;
        outcome.search.status = SearchStatus::proved;
        QVERIFY(!OptimiseText::notes(outcome).contains(QStringLiteral("not decided")));
        outcome.remarks.notDecided = {
            {ConstraintKind::roughness, UndecidedReason::notCalibrated, {}}};
        const QString text = OptimiseText::notes(outcome);
        QVERIFY2(text.startsWith(QStringLiteral("Met, except roughness Ra: not decided. ")),
                 qPrintable(text));
    }

    void anAnswerWithoutAMarginNamesItsRequirementAndTheInputThatAsksForOne() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        FoundCycle& found = outcome.found.emplace_back();
        found.time_s = 50;
        found.isBest = true;
        outcome.search.status = SearchStatus::proved;
        QVERIFY(!OptimiseText::notes(outcome).contains(QStringLiteral("No margin")));
        outcome.remarks.noMargin = {ConstraintKind::diameterMin, ConstraintKind::wheelPower};
        const QString text = OptimiseText::notes(outcome);
        QVERIFY2(text.contains(
                     QStringLiteral("No margin is left for: %1, %2. For a cycle with a margin, set "
                                    "“Maximum margin within a time” in the search.")
                         .arg(Names::inSentence(Names::constraint(ConstraintKind::diameterMin)),
                              Names::inSentence(Names::constraint(ConstraintKind::wheelPower)))),
                 qPrintable(text));
    }

    /// Where the answer stands at the edge of its grid, the line below it says so.
    void theEdgeOfTheGridIsNamed() {
        SearchOutcome outcome;
        outcome.project = outcome.searched = fixtures::searchedShaft();
        outcome.searched.machine->limits.axial_feed_mm_min = std::vector<double>{50, 5000, 50};
        FoundCycle& found = outcome.found.emplace_back();
        found.time_s = 50;
        found.isBest = true;
        outcome.search.status = SearchStatus::proved;
        Cycle cycle = *outcome.project.cycle;
        cycle.stages.resize(2);
        cycle.stages[0].radial_feed_mm = 0.003;
        cycle.stages[0].axial_feed_mm_min = 2400;
        cycle.stages[1].radial_feed_mm = 0.003;
        cycle.stages[1].axial_feed_mm_min = 1200;
        outcome.edges = edgesReached(outcome.searched, cycle);
        QString text = OptimiseText::notes(outcome);
        QVERIFY2(text.contains(QStringLiteral("Stage 1: “Axial feed” has the maximum level"))
                     && text.contains(QStringLiteral("the machine allows up to 5000")),
                 qPrintable(text));
        QVERIFY(!text.contains(QStringLiteral("Stage 2:")));
        outcome.searched.machine->limits.axial_feed_mm_min = std::vector<double>{50, 2400, 50};
        outcome.edges = edgesReached(outcome.searched, cycle);
        outcome.rounds = 3;
        text = OptimiseText::notes(outcome);
        QVERIFY2(text.contains(QStringLiteral("the machine's range ends there"))
                     && text.contains(QStringLiteral("rounds: 3")),
                 qPrintable(text));
    }

    void whenNothingHoldsTheRequirementThatCutMostIsNamed() {
        Project project = fixtures::searchedShaft();
        project.part->tolerance.radial_runout_um = 1e-6;
        const Desk desk(project);
        desk.click("optimiseRun");
        QTRY_VERIFY_WITH_TIMEOUT(desk.view->search() && !desk.view->busy(), patience_ms);
        QVERIFY(!desk.view->search()->best());
        QVERIFY2(desk.told().contains(QStringLiteral("unout")), qPrintable(desk.told()));
        QVERIFY(!desk.part<CopyTable>("optimiseFound").isVisible());
    }

    void aProjectWithoutAGridIsOfferedAUsualOne() {
        Project project = fixtures::searchedShaft();
        project.optimisation.reset();
        const Desk desk(project);
        QVERIFY(!desk.part<QPushButton>("optimiseRun").isEnabled());
        const auto& content = desk.part<QComboBox>("optimiseContent");
        QVERIFY(!content.isVisible()); // there is nothing to choose of
        desk.click("optimiseAdd");
        desk.bench.settle();
        QVERIFY(desk.project().optimisation->non_increasing);
        QVERIFY(desk.project().least_overlap && desk.project().least_overlap_last
                && desk.project().least_steps);
        QTRY_VERIFY(desk.part<QPushButton>("optimiseRun").isEnabled());
        QVERIFY(!desk.part<QPushButton>("optimiseAdd").isVisible());
        QVERIFY(content.isVisible());
    }

    void levelsAreTypedAsAListOrAsFromToAndStep() {
        const Desk desk(fixtures::searchedShaft());
        const auto axial = [&desk] { return desk.project().optimisation->axial_feed_mm_min; };
        desk.type("/optimisation/axial_feed_mm_min", QStringLiteral("300; 1200,5"));
        QVERIFY(axial() == Levels(std::vector<double>{300, 1200.5}));
        for (const char* text : {"300…2400 step 100", "300..2400/100", "300 to 2400; 100",
                                 "300 - 2400 шаг 100", "300 до 2400 step 100"}) {
            desk.type("/optimisation/axial_feed_mm_min", QStringLiteral("500"));
            desk.type("/optimisation/axial_feed_mm_min", QString::fromUtf8(text));
            QVERIFY2(axial() == Levels(SteppedLevels{300, 2400, 100}), text);
        }
        desk.type("/optimisation/stages", QStringLiteral("1; 3"));
        QVERIFY((desk.project().optimisation->stages == std::vector<double>{1, 3}));
        desk.type("/optimisation/last_stock_mm", QStringLiteral("0.01; 0.05"));
        QVERIFY((desk.project().optimisation->last_stock_mm == std::vector<double>{0.01, 0.05}));
        desk.type("/optimisation/last_stock_mm", QString());
        QVERIFY(!desk.project().optimisation->last_stock_mm);
    }

    void levelsThatCannotBeReadStayInSightWithTheirReason_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason"); ///< a part of it
        const QString axial = QStringLiteral("/optimisation/axial_feed_mm_min");
        QTest::newRow("words") << axial << "fast; slow"
                               << "semicolons";
        QTest::newRow("zero") << axial << "0; 300"
                              << "0; allowed: above 0";
        QTest::newRow("no step") << axial << "300…2400"
                                 << "semicolons";
        QTest::newRow("falling") << axial << "2400…300 step 100"
                                 << "below the first";
        QTest::newRow("half a stage") << "/optimisation/stages"
                                      << "1; 2.5"
                                      << "contradict";
        QTest::newRow("six stages") << "/optimisation/stages"
                                    << "6"
                                    << "6; allowed: 1 to 5";
        QTest::newRow("one end") << "/optimisation/last_stock_mm"
                                 << "0.01"
                                 << "2 numbers";
    }
    void levelsThatCannotBeReadStayInSightWithTheirReason() {
        QFETCH(QString, path);
        QFETCH(QString, text);
        QFETCH(QString, reason);
        const Desk desk(fixtures::searchedShaft());
        const Project before = desk.project();
        desk.type(path.toUtf8().constData(), text);
        const FormPage& page = *desk.bench.window->inputs().pages()[searchPage];
        QCOMPARE(page.findChild<QLineEdit*>(path)->text(), text);
        QVERIFY(sameSearch(desk.project(), before));
        const std::vector<Refusal> refusals = desk.bench.window->inputs().refusals();
        QCOMPARE(refusals.size(), std::size_t{1});
        QVERIFY2(refusals.front().reason.contains(reason), qPrintable(refusals.front().reason));
    }
};

} // namespace sparkout::test_optimise_view

SPARKOUT_TEST(test_optimise_view, TestOptimiseView)
#include "test_optimise_view.moc"
