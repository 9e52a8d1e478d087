// SPDX-License-Identifier: GPL-3.0-or-later
// The times that the feeds view has in sight: one for all columns, chosen by wheel, drag, keys and
// lists, in the overview, and gone back to.
#include "tests/registry.h"
#include "tests/ui/support/typing.h"
#include "tests/ui/views/cycle/feeds_bench.h"
#include "ui/chart/plot_tools.h"
#include "ui/views/cycle/feeds_overview.h"

#include <QComboBox>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace sparkout::test_feeds_times {

using namespace feeds_bench;

class TestFeedsTimes : public FeedsTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void allColumnsKeepTheSameTimes() {
        ShownFeeds view(m_traverse);
        view.plot()->cell(2, 1)->axis(QCPAxis::atBottom)->setRange(3, 5);
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < FeedsPlot::rowCount; ++row) {
                QVERIFY(std::abs(xRange(view, column, row).lower - 3) < 1e-9);
                QVERIFY(std::abs(xRange(view, column, row).upper - 5) < 1e-9);
            }
        }
    }

    void aWheelTurnZoomsAllColumnsAndADoubleClickFits() {
        ShownFeeds view(m_traverse);
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

    void draggingMovesTheTimesWithinTheCycle() {
        ShownFeeds view(m_traverse);
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

    void keysChooseStageAndStroke() {
        ShownFeeds view(m_traverse);
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
        typeOver(*stroke, QStringLiteral("27"));
        QTest::keyClick(stroke, Qt::Key_Return);
        QCOMPARE(view.plot()->visibleFrom_s(), series.strokeStart_s[26]);
        QCOMPARE(view.plot()->visibleTo_s(), series.strokeEnd_s(27));
        QCOMPARE(view.plot()->detail(), FeedsPlot::Detail::radius);
        for (int column = 0; column < view.plot()->columnCount(); ++column) {
            const auto& sums = curve(*view.plot(), column, Quantity::actualSum)->points;
            QVERIFY(sums.size() > 2);
            QVERIFY(std::ranges::is_sorted(sums, {}, &XY::y));
        }
    }

    void buttonsStepFromStrokeToStroke() {
        ShownFeeds view(m_traverse);
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

    void theRangeChosenOutlivesANewOutcome() {
        ShownFeeds view(m_traverse);
        view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(20);
        Project project = traverseProject();
        project.machine->dwell_entry_s = 1;
        show(view, run(project));
        QCOMPARE(view.plot()->visibleFrom_s(), view.plot()->series().strokeStart_s[19]);
        QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().strokeEnd_s(20));
    }

    void backLeadsThroughWhatWasInSight() {
        ShownFeeds view(m_traverse);
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

    // --- the overview ---------------------------------------------------------------------------

    void theOverviewShowsWhatIsInSight() {
        ShownFeeds view(m_traverse);
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
        QVERIFY(std::abs(overview->window().left()
                         - strokes / view.plot()->series().strokeCount() * width)
                < 1e-6);
    }

    void draggingTheOverviewsWindowMovesTheTimes() {
        ShownFeeds view(m_traverse);
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

    void anEdgeOfTheOverviewsWindowCanBeDragged() {
        ShownFeeds view(m_traverse);
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

    void aClickInTheOverviewBringsTheWindowThere() {
        ShownFeeds view(m_traverse);
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

    void theOverviewIsMovedByKeys() {
        ShownFeeds view(m_traverse);
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
};

} // namespace sparkout::test_feeds_times

SPARKOUT_TEST(test_feeds_times, TestFeedsTimes)
#include "test_feeds_times.moc"
