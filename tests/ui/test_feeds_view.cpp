// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/view_fixtures.h"
#include "ui/views/band_layer.h"
#include "ui/views/feeds_note.h"
#include "ui/views/feeds_overview.h"
#include "ui/views/feeds_plot.h"
#include "ui/views/feeds_view.h"
#include "ui/views/hair_line.h"
#include "ui/views/legend_strip.h"
#include "ui/views/plot_tools.h"

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <clocale>
#include <cmath>
#include <limits>

using namespace sparkout;
using namespace fixtures;

namespace {

void show(FeedsView& view, const OutcomePtr& outcome) {
    view.resize(700, 620);
    view.show();
    QSignalSpy spy(&view, &FeedsView::updated);
    view.setOutcome(outcome);
    QTRY_COMPARE(spy.count(), 1);
}

QCPRange xRange(const FeedsView& view, int column, int row) {
    return view.plot()->cell(column, row)->axis(QCPAxis::atBottom)->range();
}

QStringList names(const FeedsView& view, int column) {
    QStringList texts;
    for (const BandLayer::DrawnName& name : view.plot()->bands(column, 0)->drawnNames()) {
        texts << name.text;
    }
    return texts;
}

/// The numbers drawn, over all graphs; false at one that is not finite or out of order.
bool drawable(FeedsPlot* plot) {
    for (int g = 0; g < plot->graphCount(); ++g) {
        double last = std::numeric_limits<double>::lowest();
        for (const QCPGraphData& d : *plot->graph(g)->data()) {
            if (!std::isfinite(d.key) || !std::isfinite(d.value) || d.key < last) {
                return false;
            }
            last = d.key;
        }
    }
    return true;
}

/// The place of an entry of the legend, by its text.
QPoint entryOf(const LegendStrip& legend, const QString& text) {
    for (std::size_t i = 0; i < legend.entries().size(); ++i) {
        if (legend.entries()[i].text == text) {
            return legend.entryRect(static_cast<int>(i)).center();
        }
    }
    return {};
}

double axisTop(const FeedsView& view, int row, QCPAxis::AxisType side) {
    return view.plot()->cell(0, row)->axis(side)->range().upper;
}

} // namespace

class TestFeedsView : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();

    void valuesThatAreNoNumbersAreLeftOut();
    void curvesAreDrawableAtEveryDetail_data();
    void curvesAreDrawableAtEveryDetail();
    void allColumnsKeepTheSameTimes();
    void aWheelTurnZoomsAllColumnsAndADoubleClickFits();
    void draggingMovesTheTimesWithinTheCycle();
    void stepsAreNamedWhenOneStrokeIsInSight();
    void stagesAreNamedOverTheWholeCycle();
    void namesOfBandsStandInOneLineOverTheirBands();
    void keysChooseStageAndStroke();
    void buttonsStepFromStrokeToStroke();
    void theRangeChosenOutlivesANewOutcome();
    void pointingAtACurveTellsItsValues();
    void plungeShowsForceAndAtMostFourSections();
    void aChangeOfOperationRebuildsTheGrid();
    void refusedInputsKeepTheCurvesDimmed();
    void withoutAResultTheViewSaysSo();
    void anotherLanguageReachesEveryText();
    void aNewOutcomeIsDrawnQuickly();
    void theOverviewShowsWhatIsInSight();
    void draggingTheOverviewsWindowMovesTheTimes();
    void anEdgeOfTheOverviewsWindowCanBeDragged();
    void aClickInTheOverviewBringsTheWindowThere();
    void theOverviewIsMovedByKeys();
    void backLeadsThroughWhatWasInSight();
    void aLegendClickHidesACurveAndItsScale();
    void controlClickShowsOnlyThisCurve();
    void theLegendWorksByKeyboard();
    void theHairLineStandsAtOneTimeInAllColumns();
    void forceAndAxialFeedShareTheThirdRow();
    void plotsOfARowAreEquallyWideAndUseTheirRoom();
    void theNoteTellsTheStepsOfEachZone();
    void theTableHoldsTheCurvesData();
    void aLongPlungeDoesNotStallTheWindow();

private:
    OutcomePtr m_traverse, m_plunge;
};

void TestFeedsView::initTestCase() {
    setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    m_traverse = run(traverseProject());
    m_plunge = run(plungeProject(20));
    QVERIFY(m_traverse->ran() && m_traverse->result.status == RunStatus::completed);
    QVERIFY(m_plunge->ran() && !m_plunge->trajectory.passes.empty());
}

void TestFeedsView::valuesThatAreNoNumbersAreLeftOut() {
    auto outcome = std::make_shared<Outcome>(*m_traverse);
    outcome->trajectory.visits[40].actual_mm = std::nan("");
    outcome->trajectory.visits[5000].radius_mm = std::numeric_limits<double>::infinity();
    outcome->feeds = makeFeedSeries(outcome->result, outcome->trajectory);
    FeedsView view;
    show(view, outcome);
    QCOMPARE(view.plot()->series().dropped, 2);
    QVERIFY(drawable(view.plot()));
    QVERIFY(view.findChild<QLabel*>(QStringLiteral("notice"))->text().contains(u'2'));
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(2);
    QVERIFY(drawable(view.plot()));
}

void TestFeedsView::curvesAreDrawableAtEveryDetail_data() {
    QTest::addColumn<bool>("plunge");
    QTest::addColumn<double>("share");
    for (bool plunge : {false, true}) {
        for (double share : {1.0, 0.1, 0.03, 0.005, 1e-5}) {
            QTest::addRow("%s, %g of the cycle", plunge ? "plunge" : "traverse", share)
                << plunge << share;
        }
    }
}

void TestFeedsView::curvesAreDrawableAtEveryDetail() {
    QFETCH(bool, plunge);
    QFETCH(double, share);
    FeedsView view;
    show(view, plunge ? m_plunge : m_traverse);
    const double end = view.plot()->series().end_s;
    view.plot()->showTimes(0.3 * end, 0.3 * end + share * 0.7 * end);
    view.plot()->replot();
    QVERIFY(drawable(view.plot()));
    QVERIFY(view.plot()->curve(0, Quantity::actual, Edge::mean)->dataCount() > 0);
    for (QCPAxisRect* rect : view.plot()->axisRects()) {
        for (QCPAxis* axis : rect->axes()) {
            QVERIFY(std::isfinite(axis->range().size()) && axis->range().size() > 0);
            QVERIFY(axis->tickVector().size() < 1000);
        }
    }
}

void TestFeedsView::allColumnsKeepTheSameTimes() {
    FeedsView view;
    show(view, m_traverse);
    view.plot()->cell(2, 1)->axis(QCPAxis::atBottom)->setRange(3, 5);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < FeedsPlot::rowCount; ++row) {
            QVERIFY(std::abs(xRange(view, column, row).lower - 3) < 1e-9);
            QVERIFY(std::abs(xRange(view, column, row).upper - 5) < 1e-9);
        }
    }
}

void TestFeedsView::aWheelTurnZoomsAllColumnsAndADoubleClickFits() {
    FeedsView view;
    show(view, m_traverse);
    const QCPRange whole = xRange(view, 0, 0);
    wheel(view.plot(), view.plot()->cell(0, 0)->rect().center(), 240);
    QVERIFY(xRange(view, 2, 2).size() < whole.size() * 0.9);
    QCOMPARE(xRange(view, 2, 2).size(), xRange(view, 0, 0).size());
    auto* span = view.findChild<QComboBox*>(QStringLiteral("span"));
    QCOMPARE(span->currentIndex(), -1);

    // Over the values' axis the wheel leaves the times alone.
    const QCPRange times = xRange(view, 0, 0);
    QCPAxis* values = view.plot()->cell(0, 0)->axis(QCPAxis::atLeft);
    const double before = values->range().size();
    const QRect rect = view.plot()->cell(0, 0)->rect();
    wheel(view.plot(), QPointF(rect.left() - 10, rect.center().y()), 120);
    QVERIFY(values->range().size() < before);
    QCOMPARE(xRange(view, 0, 0).size(), times.size());
    QCOMPARE(view.plot()->cell(2, 0)->axis(QCPAxis::atLeft)->range().size(),
             values->range().size());

    QTest::mouseDClick(view.plot(), Qt::LeftButton, {}, rect.center());
    QVERIFY(std::abs(xRange(view, 1, 0).size() - whole.size()) < 1e-9);
    QVERIFY(std::abs(values->range().size() - before) < before * 0.5);
    QCOMPARE(span->currentIndex(), 0);
}

void TestFeedsView::draggingMovesTheTimesWithinTheCycle() {
    FeedsView view;
    show(view, m_traverse);
    view.plot()->showTimes(60, 180);
    view.plot()->replot();
    const QPoint from = view.plot()->cell(1, 1)->rect().center();
    QTest::mousePress(view.plot(), Qt::LeftButton, {}, from);
    QTest::mouseMove(view.plot(), from + QPoint(-20, 0));
    QTest::mouseMove(view.plot(), from + QPoint(-40, 0));
    QTest::mouseRelease(view.plot(), Qt::LeftButton, {}, from + QPoint(-40, 0));
    QVERIFY(view.plot()->visibleFrom_s() > 61);
    QVERIFY(std::abs(view.plot()->visibleTo_s() - view.plot()->visibleFrom_s() - 120) < 1e-6);
    view.plot()->cell(0, 0)->axis(QCPAxis::atBottom)->moveRange(-100);
    QCOMPARE(view.plot()->visibleFrom_s(), 0.0);
}

void TestFeedsView::stepsAreNamedWhenOneStrokeIsInSight() {
    FeedsView view;
    show(view, m_traverse);
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(27);
    view.grab();
    QCOMPARE(names(view, 0),
             QStringList({QStringLiteral("E1"), QStringLiteral("E2"), QStringLiteral("E3"),
                          QStringLiteral("E4"), QStringLiteral("E5")}));
    QCOMPARE(names(view, 1), QStringList({QStringLiteral("E1"), QStringLiteral("E2")}));
    QCOMPARE(names(view, 2),
             QStringList({QStringLiteral("E1"), QStringLiteral("E2"), QStringLiteral("E3")}));
    const auto meanings = [&](int column) {
        QStringList list;
        for (const Band& band : view.plot()->bands(column, 0)->bands()) {
            if (!list.contains(band.meaning)) {
                list << band.meaning;
            }
        }
        return list;
    };
    QVERIFY(meanings(0).contains(QStringLiteral("E1: plunge-in")));
    QVERIFY(meanings(1).contains(QStringLiteral("E2: return stroke")));
    QVERIFY(meanings(2).contains(QStringLiteral("E2: exit dwell")));
    const auto legend = view.plot()->legendEntries();
    QVERIFY(std::ranges::any_of(
        legend, [](const LegendEntry& e) { return e.text == QStringLiteral("exit dwell"); }));
}

void TestFeedsView::stagesAreNamedOverTheWholeCycle() {
    FeedsView view;
    show(view, m_traverse);
    view.grab();
    for (int column = 0; column < 3; ++column) {
        QCOMPARE(names(view, column),
                 QStringList({QStringLiteral("stage 1"), QStringLiteral("stage 2")}));
    }
}

void TestFeedsView::namesOfBandsStandInOneLineOverTheirBands() {
    Project project = traverseProject();
    project.cycle.stages.insert(project.cycle.stages.begin(), project.cycle.stages[0]);
    project.cycle.stages[0].stock_mm = 0.02;
    project.cycle.stages[1].stock_mm = 0.09;
    FeedsView view;
    show(view, run(project));
    for (int width : {380, 520, 700, 1100}) {
        view.resize(width, 620);
        view.grab();
        for (int column = 0; column < 3; ++column) {
            const auto& drawn = view.plot()->bands(column, 0)->drawnNames();
            QVERIFY(!drawn.empty());
            const QRect plot = view.plot()->cell(column, 0)->rect();
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                QCOMPARE(drawn[i].box.top(), drawn[0].box.top());
                QVERIFY(drawn[i].box.bottom() <= plot.top());
                QVERIFY(drawn[i].box.left() >= plot.left()
                        && drawn[i].box.right() <= plot.right() + 1);
                QVERIFY(i == 0 || drawn[i].box.left() > drawn[i - 1].box.right());
            }
        }
    }
    // In the narrowest the names are cut short, all alike.
    view.resize(520, 620);
    view.grab();
    QVERIFY(names(view, 0).contains(QStringLiteral("st. 3")));
    QVERIFY(!names(view, 0).contains(QStringLiteral("stage 3")));
}

void TestFeedsView::keysChooseStageAndStroke() {
    FeedsView view;
    show(view, m_traverse);
    const FeedSeries& series = view.plot()->series();
    auto* span = view.findChild<QComboBox*>(QStringLiteral("span"));
    span->setFocus();
    QTest::keyClick(span, Qt::Key_Down);
    QCOMPARE(view.plot()->visibleFrom_s(), series.stages[0].start_s);
    QCOMPARE(view.plot()->visibleTo_s(), series.stages[0].end_s);
    QTest::keyClick(span, Qt::Key_Down);
    QCOMPARE(view.plot()->visibleFrom_s(), series.stages[1].start_s);
    QTest::keyClick(span, Qt::Key_Down);
    QCOMPARE(view.plot()->visibleTo_s(), series.strokeEnd_s(1));
    QTest::keyClick(span, Qt::Key_Home);
    QCOMPARE(view.plot()->visibleTo_s(), series.end_s);

    auto* stroke = view.findChild<QSpinBox*>(QStringLiteral("stroke"));
    stroke->setFocus();
    stroke->selectAll();
    QTest::keyClicks(stroke, QStringLiteral("27"));
    QTest::keyClick(stroke, Qt::Key_Return);
    QCOMPARE(view.plot()->visibleFrom_s(), series.strokeStart_s[26]);
    QCOMPARE(view.plot()->visibleTo_s(), series.strokeEnd_s(27));
    QCOMPARE(view.plot()->detail(), FeedsPlot::Detail::radius);
}

void TestFeedsView::buttonsStepFromStrokeToStroke() {
    FeedsView view;
    show(view, m_traverse);
    auto* next = view.findChild<QToolButton*>(QStringLiteral("next"));
    auto* previous = view.findChild<QToolButton*>(QStringLiteral("previous"));
    QVERIFY(!previous->isEnabled());
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(view.plot()->visibleFrom_s(), view.plot()->series().strokeStart_s[1]);
    next->setFocus();
    QTest::keyClick(next, Qt::Key_Space);
    QCOMPARE(view.plot()->visibleFrom_s(), view.plot()->series().strokeStart_s[2]);
    QTest::mouseClick(previous, Qt::LeftButton);
    QCOMPARE(view.plot()->visibleFrom_s(), view.plot()->series().strokeStart_s[1]);
    view.tools()->fit->trigger();
    QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().end_s);
}

void TestFeedsView::theRangeChosenOutlivesANewOutcome() {
    FeedsView view;
    show(view, m_traverse);
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(20);
    Project project = traverseProject();
    project.machine.dwell_entry_s = 1;
    show(view, run(project));
    QCOMPARE(view.plot()->visibleFrom_s(), view.plot()->series().strokeStart_s[19]);
    QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().strokeEnd_s(20));
}

void TestFeedsView::pointingAtACurveTellsItsValues() {
    FeedsView view;
    show(view, m_traverse);
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(27);
    const QRect rect = view.plot()->cell(1, 0)->rect();
    auto* values = view.findChild<QLabel*>(QStringLiteral("values"));
    hover(view.plot(), rect.topLeft() + QPoint(rect.width() / 3, 20));
    QVERIFY2(values->text().contains(QStringLiteral("NZ, E1, stage 1, double stroke 27")),
             qPrintable(values->text()));
    QVERIFY(values->text().contains(QStringLiteral("programmed 4.00")));
    QVERIFY(view.plot()->toolTip().contains(QStringLiteral("working stroke")));
}

void TestFeedsView::plungeShowsForceAndAtMostFourSections() {
    FeedsView view;
    show(view, m_plunge);
    QVERIFY(view.plot()->curve(0, Quantity::force, Edge::mean));
    QVERIFY(!view.plot()->curve(0, Quantity::axialFeed, Edge::mean));
    QCOMPARE(view.plot()->columnCount(), 4);
    int gauges = 0;
    for (int i = 0; i < 4; ++i) {
        gauges += view.plot()->source(i).gauge ? 1 : 0;
    }
    QCOMPARE(gauges, 1);
    auto* section = view.findChild<QComboBox*>(QStringLiteral("section"));
    QVERIFY(section->isVisible());
    section->setFocus();
    QTest::keyClick(section, Qt::Key_End);
    QTest::keyClick(section, Qt::Key_Up);
    QStringList shown;
    for (int i = 0; i < 4; ++i) {
        shown << QString::number(view.plot()->source(i).section);
    }
    QVERIFY2(shown.contains(QStringLiteral("18")), qPrintable(shown.join(u' ')));
}

void TestFeedsView::aChangeOfOperationRebuildsTheGrid() {
    FeedsView view;
    show(view, m_traverse);
    show(view, m_plunge);
    QCOMPARE(view.plot()->axisRectCount(), 12);
    show(view, m_traverse);
    QCOMPARE(view.plot()->axisRectCount(), 9);
    QVERIFY(view.plot()->curve(0, Quantity::axialFeed, Edge::mean));
    QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().end_s);
}

void TestFeedsView::refusedInputsKeepTheCurvesDimmed() {
    FeedsView view;
    show(view, m_traverse);
    QCPGraph* graph = view.plot()->curve(0, Quantity::actual, Edge::mean);
    const int points = graph->dataCount();
    const int alpha = graph->pen().color().alpha();
    show(view, refused());
    QCOMPARE(graph->dataCount(), points);
    QVERIFY(graph->pen().color().alpha() < alpha / 2);
    auto* notice = view.findChild<QLabel*>(QStringLiteral("notice"));
    QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("5000")));
    show(view, m_traverse);
    QCOMPARE(graph->pen().color().alpha(), alpha);
    QVERIFY(!notice->isVisible());
}

void TestFeedsView::withoutAResultTheViewSaysSo() {
    FeedsView view;
    view.show();
    auto* notice = view.findChild<QLabel*>(QStringLiteral("notice"));
    QCOMPARE(notice->text(), QStringLiteral("No result yet."));
    show(view, refused());
    QVERIFY(notice->text().startsWith(QStringLiteral("The inputs are refused:")));
    QVERIFY(!view.plot()->isVisible());
    show(view, OutcomePtr());
    QCOMPARE(notice->text(), QStringLiteral("No result yet."));
}

void TestFeedsView::anotherLanguageReachesEveryText() {
    FeedsView view;
    show(view, m_traverse);
    Marking marking;
    QApplication::installTranslator(&marking);
    QCoreApplication::processEvents();
    const auto marked = [](const QString& text) { return text.startsWith(QChar(0x00AB)); };
    auto* span = view.findChild<QComboBox*>(QStringLiteral("span"));
    QVERIFY(marked(span->itemText(0)) && marked(span->itemText(1)));
    QCOMPARE(span->currentIndex(), 0);
    QVERIFY(marked(view.plot()->timeLabel()));
    QVERIFY(marked(view.plot()->cell(2, 2)->axis(QCPAxis::atRight)->label()));
    for (const QString& name : view.plot()->table().header) {
        QVERIFY2(marked(name), qPrintable(name));
    }
    QVERIFY(marked(view.plot()->cell(0, 0)->axis(QCPAxis::atLeft)->label()));
    for (const LegendEntry& entry : view.plot()->legendEntries()) {
        QVERIFY(marked(entry.text));
    }
    QVERIFY(marked(view.plot()->bands(0, 0)->bands().front().name));
    for (QWidget* widget : view.findChildren<QWidget*>()) {
        if (!widget->accessibleName().isEmpty()) {
            QVERIFY(marked(widget->accessibleName()));
        }
    }
    QApplication::removeTranslator(&marking);
    QCoreApplication::processEvents();
    QCOMPARE(span->itemText(0), QStringLiteral("Whole cycle"));
}

void TestFeedsView::aNewOutcomeIsDrawnQuickly() {
    FeedsView view;
    show(view, m_traverse);
    double best = 1e9;
    for (int i = 0; i < 10; ++i) {
        show(view, m_traverse);
        best = std::min(best, view.lastUpdate_ms());
    }
    qInfo("filling and replot: %.1f ms for %lld visits", best, m_traverse->result.visits);
    QVERIFY(best < 100); // four times the bound of a release build
}

// --- overview -----------------------------------------------------------------------------------

void TestFeedsView::theOverviewShowsWhatIsInSight() {
    FeedsView view;
    show(view, m_traverse);
    const FeedsOverview* overview = view.overview();
    const double width = overview->width();
    QCOMPARE(overview->window().left(), 0.0);
    QCOMPARE(overview->window().right(), width);
    const double end_s = view.plot()->series().end_s;
    view.plot()->showTimes(0.25 * end_s, 0.5 * end_s);
    QVERIFY(std::abs(overview->window().left() - 0.25 * width) < 1e-6);
    QVERIFY(std::abs(overview->window().right() - 0.5 * width) < 1e-6);
    // In double strokes the strip has the same axis as the plots.
    auto* axis = view.findChild<QComboBox*>(QStringLiteral("axis"));
    axis->setCurrentIndex(axis->findData(static_cast<int>(CycleAxis::strokes)));
    const double strokes = view.plot()->scale().at(0.25 * end_s);
    QVERIFY(
        std::abs(overview->window().left() - strokes / view.plot()->series().strokeCount() * width)
        < 1e-6);
}

void TestFeedsView::draggingTheOverviewsWindowMovesTheTimes() {
    FeedsView view;
    show(view, m_traverse);
    const double end_s = view.plot()->series().end_s;
    view.plot()->showTimes(0.2 * end_s, 0.4 * end_s);
    FeedsOverview* overview = view.overview();
    const QPoint middle = overview->window().center().toPoint();
    drag(overview, middle, middle + QPoint(100, 0));
    const double moved_s = 100.0 / overview->width() * end_s;
    QVERIFY(std::abs(view.plot()->visibleFrom_s() - 0.2 * end_s - moved_s) < 1e-6 * end_s);
    QVERIFY(std::abs(view.plot()->visibleTo_s() - 0.4 * end_s - moved_s) < 1e-6 * end_s);
    // Past the end it stops, with its width.
    const QPoint now = overview->window().center().toPoint();
    drag(overview, now, now + QPoint(overview->width(), 0));
    QVERIFY(std::abs(view.plot()->visibleTo_s() - end_s) < 1e-9 * end_s);
    QVERIFY(std::abs(view.plot()->visibleFrom_s() - 0.8 * end_s) < 1e-6 * end_s);
}

void TestFeedsView::anEdgeOfTheOverviewsWindowCanBeDragged() {
    FeedsView view;
    show(view, m_traverse);
    const double end_s = view.plot()->series().end_s;
    FeedsOverview* overview = view.overview();
    const int y = overview->height() / 2;
    const int width = overview->width();
    drag(overview, {width - 1, y}, {width / 2, y});
    QCOMPARE(view.plot()->visibleFrom_s(), 0.0);
    QVERIFY(std::abs(view.plot()->visibleTo_s() - 0.5 * end_s) < 0.005 * end_s);
    drag(overview, {0, y}, {width / 4, y});
    QVERIFY(std::abs(view.plot()->visibleFrom_s() - 0.25 * end_s) < 0.005 * end_s);
    QVERIFY(std::abs(view.plot()->visibleTo_s() - 0.5 * end_s) < 0.005 * end_s);
    // An edge dragged past the other leaves a window, however small.
    drag(overview, overview->window().topLeft().toPoint() + QPoint(0, y), {width, y});
    QVERIFY(view.plot()->visibleTo_s() > view.plot()->visibleFrom_s());
}

void TestFeedsView::aClickInTheOverviewBringsTheWindowThere() {
    FeedsView view;
    show(view, m_traverse);
    const double end_s = view.plot()->series().end_s;
    view.plot()->showTimes(0, 0.1 * end_s);
    FeedsOverview* overview = view.overview();
    QTest::mouseClick(overview, Qt::LeftButton, {}, {overview->width() / 2, 5});
    const double middle_s = (view.plot()->visibleFrom_s() + view.plot()->visibleTo_s()) / 2;
    QVERIFY(std::abs(middle_s - 0.5 * end_s) < 0.005 * end_s);
    wheel(overview, {overview->width() / 2.0, 5}, 120);
    QVERIFY(view.plot()->visibleTo_s() - view.plot()->visibleFrom_s() < 0.099 * end_s);
    QTest::mouseDClick(overview, Qt::LeftButton, {}, {overview->width() / 2, 5});
    QCOMPARE(view.plot()->visibleFrom_s(), 0.0);
    QCOMPARE(view.plot()->visibleTo_s(), end_s);
}

void TestFeedsView::theOverviewIsMovedByKeys() {
    FeedsView view;
    show(view, m_traverse);
    const double end_s = view.plot()->series().end_s;
    view.plot()->showTimes(0.2 * end_s, 0.4 * end_s);
    FeedsOverview* overview = view.overview();
    const auto stands = [&](double from, double to) {
        return std::abs(view.plot()->visibleFrom_s() - from * end_s) < 1e-9 * end_s
               && std::abs(view.plot()->visibleTo_s() - to * end_s) < 1e-9 * end_s;
    };
    QTest::keyClick(overview, Qt::Key_Right);
    QVERIFY(stands(0.22, 0.42));
    QTest::keyClick(overview, Qt::Key_Left);
    QVERIFY(stands(0.2, 0.4));
    QTest::keyClick(overview, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(stands(0.2, 0.42));
    QTest::keyClick(overview, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(stands(0.178, 0.42));
    QTest::keyClick(overview, Qt::Key_Home);
    QVERIFY(stands(0, 1));
}

// --- tools --------------------------------------------------------------------------------------

void TestFeedsView::backLeadsThroughWhatWasInSight() {
    FeedsView view;
    show(view, m_traverse);
    FeedsPlot* plot = view.plot();
    const double end_s = plot->series().end_s;
    auto* span = view.findChild<QComboBox*>(QStringLiteral("span"));
    QVERIFY(!view.tools()->back->isEnabled());
    span->setCurrentIndex(1); // stage 1
    const double stage_s = plot->series().stages[0].end_s;
    QCOMPARE(plot->visibleTo_s(), stage_s);
    for (int i = 0; i < 4; ++i) { // one gesture
        wheel(plot, plot->cell(1, 1)->rect().center(), 120);
    }
    QCOMPARE(span->currentIndex(), -1);
    QVERIFY(plot->visibleTo_s() < stage_s);
    view.tools()->back->trigger();
    QCOMPARE(plot->visibleFrom_s(), 0.0);
    QCOMPARE(plot->visibleTo_s(), stage_s);
    QCOMPARE(span->currentIndex(), 1); // the list says so again
    view.tools()->back->trigger();
    QCOMPARE(plot->visibleTo_s(), end_s);
    QCOMPARE(span->currentIndex(), 0);
    QVERIFY(!view.tools()->back->isEnabled());
    view.tools()->forward->trigger();
    QCOMPARE(plot->visibleTo_s(), stage_s);
    // A new result is no entry; it only changes where the present one ends.
    show(view, m_traverse);
    view.tools()->back->trigger();
    QCOMPARE(plot->visibleTo_s(), end_s);
    // Another grid has another history.
    show(view, m_plunge);
    QVERIFY(!view.tools()->back->isEnabled() && !view.tools()->forward->isEnabled());
}

void TestFeedsView::aLegendClickHidesACurveAndItsScale() {
    FeedsView view;
    show(view, m_traverse);
    LegendStrip* legend = view.legend();
    const QString name = QStringLiteral("normal force");
    const QPoint at = entryOf(*legend, name);
    QVERIFY(!at.isNull());
    const double before = axisTop(view, 2, QCPAxis::atRight);
    QTest::mouseClick(legend, Qt::LeftButton, {}, at);
    for (int column = 0; column < 3; ++column) {
        for (Edge edge : {Edge::low, Edge::mean, Edge::high}) {
            QVERIFY(!view.plot()->curve(column, Quantity::force, edge)->visible());
        }
    }
    QVERIFY(axisTop(view, 2, QCPAxis::atRight) < before); // nothing to scale to
    QVERIFY(!view.plot()->table().header.contains(QStringLiteral("normal force, N")));
    QVERIFY(legend->accessibleDescription().contains(QStringLiteral("normal force (hidden)")));
    // The sum goes with its feed.
    QTest::mouseClick(legend, Qt::LeftButton, {}, entryOf(*legend, QStringLiteral("actual feed")));
    QVERIFY(!view.plot()->curve(1, Quantity::actual, Edge::mean)->visible());
    QVERIFY(!view.plot()->curve(1, Quantity::actualSum, Edge::mean)->visible());
    // What is hidden stays hidden with a new result.
    show(view, m_traverse);
    QVERIFY(!view.plot()->curve(0, Quantity::force, Edge::mean)->visible());
    QTest::mouseClick(legend, Qt::LeftButton, {}, entryOf(*legend, name));
    QVERIFY(view.plot()->curve(0, Quantity::force, Edge::mean)->visible());
    QCOMPARE(axisTop(view, 2, QCPAxis::atRight), before);
}

void TestFeedsView::controlClickShowsOnlyThisCurve() {
    FeedsView view;
    show(view, m_traverse);
    LegendStrip* legend = view.legend();
    const auto visible = [&] {
        int count = 0;
        for (const LegendEntry& e : legend->entries()) {
            count += e.key >= 0 && e.shown ? 1 : 0;
        }
        return count;
    };
    const int all = visible();
    QVERIFY(all >= 6);
    const QString name = QStringLiteral("radius after the pass");
    QTest::mouseClick(legend, Qt::LeftButton, Qt::ControlModifier, entryOf(*legend, name));
    QCOMPARE(visible(), 1);
    QVERIFY(view.plot()->curve(0, Quantity::left, Edge::mean)->visible());
    QVERIFY(!view.plot()->curve(0, Quantity::actual, Edge::mean)->visible());
    QTest::mouseClick(legend, Qt::LeftButton, Qt::ControlModifier, entryOf(*legend, name));
    QCOMPARE(visible(), all);
}

void TestFeedsView::theLegendWorksByKeyboard() {
    FeedsView view;
    show(view, m_traverse);
    QApplication::setActiveWindow(&view);
    LegendStrip* legend = view.legend();
    legend->setFocus();
    QTest::keyClick(legend, Qt::Key_Right);
    QVERIFY(legend->accessibleDescription().startsWith(QStringLiteral("chosen: actual feed")));
    QTest::keyClick(legend, Qt::Key_Space);
    QVERIFY(!view.plot()->curve(0, Quantity::actual, Edge::mean)->visible());
    QTest::keyClick(legend, Qt::Key_Space);
    QVERIFY(view.plot()->curve(0, Quantity::actual, Edge::mean)->visible());
    QTest::keyClick(legend, Qt::Key_Left);
    QTest::keyClick(legend, Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(view.plot()->curve(0, Quantity::programmed, Edge::mean)->visible());
    QVERIFY(!view.plot()->curve(0, Quantity::actual, Edge::mean)->visible());
}

void TestFeedsView::theHairLineStandsAtOneTimeInAllColumns() {
    FeedsView view;
    show(view, m_traverse);
    const auto hairLine = [&]() -> const HairLine* {
        for (QCPLayerable* item : view.plot()->layer(HairLine::layerName())->children()) {
            return qobject_cast<HairLine*>(item);
        }
        return nullptr;
    };
    QVERIFY(hairLine() && !hairLine()->at());
    const QRect rect = view.plot()->cell(0, 0)->rect();
    hover(view.plot(), rect.center());
    QVERIFY(hairLine()->at());
    const double x = *hairLine()->at();
    QVERIFY(std::abs(x - xRange(view, 0, 0).center()) < xRange(view, 0, 0).size() * 0.01);
    // The line is drawn there in the other columns too: a column of pixels that was not dark.
    const QImage with = view.plot()->grab().toImage();
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(view.plot(), &leave);
    QVERIFY(!hairLine()->at());
    const QImage without = view.plot()->grab().toImage();
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < FeedsPlot::rowCount; ++row) {
            const QCPAxisRect* cell = view.plot()->cell(column, row);
            const int pixel = qRound(cell->axis(QCPAxis::atBottom)->coordToPixel(x));
            int changed = 0;
            for (int y = cell->top() + 1; y < cell->bottom(); ++y) {
                for (int near = pixel - 1; near <= pixel + 1; ++near) {
                    changed += with.pixel(near, y) != without.pixel(near, y) ? 1 : 0;
                }
            }
            QVERIFY2(changed > cell->height() / 2, qPrintable(QString::number(changed)));
        }
    }
}

void TestFeedsView::forceAndAxialFeedShareTheThirdRow() {
    FeedsView view;
    show(view, m_traverse);
    const QCPGraph* force = view.plot()->curve(1, Quantity::force, Edge::mean);
    const QCPGraph* axial = view.plot()->curve(1, Quantity::axialFeed, Edge::mean);
    QCOMPARE(force->valueAxis(), view.plot()->cell(1, 2)->axis(QCPAxis::atRight));
    QCOMPARE(axial->valueAxis(), view.plot()->cell(1, 2)->axis(QCPAxis::atLeft));
    // The axis holds the largest force of the run.
    QVERIFY(force->valueAxis()->range().upper >= m_traverse->result.peakNormalForce_n);
    QVERIFY(force->valueAxis()->range().upper <= 1.2 * m_traverse->result.peakNormalForce_n);
    hover(view.plot(), view.plot()->cell(1, 2)->rect().center());
    const QString text = view.findChild<QLabel*>(QStringLiteral("values"))->text();
    QVERIFY(text.contains(QStringLiteral("force")) && text.contains(QStringLiteral("axial feed")));
}

void TestFeedsView::plotsOfARowAreEquallyWideAndUseTheirRoom() {
    FeedsView view;
    for (const OutcomePtr& outcome : {m_traverse, m_plunge}) {
        show(view, outcome);
        for (const QSize size : {QSize(668, 545), QSize(1210, 860)}) {
            view.resize(size);
            view.grab();
            const FeedsPlot* plot = view.plot();
            int sum = 0;
            for (int column = 0; column < plot->columnCount(); ++column) {
                const int width = plot->cell(column, 0)->width();
                sum += width;
                QVERIFY(std::abs(width - plot->cell(0, 0)->width()) <= 2);
            }
            QVERIFY2(sum > 0.7 * plot->width(), qPrintable(QString::number(sum)));
            int high = 0;
            for (int row = 0; row < FeedsPlot::rowCount; ++row) {
                high += plot->cell(0, row)->height();
                QVERIFY(std::abs(plot->cell(0, row)->height() - plot->cell(0, 0)->height()) <= 3);
            }
            QVERIFY2(high > 0.7 * plot->height(), qPrintable(QString::number(high)));
        }
    }
}

void TestFeedsView::theNoteTellsTheStepsOfEachZone() {
    FeedsView view;
    show(view, m_traverse);
    QTest::mouseClick(view.findChild<QToolButton*>(QStringLiteral("note")), Qt::LeftButton);
    auto* note = view.findChild<FeedsNote*>();
    QVERIFY(note && note->isVisible());
    QString all;
    for (const QLabel* label : note->findChildren<QLabel*>()) {
        all += label->text() + u'|';
    }
    for (const char* text : {"plunge-in", "entry dwell", "working stroke", "exit dwell",
                             "return stroke", "E5", "during the whole stroke"}) {
        QVERIFY2(all.contains(QLatin1String(text)), text);
    }
    QTest::keyClick(note, Qt::Key_Escape);
    QVERIFY(!note->isVisible());
}

void TestFeedsView::theTableHoldsTheCurvesData() {
    FeedsView view;
    show(view, m_traverse);
    for (const double share : {1.0, 0.1, 0.01}) { // strokes, passes, radii
        const double end_s = view.plot()->series().end_s;
        view.plot()->showTimes(0.3 * end_s, 0.3 * end_s + share * 0.7 * end_s);
        const CsvTable table = view.plot()->table();
        QVERIFY(!table.empty());
        const auto actual = table.header.indexOf(QStringLiteral("actual feed, µm"));
        const auto to = table.header.indexOf(QStringLiteral("Time, min: to"));
        QVERIFY(actual > 0 && to > 0);
        // Every number of the table is a point of the curve of its zone.
        std::size_t row = 0;
        for (int column = 0; column < 3; ++column) {
            const QCPGraph* graph = view.plot()->curve(column, Quantity::actual, Edge::mean);
            const QString zone = std::get<QString>(table.rows[row][0]);
            for (; row < table.rows.size() && std::get<QString>(table.rows[row][0]) == zone;
                 ++row) {
                const double x = std::get<double>(table.rows[row][std::size_t(to)]);
                const double y = std::get<double>(table.rows[row][std::size_t(actual)]);
                const bool found = std::ranges::any_of(*graph->data(), [&](const QCPGraphData& d) {
                    return std::abs(d.key - x) < 1e-9 && d.value == y;
                });
                QVERIFY(found);
            }
        }
        QCOMPARE(row, table.rows.size());
    }
}

/// 2 million visits: all that is recorded. The series comes with the outcome; the window has only
/// to draw it.
void TestFeedsView::aLongPlungeDoesNotStallTheWindow() {
    constexpr double target_ms = 50;
    Project project = plungeProject(4);
    project.part.radii_per_section = 360;
    project.cycle.stages[0].radial_feed_mm_min = 0.1;
    project.cycle.stages[1].radial_feed_mm_min = 0.012;
    const OutcomePtr outcome = run(project);
    QVERIFY2(outcome->result.visits > 1'000'000 && !outcome->trajectory.passes.empty(),
             qPrintable(QString::number(outcome->result.visits)));
    FeedsView view;
    show(view, m_plunge);
    double worst = 0;
    for (int i = 0; i < 5; ++i) {
        show(view, i % 2 == 0 ? outcome : m_plunge);
        worst = std::max(worst, view.lastUpdate_ms());
    }
    QElapsedTimer clock;
    clock.start();
    auto* stroke = view.findChild<QSpinBox*>(QStringLiteral("stroke"));
    stroke->setValue(2);
    const double zoomed = double(clock.nsecsElapsed()) * 1e-6;
    qInfo("drawing a plunge of %lld visits: %.1f ms, one revolution of it %.1f ms, target %g ms",
          outcome->result.visits, worst, zoomed, target_ms);
    QVERIFY(worst < 4 * target_ms && zoomed < 4 * target_ms);
}

QTEST_MAIN(TestFeedsView)
#include "test_feeds_view.moc"
