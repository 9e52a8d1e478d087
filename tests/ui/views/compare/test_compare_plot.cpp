// SPDX-License-Identifier: GPL-3.0-or-later
// The plot of the view "Compare": its curves are those of the runs, read and zoomed.
#include "tests/registry.h"
#include "tests/ui/views/compare/compare_bench.h"
#include "ui/plot/legend_strip.h"
#include "ui/plot/plot_tools.h"
#include "ui/text/language.h"

#include <QAction>
#include <QComboBox>

#include <algorithm>
#include <cmath>
#include <variant>

namespace sparkout::test_compare_plot {

using namespace compare_bench;

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

class TestComparePlot : public QObject {
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
        click(0);
        QVERIFY(!desk.plot().curve(0, Quantity::actual)->visible());
        QVERIFY(!desk.plot().curve(1, Quantity::actual)->visible());
        QVERIFY(desk.plot().curve(1, Quantity::force)->visible());
        click(5);
        QVERIFY(!desk.plot().curve(1, Quantity::force)->visible());
        QVERIFY(desk.plot().curve(0, Quantity::force)->visible());
        for (const std::vector<CsvCell>& row : desk.plot().table().rows) {
            QCOMPARE(std::get<QString>(row[0]), QStringLiteral("Current run"));
        }
    }

    void theMouseReadsBothRunsAndAClickMovesTheCycle() {
        KeptDesk desk;
        desk.change(quicker);
        const QRect rect = desk.plot().axisRects()[1]->rect();
        const QPoint at(rect.left() + rect.width() / 4, rect.center().y());
        fixtures::hover(&desk.plot(), at);
        const QString told = desk.text("compareValues");
        QVERIFY2(told.contains(QStringLiteral("Current run, double stroke")), qPrintable(told));
        QVERIFY2(told.contains(QStringLiteral("\nRun 1, double stroke")), qPrintable(told));
        QTest::mouseClick(&desk.plot(), Qt::LeftButton, {}, at);
        const double wanted_s =
            desk.plot().axisRects()[1]->axis(QCPAxis::atBottom)->pixelToCoord(at.x()) * 60;
        QVERIFY(std::abs(desk.cursor.time_s() - wanted_s) < 2);
        QCOMPARE(desk.plot().moment_s().value(), desk.cursor.time_s());
    }

    void zoomGoesBackAndFits() {
        KeptDesk desk;
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
};

} // namespace sparkout::test_compare_plot

SPARKOUT_TEST(test_compare_plot, TestComparePlot)
#include "test_compare_plot.moc"
