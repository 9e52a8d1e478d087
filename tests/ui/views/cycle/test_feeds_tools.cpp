// SPDX-License-Identifier: GPL-3.0-or-later
// The feeds view's legend, hair line, room, note and table, and how long it takes.
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/views/cycle/feeds_bench.h"
#include "ui/chart/legend.h"
#include "ui/chart/painted_layer.h"
#include "ui/text/language.h"
#include "ui/views/cycle/feeds_note.h"

#include <QLabel>
#include <QSpinBox>
#include <QToolButton>

#include <cmath>

namespace sparkout::test_feeds_tools {

using namespace feeds_bench;

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

class TestFeedsTools : public FeedsTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void aLegendClickHidesACurveAndItsScale() {
        ShownFeeds view(m_traverse);
        LegendStrip* legend = view.legend();
        const QString name = QStringLiteral("normal force");
        const QPoint at = entryOf(*legend, name);
        QVERIFY(!at.isNull());
        const double before = axisTop(view, 2, QCPAxis::atRight);
        const int drawn = view.plot()->graphCount();
        QTest::mouseClick(legend, Qt::LeftButton, {}, at);
        QVERIFY(!isShown(*view.plot(), Quantity::force));
        QCOMPARE(view.plot()->graphCount(), drawn - 9);       // with its spread, in three columns
        QVERIFY(axisTop(view, 2, QCPAxis::atRight) < before); // nothing to scale to
        QVERIFY(!view.plot()->table().header.contains(QStringLiteral("normal force, N")));
        QVERIFY(legend->accessibleDescription().contains(QStringLiteral("normal force (hidden)")));
        // The sum goes with its feed.
        QTest::mouseClick(legend, Qt::LeftButton, {},
                          entryOf(*legend, QStringLiteral("actual feed")));
        QVERIFY(!isShown(*view.plot(), Quantity::actual));
        QCOMPARE(view.plot()->graphCount(), drawn - 27);
        // What is hidden stays hidden with a new result.
        show(view, m_traverse);
        QVERIFY(!isShown(*view.plot(), Quantity::force));
        QTest::mouseClick(legend, Qt::LeftButton, {}, entryOf(*legend, name));
        QVERIFY(isShown(*view.plot(), Quantity::force));
        QCOMPARE(axisTop(view, 2, QCPAxis::atRight), before);
    }

    void controlClickShowsOnlyThisCurve() {
        ShownFeeds view(m_traverse);
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
        QVERIFY(isShown(*view.plot(), Quantity::left));
        QVERIFY(!isShown(*view.plot(), Quantity::actual));
        QTest::mouseClick(legend, Qt::LeftButton, Qt::ControlModifier, entryOf(*legend, name));
        QCOMPARE(visible(), all);
    }

    void theLegendWorksByKeyboard() {
        ShownFeeds view(m_traverse);
        QApplication::setActiveWindow(&view);
        LegendStrip* legend = view.legend();
        legend->setFocus();
        QTest::keyClick(legend, Qt::Key_Right);
        QVERIFY(legend->accessibleDescription().startsWith(QStringLiteral("chosen: actual feed")));
        QTest::keyClick(legend, Qt::Key_Space);
        QVERIFY(!isShown(*view.plot(), Quantity::actual));
        QTest::keyClick(legend, Qt::Key_Space);
        QVERIFY(isShown(*view.plot(), Quantity::actual));
        QTest::keyClick(legend, Qt::Key_Left);
        QTest::keyClick(legend, Qt::Key_Space, Qt::ControlModifier);
        QVERIFY(isShown(*view.plot(), Quantity::programmed));
        QVERIFY(!isShown(*view.plot(), Quantity::actual));
    }

    void theHairLineStandsAtOneTimeInAllColumns() {
        ShownFeeds view(m_traverse);
        const auto hairLine = [&]() -> const HairLine* {
            for (QCPLayerable* item : view.plot()->layer(HairLine::layerName())->children()) {
                const auto* line = qobject_cast<HairLine*>(item);
                if (line && line->role() == HairLine::Role::mouse) {
                    return line;
                }
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

    void forceAndAxialFeedShareTheThirdRow() {
        ShownFeeds view(m_traverse);
        QVERIFY(curve(*view.plot(), 1, Quantity::force)->onSecond);
        QVERIFY(!curve(*view.plot(), 1, Quantity::axialFeed)->onSecond);
        // The axis holds the largest force of the run.
        const double top = axisTop(view, 2, QCPAxis::atRight);
        QVERIFY(top >= m_traverse->result.peakNormalForce_n);
        QVERIFY(top <= 1.2 * m_traverse->result.peakNormalForce_n);
        hover(view.plot(), view.plot()->cell(1, 2)->rect().center());
        const QString text = view.findChild<QLabel*>(QStringLiteral("feedsValues"))->text();
        QVERIFY(text.contains(QStringLiteral("force"))
                && text.contains(QStringLiteral("axial feed")));
    }

    void plotsOfARowAreEquallyWideAndUseTheirRoom() {
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
                    QVERIFY(std::abs(plot->cell(0, row)->height() - plot->cell(0, 0)->height())
                            <= 3);
                }
                QVERIFY2(high > 0.7 * plot->height(), qPrintable(QString::number(high)));
            }
        }
    }

    /// Beside the docks of a window of 1366 × 768 a view has 668 pixels.
    void theViewFitsASmallWindowInBothLanguages() {
        FeedsView view;
        Language language;
        for (const char* code : {"ru", "en"}) {
            language.apply(QString::fromLatin1(code));
            for (const OutcomePtr& outcome : {m_traverse, m_plunge}) {
                show(view, outcome);
                const QSize least = view.minimumSizeHint();
                QVERIFY2(
                    least.width() <= 668 && least.height() <= 545,
                    qPrintable(QStringLiteral("%1 × %2").arg(least.width()).arg(least.height())));
            }
        }
        QLocale::setDefault(QLocale::c());
    }

    void theNoteTellsTheStepsOfEachZone() {
        ShownFeeds view(m_traverse);
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
        QVERIFY(!all.contains(QLatin1String("plunge-in at the exit")));
        QTest::keyClick(note, Qt::Key_Escape);
        QVERIFY(!note->isVisible());
        Project bothEnds = m_traverse->result.project;
        bothEnds.machine->reversal_infeed = ReversalInfeed::both;
        show(view, run(bothEnds));
        QTest::mouseClick(view.findChild<QToolButton*>(QStringLiteral("note")), Qt::LeftButton);
        const auto labels = note->findChildren<QLabel*>();
        const auto has = [&labels](const char* text) {
            return std::ranges::any_of(labels, [text](const QLabel* label) {
                return label->text() == QLatin1String(text);
            });
        };
        QVERIFY(has("plunge-in") && has("plunge-in at the exit"));
    }

    void theTableHoldsTheCurvesData() {
        ShownFeeds view(m_traverse);
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
                const auto& points = curve(*view.plot(), column, Quantity::actual)->points;
                const QString zone = std::get<QString>(table.rows[row][0]);
                for (; row < table.rows.size() && std::get<QString>(table.rows[row][0]) == zone;
                     ++row) {
                    const double x = std::get<double>(table.rows[row][std::size_t(to)]);
                    const double y = std::get<double>(table.rows[row][std::size_t(actual)]);
                    QVERIFY(std::ranges::any_of(points, [&](const XY& point) {
                        return std::abs(point.x - x) < 1e-9 && point.y == y;
                    }));
                }
            }
            QCOMPARE(row, table.rows.size());
        }
    }

    /// 2 million visits: all that is recorded. The series comes with the outcome; the window has
    /// only to draw it.
    void aLongPlungeDoesNotStallTheWindow() {
        constexpr double target_ms = 50;
        Project project = plungeProject(4);
        project.part->radii_per_section = 360;
        project.cycle->stages[0].radial_feed_mm_min = 0.1;
        project.cycle->stages[1].radial_feed_mm_min = 0.012;
        const OutcomePtr outcome = run(project);
        RunningTimer clock;
        QVERIFY(!makeFeedSeries(outcome->result, outcome->trajectory).columns.empty());
        const double series_ms = double(clock.nsecsElapsed()) * 1e-6;
        QVERIFY2(outcome->result.visits > 1'000'000 && !outcome->trajectory.passes.empty(),
                 qPrintable(QString::number(outcome->result.visits)));
        ShownFeeds view(m_plunge);
        const double worst = leastOfTries_ms(4 * target_ms, [&] {
            double worst_ms = 0;
            for (int i = 0; i < 5; ++i) {
                show(view, i % 2 == 0 ? outcome : m_plunge);
                worst_ms = std::max(worst_ms, view.lastUpdate_ms());
            }
            return worst_ms;
        });
        auto* stroke = view.findChild<QSpinBox*>(QStringLiteral("stroke"));
        int shown = 1;
        const double zoomed = leastOfTries_ms(4 * target_ms, [&] {
            clock.start();
            stroke->setValue(++shown);
            return double(clock.nsecsElapsed()) * 1e-6;
        });
        qInfo("a plunge of %lld visits: drawn in %.1f ms, one revolution of it in %.1f ms, target "
              "%g ms; "
              "summed up beside the window in %.1f ms",
              outcome->result.visits, worst, zoomed, target_ms, series_ms);
        QVERIFY(worst <= 4 * target_ms && zoomed <= 4 * target_ms);
    }
};

} // namespace sparkout::test_feeds_tools

SPARKOUT_TEST(test_feeds_tools, TestFeedsTools)
#include "test_feeds_tools.moc"
