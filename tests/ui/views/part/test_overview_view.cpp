// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Overview": its numbers are the engine's, its bars lead to their views, what is empty
// says what will be there.
#include "core/batch/batch_summary.h"
#include "core/quality/diameter_shares.h"
#include "core/quality/run_summary.h"
#include "core/quality/verdict.h"
#include "core/study/run_comparison.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "tests/two_stage_projects.h"
#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/view_fixtures.h"
#include "tests/ui/support/window_bench.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/chart/view.h"
#include "ui/results/verdict_table.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/views/cycle/feeds_view.h"
#include "ui/views/part/overview_view.h"
#include "ui/views/requirements/constraints_view.h"
#include "ui/views/study/batch_view.h"
#include "ui/window/view_tabs.h"

#include <QAction>
#include <QComboBox>
#include <QScrollArea>
#include <QToolButton>

#include <utility>
#include <variant>
#include <vector>

namespace sparkout::test_overview_view {

using enum OverviewChart;

/// A window with the overview in sight.
struct Desk {
    explicit Desk(const QString& language = QStringLiteral("en")) : bench(language) {
        view = bench.window->findChild<OverviewView*>();
    }
    explicit Desk(const Project& project) : Desk() { QVERIFY(open(project)); }
    [[nodiscard]] bool open(const Project& project) const {
        bench.window->document().startUntitled(project);
        const bool came = QTest::qWaitFor(
            [this] { return bench.window->studies().outcome && !bench.window->runs().running(); },
            30'000);
        bench.settle();
        return came;
    }
    [[nodiscard]] BarPlot& plot(OverviewChart chart) const { return *view->tile(chart)->plot(); }
    /// Scrolls a chart into sight, until it is painted.
    [[nodiscard]] bool see(OverviewChart chart) const {
        bench.window->showView(QStringLiteral("overview"));
        view->findChild<QScrollArea*>(QStringLiteral("overviewPage"))
            ->ensureWidgetVisible(view->tile(chart)->plot());
        bench.settle();
        return QTest::qWaitFor([&] { return !plot(chart).drawing().parts().empty(); });
    }
    /// Clicks on the bar of a series in a category.
    [[nodiscard]] bool click(OverviewChart chart, std::size_t category) const {
        if (!see(chart)) {
            return false;
        }
        BarPlot& of = plot(chart);
        for (const BarPart& part : of.drawing().parts()) {
            if (part.category == category && (part.rect.width() > 2 && part.rect.height() > 2)) {
                // Of a ring that is nearly all of one slice, its lower part.
                const double below = part.slice.isEmpty() ? 0 : 0.4 * part.rect.height();
                const QPoint at = (part.rect.center() + QPointF(0, below)).toPoint();
                QTest::mouseClick(&of, Qt::LeftButton, {}, at);
                bench.settle();
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] QString current() const {
        return bench.window->viewTabs().currentView()->objectName();
    }
    [[nodiscard]] const Outcome& outcome() const { return *bench.window->studies().outcome; }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) const {
        return *bench.window->findChild<Widget*>(QString::fromLatin1(name));
    }
    Bench bench;
    OverviewView* view;
};

Project batchProject() {
    Project project = fixtures::traverseProject();
    project.batch = Batch{};
    project.batch->parts = 40;
    project.batch->factors.stock_mm = fixtures::uniform(0.145, 0.155);
    project.batch->factors.initial_runout_mm = fixtures::uniform(0.01, 0.03);
    return project;
}

bool runBatch(const Desk& desk) {
    desk.bench.window->showView(QStringLiteral("batch"));
    desk.bench.settle();
    auto* batch = desk.bench.window->findChild<BatchView*>();
    const bool came = QTest::qWaitFor([batch] { return batch->batch() && !batch->busy(); }, 60'000);
    desk.bench.window->showView(QStringLiteral("overview"));
    desk.bench.settle();
    return came;
}

class TestOverviewView : public QObject {
    Q_OBJECT

private slots:
    void itIsTheFirstViewAndShownAtFirst() {
        const Desk desk;
        QCOMPARE(desk.bench.window->views().front(), static_cast<View*>(desk.view));
        QVERIFY(desk.view->isVisible());
    }

    // --- the numbers ----------------------------------------------------------------------------

    void everyTileDrawsItsChart() {
        const Desk desk(fixtures::traverseProject());
        const Outcome& outcome = desk.outcome();
        for (const auto& [tile, chart] :
             {std::pair(times, OverviewCharts::times(outcome)),
              std::pair(stock, OverviewCharts::stock(outcome)),
              std::pair(diameters, OverviewCharts::diameters(outcome)),
              std::pair(requirements, OverviewCharts::requirements(outcome))}) {
            QVERIFY(!chart.description().isEmpty());
            QCOMPARE(desk.plot(tile).chart().description(), chart.description());
        }
    }

    void timesAreThoseOfTheEngine() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const BarChart chart = OverviewCharts::times(*outcome);
        const SimulationResult& result = outcome->result;
        QCOMPARE(chart.categories.size(), qsizetype(result.timeByStage_s.size()));
        QCOMPARE(chart.series.size(), std::size_t(6)); // all steps of a stroke with two dwells
        double all = 0;
        for (std::size_t stage = 0; stage < result.timeByStage_s.size(); ++stage) {
            QVERIFY(std::abs(chart.total(stage) * 60 - result.timeByStage_s[stage]) < 1e-9);
            all += chart.total(stage);
        }
        QVERIFY(std::abs(all * 60 - result.time_s) < 1e-9);
        QVERIFY(chart.series[2].name.contains(QStringLiteral("E3/E1/E1")));
    }

    void stockIsThatOfTheEngineZoneByZone() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const BarChart chart = OverviewCharts::stock(*outcome);
        const auto stages = outcome->steps.time_s.size();
        QCOMPARE(chart.categories.size(), qsizetype(3 * stages));
        for (std::size_t zone = 0; zone < 3; ++zone) {
            double removed_um = 0;
            for (std::size_t stage = 0; stage < stages; ++stage) {
                removed_um += chart.total(3 * stage + zone);
            }
            const LayerColumn& layers = outcome->layers.columns[zone];
            QVERIFY(std::abs(removed_um - 1000 * (layers.blank_mm - layers.final_mm)) < 1e-6);
        }
        QVERIFY(chart.described(2, 0).contains(QStringLiteral("E3")));
        QVERIFY(chart.described(2, 1).contains(QStringLiteral("E1")));
    }

    void aDiametersSharesAddUpToItsDeviation() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const BarChart chart = OverviewCharts::diameters(*outcome);
        const auto& sections = outcome->result.sections;
        QCOMPARE(chart.sums.size(), 2 * sections.size());
        for (std::size_t i = 0; i < sections.size(); ++i) {
            QVERIFY(std::abs(chart.total(2 * i) - 1000 * sections[i].diameterDeviationMin_mm)
                    < 1e-6);
            QVERIFY(std::abs(chart.total(2 * i + 1) - 1000 * sections[i].diameterDeviationMax_mm)
                    < 1e-6);
            QVERIFY(std::abs(chart.sums[2 * i] - chart.total(2 * i)) < 1e-9);
        }
        QCOMPARE(chart.band->low, outcome->result.project.part->lower_deviation_um);
    }

    void requirementsAreThoseOfTheEngineTheWorstFirst() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const BarChart chart = OverviewCharts::requirements(*outcome);
        const auto shown = OverviewCharts::requirementsShown(*outcome);
        QVERIFY(shown.size() > 2);
        QCOMPARE(chart.categories.size(), qsizetype(shown.size()));
        for (std::size_t i = 0; i < shown.size(); ++i) {
            if (shown[i].isWhole) {
                QVERIFY(std::abs(chart.total(i) - 100 * usageOf(shown[i])) < 1e-9);
            }
            QVERIFY(i == 0 || shown[i].holds || !shown[i - 1].holds); // fails first
        }
    }

    /// Neither as met nor as close to the limit, and its bar as the least that is used up.
    void whatIsNotDecidedIsDrawnAsThat() {
        Project project = fixtures::traverseProject(); // whose machine's runout is not known
        project.part->tolerance.radial_runout_um = 100;
        const OutcomePtr outcome = fixtures::run(project);
        const BarChart chart = OverviewCharts::requirements(*outcome);
        const auto shown = OverviewCharts::requirementsShown(*outcome);
        int undecided = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            for (const BarSeries& series : chart.series) {
                const bool isHere = std::isfinite(series.values[i]);
                QVERIFY(!isHere || series.name == lightName(lightOf(shown[i])));
                QVERIFY(!isHere || series.atLeast == (lightOf(shown[i]) == Light::undecided));
            }
            undecided += chart.isLowerBound(i) ? 1 : 0;
            QCOMPARE(chart.isLowerBound(i), lightOf(shown[i]) == Light::undecided);
        }
        QVERIFY(undecided > 0);
        QVERIFY(chart.description().contains(QStringLiteral("≥")));
    }

    void theBatchIsThatOfTheEngine() {
        const Desk desk(batchProject());
        QVERIFY(runBatch(desk));
        const BatchSummary& summary = desk.bench.window->findChild<BatchView*>()->batch()->summary;
        const BarChart& ring = desk.plot(parts).chart();
        double all = 0;
        for (std::size_t i = 0; i < ring.series.size(); ++i) {
            all += ring.value(i, 0);
        }
        QCOMPARE(all, double(summary.parts));
        const BarChart& chart = desk.plot(boxes).chart();
        const auto places = placesOf(summary, "diameter");
        QCOMPARE(chart.boxes.size(), places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const CharacteristicSummary& of = summary.characteristics[places[i]];
            QCOMPARE(chart.boxes[i].least, of.least.value);
            QCOMPARE(chart.boxes[i].most, of.most.value);
            const auto median = std::ranges::find(of.percentiles, 0.5, &Percentile::order);
            QCOMPARE(chart.boxes[i].median, median->value);
            QVERIFY(chart.boxes[i].least <= chart.boxes[i].low
                    && chart.boxes[i].low <= chart.boxes[i].median
                    && chart.boxes[i].median <= chart.boxes[i].high
                    && chart.boxes[i].high <= chart.boxes[i].most);
        }
    }

    void keptRunsStandBesideThePresentOne() {
        const Desk desk(fixtures::traverseProject());
        QVERIFY(desk.view->tile(runs)->isEmpty());
        auto& keep = desk.part<QPushButton>("overviewRunsStep");
        QVERIFY(keep.isVisible());
        QTest::mouseClick(&keep, Qt::LeftButton);
        desk.bench.settle();
        const BarChart& chart = desk.plot(runs).chart();
        QCOMPARE(chart.categories.size(), qsizetype(2));
        QCOMPARE(chart.value(0, 0), desk.outcome().result.time_s / 60);
        QCOMPARE(chart.value(0, 1), chart.value(0, 0));
        const RunSummary present =
            summarise(desk.outcome().result, desk.outcome().accuracy, desk.outcome().constraints);
        const Project& inputs = desk.outcome().result.project;
        const ConstraintResult least = leastMargin(present, &inputs).value();
        QCOMPARE(chart.value(1, 0), 100 * least.relativeMargin);
        // The bar, and the table that is copied, say whose margin it is.
        const QString whose = QStringLiteral("%1, %2").arg(
            Names::inSentence(Names::constraint(least.kind)), Names::where(least));
        for (const std::size_t run : {0u, 1u}) {
            const QString told = chart.described(1, run);
            QVERIFY2(told.contains(QStringLiteral("minimum margin (%1): ").arg(whose)),
                     qPrintable(told));
        }
        const CsvTable table = chart.table([](std::size_t) { return true; });
        QCOMPARE(table.header.last(), QStringLiteral("Requirement"));
        for (const std::vector<CsvCell>& row : table.rows) {
            QCOMPARE(qsizetype(row.size()), table.header.size());
            QCOMPARE(std::get<QString>(row.back()), whose);
        }
    }

    void theRunsOfAnExampleAreNamedInTheWindowsLanguage() {
        const Desk desk(QStringLiteral("ru"));
        Project project = fixtures::traverseProject();
        QVERIFY(desk.open(project));
        const Outcome& now = desk.outcome();
        project.runs.push_back(keptRun(now.result,
                                       summarise(now.result, now.accuracy, now.constraints),
                                       "Factory", "2026-01-01T00:00:00Z"));
        QVERIFY(desk.open(project));
        const QStringList shown = desk.plot(runs).chart().categories;
        QCOMPARE(shown.size(), qsizetype(2));
        QCOMPARE(shown[1], exampleTitle("Factory"));
        QVERIFY(shown[1] != QStringLiteral("Factory"));
    }

    // --- where bars lead ------------------------------------------------------------------------

    void aBarLeadsToItsView() {
        const Desk desk(fixtures::traverseProject());
        QVERIFY(desk.click(times, 1));
        QCOMPARE(desk.current(), QStringLiteral("feeds"));
        QCOMPARE(desk.part<QComboBox>("span").currentData().toInt(), 2);
        QVERIFY(desk.click(stock, 0));
        QCOMPARE(desk.current(), QStringLiteral("layers"));
        QVERIFY(desk.click(diameters, 4));
        QCOMPARE(desk.current(), QStringLiteral("profiles"));
        QVERIFY(desk.click(requirements, 0));
        QCOMPARE(desk.current(), QStringLiteral("constraints"));
        QTest::mouseClick(&desk.part<QPushButton>("overviewRunsStep"), Qt::LeftButton);
        desk.bench.settle();
        QVERIFY(desk.see(runs));
        QVERIFY(desk.click(runs, 0));
        QCOMPARE(desk.current(), QStringLiteral("compare"));
    }

    void barsOfTheBatchLeadToIt() {
        const Desk desk(batchProject());
        QVERIFY(runBatch(desk));
        for (const OverviewChart chart : {boxes, parts}) {
            QVERIFY(desk.click(chart, 0));
            QCOMPARE(desk.current(), QStringLiteral("batch"));
        }
    }

    void whatIsEmptySaysWhatWillBeThereAndLeadsThere() {
        const Desk desk(fixtures::traverseProject());
        for (const OverviewChart chart : {boxes, parts, runs}) {
            QVERIFY(desk.view->tile(chart)->isEmpty());
            QVERIFY(desk.view->tile(chart)->emptyText().size() > 20);
            QVERIFY(!desk.plot(chart).isVisible());
            QVERIFY(!desk.plot(chart).tools()->svg->isEnabled());
        }
        QTest::mouseClick(&desk.part<QPushButton>("overviewBoxesStep"), Qt::LeftButton);
        QCOMPARE(desk.current(), QStringLiteral("batch"));
        Project corners = batchProject();
        corners.batch->scenarios = Scenarios::corners;
        QVERIFY(desk.open(corners));
        QVERIFY(runBatch(desk));
        QVERIFY(desk.view->tile(boxes)->isEmpty()); // no sample
        QVERIFY(!desk.view->tile(parts)->isEmpty());
    }

    void aBatchOfOtherInputsIsPaleAndAnotherDocumentsIsGone() {
        const Desk desk;
        Project project = batchProject();
        QVERIFY(desk.open(project));
        QVERIFY(runBatch(desk));
        QVERIFY(!desk.plot(boxes).isDimmed());
        project.part->stock_mm += 0.01;
        desk.bench.window->document().edit(project, {"Edit", ""});
        QTRY_VERIFY(desk.plot(boxes).isDimmed() && desk.plot(parts).isDimmed());
        QVERIFY(!desk.plot(times).isDimmed());
        QVERIFY(desk.open(batchProject()));
        QVERIFY(desk.view->tile(boxes)->isEmpty() && desk.view->tile(parts)->isEmpty());
    }

    // --- page, look, words ----------------------------------------------------------------------

    void aChartIsEnlargedAndBack() {
        const Desk desk(fixtures::traverseProject());
        QVERIFY(desk.see(times));
        const int before = desk.plot(times).height();
        QTest::mouseClick(&desk.part<QToolButton>("overviewTimesEnlarge"), Qt::LeftButton);
        desk.bench.settle();
        QCOMPARE(desk.view->enlarged(), std::optional(times));
        QVERIFY(!desk.view->tile(stock)->isVisible());
        QVERIFY(desk.plot(times).height() > before);
        QTest::keyClick(&desk.plot(times), Qt::Key_Escape);
        desk.bench.settle();
        QVERIFY(!desk.view->enlarged() && desk.view->tile(stock)->isVisible());
    }

    void aLegendLeavesOutAStep() {
        const Desk desk(fixtures::traverseProject());
        QVERIFY(desk.see(times));
        auto& legend = desk.part<LegendStrip>("overviewTimesLegend");
        const std::size_t before = desk.plot(times).drawing().parts().size();
        QTest::mouseClick(&legend, Qt::LeftButton, {}, legend.entryRect(0).center());
        desk.bench.settle();
        QCOMPARE(desk.plot(times).drawing().parts().size(), before - 2); // of two stages
    }

    void languageThemeAndTypeFollowAtOnce() {
        const Desk desk(fixtures::traverseProject());
        QVERIFY(desk.see(times));
        desk.bench.action("russian")->trigger();
        desk.bench.settle();
        QCOMPARE(desk.view->tile(times)->title(), QStringLiteral("Время по ступеням и этапам"));
        QVERIFY(desk.plot(times).drawing().texts().contains(QStringLiteral("Ступень 1")));
        for (const OverviewChart chart : allOverviewCharts) {
            for (const QString& text : desk.plot(chart).drawing().texts()
                                           + QStringList(desk.plot(chart).chart().remark)
                                           + QStringList(desk.view->tile(chart)->emptyText())) {
                QCOMPARE(englishIn(text), QString());
            }
        }
        const QImage light = desk.plot(times).grab().toImage();
        desk.bench.action("theme-dark")->trigger();
        desk.bench.settle();
        QTest::qWait(20);
        const QImage dark = desk.plot(times).grab().toImage();
        QVERIFY(qGray(light.pixel(2, 2)) > 200 && qGray(dark.pixel(2, 2)) < 60);
        const int columns = desk.view->columns();
        desk.bench.action("fontSize-130")->trigger();
        desk.bench.settle();
        QTest::qWait(20);
        QVERIFY(desk.view->columns() <= columns);
        QVERIFY(desk.plot(times).minimumHeight() > 0);
        desk.bench.action("theme-light")->trigger();
    }

    // --- much and nothing -----------------------------------------------------------------------

    void aThousandSectionsAreCappedAndSaidSo() {
        const Desk desk;
        Project project = fixtures::plungeProject(200); // as many as the model takes
        project.part->radii_per_section = 4;
        QVERIFY(desk.open(project));
        QVERIFY(desk.plot(diameters).chart().categories.size() <= 8);
        QVERIFY(desk.plot(diameters).chart().remark.contains(QStringLiteral("200")));
        QVERIFY(desk.plot(stock).chart().remark.contains(QStringLiteral("200")));
        QVERIFY(desk.see(stock));
        QCOMPARE(desk.plot(times).chart().series.size(), std::size_t(1)); // no steps in plunge
    }

    /// Those that take longest; a bar leads to its own stage.
    void manyStagesAreCappedAndSaidSo() {
        const Desk desk;
        Project project = fixtures::traverseProject();
        const Stage first = project.cycle->stages.front();
        const std::size_t count = 2 * OverviewCharts::mostStages;
        project.cycle->stages.assign(count, first);
        for (std::size_t i = 0; i < count; ++i) { // the second half takes longer
            project.cycle->stages[i].stock_mm =
                project.part->stock_mm * (i < count / 2 ? 0.5 : 1.5) / double(count);
        }
        QVERIFY(desk.open(project));
        const std::vector<std::size_t> shown = OverviewCharts::stagesShown(desk.outcome());
        const BarChart& bars = desk.plot(OverviewChart::times).chart();
        QCOMPARE(shown.size(), OverviewCharts::mostStages);
        QCOMPARE(std::size_t(bars.categories.size()), shown.size());
        QVERIFY(std::ranges::is_sorted(shown));
        const double unit_s = bars.unit == QStringLiteral("s") ? 1 : 60;
        double least_s = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const double time_s = desk.outcome().result.timeByStage_s[shown[i]];
            QVERIFY(std::abs(bars.total(i) * unit_s - time_s) < 1e-9 * time_s);
            least_s = std::min(least_s, time_s);
        }
        for (std::size_t stage = 0; stage < count; ++stage) {
            QVERIFY(std::ranges::count(shown, stage) > 0
                    || desk.outcome().result.timeByStage_s[stage] <= least_s);
        }
        QVERIFY(bars.remark.startsWith(QStringLiteral("24 of 48 stages")));
    }

    void aThousandKeptRunsAreCappedAndSaidSo() {
        const Desk desk;
        Project project = fixtures::traverseProject();
        QVERIFY(desk.open(project));
        const KeptRun one = keptRun(
            desk.outcome().result,
            summarise(desk.outcome().result, desk.outcome().accuracy, desk.outcome().constraints),
            "Run", "2026-11-25T00:00:00Z");
        for (int i = 0; i < 1000; ++i) {
            project.runs.push_back(one);
            project.runs.back().name = "Run " + std::to_string(i + 1);
        }
        QVERIFY(desk.open(project));
        const BarChart& chart = desk.plot(runs).chart();
        QCOMPARE(chart.categories.size(), qsizetype(OverviewCharts::mostRuns + 1));
        QCOMPARE(chart.categories.last(), QStringLiteral("Run 1000"));
        QVERIFY(chart.remark.contains(QStringLiteral("1000")));
    }

    void refusedInputsLeaveTheChartsPale() {
        const Desk desk;
        Project project = fixtures::traverseProject();
        QVERIFY(desk.open(project));
        project.wheel->width_mm = 5000;
        desk.bench.window->document().edit(project, {"Edit", ""});
        QTRY_VERIFY(desk.plot(times).isDimmed());
        QVERIFY(!desk.plot(times).chart().empty());
    }

    void hiddenItDoesNothing() {
        const Desk desk(fixtures::traverseProject());
        desk.bench.window->showView(QStringLiteral("feeds"));
        desk.bench.settle();
        int changes = 0;
        connect(&desk.plot(times), &ViewPlot::contentChanged, this, [&changes] { ++changes; });
        Project project = fixtures::traverseProject();
        project.part->stock_mm = 0.2;
        desk.bench.window->document().edit(project, {"Edit", ""});
        QTRY_VERIFY(!desk.bench.window->runs().running());
        desk.bench.settle();
        QCOMPARE(changes, 0);
        desk.bench.window->showView(QStringLiteral("overview"));
        desk.bench.settle();
        QVERIFY(changes > 0);
    }

    void anUpdateTakesLessThanAFrame() {
        constexpr double target_ms = 16;
        Desk desk;
        std::vector<double> times_ms;
        for (const QString& path : examplePaths()) {
            QVERIFY(desk.bench.open(path));
            for (int i = 0; i < 3; ++i) {
                Project project = desk.bench.window->document().project();
                project.part->stock_mm *= 1.001;
                desk.bench.window->document().edit(project, {"Edit", ""});
                QTRY_VERIFY(!desk.bench.window->runs().running());
                desk.bench.settle();
                times_ms.push_back(desk.view->lastUpdate_ms());
            }
        }
        std::ranges::sort(times_ms);
        qInfo("SPEED update of the overview: median %.1f ms, worst %.1f ms, target %g ms",
              times_ms[times_ms.size() / 2], times_ms.back(), target_ms);
        QVERIFY(times_ms[times_ms.size() / 2] <= 4 * target_ms);
    }
};

} // namespace sparkout::test_overview_view

SPARKOUT_TEST(test_overview_view, TestOverviewView)
#include "test_overview_view.moc"
