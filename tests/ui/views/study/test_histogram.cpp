// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "ui/chart/chart_plot.h"
#include "ui/views/study/batch_charts.h"

namespace sparkout::test_histogram {

BatchSummary batch() {
    return summarise(runBatch(fixtures::shaftBatch(60)));
}

/// The mean diameter of a zone.
const CharacteristicSummary& diameter(const BatchSummary& summary, std::size_t zone) {
    return summary.characteristics[placesOf(summary, "diameter")[zone]];
}

void show(ChartPlot& plot, const BatchSummary& summary) {
    plot.setGrid([summary] { return BatchCharts::histograms(summary, "diameter", true); });
}

class TestHistogram : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void everyPartStandsInOneBarOfItsZone() {
        const BatchSummary summary = batch();
        const ChartGrid grid = BatchCharts::histograms(summary, "diameter", true);
        QCOMPARE(grid.cells.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const CharacteristicSummary& row = diameter(summary, i);
            const ChartSeries& bars = *grid.cells[i].find(BatchCharts::partsKey);
            double parts = 0;
            for (const XY& bar : bars.points) {
                parts += bar.y;
                QVERIFY(bar.x + bars.barWidth / 2 > row.least.value);
                QVERIFY(bar.x - bars.barWidth / 2 <= row.most.value);
            }
            QCOMPARE(parts, 60.0);
        }
    }

    void limitsAndMeanStandWhereTheyAre() {
        const BatchSummary summary = batch();
        ChartPlot plot;
        show(plot, summary);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::vector<ChartRule>& rules = plot.chart(i).rules;
            QCOMPARE(rules.size(), 3U);
            QCOMPARE(rules[0].at, -16.0);
            QCOMPARE(rules[1].at, 0.0);
            QCOMPARE(rules[2].at, diameter(summary, i).moments.mean);
            QVERIFY(plot.across(i).range().contains(-16));
            QVERIFY(plot.across(i).range().contains(0));
        }
    }

    void allZonesHaveTheSameAxes() {
        ChartPlot plot;
        show(plot, batch());
        plot.across(1).setRange(-12, -4);
        plot.up(2).setRange(0, 99);
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(plot.across(i).range().lower, -12.0);
            QCOMPARE(plot.up(i).range().upper, 99.0);
            QCOMPARE(plot.up(i).tickLabels(), i == 0); // once, beside the first zone
        }
        plot.fit();
        QVERIFY(plot.across().range().contains(-16));
        const int number = QFontMetrics(plot.font()).horizontalAdvance(QStringLiteral("-16"));
        QVERIFY(plot.cell(2).margins().right() >= number / 2); // the last one is not cut off
    }

    void theTableHasTheVisibleBars() {
        ChartPlot plot;
        show(plot, batch());
        double parts = 0;
        for (const std::vector<CsvCell>& row : plot.table().rows) {
            parts += std::get<double>(row.back());
        }
        QCOMPARE(parts, 3 * 60.0);
        plot.across().setRange(100, 200);
        QVERIFY(plot.table().rows.empty());
        plot.fit();
        plot.toggleCurve(BatchCharts::partsKey);
        QVERIFY(plot.table().rows.empty());
        QCOMPARE(plot.table().header.size(), 5);
    }

    // Six cells of a small window, as a plunge with many sections has them.
    void narrowBarsAreNotErasedByTheirGaps() {
        CharacteristicSummary many;
        many.characteristic = {"diameter", "µm", Zone::section, 0, -16.0, 0.0, 0x1p-6};
        constexpr int bars = 40;
        for (int i = 0; i < bars; ++i) {
            const double low = -10 + 0.125 * i;
            many.histogram.push_back({low, low + 0.125, 250});
        }
        many.histogram[20].count = 0;
        BatchSummary summary;
        summary.characteristics.assign(6, many);
        ChartPlot plot;
        plot.resize(900, 300);
        show(plot, summary);
        const auto* drawn = qobject_cast<QCPBars*>(plot.plottable(0));
        for (const double perBar : {0.4, 1.0, 2.0, 3.0, 4.0, 8.0, 20.0}) { // pixels
            plot.replot();
            const double unit = plot.cell().width() / perBar * 0.125;
            plot.across().setRange(-7.5 - unit / 2, -7.5 + unit / 2);
            plot.replot();
            QCOMPARE(drawn->pen().style() == Qt::SolidLine, perBar < 6);
            QVERIFY(perBar > 6 || drawn->pen().color() == drawn->brush().color());
            QCOMPARE(drawn->width(), 0.125);
        }
        QCOMPARE(drawn->data()->size(), bars - 1); // no line where no part is
    }

    void headingsAndAxesNameWhatIsShown() {
        const BatchSummary summary = batch();
        ChartPlot plot;
        plot.resize(900, 300);
        show(plot, summary);
        const QString heading = plot.heading(0)->text();
        QVERIFY(heading.startsWith(QStringLiteral("RZ1")));
        const QString ppk = QString::number(diameter(summary, 0).ppk->value, 'f', 2);
        QVERIFY(heading.endsWith(ppk));
        QCOMPARE(heading, QStringLiteral("RZ1, mean diameter: Ppk ") + ppk);
        QStringList shown; // with more and more room
        for (const int width : {330, 480, 600, 900}) {
            plot.resize(width, 300);
            show(plot, summary);
            shown << plot.heading(0)->text();
        }
        shown.removeDuplicates();
        const QStringList all = plot.chart(0).headings;
        QCOMPARE(all, (QStringList{QStringLiteral("RZ1, mean diameter: Ppk ") + ppk,
                                   QStringLiteral("RZ1, diameter: Ppk ") + ppk,
                                   QStringLiteral("RZ1, Ppk ") + ppk, QStringLiteral("RZ1")}));
        QVERIFY2(shown.size() >= 3, qPrintable(shown.join(u'\n')));
        qsizetype before = all.size();
        for (const QString& text : shown) {
            const qsizetype at = all.indexOf(text);
            QVERIFY2(at >= 0 && at < before, qPrintable(text));
            before = at;
        }
        QCOMPARE(plot.caption()->text(), QStringLiteral("Mean diameter, µm"));
        QCOMPARE(plot.up().label(), QStringLiteral("Parts"));
        const ChartGrid plain = BatchCharts::histograms(summary, "diameter", false);
        QCOMPARE(plain.cells[0].headings, QStringList(QStringLiteral("RZ1")));
        show(plot, {});
        QCOMPARE(plot.cellCount(), 0U);
        plot.fit();
    }
};

} // namespace sparkout::test_histogram

SPARKOUT_TEST(test_histogram, TestHistogram)
#include "test_histogram.moc"
