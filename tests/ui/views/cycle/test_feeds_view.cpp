// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// What the feeds view draws: its curves, bands and columns, in every state and language.
#include "tests/registry.h"
#include "tests/ui/views/cycle/feeds_bench.h"
#include "ui/chart/painted_layer.h"

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout::test_feeds_view {

using namespace feeds_bench;

const std::vector<BandLayer::DrawnName>& drawnNames(const FeedsView& view, int column) {
    return view.plot()->bands(view.plot()->at(column, 0))->drawnNames();
}

QStringList names(const FeedsView& view, int column) {
    QStringList texts;
    for (const BandLayer::DrawnName& name : drawnNames(view, column)) {
        texts << name.text;
    }
    return texts;
}

/// Whether the points of all curves are finite and in order.
bool drawable(const FeedsPlot& plot) {
    for (std::size_t cell = 0; cell < plot.cellCount(); ++cell) {
        for (const ChartSeries& series : plot.chart(cell).series) {
            for (const auto* line : {&series.points, &series.lower}) {
                const bool areFinite = std::ranges::all_of(*line, [](const XY& point) {
                    return std::isfinite(point.x) && std::isfinite(point.y);
                });
                if (!areFinite || !std::ranges::is_sorted(*line, {}, &XY::x)) {
                    return false;
                }
            }
        }
    }
    return true;
}

class TestFeedsView : public FeedsTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void valuesThatAreNoNumbersAreLeftOut() {
        auto outcome = std::make_shared<Outcome>(*m_traverse);
        outcome->trajectory.visits[40].actual_mm = std::nan("");
        outcome->trajectory.visits[5000].radius_mm = std::numeric_limits<double>::infinity();
        outcome->feeds = makeFeedSeries(outcome->result, outcome->trajectory);
        ShownFeeds view(outcome);
        QVERIFY(view.findChild<QLabel*>(QStringLiteral("feedsNotice"))->text().contains(u'2'));
        view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(2);
        QVERIFY(drawable(*view.plot()));
    }

    void curvesAreDrawableAtEveryDetail_data() {
        addColumns<bool, double>("plunge", "share");
        for (bool plunge : {false, true}) {
            for (double share : {1.0, 0.1, 0.03, 0.005, 1e-5}) {
                QTest::addRow("%s, %g of the cycle", plunge ? "plunge" : "traverse", share)
                    << plunge << share;
            }
        }
    }

    void curvesAreDrawableAtEveryDetail() {
        QFETCH(bool, plunge);
        QFETCH(double, share);
        ShownFeeds view(plunge ? m_plunge : m_traverse);
        const double end = view.plot()->series().end_s;
        view.plot()->showTimes(0.3 * end, 0.3 * end + share * 0.7 * end);
        view.plot()->replot();
        QVERIFY(drawable(*view.plot()));
        QVERIFY(!curve(*view.plot(), 0, Quantity::actual)->points.empty());
        for (QCPAxisRect* rect : view.plot()->axisRects()) {
            for (QCPAxis* axis : rect->axes()) {
                QVERIFY(std::isfinite(axis->range().size()) && axis->range().size() > 0);
                QVERIFY(axis->tickVector().size() < 1000);
            }
        }
    }

    void labelsOfNeighbouringColumnsStayApart() {
        FeedsView view;
        view.resize(655, 420);
        show(view, m_traverse);
        FeedsPlot* plot = view.plot();
        const QFontMetrics metrics(plot->font());
        int drawn = 0, leftOut = 0;
        for (double to = 1.0; to < 1000; to *= 1.13) { // minutes at the right edge
            plot->cell(0, 0)->axis(QCPAxis::atBottom)->setRange(0, to);
            plot->replot();
            double end = -1e9;
            for (int column = 0; column < plot->columnCount(); ++column) {
                const QCPAxis* axis = plot->cell(column, 2)->axis(QCPAxis::atBottom);
                const QVector<double> ticks = axis->tickVector();
                for (qsizetype i = 0; i < ticks.size(); ++i) {
                    const QString label = axis->tickVectorLabels()[i];
                    const double middle = axis->coordToPixel(ticks[i]);
                    const double half = metrics.horizontalAdvance(label) / 2.0;
                    if (label.isEmpty()) {
                        ++leftOut;
                        continue;
                    }
                    ++drawn;
                    QVERIFY2(middle - half >= end + 3, qPrintable(label));
                    end = middle + half;
                }
            }
        }
        QVERIFY(drawn > 200 && leftOut > 0);
    }

    void stepsAreNamedWhenOneStrokeIsInSight() {
        ShownFeeds view(m_traverse);
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
            for (const Band& band : view.plot()->chart(view.plot()->at(column, 0)).bands) {
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
        QVERIFY(std::ranges::any_of(legend, [](const LegendEntry& e) {
            return e.text == QStringLiteral("E2 exit dwell");
        }));
    }

    void stagesAreNamedOverTheWholeCycle() {
        ShownFeeds view(m_traverse);
        view.grab();
        for (int column = 0; column < 3; ++column) {
            QCOMPARE(names(view, column),
                     QStringList({QStringLiteral("stage 1"), QStringLiteral("stage 2")}));
        }
    }

    void namesOfBandsStandInOneLineOverTheirBands() {
        Project project = traverseProject();
        project.cycle->stages.insert(project.cycle->stages.begin(), project.cycle->stages[0]);
        project.cycle->stages[0].stock_mm = 0.02;
        project.cycle->stages[1].stock_mm = 0.09;
        ShownFeeds view(run(project));
        for (int width : {380, 520, 700, 1100}) {
            view.resize(width, 620);
            view.grab();
            for (int column = 0; column < 3; ++column) {
                const auto& drawn = drawnNames(view, column);
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

    void pointingAtACurveTellsItsValues() {
        ShownFeeds view(m_traverse);
        view.findChild<QSpinBox*>(QStringLiteral("stroke"))->setValue(27);
        const QRect rect = view.plot()->cell(1, 0)->rect();
        auto* values = view.findChild<QLabel*>(QStringLiteral("feedsValues"));
        hover(view.plot(), rect.topLeft() + QPoint(rect.width() / 3, 20));
        QVERIFY2(values->text().contains(
                     QStringLiteral("NZ, working stroke (E1), stage 1, double stroke 27")),
                 qPrintable(values->text()));
        QVERIFY(values->text().contains(QStringLiteral("programmed 4.00")));
        QVERIFY(view.plot()->toolTip().contains(QStringLiteral("working stroke")));
    }

    void plungeShowsForceAndAtMostFourSections() {
        ShownFeeds view(m_plunge);
        QVERIFY(curve(*view.plot(), 0, Quantity::force));
        QVERIFY(!curve(*view.plot(), 0, Quantity::axialFeed));
        QCOMPARE(view.plot()->columnCount(), 4);
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

    void aChangeOfOperationRebuildsTheGrid() {
        ShownFeeds view(m_traverse);
        show(view, m_plunge);
        QCOMPARE(view.plot()->axisRectCount(), 12);
        show(view, m_traverse);
        QCOMPARE(view.plot()->axisRectCount(), 9);
        QVERIFY(curve(*view.plot(), 0, Quantity::axialFeed));
        QCOMPARE(view.plot()->visibleTo_s(), view.plot()->series().end_s);
    }

    void refusedInputsKeepTheCurvesDimmed() {
        ShownFeeds view(m_traverse);
        const auto points = [&] { return curve(*view.plot(), 0, Quantity::actual)->points.size(); };
        const auto alpha = [&] { return view.plot()->legendEntries().front().colour.alpha(); };
        const auto pointsBefore = points();
        const int alphaBefore = alpha();
        show(view, refused());
        QCOMPARE(points(), pointsBefore);
        QVERIFY(alpha() < alphaBefore / 2);
        auto* notice = view.findChild<QLabel*>(QStringLiteral("feedsNotice"));
        QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("5000")));
        show(view, m_traverse);
        QCOMPARE(alpha(), alphaBefore);
        QVERIFY(!notice->isVisible());
    }

    void withoutAResultTheViewSaysSo() {
        FeedsView view;
        view.show();
        auto* notice = view.findChild<QLabel*>(QStringLiteral("feedsNotice"));
        QCOMPARE(notice->text(), QStringLiteral("No result yet."));
        show(view, refused());
        QVERIFY(notice->text().startsWith(QStringLiteral("The inputs are refused:")));
        QVERIFY(!view.plot()->isVisible());
        show(view, OutcomePtr());
        QCOMPARE(notice->text(), QStringLiteral("No result yet."));
    }

    void anotherLanguageReachesEveryText() {
        ShownFeeds view(m_traverse);
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
        QVERIFY(marked(view.plot()->chart().bands.front().name));
        for (QWidget* widget : view.findChildren<QWidget*>()) {
            if (!widget->accessibleName().isEmpty()) {
                QVERIFY(marked(widget->accessibleName()));
            }
        }
        QApplication::removeTranslator(&marking);
        QCoreApplication::processEvents();
        QCOMPARE(span->itemText(0), QStringLiteral("Whole cycle"));
    }

    void aNewOutcomeIsDrawnQuickly() {
        ShownFeeds view(m_traverse);
        double best = 1e9;
        for (int i = 0; i < 10; ++i) {
            show(view, m_traverse);
            best = std::min(best, view.lastUpdate_ms());
        }
        qInfo("filling and replot: %.1f ms for %lld visits", best, m_traverse->result.visits);
        QVERIFY(best < 100); // four times the bound of a release build
    }
};

} // namespace sparkout::test_feeds_view

SPARKOUT_TEST(test_feeds_view, TestFeedsView)
#include "test_feeds_view.moc"
