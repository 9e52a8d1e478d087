// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of bars: what Qt Charts draws stands where it is said to stand, numbers never meet, and a
// chart is told, tabulated and told apart without colours.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/bar_plot.h"
#include "ui/chart/plot_tools.h"
#include "ui/kit/theme.h"

#include <QBarSeries>
#include <QBarSet>
#include <QChart>
#include <QGraphicsRectItem>
#include <QGraphicsScene>
#include <QImage>
#include <QPainter>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace sparkout::test_bar_chart {

using Shape = BarChart::Shape;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
const QSize size(360, 260);

BarChart chartOf(Shape shape, bool isLying, int categories, int series) {
    BarChart chart;
    chart.shape = shape;
    chart.isLying = isLying;
    chart.what = QStringLiteral("What");
    chart.axis = QStringLiteral("Time");
    chart.unit = QStringLiteral("min");
    for (int c = 0; c < categories; ++c) {
        chart.categories << QStringLiteral("Category %1").arg(c + 1);
    }
    for (int s = 0; s < series; ++s) {
        BarSeries bars{QStringLiteral("Series %1").arg(s + 1),
                       barColour(style::oneOfSeries(std::size_t(s))),
                       hatchAt(std::size_t(s)),
                       {}};
        for (int c = 0; c < categories; ++c) {
            bars.values.push_back((s % 3 == 1 ? -0.7 : 1.3) * (1 + c % 4) + 0.1 * s);
        }
        chart.series.push_back(std::move(bars));
    }
    return chart;
}

struct Drawn {
    explicit Drawn(BarChart chart, QSize of = size, QStringList* texts = nullptr) {
        drawing.setChart(std::move(chart));
        drawing.setLook({paletteOf(Theme::light), QApplication::font(), false});
        image = QImage(of, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        drawing.paint(painter, of);
        if (texts) {
            *texts = drawing.texts();
        }
    }
    BarDrawing drawing;
    QImage image;
};

/// Rectangles of the bars among the items of the scene.
std::vector<QRectF> rectsOf(const BarDrawing& drawing) {
    std::vector<QRectF> rects;
    QChart* const chart = drawing.scene().chart();
    for (QGraphicsItem* item : chart->scene()->items()) {
        if (auto* rect = dynamic_cast<QGraphicsRectItem*>(item)) {
            rects.push_back(rect->mapRectToScene(rect->rect()));
        }
    }
    return rects;
}

class TestBarChart : public QObject {
    Q_OBJECT

private slots:
    void everyBarStandsWhereQtChartsDrawsIt_data() {
        addColumns<int, bool, int, int, bool>("shape", "lying", "categories", "series", "second");
        for (const bool lying : {false, true}) {
            for (const int series : {1, 2, 5}) {
                QTest::addRow("stacked %d %d", lying, series)
                    << int(Shape::stacked) << lying << 4 << series << false;
                QTest::addRow("grouped %d %d", lying, series)
                    << int(Shape::grouped) << lying << 3 << series << false;
            }
        }
        QTest::addRow("two axes") << int(Shape::grouped) << false << 4 << 2 << true;
        QTest::addRow("one category") << int(Shape::stacked) << false << 1 << 3 << false;
    }

    void everyBarStandsWhereQtChartsDrawsIt() {
        QFETCH(int, shape);
        QFETCH(bool, lying);
        QFETCH(int, categories);
        QFETCH(int, series);
        QFETCH(bool, second);
        BarChart chart = chartOf(Shape(shape), lying, categories, series);
        if (second) {
            chart.series[1].onSecond = true;
            chart.secondAxis = QStringLiteral("Margin");
        }
        const Drawn of(chart);
        QCOMPARE(of.drawing.parts().size(), std::size_t(categories * series));
        const std::vector<QRectF> rects = rectsOf(of.drawing);
        for (const BarPart& part : of.drawing.parts()) {
            const auto same = [&part](const QRectF& rect) {
                return std::abs(rect.left() - part.rect.left()) < 0.6
                       && std::abs(rect.right() - part.rect.right()) < 0.6
                       && std::abs(rect.top() - part.rect.top()) < 0.6
                       && std::abs(rect.bottom() - part.rect.bottom()) < 0.6;
            };
            QVERIFY2(
                std::ranges::any_of(rects, same),
                qPrintable(
                    QStringLiteral("series %1, category %2").arg(part.series).arg(part.category)));
            QCOMPARE(of.drawing.partAt(part.rect.center()), int(&part - of.drawing.parts().data()));
        }
    }

    /// Between a new chart and its painting no bar of the old one can be chosen.
    void barsOfTheChartBeforeAreGone() {
        BarPlot plot;
        plot.resize(size);
        plot.setChart(chartOf(Shape::stacked, false, 5, 2));
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot));
        plot.setFocus();
        plot.replot();
        QCOMPARE(plot.drawing().parts().size(), std::size_t(10));
        QTest::keyClick(&plot, Qt::Key_Right);
        QPointF last = plot.drawing().parts().back().rect.center();
        int entered = 0;
        connect(&plot, &BarPlot::entered, this, [&entered] { ++entered; });
        plot.setChart(chartOf(Shape::stacked, false, 1, 1));
        QCOMPARE(plot.drawing().partAt(last), -1);
        QTest::mouseMove(&plot, last.toPoint());
        QTest::mouseClick(&plot, Qt::LeftButton, {}, last.toPoint());
        QCOMPARE(entered, 0);
    }

    void valuesChangeInPlace() {
        Drawn of(chartOf(Shape::stacked, true, 4, 3));
        const QChart* const before = of.drawing.scene().chart();
        BarChart other = chartOf(Shape::stacked, true, 4, 3);
        other.series[0].values[2] = 9.5;
        QPainter painter(&of.image);
        of.drawing.setChart(other);
        of.drawing.paint(painter, size);
        QCOMPARE(of.drawing.scene().chart(), before);
        const auto* bars = qobject_cast<QAbstractBarSeries*>(of.drawing.scene().series().front());
        QCOMPARE(bars->barSets()[0]->at(1), 9.5); // of lying ones the last is the first
        of.drawing.setChart(chartOf(Shape::stacked, true, 5, 3));
        of.drawing.paint(painter, size);
        QCOMPARE(of.drawing.parts().size(), std::size_t(15));
    }

    void axesFollowAnotherSize() {
        for (const bool lying : {false, true}) {
            Drawn of(chartOf(Shape::stacked, lying, 4, 3));
            QImage larger(640, 420, QImage::Format_RGB32);
            larger.fill(Qt::white);
            QPainter painter(&larger);
            of.drawing.paint(painter, larger.size());
            painter.end();
            const QImage anew = Drawn(chartOf(Shape::stacked, lying, 4, 3), larger.size()).image;
            QCOMPARE(larger, anew);
        }
    }

    void theAxisHasRoundStepsAndHoldsAllBars() {
        for (const double scale : {1e-4, 0.03, 1.0, 77.0, 12345.0}) {
            BarChart chart = chartOf(Shape::stacked, false, 4, 3);
            for (BarSeries& series : chart.series) {
                for (double& value : series.values) {
                    value *= scale;
                }
            }
            const BarScale axis = scalesOf(chart, 5).first;
            const double digits =
                axis.step / std::pow(10, std::floor(std::log10(axis.step) + 1e-9));
            QVERIFY(std::abs(digits - 1) < 1e-6 || std::abs(digits - 2) < 1e-6
                    || std::abs(digits - 5) < 1e-6);
            for (std::size_t c = 0; c < 4; ++c) {
                double up = 0, down = 0;
                for (std::size_t s = 0; s < 3; ++s) {
                    (chart.value(s, c) < 0 ? down : up) += chart.value(s, c);
                }
                QVERIFY(axis.low() <= down && up <= axis.high());
            }
            QVERIFY(axis.below + axis.above <= 12);
        }
    }

    void bothAxesHaveTheirZeroAtTheSameHeight() {
        BarChart chart = chartOf(Shape::grouped, false, 3, 2);
        chart.series[1].onSecond = true;
        chart.series[1].values = {-40, 55, 3};
        const BarScales scales = scalesOf(chart, 4);
        QCOMPARE(scales.first.share(0), scales.second.share(0));
        QVERIFY(scales.second.low() <= -40 && scales.second.high() >= 55);
    }

    void noTextMeetsAnother_data() {
        QTest::addColumn<QSize>("of");
        for (const QSize of : {QSize(160, 110), QSize(230, 160), size, QSize(800, 500)}) {
            QTest::addRow("%d × %d", of.width(), of.height()) << of;
        }
    }

    void noTextMeetsAnother() {
        QFETCH(QSize, of);
        for (const Shape shape : {Shape::stacked, Shape::grouped, Shape::ring}) {
            for (const bool lying : {false, true}) {
                BarChart chart = chartOf(shape, lying, shape == Shape::ring ? 1 : 6, 4);
                for (BarSeries& series : chart.series) {
                    for (double& value : series.values) {
                        value = shape == Shape::ring ? std::abs(value) : value;
                    }
                }
                chart.hasTotals = shape == Shape::stacked;
                const Drawn drawn(chart, of);
                const std::vector<QRectF>& taken = drawn.drawing.numberBoxes();
                for (std::size_t i = 0; i < taken.size(); ++i) {
                    for (std::size_t k = i + 1; k < taken.size(); ++k) {
                        QVERIFY(!taken[i].intersects(taken[k]));
                    }
                }
            }
        }
    }

    /// Beside the mark that it is the number of, not at the other end of the stack.
    void theSumOfAStackBelowZeroStandsBelowIt() {
        BarChart chart = chartOf(Shape::stacked, false, 3, 2);
        chart.series[0].values = {-6, -7, -5};
        chart.series[1].values = {-2, -1, -3};
        chart.sums = {-8, -8, -8};
        chart.number = [](double value) { return QString::number(value, 'f', 3); };
        QStringList texts;
        const Drawn drawn(chart, {520, 360}, &texts);
        QRectF stacks[3];
        for (const BarPart& part : drawn.drawing.parts()) {
            stacks[part.category] |= part.rect;
        }
        for (const QRectF& stack : stacks) {
            QVERIFY(std::ranges::any_of(drawn.drawing.numberBoxes(), [&](const QRectF& box) {
                return std::abs(box.center().x() - stack.center().x()) < 2
                       && box.top() >= stack.bottom() && box.top() < stack.bottom() + 8;
            }));
        }
        QCOMPARE(texts.filter(QStringLiteral("8.000")).size(), 3);
    }

    /// Where parts reach far beyond a sum, a number at their end would be taken for theirs.
    void sumsWithinTheirStacksStandInRows() {
        for (const int width : {520, 190}) { // wide, and with no room side by side
            BarChart chart = chartOf(Shape::stacked, false, 4, 2);
            chart.series[0].values = {8.29, 8.29, 8.29, 8.29};
            chart.series[1].values = {-8.55, -4.49, 0.73, 5.4};
            chart.sums = {-0.26, 3.8, 9.02, 13.69};
            chart.number = [](double value) { return QString::number(value, 'f', 2); };
            QStringList texts;
            const Drawn drawn(chart, {width, 360}, &texts);
            for (const char* sum : {"-0.26", "3.80", "9.02", "13.69"}) {
                QCOMPARE(texts.filter(QLatin1String(sum)).size(), 1);
            }
            QRectF first;
            for (const BarPart& part : drawn.drawing.parts()) {
                first = part.category == 0 ? first | part.rect : first;
            }
            QVERIFY(std::ranges::none_of(drawn.drawing.numberBoxes(), [&](const QRectF& box) {
                return std::abs(box.center().x() - first.center().x()) < 2
                       && box.top() >= first.bottom() && box.top() < first.bottom() + 8;
            }));
        }
    }

    void theNameOfAnAxisIsReadInFullAtTheLeastHeight() {
        BarChart chart = chartOf(Shape::grouped, false, 3, 2);
        chart.axis = QStringLiteral("Time that a long name is given, of all");
        chart.series[1].onSecond = true;
        chart.secondAxis = QStringLiteral("Margin of the nearest requirement, least of all");
        chart.secondUnit = QStringLiteral("%");
        QStringList texts;
        const Drawn drawn(chart, {640, BarDrawing::leastHeight(chart, QApplication::font())},
                          &texts);
        QVERIFY2(texts.contains(chart.axisText()), qPrintable(texts.join(u'\n')));
        QVERIFY2(texts.contains(chart.secondAxisText()), qPrintable(texts.join(u'\n')));
    }

    void whereThereIsRoomEveryBarHasItsNumber() {
        BarChart chart = chartOf(Shape::grouped, true, 3, 1);
        chart.series[0].values = {1.25, 2.5, 3.75};
        QStringList texts;
        const Drawn drawn(chart, {600, 300}, &texts);
        for (const double value : chart.series[0].values) {
            QVERIFY2(texts.contains(chart.numberText(value)), qPrintable(texts.join(u' ')));
        }
    }

    /// In smaller type, as under standing bars.
    void aLongNameBesideALyingBarIsReadInFull() {
        BarChart chart = chartOf(Shape::stacked, true, 3, 1);
        QString name = QStringLiteral("Minimum overlap, stage 2");
        while (QFontMetrics(QApplication::font()).horizontalAdvance(name) < size.width() / 2) {
            name += u'0';
        }
        chart.categories[1] = name;
        QStringList texts;
        const Drawn drawn(chart, size, &texts);
        QVERIFY2(texts.contains(name), qPrintable(texts.join(u'\n')));
    }

    void noNumberStandsOnTheLineOfALimit_data() {
        addColumns<bool, bool>("lying", "totals");
        for (const bool lying : {false, true}) {
            for (const bool totals : {false, true}) {
                QTest::addRow("%s, %s", lying ? "lying" : "standing", totals ? "sums" : "values")
                    << lying << totals;
            }
        }
    }

    void noNumberStandsOnTheLineOfALimit() {
        QFETCH(bool, lying);
        QFETCH(bool, totals);
        BarChart chart = chartOf(totals ? Shape::stacked : Shape::grouped, lying, 7, 1);
        chart.series[0].values = {99.5, 97, 92, 88, 83, 100, 40};
        chart.limits = {{100, QStringLiteral("limit"), Qt::DashLine, {}}};
        chart.most = 150;
        chart.hasTotals = totals;
        QStringList texts;
        const Drawn drawn(chart, {640, 420}, &texts);
        const QRectF full = drawn.drawing.parts()[5].rect; // it ends at the limit
        QRectF bars;
        for (const BarPart& part : drawn.drawing.parts()) {
            bars |= part.rect;
        }
        int numbers = 0;
        for (const QRectF& box : drawn.drawing.numberBoxes()) {
            const QPointF at = box.center();
            if (lying ? at.y() < bars.bottom() : at.x() > bars.left()) { // else of the axis
                ++numbers;
                QVERIFY(lying ? box.right() <= full.right() || box.left() >= full.right()
                              : box.bottom() <= full.top() || box.top() >= full.top());
            }
        }
        QCOMPARE(numbers, 7);
    }

    void aCutBarTellsItsWholeValue() {
        BarChart chart = chartOf(Shape::stacked, true, 2, 1);
        chart.series[0].values = {50, 4321};
        chart.most = 200;
        chart.hasTotals = true;
        QStringList texts;
        const Drawn drawn(chart, {600, 200}, &texts);
        QVERIFY(texts.contains(chart.numberText(4321)));
        QVERIFY(drawn.drawing.parts()[1].rect.width()
                < 4.5 * drawn.drawing.parts()[0].rect.width());
    }

    void barsAreToldApartWithoutColours() {
        BarChart chart = chartOf(Shape::stacked, true, 1, 5);
        for (BarSeries& series : chart.series) {
            series.values = {1};
            series.colour = barColour(Tone::blue);
        }
        const Drawn drawn(chart, {700, 160});
        std::set<QByteArray> looks;
        for (const BarPart& part : drawn.drawing.parts()) {
            QRect middle(0, 0, 24, 24);
            middle.moveCenter(part.rect.center().toPoint() - QPoint(28, 0)); // beside its number
            const QImage look = drawn.image.copy(middle).convertToFormat(QImage::Format_Grayscale8);
            int light = 0;
            for (int y = 0; y < look.height(); ++y) {
                for (int x = 0; x < look.width(); ++x) {
                    light += qGray(look.pixel(x, y)) > 160 ? 1 : 0;
                }
            }
            looks.insert(
                QByteArray(reinterpret_cast<const char*>(look.constBits()), look.sizeInBytes()));
            QVERIFY(light < 24 * 24 / 2);
        }
        QCOMPARE(looks.size(), std::size_t(5));
    }

    void aHiddenSeriesIsNeitherDrawnNorTabulated() {
        BarPlot plot;
        plot.resize(size);
        plot.setChart(chartOf(Shape::stacked, false, 3, 3));
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot));
        plot.replot();
        QCOMPARE(plot.drawing().parts().size(), std::size_t(9));
        plot.toggleCurve(1);
        plot.replot();
        QCOMPARE(plot.drawing().parts().size(), std::size_t(6));
        for (const BarPart& part : plot.drawing().parts()) {
            QVERIFY(part.series != 1);
        }
        QCOMPARE(plot.table().header.size(), qsizetype(3));
        QVERIFY(!plot.legendEntries()[1].shown);
        plot.showOnly(2);
        plot.replot();
        QCOMPARE(plot.drawing().parts().size(), std::size_t(3));
    }

    /// Of stacks their height, of bars side by side the longest; those of a second axis stay.
    void timesAreAllInTheUnitOfTheLongest() {
        BarChart chart = chartOf(Shape::stacked, false, 1, 2);
        chart.series[0].values = {70};
        chart.series[1].values = {49};
        chart.fitTimeUnit();
        QCOMPARE(chart.unit, QStringLiteral("s"));
        QCOMPARE(chart.value(0, 0), 70.0);
        chart.series[1].values = {50};
        chart.fitTimeUnit();
        QCOMPARE(chart.unit, QStringLiteral("min"));
        QCOMPARE(chart.total(0), 2.0);
        BarChart beside = chartOf(Shape::grouped, false, 1, 2);
        beside.series[0].values = {70};
        beside.series[1].values = {300};
        beside.series[1].onSecond = true;
        beside.limits = {{119, QStringLiteral("limit")}};
        beside.fitTimeUnit();
        QCOMPARE(beside.unit, QStringLiteral("s"));
        beside.limits = {{120, QStringLiteral("limit")}};
        beside.fitTimeUnit();
        QCOMPARE(beside.unit, QStringLiteral("min"));
        QCOMPARE(beside.limits[0].at, 2.0);
        QCOMPARE(beside.value(1, 0), 300.0);
    }

    void aTableHasEveryValueWithAllItsDigits() {
        BarChart chart = chartOf(Shape::stacked, false, 3, 2);
        chart.series[0].values[1] = 1.0 / 3;
        chart.series[1].values[2] = none;
        const CsvTable table = chart.table([](std::size_t) { return true; });
        QCOMPARE(table.header,
                 QStringList({QStringLiteral("What"), QStringLiteral("Time: Series 1, min"),
                              QStringLiteral("Time: Series 2, min")}));
        QCOMPARE(std::get<double>(table.rows[1][1]), 1.0 / 3);
        QVERIFY(std::holds_alternative<std::monostate>(table.rows[2][2]));
    }

    void aBarIsChosenReadAndEnteredByKeyboard() {
        BarPlot plot;
        PlotSubject subject;
        subject.heading = [] { return QStringList(QStringLiteral("Chart")); };
        plot.addTools(std::move(subject), nullptr);
        plot.resize(size);
        plot.setChart(chartOf(Shape::stacked, true, 3, 2));
        plot.show();
        QVERIFY(QTest::qWaitForWindowActive(&plot));
        plot.replot();
        plot.setFocus(Qt::TabFocusReason);
        QStringList told;
        std::vector<std::pair<std::size_t, std::size_t>> entered;
        connect(&plot, &ViewPlot::pointed, this, [&told](const QString& text) { told << text; });
        connect(&plot, &BarPlot::entered, this,
                [&entered](std::size_t s, std::size_t c) { entered.emplace_back(s, c); });
        QTest::keyClick(&plot, Qt::Key_Down);
        QTest::keyClick(&plot, Qt::Key_Down);
        QTest::keyClick(&plot, Qt::Key_Return);
        QCOMPARE(entered.size(), std::size_t(1));
        const auto [series, category] = entered.front();
        QCOMPARE(told.last(), plot.chart().described(series, category));
        QCOMPARE(plot.accessibleDescription(), told.last());
        QVERIFY(told.last().endsWith(QChar(0xa0) + plot.chart().unit)); // they stay on one line
        QTest::keyClick(&plot, Qt::Key_Up);
        QVERIFY(told.last() != plot.chart().described(series, category));
        for (int i = 0; i < 20; ++i) {
            QTest::keyClick(&plot, Qt::Key_Right); // the end holds
        }
        QTest::keyClick(&plot, Qt::Key_Space);
        QCOMPARE(entered.size(), std::size_t(2));
    }

    void aDrawingIsVectorsInSvgAndPdf() {
        BarPlot plot;
        plot.resize(size);
        plot.setChart(chartOf(Shape::stacked, true, 3, 3));
        const PlotPicture picture{&plot, {QStringLiteral("Chart")}, plot.legendEntries()};
        const QByteArray svg = svgWork(picture)();
        QXmlStreamReader reader(svg);
        int paths = 0, images = 0, texts = 0;
        while (!reader.atEnd()) {
            if (reader.readNext() == QXmlStreamReader::StartElement) {
                paths += reader.name() == u"path" ? 1 : 0;
                images += reader.name() == u"image" ? 1 : 0;
                texts += reader.name() == u"text" ? 1 : 0;
            }
        }
        QVERIFY(!reader.hasError());
        QVERIFY(paths > 9 && texts > 6);
        QCOMPARE(images, 0);
        QVERIFY(pdfWork(picture)().startsWith("%PDF"));
        QVERIFY(pngWork(picture, 2)().startsWith("\x89PNG"));
    }
};

} // namespace sparkout::test_bar_chart

SPARKOUT_TEST(test_bar_chart, TestBarChart)
#include "test_bar_chart.moc"
