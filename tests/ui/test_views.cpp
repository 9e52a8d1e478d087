// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/validate.h"
#include "core/simulation/simulate.h"
#include "ui/views/band_layer.h"
#include "ui/views/feed_series.h"
#include "ui/views/feed_text.h"
#include "ui/views/feeds_plot.h"
#include "ui/views/feeds_view.h"
#include "ui/views/verdict_model.h"
#include "ui/views/verdict_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <QWheelEvent>

#include <clocale>
#include <cmath>
#include <limits>

using namespace sparkout;

namespace {

Project traverseProject() {
    Project p;
    p.part.tolerance.radial_runout_um = 6;
    p.machine.compliance_mm_per_n = ZoneCompliance{1.2e-4, 1.7e-4, 1.5e-4};
    p.machine.dwell_entry_s = 0.333;
    p.machine.dwell_exit_s = 0.333;
    Stage rough, fine;
    rough.radial_feed_mm = 0.004;
    rough.axial_feed_mm_min = 1800;
    rough.stock_mm = 0.110;
    fine.radial_feed_mm = 0.001;
    fine.axial_feed_mm_min = 300;
    fine.stock_mm = 0.040;
    p.cycle.stages = {rough, fine};
    return p;
}

Project plungeProject(int sections) {
    Project p = traverseProject();
    p.operation = Operation::plunge;
    p.sections = sections;
    p.part.length_mm = 40;
    p.machine.compliance_mm_per_n = std::vector<double>(static_cast<std::size_t>(sections), 2e-5);
    Stage rough, fine;
    rough.radial_feed_mm_min = 0.5;
    rough.stock_mm = 0.110;
    fine.radial_feed_mm_min = 0.15;
    fine.stock_mm = 0.040;
    p.cycle.stages = {rough, fine};
    return p;
}

OutcomePtr run(const Project& project) {
    auto outcome = std::make_shared<Outcome>();
    outcome->issues = validate(project);
    if (outcome->ran()) {
        outcome->result = simulate(project, &outcome->trajectory);
        outcome->constraints = evaluateConstraints(outcome->result);
        outcome->shop = shopNumbers(outcome->result);
    }
    return outcome;
}

OutcomePtr refused() {
    auto outcome = std::make_shared<Outcome>();
    outcome->issues.push_back(
        {IssueCode::outOfRange, Severity::error, "/wheel/width_mm", "5000", "0.5…1000 mm"});
    return outcome;
}

/// Marks every text, so that an untranslated one shows.
class Marking : public QTranslator {
public:
    QString translate(const char*, const char* text, const char*, int) const override {
        return QStringLiteral("«") + QString::fromUtf8(text) + QStringLiteral("»");
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

void show(FeedsView& view, const OutcomePtr& outcome) {
    view.resize(700, 620);
    view.show();
    QSignalSpy spy(&view, &FeedsView::updated);
    view.setOutcome(outcome);
    QTRY_COMPARE(spy.count(), 1);
}

void settle(VerdictPanel& panel, const OutcomePtr& outcome) {
    panel.setOutcome(outcome);
    QTest::qWait(20);
}

QCPRange xRange(const FeedsView& view, int column, int row) {
    return view.plot()->cell(column, row)->axis(QCPAxis::atBottom)->range();
}

void wheel(QWidget* widget, const QPointF& at, int delta) {
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

void hover(QWidget* widget, const QPointF& at) {
    QMouseEvent event(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
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

ConstraintResult requirement(ConstraintKind kind, double margin, double relative) {
    ConstraintResult c{};
    c.kind = kind;
    c.zone = Zone::nz;
    c.section = 1;
    c.limit = -16;
    c.value = -16 + margin;
    c.margin = margin;
    c.relativeMargin = relative;
    c.holds = margin >= 0;
    return c;
}

} // namespace

class TestViews : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();

    void aPassShowsTheMeanOfItsRadii();
    void radiusBeforeLessRadiusAfterIsTheActualFeed();
    void aDoubleStrokeIsTheSumOfItsPasses();
    void theLastAccumulatedFeedIsTheProgrammedInfeed();
    void theStrokeAxisCountsStrokesAndInverts();
    void evenlyChosenSectionsHoldEndsAndGauge_data();
    void evenlyChosenSectionsHoldEndsAndGauge();
    void aWantedSectionIsShownBesideTheGauge();
    void valuesThatAreNoNumbersAreLeftOut();
    void curvesAreDrawableAtEveryDetail_data();
    void curvesAreDrawableAtEveryDetail();
    void curvesOfALongPlungeAreThinned();

    void allColumnsKeepTheSameTimes();
    void aWheelTurnZoomsAllColumnsAndADoubleClickFits();
    void draggingMovesTheTimesWithinTheCycle();
    void stepsAreNamedWhenOneStrokeIsInSight();
    void stagesAreNamedOverTheWholeCycle();
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

    void theLightsSayHoldsCloseAndFails_data();
    void theLightsSayHoldsCloseAndFails();
    void theVerdictNamesTheWorstRequirement();
    void aCycleThatCannotReachSizeSaysWhatRemains();
    void refusedInputsGreyTheVerdict();
    void copyGivesTabSeparatedText();
    void nothingIsClippedAt300Pixels();
    void theVerdictIsRetranslated();

private:
    OutcomePtr m_traverse, m_plunge;
};

void TestViews::initTestCase() {
    setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    m_traverse = run(traverseProject());
    m_plunge = run(plungeProject(20));
    QVERIFY(m_traverse->ran() && m_traverse->result.status == RunStatus::completed);
    QVERIFY(m_plunge->ran() && !m_plunge->trajectory.passes.empty());
}

// --- series -------------------------------------------------------------------------------------

void TestViews::aPassShowsTheMeanOfItsRadii() {
    const Trajectory& trajectory = m_traverse->trajectory;
    const FeedSeries series = makeFeedSeries(m_traverse->result, trajectory);
    std::size_t seen = 0;
    for (const FeedColumn& column : series.columns) {
        QCOMPARE(column.passes.size(), column.passIndex.size());
        for (std::size_t i = 0; i < column.passes.size(); ++i, ++seen) {
            const Pass& pass = trajectory.passes[column.passIndex[i]];
            double sum = 0;
            for (int k = 0; k < trajectory.radii; ++k) {
                sum += trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)].actual_mm;
            }
            const Spread& actual = column.passes[i].actual_um;
            QVERIFY(std::abs(actual.mean - sum / trajectory.radii * 1000) < 1e-9);
            QVERIFY(actual.min <= actual.mean && actual.mean <= actual.max);
        }
    }
    QCOMPARE(seen, trajectory.passes.size());
}

void TestViews::radiusBeforeLessRadiusAfterIsTheActualFeed() {
    const FeedSeries series = makeFeedSeries(m_traverse->result, m_traverse->trajectory);
    for (const FeedColumn& column : series.columns) {
        const FeedPoints points =
            radiusPoints(series, column, m_traverse->trajectory, 0, series.end_s);
        QCOMPARE(points.size(), column.passes.size() * 36);
        for (const FeedPoint& p : points) {
            QVERIFY(std::abs(p.came_um.mean - p.left_um.mean - p.actual_um.mean) < 1e-9);
        }
        // What a pass leaves is what the next one finds.
        for (std::size_t i = 1; i < column.passes.size(); ++i) {
            QVERIFY(std::abs(column.passes[i].came_um.mean - column.passes[i - 1].left_um.mean)
                    < 1e-8);
        }
    }
}

void TestViews::aDoubleStrokeIsTheSumOfItsPasses() {
    const FeedSeries series = makeFeedSeries(m_traverse->result, m_traverse->trajectory);
    QCOMPARE(series.strokeCount(), m_traverse->result.cycleCount);
    for (const FeedColumn& column : series.columns) {
        std::vector<double> actual(series.strokeStart_s.size()), fed(actual);
        for (const FeedPoint& p : column.passes) {
            actual[static_cast<std::size_t>(p.place.cycleCount - 1)] += p.actual_um.mean;
            fed[static_cast<std::size_t>(p.place.cycleCount - 1)] += p.programmed_um.mean;
        }
        QCOMPARE(column.strokes.size(), actual.size());
        for (std::size_t i = 0; i < actual.size(); ++i) {
            QVERIFY(std::abs(column.strokes[i].actual_um.mean - actual[i]) < 1e-9);
            QVERIFY(std::abs(column.strokes[i].programmed_um.mean - fed[i]) < 1e-9);
        }
        // The first double stroke feeds S_t of stage 1, the last that of stage 2.
        QVERIFY(std::abs(column.strokes.front().programmed_um.mean - 4) < 1e-9);
        QVERIFY(std::abs(column.strokes.back().programmed_um.mean - 1) < 1e-9);
    }
}

void TestViews::theLastAccumulatedFeedIsTheProgrammedInfeed() {
    const FeedSeries series = makeFeedSeries(m_traverse->result, m_traverse->trajectory);
    const double total =
        4.0 * m_traverse->result.countsByStage[0] + 1.0 * m_traverse->result.countsByStage[1];
    const CycleScale scale(series, CycleAxis::minutes);
    for (const FeedColumn& column : series.columns) {
        const std::vector<XY> line =
            polyline(column.strokes, Quantity::programmedSum, Edge::mean, scale);
        QVERIFY(std::abs(line.back().y - total) < 1e-6);
        QVERIFY(std::abs(line.back().x - m_traverse->result.time_s / 60) < 1e-9);
        QVERIFY(line.front().y >= -1e-12 && line.front().y < 1e-9);
    }
}

void TestViews::theStrokeAxisCountsStrokesAndInverts() {
    const FeedSeries series = makeFeedSeries(m_traverse->result, m_traverse->trajectory);
    for (CycleAxis axis :
         {CycleAxis::minutes, CycleAxis::seconds, CycleAxis::strokes, CycleAxis::revolutions}) {
        const CycleScale scale(series, axis);
        for (double part : {0.0, 0.123, 0.5, 0.77, 1.0}) {
            const double time = part * series.end_s;
            QVERIFY(std::abs(scale.time_s(scale.at(time)) - time) < 1e-9);
        }
    }
    const CycleScale strokes(series, CycleAxis::strokes);
    QVERIFY(std::abs(strokes.at(series.end_s) - series.strokeCount()) < 1e-9);
    QVERIFY(std::abs(strokes.at(series.strokeStart_s[26]) - 26) < 1e-9);
    QCOMPARE(series.strokeAt(series.strokeStart_s[26] + 0.01), 27);
}

void TestViews::evenlyChosenSectionsHoldEndsAndGauge_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("gauge");
    for (int count : {1, 2, 3, 4, 5, 20, 200}) {
        for (int gauge : {0, count / 2, count - 1}) {
            QTest::addRow("%d sections, gauge at %d", count, gauge) << count << gauge;
        }
    }
}

void TestViews::evenlyChosenSectionsHoldEndsAndGauge() {
    QFETCH(int, count);
    QFETCH(int, gauge);
    const std::vector<int> shown = shownSections(count, gauge);
    QCOMPARE(static_cast<int>(shown.size()), std::min(count, 4));
    QVERIFY(std::ranges::count(shown, 0) == 1 && std::ranges::count(shown, count - 1) == 1);
    QCOMPARE(std::ranges::count(shown, gauge), 1);
}

void TestViews::aWantedSectionIsShownBesideTheGauge() {
    for (int wanted = 0; wanted < 20; ++wanted) {
        const std::vector<int> shown = shownSections(20, 10, wanted);
        QCOMPARE(shown.size(), std::size_t{4});
        QCOMPARE(std::ranges::count(shown, wanted), 1);
        QCOMPARE(std::ranges::count(shown, 10), 1);
    }
}

void TestViews::valuesThatAreNoNumbersAreLeftOut() {
    auto outcome = std::make_shared<Outcome>(*m_traverse);
    outcome->trajectory.visits[40].actual_mm = std::nan("");
    outcome->trajectory.visits[5000].radius_mm = std::numeric_limits<double>::infinity();
    FeedsView view;
    show(view, outcome);
    QCOMPARE(view.plot()->series().dropped, 2);
    QVERIFY(drawable(view.plot()));
    QVERIFY(view.findChild<QLabel*>(QStringLiteral("notice"))->text().contains(u'2'));
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(2);
    QVERIFY(drawable(view.plot()));
}

void TestViews::curvesAreDrawableAtEveryDetail_data() {
    QTest::addColumn<bool>("plunge");
    QTest::addColumn<double>("share");
    for (bool plunge : {false, true}) {
        for (double share : {1.0, 0.1, 0.03, 0.005, 1e-5}) {
            QTest::addRow("%s, %g of the cycle", plunge ? "plunge" : "traverse", share)
                << plunge << share;
        }
    }
}

void TestViews::curvesAreDrawableAtEveryDetail() {
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

void TestViews::curvesOfALongPlungeAreThinned() {
    Project project = plungeProject(4);
    project.cycle.stages[1].radial_feed_mm_min = 0.004;
    const OutcomePtr outcome = run(project);
    const FeedSeries series = makeFeedSeries(outcome->result, outcome->trajectory, {0, 2});
    QVERIFY(series.strokeCount() > 1000);
    for (const FeedColumn& column : series.columns) {
        QVERIFY(column.strokes.size() <= mostStrokePoints);
        QCOMPARE(column.strokes.back().end_s, column.passes.back().end_s);
        QCOMPARE(column.strokes.back().left_um.mean, column.passes.back().left_um.mean);
    }
}

// --- feeds view ---------------------------------------------------------------------------------

void TestViews::allColumnsKeepTheSameTimes() {
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

void TestViews::aWheelTurnZoomsAllColumnsAndADoubleClickFits() {
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

void TestViews::draggingMovesTheTimesWithinTheCycle() {
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

void TestViews::stepsAreNamedWhenOneStrokeIsInSight() {
    FeedsView view;
    show(view, m_traverse);
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(27);
    view.grab();
    QStringList rz1 = view.plot()->bands(0, 0)->drawnNames();
    rz1.sort();
    QCOMPARE(rz1, QStringList({QStringLiteral("E1"), QStringLiteral("E2"), QStringLiteral("E3"),
                               QStringLiteral("E4"), QStringLiteral("E5")}));
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

void TestViews::stagesAreNamedOverTheWholeCycle() {
    FeedsView view;
    show(view, m_traverse);
    view.grab();
    QStringList names = view.plot()->bands(0, 0)->drawnNames();
    names.sort();
    QCOMPARE(names, QStringList({QStringLiteral("stage 1"), QStringLiteral("stage 2")}));
}

void TestViews::keysChooseStageAndStroke() {
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

void TestViews::buttonsStepFromStrokeToStroke() {
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
    QTest::mouseClick(view.findChild<QToolButton*>(QStringLiteral("fit")), Qt::LeftButton);
    QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().end_s);
}

void TestViews::theRangeChosenOutlivesANewOutcome() {
    FeedsView view;
    show(view, m_traverse);
    view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(20);
    Project project = traverseProject();
    project.machine.dwell_entry_s = 1;
    show(view, run(project));
    QCOMPARE(view.plot()->visibleFrom_s(), view.plot()->series().strokeStart_s[19]);
    QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().strokeEnd_s(20));
}

void TestViews::pointingAtACurveTellsItsValues() {
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

void TestViews::plungeShowsForceAndAtMostFourSections() {
    FeedsView view;
    show(view, m_plunge);
    const FeedSeries& series = view.plot()->series();
    QCOMPARE(series.columns.size(), std::size_t{4});
    QVERIFY(view.plot()->curve(0, Quantity::force, Edge::mean));
    QVERIFY(!view.plot()->curve(0, Quantity::axialFeed, Edge::mean));
    QCOMPARE(std::ranges::count(series.columns, true, &FeedColumn::gauge), 1);
    auto* section = view.findChild<QComboBox*>(QStringLiteral("section"));
    QVERIFY(section->isVisible());
    section->setFocus();
    QTest::keyClick(section, Qt::Key_End);
    QTest::keyClick(section, Qt::Key_Up);
    QVERIFY(std::ranges::count(view.plot()->series().columns, 18, &FeedColumn::section) == 1);
}

void TestViews::aChangeOfOperationRebuildsTheGrid() {
    FeedsView view;
    show(view, m_traverse);
    show(view, m_plunge);
    QCOMPARE(view.plot()->axisRectCount(), 12);
    show(view, m_traverse);
    QCOMPARE(view.plot()->axisRectCount(), 9);
    QVERIFY(view.plot()->curve(0, Quantity::axialFeed, Edge::mean));
    QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().end_s);
}

void TestViews::refusedInputsKeepTheCurvesDimmed() {
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

void TestViews::withoutAResultTheViewSaysSo() {
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

void TestViews::anotherLanguageReachesEveryText() {
    FeedsView view;
    show(view, m_traverse);
    Marking marking;
    QApplication::installTranslator(&marking);
    QCoreApplication::processEvents();
    const auto marked = [](const QString& text) { return text.startsWith(QChar(0x00AB)); };
    auto* span = view.findChild<QComboBox*>(QStringLiteral("span"));
    QVERIFY(marked(span->itemText(0)) && marked(span->itemText(1)));
    QCOMPARE(span->currentIndex(), 0);
    QVERIFY(marked(view.plot()->cell(0, 2)->axis(QCPAxis::atBottom)->label()));
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

void TestViews::aNewOutcomeIsDrawnQuickly() {
    FeedsView view;
    show(view, m_traverse);
    double best = 1e9;
    for (int i = 0; i < 10; ++i) {
        show(view, m_traverse);
        best = std::min(best, view.lastUpdate_ms());
    }
    qInfo("setOutcome and replot: %.1f ms for %lld visits", best, m_traverse->result.visits);
    QVERIFY(best < 100); // four times the bound of a release build
}

// --- verdict ------------------------------------------------------------------------------------

void TestViews::theLightsSayHoldsCloseAndFails_data() {
    QTest::addColumn<double>("margin");
    QTest::addColumn<double>("relative");
    QTest::addColumn<QString>("word");
    QTest::newRow("holds") << 6.4 << 0.4 << QStringLiteral("holds");
    QTest::newRow("just holds") << 1.6 << 0.1 << QStringLiteral("holds");
    QTest::newRow("close") << 1.59 << 0.0994 << QStringLiteral("close to the limit");
    QTest::newRow("on the limit") << 0.0 << 0.0 << QStringLiteral("close to the limit");
    QTest::newRow("fails") << -3.2 << -0.2 << QStringLiteral("fails");
}

void TestViews::theLightsSayHoldsCloseAndFails() {
    QFETCH(double, margin);
    QFETCH(double, relative);
    QFETCH(QString, word);
    auto outcome = std::make_shared<Outcome>(*m_traverse);
    outcome->constraints = {requirement(ConstraintKind::diameterMin, margin, relative)};
    VerdictPanel panel;
    settle(panel, outcome);
    QCOMPARE(panel.model()->rowCount(), 2);
    const QString cell = panel.model()->index(1, 0).data().toString();
    QCOMPARE(cell.section(u'\n', 1), word);
    QVERIFY(!panel.model()->index(1, 0).data(Qt::DecorationRole).value<QIcon>().isNull());
}

void TestViews::theVerdictNamesTheWorstRequirement() {
    auto outcome = std::make_shared<Outcome>(*m_traverse);
    VerdictPanel panel;
    auto* overall = panel.findChild<QLabel*>(QStringLiteral("overall"));
    settle(panel, outcome);
    QCOMPARE(overall->text(), QStringLiteral("Holds the drawing"));
    outcome = std::make_shared<Outcome>(*m_traverse);
    outcome->constraints = {requirement(ConstraintKind::diameterMax, 1, 0.05),
                            requirement(ConstraintKind::diameterMin, -3.2, -0.2)};
    settle(panel, outcome);
    QCOMPARE(overall->text(),
             QStringLiteral("Does not hold: diameter in NZ is 3.20 µm below the lower limit"));
    outcome = std::make_shared<Outcome>(*outcome);
    outcome->constraints.pop_back();
    settle(panel, outcome);
    QVERIFY(overall->text().startsWith(QStringLiteral("Holds the drawing, but close")));
}

void TestViews::aCycleThatCannotReachSizeSaysWhatRemains() {
    auto outcome = std::make_shared<Outcome>(*m_traverse);
    outcome->result.status = RunStatus::cannotReachSize;
    outcome->result.gaugeReading_mm = 30.0124;
    outcome->result.remainingStock_mm = 0.0102;
    VerdictPanel panel;
    settle(panel, outcome);
    const QString text = panel.findChild<QLabel*>(QStringLiteral("status"))->text();
    QVERIFY(text.contains(QStringLiteral("30.0124 mm")));
    QVERIFY(text.contains(QStringLiteral("10.20 µm")));
    QVERIFY(panel.findChild<QLabel*>(QStringLiteral("overall"))
                ->text()
                .startsWith(QStringLiteral("Does not hold")));
}

void TestViews::refusedInputsGreyTheVerdict() {
    VerdictPanel panel;
    panel.show();
    auto* notice = panel.findChild<QLabel*>(QStringLiteral("notice"));
    auto* time = panel.findChild<QLabel*>(QStringLiteral("time"));
    QCOMPARE(notice->text(), QStringLiteral("No result yet."));
    settle(panel, m_traverse);
    QVERIFY(!notice->isVisible());
    const QString before = time->text();
    const QColor colour = time->palette().color(QPalette::WindowText);
    settle(panel, refused());
    QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("5000")));
    QCOMPARE(time->text(), before);
    QVERIFY(time->palette().color(QPalette::WindowText) != colour);
    QVERIFY(panel.model()->index(1, 1).data(Qt::ForegroundRole).isValid());
    settle(panel, m_traverse);
    QCOMPARE(time->palette().color(QPalette::WindowText), colour);
    QVERIFY(!panel.model()->index(1, 1).data(Qt::ForegroundRole).isValid());
}

void TestViews::copyGivesTabSeparatedText() {
    VerdictPanel panel;
    panel.show();
    settle(panel, m_traverse);
    auto* table = panel.findChild<QTableView*>(QStringLiteral("requirements"));
    table->setFocus();
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QApplication::clipboard()->text().trimmed().split(u'\n');
    QCOMPARE(lines.size(), 1 + static_cast<qsizetype>(m_traverse->constraints.size()));
    for (const QString& line : lines) {
        QCOMPARE(line.count(u'\t'), 5);
    }
    QVERIFY(lines[1].startsWith(QStringLiteral("RZ1\tSmallest diameter\t")));
}

void TestViews::nothingIsClippedAt300Pixels() {
    VerdictPanel panel;
    panel.resize(300, 640);
    panel.show();
    settle(panel, m_traverse);
    QCOMPARE(panel.width(), 300);
    auto* table = panel.findChild<QTableView*>(QStringLiteral("requirements"));
    QVERIFY(table->width() <= 300);
    for (int row = 0; row < panel.model()->rowCount(); ++row) {
        for (int column = 1; column < panel.model()->columnCount(); ++column) {
            const QString text = panel.model()->index(row, column).data().toString();
            QVERIFY(table->fontMetrics().horizontalAdvance(text) <= table->columnWidth(column));
        }
        const int lines = panel.model()->isZoneRow(row) ? 1 : 2;
        QVERIFY(table->rowHeight(row) >= lines * table->fontMetrics().height());
    }
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        if (label->isVisible() && !label->text().isEmpty()) {
            QTRY_VERIFY(label->height() >= label->heightForWidth(label->width()));
        }
    }
}

void TestViews::theVerdictIsRetranslated() {
    VerdictPanel panel;
    settle(panel, m_traverse);
    Marking marking;
    QApplication::installTranslator(&marking);
    QCoreApplication::processEvents();
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        if (!label->isHidden() && !label->text().isEmpty()) {
            QVERIFY2(label->text().contains(QChar(0x00AB)), qPrintable(label->text()));
        }
    }
    QVERIFY(panel.model()->index(1, 0).data().toString().startsWith(QChar(0x00AB)));
    QApplication::removeTranslator(&marking);
    QCoreApplication::processEvents();
    QCOMPARE(panel.model()->headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(),
             QStringLiteral("Value"));
}

QTEST_MAIN(TestViews)
#include "test_views.moc"
