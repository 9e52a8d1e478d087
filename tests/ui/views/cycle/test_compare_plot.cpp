// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of the view "Compare": its curves are those of the runs, read and zoomed.
#include "tests/registry.h"
#include "tests/ui/views/cycle/compare_bench.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/text/language.h"

#include <QAction>
#include <QComboBox>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

namespace sparkout::test_compare_plot {

using namespace compare_bench;

constexpr std::array usual{Quantity::actual, Quantity::force, Quantity::actualSum, Quantity::left};

/// The curve of a quantity of a run; null: the quantity is not drawn.
const ChartSeries* curve(const ComparePlot& plot, std::size_t run, Quantity quantity) {
    std::vector<const ChartSeries*> found;
    for (std::size_t row = 0; row < plot.cellCount(); ++row) {
        for (const ChartSeries& series : plot.chart(row).series) {
            if (series.key == static_cast<int>(quantity)) {
                found.push_back(&series);
            }
        }
    }
    return run < found.size() ? found[found.size() - 1 - run] : nullptr; // the present one is last
}

/// It is as the run's own feeds have it, by minutes.
void compareWithFeeds(const ChartSeries* curve, const FeedSeries& feeds, std::size_t column,
                      Quantity quantity) {
    QVERIFY(curve);
    for (const FeedPoint& p : feeds.columns[column].strokes) {
        const double end_min = p.end_s / 60;
        QVERIFY(std::ranges::any_of(curve->points, [&](const XY& at) {
            return std::abs(at.x - end_min) <= end_min * 1e-12
                   && at.y == valueOf(p, quantity, Edge::mean);
        }));
    }
}

class TestComparePlot : public QObject {
    Q_OBJECT

private slots:
    void theCurvesAreThoseOfTheRuns() {
        Desk desk;
        const OutcomePtr first = desk.outcome;
        desk.keep();
        desk.change(quicker);
        QCOMPARE(desk.plot().runs().size(), 2u);
        for (const Quantity quantity : usual) {
            compareWithFeeds(curve(desk.plot(), 0, quantity), desk.outcome->feeds, 1, quantity);
            compareWithFeeds(curve(desk.plot(), 1, quantity), first->feeds, 1, quantity);
        }
        const auto colour = [&](std::size_t run, Quantity q) {
            return curve(desk.plot(), run, q)->colour;
        };
        const auto pen = [&](std::size_t run, Quantity q) {
            return curve(desk.plot(), run, q)->pen;
        };
        QVERIFY(colour(0, Quantity::actual) == colour(1, Quantity::actual));
        QVERIFY(colour(0, Quantity::actual) != colour(0, Quantity::force));
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
        const ComparePlot& plot = desk.plot();
        const QCPRange feeds = plot.up().range();
        const auto choose = [&](Quantity quantity) {
            desk.view
                .findChild<QAction*>(QStringLiteral("second%1").arg(static_cast<int>(quantity)))
                ->trigger();
            desk.settle();
        };
        choose(Quantity::axialFeed);
        choose(Quantity::programmedSum);
        QVERIFY(!curve(plot, 0, Quantity::force) && !curve(plot, 0, Quantity::left));
        for (const Quantity quantity : {Quantity::actual, Quantity::axialFeed, Quantity::actualSum,
                                        Quantity::programmedSum}) {
            compareWithFeeds(curve(plot, 0, quantity), desk.outcome->feeds, 1, quantity);
            compareWithFeeds(curve(plot, 1, quantity), first->feeds, 1, quantity);
        }
        const QCPAxis& axis = plot.second();
        QCOMPARE(axis.axisType(), QCPAxis::atRight);
        QVERIFY(axis.range().contains(2400)); // of the present run
        QCOMPARE(plot.up().range(), feeds);
        const ChartSeries& drawn = *curve(plot, 0, Quantity::axialFeed);
        QVERIFY(drawn.onSecond);
        QCOMPARE(axis.labelColor(), chartColour(drawn.colour, plot.palette()));
        QCOMPARE(axis.tickLabelColor(), axis.labelColor());
        QVERIFY(plot.chart().second.label.contains(QStringLiteral("mm/min")));
        const QString name = QStringLiteral("axial feed");
        QVERIFY(std::ranges::any_of(desk.plot().legendEntries(),
                                    [&](const LegendEntry& e) { return e.text == name; }));
        const CsvTable table = desk.plot().table();
        const auto column = table.header.indexOf(QStringLiteral("axial feed, mm/min"));
        QVERIFY(column > 0);
        QCOMPARE(std::get<double>(table.rows[0][std::size_t(column)]), 2400.0);
        // The wheel over the axis zooms it alone.
        const QCPAxisRect* rect = axis.axisRect();
        const double before = axis.range().size();
        fixtures::wheel(&desk.plot(), QPointF(rect->right() + 12, rect->center().y()), 120);
        QVERIFY(axis.range().size() < before);
        QCOMPARE(plot.up().range(), feeds);
        Language language; // what was chosen stays, in other words
        language.apply(QStringLiteral("ru"));
        desk.settle();
        QCOMPARE(plot.secondQuantity(0), Quantity::axialFeed);
        QVERIFY(plot.chart().second.label.contains(QStringLiteral("мм/мин")));
        language.apply(QStringLiteral("en"));
        desk.settle();
        QVERIFY(plot.chart().second.label.contains(QStringLiteral("mm/min")));
        choose(Quantity::force);
        QVERIFY(curve(plot, 0, Quantity::force) && !curve(plot, 0, Quantity::axialFeed));
    }

    void theNumbersOfBothPlotsHaveRoom() {
        Desk desk;
        for (std::size_t row = 0; row < 2; ++row) {
            const QFontMetrics text(desk.plot().font());
            QVERIFY(desk.plot().cell(row).margins().top() >= text.height() / 2);
            QCOMPARE(desk.plot().across(row).tickLabels(), row == 1);
            QVERIFY(desk.plot().second(row).tickLabels());
        }
        QCOMPARE(desk.plot().caption()->text(), QStringLiteral("Time, min"));
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
        compareWithFeeds(curve(desk.plot(), 0, Quantity::actual), desk.outcome->feeds, 0,
                         Quantity::actual);
        compareWithFeeds(curve(desk.plot(), 1, Quantity::actual), first->feeds, 0,
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
        QCOMPARE(desk.plot().runs()[1].name, QStringLiteral("Run 1: Section 2"));
    }

    void theLegendHidesAQuantityOrARun() {
        KeptDesk desk;
        desk.change(quicker);
        auto* legend = desk.view.findChild<LegendStrip*>();
        QCOMPARE(legend->entries().size(), 6u);
        const auto click = [&](int entry) {
            QTest::mouseClick(legend, Qt::LeftButton, {}, legend->entryRect(entry).center());
            QTest::qWait(20);
        };
        QCOMPARE(desk.plot().graphCount(), 8);
        click(0);
        QCOMPARE(desk.plot().graphCount(), 6); // of both runs
        QVERIFY(!curve(desk.plot(), 1, Quantity::force)->points.empty());
        QCOMPARE(desk.plot().readCurves().size(), 6u);
        click(5);
        QVERIFY(curve(desk.plot(), 1, Quantity::force)->points.empty());
        QVERIFY(!curve(desk.plot(), 0, Quantity::force)->points.empty());
        QCOMPARE(desk.plot().readCurves().size(), 3u);
        for (const std::vector<CsvCell>& row : desk.plot().table().rows) {
            QCOMPARE(std::get<QString>(row[0]), QStringLiteral("Current run"));
        }
    }

    void theMouseReadsBothRunsAndAClickMovesTheCycle() {
        KeptDesk desk;
        desk.change(quicker);
        const QRect rect = desk.plot().cell(1).rect();
        const QPoint at(rect.left() + rect.width() / 4, rect.center().y());
        fixtures::hover(&desk.plot(), at);
        const QString told = desk.text("compareValues");
        QVERIFY2(told.contains(QStringLiteral("Current run, double stroke")), qPrintable(told));
        QVERIFY2(told.contains(QStringLiteral("\nRun 1, double stroke")), qPrintable(told));
        QTest::mouseClick(&desk.plot(), Qt::LeftButton, {}, at);
        const double wanted_s = desk.plot().across(1).pixelToCoord(at.x()) * 60;
        QVERIFY(std::abs(desk.cursor.time_s() - wanted_s) < 2);
        QCOMPARE(desk.plot().moment_s().value(), desk.cursor.time_s());
    }

    void zoomGoesBackAndFits() {
        KeptDesk desk;
        const QCPAxis* const time = &desk.plot().across();
        const QCPRange all = time->range();
        fixtures::wheel(&desk.plot(), desk.plot().cell().rect().center(), 240);
        QVERIFY(time->range().size() < 0.9 * all.size());
        QCOMPARE(desk.plot().across(1).range(), time->range());
        const QCPRange zoomed = time->range();
        desk.change(quicker); // a new run leaves what is in sight
        QCOMPARE(time->range(), zoomed);
        desk.view.tools()->fit->trigger();
        QVERIFY(time->range().size() > zoomed.size());
        desk.view.tools()->back->trigger();
        QCOMPARE(time->range(), zoomed);
    }
};

} // namespace sparkout::test_compare_plot

SPARKOUT_TEST(test_compare_plot, TestComparePlot)
#include "test_compare_plot.moc"
