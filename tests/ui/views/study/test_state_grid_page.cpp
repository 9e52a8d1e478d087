// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The grid of dynamic programming in the view "Optimise": chosen, sized, stepped, played and
// clicked with mouse and keys; what stands in its cells is what the engine fills.
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/optimisation.h"
#include "core/search/state_grid.h"
#include "core/study/outcome.h"
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/text/names.h"
#include "ui/views/study/optimise_view.h"
#include "ui/views/study/state_grid_plot.h"
#include "ui/views/study/state_grid_text.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cstdio>

namespace sparkout::test_state_grid_page {

constexpr int patience_ms = 60'000;

Project example(const char* name) {
    const auto read = loadProject(QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/")
                                  + QLatin1String(name));
    return read.setup.value().surfaces.front().project;
}

/// The rule is slower here, as test_dynamic_programming has it.
Project slowByTheRule() {
    Project project = example("plunge-shaft-two-stage.sparkout");
    project.optimisation = Optimisation{};
    project.optimisation->stages = {1, 2, 3, 4};
    project.optimisation->stock_step_mm = 0.01;
    project.optimisation->radial_feed_mm_min = std::vector<double>{0.2, 0.3, 0.5, 0.8, 1.2};
    project.gauge->commands = 5;
    return project;
}

Project traverse() {
    Project project = example("shaft-30h6-factory.sparkout");
    project.optimisation = Optimisation{};
    project.optimisation->stages = {1, 2, 3};
    project.optimisation->radial_feed_mm = SteppedLevels{0.001, 0.010, 0.001};
    project.optimisation->axial_feed_mm_min = SteppedLevels{500, 2000, 500};
    return project;
}

/// A view with a document, as in the window, with the page in front.
struct Bench {
    explicit Bench(const Project& project) {
        view.resize(900, 700);
        QObject::connect(&document, &Document::changed, &view,
                         [this] { view.setOutcome(evaluate(document.project(), {})); });
        document.startUntitled(project);
        view.show();
        QTest::qWait(20);
        auto* content = view.findChild<QComboBox*>(QStringLiteral("optimiseContent"));
        content->setFocus();
        QTest::keyClick(content, Qt::Key_End);
    }
    [[nodiscard]] bool settled() {
        QTest::qWait(20);
        return QTest::qWaitFor([this] { return !view.busy(); }, patience_ms);
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) {
        return *view.findChild<Widget*>(QString::fromLatin1(name));
    }
    void click(const char* button) {
        QTest::mouseClick(&part<QToolButton>(button), Qt::LeftButton);
    }
    [[nodiscard]] StateGridPlot& plot() { return *view.stateGrid(); }
    [[nodiscard]] const StateGrid& grid() { return plot().outcome()->grid; }
    [[nodiscard]] int moment() { return part<QSlider>("stateGridSlider").value(); }
    [[nodiscard]] QString notice() { return part<QLabel>("optimiseNotice").text(); }
    [[nodiscard]] QString readout() { return part<QLabel>("optimiseValues").text(); }
    Document document;
    OptimiseView view;
};

class TestStateGridPage : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void whatStandsInTheCellsIsWhatTheEngineFills() {
        const Project project = slowByTheRule();
        Bench bench(project);
        QVERIFY(bench.settled());
        QVERIFY(bench.plot().isVisible());
        QVERIFY(!bench.part<QPushButton>("optimiseRun").isVisible());
        const auto filled = fillStateGrid(project, usualStateGrid(project));
        const StateGrid& grid = bench.grid();
        QVERIFY(grid.size == usualStateGrid(project) && grid.size.levels == 10);
        QVERIFY(grid.path == filled->path && grid.time_s == filled->time_s);
        int shown = 0;
        for (int n = 1; n <= grid.size.levels; ++n) {
            for (std::size_t m = 0; m < grid.feeds.size(); ++m) {
                const GridState& state = filled->state(n, m);
                const QString text = bench.plot().cellText(n, m);
                QVERIFY(text.isEmpty() == !state.time_s.has_value());
                if (state.time_s) {
                    ++shown;
                    const QStringList halves =
                        text.split(QRegularExpression(QStringLiteral(" \\| |\n")));
                    QCOMPARE(halves.front(),
                             Names::significant(StateGridText::unit(*filled).of(*state.time_s), 3));
                    QCOMPARE(halves.size(), n == 1 ? 1 : 2);
                    QVERIFY(n == 1 || halves.back().toInt() == static_cast<int>(state.from) + 1);
                }
            }
        }
        QVERIFY(shown > 10);
    }

    void bothAnswersStandBesideEachOther() {
        Bench bench(slowByTheRule());
        QVERIFY(bench.settled());
        QVERIFY(bench.plot().outcome()->exact.has_value());
        const ExactAnswer& exact = *bench.plot().outcome()->exact;
        QVERIFY(exact.isProved() && exact.time_s);
        QVERIFY(bench.notice().contains(StateGridText::ruleAnswer(bench.grid())));
        QVERIFY(bench.notice().contains(StateGridText::time(*exact.time_s)));
        QVERIFY(!exact.faults.empty()); // the rule is slower or finds none
        QVERIFY(bench.notice().contains(
            StateGridText::state(exact.faults.front().level, exact.faults.front().feed)));
        const LegendEntries legend = bench.plot().legendEntries();
        QVERIFY(std::ranges::any_of(legend, [](const LegendEntry& entry) {
            return entry.key == static_cast<int>(GridPart::wrong);
        }));
        const StateDifference& first = exact.faults.front();
        fixtures::hover(&bench.plot(), bench.plot().stateRect(first.level, first.feed).center());
        QVERIFY(bench.readout().contains(StateGridText::wrong(first)));
    }

    void buttonsAndKeysStepThroughTheFilling() {
        Bench bench(slowByTheRule());
        QVERIFY(bench.settled());
        const int last = momentCount(bench.grid());
        const int feeds = static_cast<int>(bench.grid().feeds.size());
        QCOMPARE(bench.moment(), last);
        QVERIFY(!bench.part<QToolButton>("stateGridNext").isEnabled());
        bench.click("stateGridFirst");
        QCOMPARE(bench.moment(), 0);
        QVERIFY(bench.plot().cellText(1, 0).isEmpty());
        bench.click("stateGridNext");
        QCOMPARE(bench.moment(), 1);
        QCOMPARE(bench.plot().moment(), 1);
        QVERIFY(!bench.plot().cellText(1, 0).isEmpty());
        QVERIFY(bench.plot().cellText(1, 1).isEmpty());
        QVERIFY(bench.readout().contains(StateGridText::state(1, 0)));
        auto& slider = bench.part<QSlider>("stateGridSlider");
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Right);
        QCOMPARE(bench.moment(), 2);
        QTest::keyClick(&slider, Qt::Key_PageUp); // a level on
        QCOMPARE(bench.moment(), 2 + feeds);
        bench.click("stateGridPrevious");
        QCOMPARE(bench.moment(), 1 + feeds);
        QTest::keyClick(&slider, Qt::Key_End);
        QCOMPARE(bench.moment(), last);
        QCOMPARE(bench.part<QLabel>("stateGridPlace").text(), QStringLiteral("%1 of %1").arg(last));
        bench.click("stateGridFirst");
        bench.click("stateGridLast");
        QCOMPARE(bench.moment(), last);
    }

    void theWayBackFollowsThePredecessors() {
        const Project project = traverse();
        const StateGrid grid = *fillStateGrid(project, usualStateGrid(project));
        QVERIFY(!grid.path.empty());
        const int filling = momentsOfFilling(grid);
        QCOMPARE(momentCount(grid) - filling, grid.size.levels);
        std::size_t feed = grid.path.back();
        for (int back = 1; back <= grid.size.levels; ++back) {
            const GridMoment moment = momentAt(grid, filling + back);
            QCOMPARE(moment.level, grid.size.levels - back + 1);
            QCOMPARE(moment.feed, feed);
            QCOMPARE(moment.stepsBack, back);
            feed = grid.state(moment.level, moment.feed).from;
        }
    }

    void playingRunsToTheEndAndPauses() {
        Project project = slowByTheRule();
        Bench bench(project);
        QVERIFY(bench.settled());
        bench.click("stateGridPlay"); // from the end: anew
        QTRY_VERIFY_WITH_TIMEOUT(bench.moment() >= 2, patience_ms);
        bench.click("stateGridPlay");
        const int paused = bench.moment();
        QTest::qWait(1200);
        QCOMPARE(bench.moment(), paused);
        bench.part<QSlider>("stateGridSlider").setFocus();
        QTest::keyClick(&bench.part<QSlider>("stateGridSlider"), Qt::Key_End);
        QTest::keyClick(&bench.part<QSlider>("stateGridSlider"), Qt::Key_Left);
        bench.click("stateGridPlay");
        QTRY_COMPARE_WITH_TIMEOUT(bench.moment(), momentCount(bench.grid()), patience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(bench.part<QToolButton>("stateGridPlay").toolTip(),
                                  QStringLiteral("Play the filling of the grid"), patience_ms);
    }

    void aClickLooksAtAState() {
        Bench bench(traverse());
        QVERIFY(bench.settled());
        const QPointF at = bench.plot().stateRect(4, 2).center();
        QTest::mouseClick(&bench.plot(), Qt::LeftButton, {}, at.toPoint());
        QCOMPARE(bench.moment(), momentOf(bench.grid(), 4, 2));
        fixtures::hover(&bench.plot(), QPointF(1, 1));
        QVERIFY(bench.readout().contains(StateGridText::moves(bench.grid(), 4, 2)));
    }

    void levelsAndStagesFillTheGridAnew() {
        Bench bench(slowByTheRule());
        QVERIFY(bench.settled());
        auto& levels = bench.part<QSpinBox>("stateGridLevels");
        levels.setFocus();
        levels.selectAll();
        QTest::keyClicks(&levels, QStringLiteral("6"));
        QTest::keyClick(&levels, Qt::Key_Return);
        QVERIFY(bench.settled());
        QCOMPARE(bench.grid().size.levels, 6);
        auto& stages = bench.part<QSpinBox>("stateGridStages");
        stages.setFocus();
        QTest::keyClick(&stages, Qt::Key_Down);
        QVERIFY(bench.settled());
        QCOMPARE(bench.grid().size.stages, 3);
        QVERIFY(bench.grid().size == StateGridSize({6, 3}));
        QCOMPARE(bench.moment(), momentCount(bench.grid()));
        // An edit of the cycle alone leaves the grid, one of the stock fills it anew.
        const auto before = bench.plot().outcome();
        Project edited = bench.document.project();
        edited.cycle->stages.front().stock_mm += 0.001;
        bench.document.edit(edited, {"Edit", "Change"});
        QVERIFY(bench.settled());
        QVERIFY(bench.plot().outcome() == before);
        edited.optimisation->radial_feed_mm_min = std::vector<double>{0.2, 0.4};
        bench.document.edit(edited, {"Edit", "Change"});
        QVERIFY(bench.settled());
        QCOMPARE(bench.grid().feeds.size(), std::size_t{2});
    }

    void positionControlHasNoGridAndSaysSo() {
        Project project = traverse();
        project.gauge->control = Control::position;
        Bench bench(project);
        QVERIFY(bench.settled());
        QVERIFY(!bench.plot().outcome());
        QCOMPARE(bench.notice(), StateGridText::fault(StateGridFault::positionControl));
        QVERIFY(!bench.part<QToolButton>("stateGridPlay").isEnabled());
    }

    void theTableHasEveryState() {
        Bench bench(traverse());
        QVERIFY(bench.settled());
        const CsvTable table = bench.plot().table();
        QCOMPARE(table.rows.size(), 10 * bench.grid().feeds.size());
        QVERIFY(std::ranges::all_of(table.rows, [&](const auto& row) {
            return row.size() == static_cast<std::size_t>(table.header.size());
        }));
        const TimeUnit unit = StateGridText::unit(bench.grid());
        const qsizetype time = table.header.indexOf(unit.titled(QStringLiteral("T")));
        QVERIFY2(time > 0, qPrintable(table.header.join(u';')));
        const std::size_t feeds = bench.grid().feeds.size();
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            const CsvCell& cell = table.rows[row][static_cast<std::size_t>(time)];
            const GridState& state =
                bench.grid().state(static_cast<int>(row / feeds) + 1, row % feeds);
            QCOMPARE(cell.index() != 0, state.time_s.has_value());
            QVERIFY(!state.time_s || std::get<double>(cell) == unit.of(*state.time_s));
        }
    }

    void twentyByFortyIsSteppedWithoutAStall() {
        Bench bench(traverse());
        QVERIFY(bench.settled());
        auto& levels = bench.part<QSpinBox>("stateGridLevels");
        levels.setFocus();
        levels.selectAll();
        QTest::keyClicks(&levels, QStringLiteral("20"));
        QTest::keyClick(&levels, Qt::Key_Return);
        QVERIFY(bench.settled());
        QCOMPARE(bench.grid().size.levels, 20);
        QCOMPARE(bench.grid().feeds.size(), std::size_t{40});
        auto& slider = bench.part<QSlider>("stateGridSlider");
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Home);
        std::vector<double> steps_ms;
        for (int i = 0; i < 200; ++i) {
            QElapsedTimer timer;
            timer.start();
            QTest::keyClick(&slider, i % 2 ? Qt::Key_PageUp : Qt::Key_Right);
            bench.plot().replot(QCustomPlot::rpImmediateRefresh);
            QCoreApplication::processEvents();
            steps_ms.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
        }
        std::ranges::sort(steps_ms);
        const double median_ms = steps_ms[steps_ms.size() / 2];
        std::printf("20 levels by 40 feeds: a step is drawn in %.1f ms, the slowest in %.1f ms\n",
                    median_ms, steps_ms.back());
        QVERIFY(median_ms < 50);
    }
};

} // namespace sparkout::test_state_grid_page

SPARKOUT_TEST(test_state_grid_page, TestStateGridPage)
#include "test_state_grid_page.moc"
