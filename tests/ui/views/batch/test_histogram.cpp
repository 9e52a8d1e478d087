// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/batch/histogram_plot.h"

namespace sparkout::test_histogram {

/// The mean diameter of the three zones of a batch.
std::vector<CharacteristicSummary> diameters(int parts) {
    std::vector<CharacteristicSummary> found;
    for (CharacteristicSummary& row :
         summarise(runBatch(fixtures::shaftBatch(parts))).characteristics) {
        if (std::string(row.characteristic.name) == "diameter") {
            found.push_back(std::move(row));
        }
    }
    return found;
}

class TestHistogram : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    /// All have the same axis of counts: its numbers stand once.
    void theNumbersOfPartsStandBesideTheFirstZone() {
        HistogramPlot plot;
        plot.setSummaries(diameters(60));
        plot.resize(600, 300);
        plot.grab();
        for (int cell = 0; cell < 3; ++cell) {
            const QCPAxis* counts = plot.axisRects()[cell]->axis(QCPAxis::atLeft);
            QCOMPARE(counts->tickLabels(), cell == 0);
            QCOMPARE(counts->range(), plot.axisRects()[0]->axis(QCPAxis::atLeft)->range());
        }
    }

    void everyPartStandsInOneBarOfItsZone() {
        const auto rows = diameters(60);
        HistogramPlot plot;
        plot.setSummaries(rows);
        QCOMPARE(plot.cellCount(), 3);
        for (int i = 0; i < 3; ++i) {
            const CharacteristicSummary& row = rows[static_cast<std::size_t>(i)];
            double parts = 0;
            for (const QCPBarsData& bar : *plot.bars(i)->data()) {
                parts += bar.value;
                const double half = plot.bars(i)->width() / 2;
                QVERIFY(bar.key + half > row.least.value || bar.value == 0);
                QVERIFY(bar.key - half <= row.most.value || bar.value == 0);
            }
            QCOMPARE(parts, 60.0);
        }
    }

    void limitsAndMeanStandWhereTheyAre() {
        const auto rows = diameters(60);
        HistogramPlot plot;
        plot.setSummaries(rows);
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(plot.low(i)->point1->key(), -16.0);
            QCOMPARE(plot.high(i)->point1->key(), 0.0);
            QCOMPARE(plot.mean(i)->point1->key(), rows[static_cast<std::size_t>(i)].moments.mean);
            QVERIFY(plot.valueAxis(i)->range().contains(-16));
            QVERIFY(plot.valueAxis(i)->range().contains(0));
        }
    }

    void allZonesHaveTheSameAxes() {
        HistogramPlot plot;
        plot.setSummaries(diameters(60));
        plot.valueAxis(1)->setRange(-12, -4);
        plot.countAxis(2)->setRange(0, 99);
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(plot.valueAxis(i)->range().lower, -12.0);
            QCOMPARE(plot.countAxis(i)->range().upper, 99.0);
        }
        plot.fit();
        QVERIFY(plot.valueAxis(0)->range().contains(-16));
    }

    // Six cells of a small window, as a plunge with many sections has them.
    void narrowBarsAreNotErasedByTheirOutlines() {
        CharacteristicSummary many;
        many.characteristic = {"diameter", "µm", Zone::section, 0, -16.0, 0.0, 0x1p-6};
        constexpr int bars = 40;
        for (int i = 0; i < bars; ++i) {
            const double low = -10 + 0.125 * i;
            many.histogram.push_back({low, low + 0.125, 250});
        }
        many.histogram[20].count = 0;
        HistogramPlot plot;
        plot.setSummaries(std::vector(6, many));
        for (const double perBar : {0.4, 1.0, 2.0, 3.0, 4.0, 8.0, 20.0}) { // pixels
            plot.resize(900, 300);
            plot.replot();
            const double unit = plot.valueAxis(0)->axisRect()->width() / perBar * 0.125;
            plot.valueAxis(0)->setRange(-7.5 - unit / 2, -7.5 + unit / 2);
            for (int settling = 0; settling < 3; ++settling) { // the room of other numbers
                plot.replot();
            }
            const QColor fill = plot.bars(0)->brush().color();
            QCOMPARE(plot.bars(0)->pen().color() == fill, perBar < 6);
            QVERIFY(perBar < 6
                    || plot.bars(0)->pen().color() == plot.palette().color(QPalette::Base));
        }
        QCOMPARE(plot.bars(0)->data()->size(), bars - 1); // nor an outline where no part is
    }

    void headingsAndAxesNameWhatIsShown() {
        const auto rows = diameters(60);
        HistogramPlot plot;
        plot.setSummaries(rows);
        QVERIFY(plot.heading(0).startsWith(QStringLiteral("RZ1")));
        QVERIFY(plot.heading(0).endsWith(QString::number(rows[0].ppk->value, 'f', 2)));
        plot.nameIndices(true); // the verdict states the Ppk of another characteristic
        plot.setSummaries(rows);
        QCOMPARE(plot.heading(0),
                 QStringLiteral("RZ1, mean diameter: Ppk ") + BatchText::brief(*rows[0].ppk));
        QCOMPARE(plot.valueAxis(0)->label(), QStringLiteral("Mean diameter, µm"));
        QCOMPARE(plot.countAxis(0)->label(), QStringLiteral("Parts"));
        plot.setSummaries({});
        QCOMPARE(plot.cellCount(), 0);
        plot.fit();
    }
};

} // namespace sparkout::test_histogram

SPARKOUT_TEST(test_histogram, TestHistogram)
#include "test_histogram.moc"
