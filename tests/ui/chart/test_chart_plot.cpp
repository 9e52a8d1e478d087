// SPDX-License-Identifier: GPL-3.0-or-later
// A chart of curves as a value, and the plot of it: what is in sight, named, read, copied and
// pointed at is what the value says.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/painted_layer.h"
#include "ui/kit/theme.h"

#include <QSignalSpy>

#include <cmath>

namespace sparkout::test_chart_plot {

enum Key { lineKey = 1, lowerKey, upperKey, zoneKey, ruleKey, ribbonKey };

LineChart sample() {
    const std::vector<XY> rising{{0, 1}, {1, 2}, {2, 4}};
    LineChart chart;
    chart.across = {QStringLiteral("Time, s")};
    chart.up = {QStringLiteral("Way, mm")};
    chart.across.room = chart.up.room = 0;
    chart.series = {{.key = lowerKey,
                     .name = QStringLiteral("below"),
                     .kind = ChartSeries::Kind::stack,
                     .points = rising,
                     .sight = InSight::never},
                    {.key = upperKey,
                     .name = QStringLiteral("above"),
                     .kind = ChartSeries::Kind::stack,
                     .points = rising,
                     .sight = InSight::never},
                    {.key = lineKey, .name = QStringLiteral("line"), .points = rising}};
    chart.zones = {{.ranges = {{0.5, 0.7}}, .key = zoneKey, .name = QStringLiteral("zone")}};
    chart.rules = {{.at = 6, .isUpright = false, .key = ruleKey, .name = QStringLiteral("near")},
                   {.at = 60, .isUpright = false, .key = ruleKey, .name = QStringLiteral("far")}};
    chart.read(chart.series.back(), QStringLiteral("line, mm"), Digits::significant);
    chart.table = [] {
        ChartTable table;
        table.cells.header = {QStringLiteral("Time, s")};
        for (const double at : {0.0, 1.0, 2.0}) {
            table.cells.rows.push_back({at});
            table.places.push_back({.across = {at, at}, .key = lineKey});
        }
        return table;
    };
    chart.pointText = [](std::size_t, std::size_t point) { return QString::number(point); };
    chart.pointed = 3;
    return chart;
}

/// Two rows of cells.
ChartGrid grid(std::size_t columns) {
    ChartGrid grid{.columns = columns, .caption = QStringLiteral("Time, s"), .sharesValues = true};
    for (std::size_t i = 0; i < 2 * columns; ++i) {
        grid.cells.push_back(sample());
        if (i < columns) {
            grid.cells.back().headings << QString::number(i);
        }
    }
    return grid;
}

/// Something else in the background of a plot.
struct Background : PaintedLayer {
    explicit Background(ChartPlot& plot)
        : PaintedLayer(plot.cell(), QStringLiteral("bands"), Edges::sharp) {}
    void draw(QCPPainter*) override {}
};

class TestChartPlot : public QObject {
    Q_OBJECT

private slots:
    /// All of what is always in sight, and what is near it.
    void whatIsFarAwaySqueezesNothing() {
        const ChartSpan values = sample().values();
        QCOMPARE(values.low, 1.0);
        QCOMPARE(values.high, 6.0);
        QCOMPARE(sample().places().high, 2.0);
        LineChart chart = sample();
        chart.up.isSymmetric = true;
        QCOMPARE(chart.values().low, -6.0);
        chart.up.range = {2, 3};
        chart.up.isSymmetric = false;
        QCOMPARE(chart.values().high, 3.0);
    }

    void aGapIsNotInSight() {
        LineChart chart = sample();
        chart.series.back().points.push_back({3, std::nan("")});
        QCOMPARE(chart.values().high, 6.0);
        QVERIFY(LineChart().values().empty());
    }

    /// One entry a key, in the order of the value; what is hidden leaves the stack.
    void theLegendNamesAndHides() {
        ChartPlot plot;
        plot.setChart(sample);
        QStringList names;
        for (const LegendEntry& entry : plot.legendEntries()) {
            names << entry.text;
        }
        QCOMPARE(names, QStringList({QStringLiteral("below"), QStringLiteral("above"),
                                     QStringLiteral("line"), QStringLiteral("zone"),
                                     QStringLiteral("near")}));
        const auto top = [&plot](int graph) { return plot.graph(graph)->data()->at(2)->value; };
        QCOMPARE(plot.graphCount(), 3);
        QCOMPARE(top(0), 4.0);
        QCOMPARE(top(1), 8.0);
        plot.toggleCurve(lowerKey);
        QCOMPARE(plot.graphCount(), 2);
        QCOMPARE(top(0), 4.0);
        QVERIFY(!plot.legendEntries().front().shown);
    }

    /// Even where the first chart with bands comes after what else is in the background.
    void bandsAreBehindAllElseAndFollowThePalette() {
        LineChart chart = sample();
        ChartPlot plot;
        new Background(plot);
        plot.setChart([&chart] { return chart; });
        QVERIFY(!plot.bands(0));
        chart.bands = {zoneBand(Zone::rz1, 0, 0, 1), zoneBand(Zone::nz, 0, 1, 2)};
        plot.remake();
        const QList<QCPLayerable*> drawn = plot.layer(QStringLiteral("bands"))->children();
        QVERIFY(drawn.size() > 2); // with the zone of the chart
        QCOMPARE(drawn.front(), static_cast<QCPLayerable*>(plot.bands(0)));
        const auto& colour = plot.bands(0)->bands().front().colour;
        QVERIFY(colour(paletteOf(Theme::light)) != colour(paletteOf(Theme::contrast)));
    }

    void theCursorsAndTheCopyHaveWhatIsShown() {
        ChartPlot plot;
        plot.setChart(sample);
        QCOMPARE(plot.readCurves().size(), std::size_t{1});
        QCOMPARE(plot.readCurves().front().at(1.5), std::optional(3.0));
        QCOMPARE(plot.table().rows.size(), std::size_t{3});
        plot.across().setRange(0.5, 1.5);
        QCOMPARE(plot.table().rows.size(), std::size_t{1});
        plot.toggleCurve(lineKey);
        QVERIFY(plot.readCurves().empty());
        QVERIFY(plot.table().empty());
    }

    void thePointUnderTheMouseIsReadAndClicked() {
        ChartPlot plot;
        plot.resize(400, 300);
        plot.setChart(sample);
        plot.show();
        plot.replot();
        QSignalSpy said(&plot, &ViewPlot::pointed), clicked(&plot, &ChartPlot::pointClicked);
        const QPoint at = plot.pixelOf({1, 2}).toPoint();
        fixtures::hover(&plot, at);
        QCOMPARE(said.last()[0].toString(), QStringLiteral("1"));
        QTest::mouseClick(&plot, Qt::LeftButton, {}, at);
        QCOMPARE(clicked.size(), 1);
        QCOMPARE(clicked[0][1].toULongLong(), 1ULL);
        fixtures::hover(&plot, plot.cell().bottomRight());
        QVERIFY(said.last()[0].toString().isEmpty());
    }

    /// A change of the state is drawn, and what is in sight stays.
    void whatIsInSightStaysWhileTheStateChanges() {
        ChartPlot plot;
        int shift = 0;
        plot.setChart([&shift] {
            LineChart chart = sample();
            chart.rules[0].at = 6 + shift;
            return chart;
        });
        QCOMPARE(plot.up().range().upper, 6.0);
        plot.up().setRange(0, 3);
        shift = 1;
        plot.remake();
        QCOMPARE(plot.chart().rules[0].at, 7.0);
        QCOMPARE(plot.up().range().upper, 3.0);
    }

    /// A line on a map may run back, has an outline and a gap; a click and the mouse have both
    /// values, and outside the cell none.
    void aMapHasAScaleAndLinesOnIt() {
        ChartPlot plot;
        plot.resize(400, 300);
        plot.setChart([] {
            LineChart chart;
            chart.across = {.range = {-0.5, 1.5}, .room = 0};
            chart.up = {.range = {9.5, 11.5}, .room = 0};
            chart.series = {{.key = lineKey,
                             .name = QStringLiteral("edge"),
                             .kind = ChartSeries::Kind::path,
                             .points = {{1, 10}, {0, 11}, {std::nan(""), std::nan("")}},
                             .outline = Qt::black}};
            chart.map = ChartMap{
                .label = QStringLiteral("Size, µm"),
                .across = {0, 1},
                .up = {10, 11},
                .columns = 2,
                .values = {1, 2, std::nan(""), 5},
                .text = [](double place, double value) {
                    return QStringLiteral("%1 %2").arg(std::lround(place)).arg(std::lround(value));
                }};
            return chart;
        });
        plot.show();
        plot.replot();
        const auto* const map = qobject_cast<QCPColorMap*>(plot.plottable(0));
        QVERIFY(map);
        QCOMPARE(map->data()->cell(1, 0), 2.0);
        QCOMPARE(map->data()->cell(1, 1), 5.0);
        QCOMPARE(map->colorScale()->dataRange(), QCPRange(1, 5));
        QCOMPARE(map->colorScale()->label(), QStringLiteral("Size, µm"));
        const auto* const outline = qobject_cast<QCPCurve*>(plot.plottable(1));
        const auto* const line = qobject_cast<QCPCurve*>(plot.plottable(2));
        QVERIFY(outline && line);
        QVERIFY(outline->pen().widthF() > line->pen().widthF());
        QCOMPARE(line->data()->at(0)->key, 1.0);
        QCOMPARE(plot.legendEntries().front().halo, QColor(Qt::black));
        QSignalSpy said(&plot, &ViewPlot::pointed), clicked(&plot, &ChartPlot::placeClicked);
        const QPoint at = plot.pixelOf({1, 11}).toPoint();
        fixtures::hover(&plot, at);
        QCOMPARE(said.last()[0].toString(), QStringLiteral("1 11"));
        QTest::mouseClick(&plot, Qt::RightButton, {}, at);
        QCOMPARE(clicked.size(), 1);
        QVERIFY(std::abs(clicked[0][1].toDouble() - 11) < 0.1);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, {2, 2});
        QCOMPARE(clicked.size(), 1);
    }

    /// The second axis has the values in another unit; a ribbon is behind all else and can be
    /// hidden.
    void anAxisFollowsAndARibbonIsBehind() {
        ChartPlot plot;
        plot.resize(400, 300);
        plot.setChart([] {
            LineChart chart = sample();
            chart.across.isReversed = true;
            chart.up.isLogarithmic = true;
            chart.second = {.label = QStringLiteral("Way, m"), .isLogarithmic = true};
            chart.perValue = 0.001;
            chart.series.push_back({.key = ribbonKey,
                                    .name = QStringLiteral("ribbon"),
                                    .kind = ChartSeries::Kind::ribbon,
                                    .points = {{0, 1}, {2, 4}},
                                    .alpha = 100});
            return chart;
        });
        plot.replot();
        QVERIFY(plot.pixelOf({0, 1}).x() > plot.pixelOf({2, 1}).x());
        QCOMPARE(plot.up().scaleType(), QCPAxis::stLogarithmic);
        plot.up().setRange(2, 5);
        const QCPAxis& right = *plot.cell().axis(QCPAxis::atRight);
        QVERIFY(right.tickLabels() && right.scaleType() == QCPAxis::stLogarithmic);
        QCOMPARE(right.range().lower, 0.002);
        QCOMPARE(right.range().upper, 0.005);
        const auto ribbons = [&plot] {
            int count = 0;
            for (const QCPLayerable* of : plot.layer(QStringLiteral("bands"))->children()) {
                count += qobject_cast<const QCPCurve*>(of) ? 1 : 0;
            }
            return count;
        };
        QCOMPARE(ribbons(), 1);
        QCOMPARE(plot.legendEntries()[3].text, QStringLiteral("ribbon"));
        QCOMPARE(plot.legendEntries()[3].colour.alpha(), 100);
        plot.toggleCurve(ribbonKey);
        QCOMPARE(ribbons(), 0);
    }

    /// Rows from the top down, their values to the right.
    void aLyingChartHasItsPlacesFromTheTopDown() {
        ChartPlot plot;
        plot.resize(400, 300);
        plot.setChart([] {
            LineChart chart = sample();
            chart.isLying = true;
            chart.across.names = QStringList{QStringLiteral("a"), QStringLiteral("b")};
            chart.second.label = QStringLiteral("Share, %");
            chart.second.range = {0, 100};
            chart.second.room = 0;
            return chart;
        });
        plot.replot();
        QVERIFY(plot.pixelOf({0, 1}).y() < plot.pixelOf({1, 1}).y());
        QVERIFY(plot.pixelOf({0, 1}).x() < plot.pixelOf({0, 2}).x());
        QCOMPARE(plot.cell().axis(QCPAxis::atTop)->range().upper, 100.0);
        QVERIFY(plot.across().tickVectorLabels().contains(QStringLiteral("b")));
    }

    void cellsShareTimesLegendAndTheValuesOfTheirRow() {
        ChartPlot plot;
        plot.resize(600, 400);
        std::size_t columns = 2;
        plot.setGrid([&columns] { return grid(columns); });
        QCOMPARE(plot.cellCount(), std::size_t{4});
        QCOMPARE(plot.legendEntries().size(), std::size_t{5});
        QCOMPARE(plot.readCurves().size(), std::size_t{4});
        QCOMPARE(plot.table().rows.size(), std::size_t{3});
        plot.across(3).setRange(0, 1);
        plot.up(1).setRange(0, 2);
        QCOMPARE(plot.across(0).range().upper, 1.0);
        QCOMPARE(plot.up(0).range().upper, 2.0);
        QCOMPARE(plot.up(2).range().upper, 6.0);
        QVERIFY(plot.up(0).tickLabels() && !plot.up(1).tickLabels());
        QVERIFY(!plot.across(0).tickLabels() && plot.across(2).tickLabels());
        columns = 3;
        plot.remake();
        QCOMPARE(plot.cellCount(), std::size_t{6});
        QCOMPARE(plot.axisRectCount(), 6);
    }
};

} // namespace sparkout::test_chart_plot

SPARKOUT_TEST(test_chart_plot, TestChartPlot)
#include "test_chart_plot.moc"
