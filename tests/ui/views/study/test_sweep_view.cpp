// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The view "Sweep": chosen, run, stopped and taken from with mouse and keys; its curves are the
// sweep's; a project from which the varied stage has gone does no harm.
#include "core/project/number_input.h"
#include "core/study/outcome.h"
#include "core/study/sweep_edits.h"
#include "tests/check_line.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/ready_made.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "ui/chart/chart_plot.h"
#include "ui/chart/plot_tools.h"
#include "ui/form/number_field.h"
#include "ui/kit/search_combo.h"
#include "ui/session/document.h"
#include "ui/session/project_io.h"
#include "ui/views/study/sweep_charts.h"
#include "ui/views/study/sweep_shown.h"
#include "ui/views/study/sweep_view.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sparkout::test_sweep_view {

constexpr int patience_ms = 60'000;
const std::string dullness = "/wheel/dullness";

Project shaft() {
    Project project = fixtures::traverse();
    project.part->tolerance.radial_runout_um = 6;
    return project;
}

Project swept(Project project, std::vector<SweepAxis> axes) {
    project.sweep = Sweep{std::move(axes)};
    return project;
}

/// Too many points to run by itself.
Project endless() {
    Project project = shaft();
    project.part->radii_per_section = 180;
    return swept(project, {{dullness, 0.005, 0.06, 101}, {"/part/stock_mm", 0.1, 0.3, 101}});
}

/// A view with a document, as in the window.
struct Bench {
    explicit Bench(const Project& project) {
        view.resize(760, 620);
        QObject::connect(&view, &SweepView::editWanted, &view,
                         [this](const auto& edit, const EditText& text) {
                             document.endMerge();
                             document.edit(edit(document.project()), text);
                         });
        QObject::connect(&document, &Document::changed, &view, [this] { give(); });
        document.startUntitled(project);
        view.show();
        QTest::qWait(20);
    }
    void give() { view.setOutcome(evaluate(document.project(), {})); }
    [[nodiscard]] bool settled() {
        QTest::qWait(20);
        return QTest::qWaitFor([this] { return view.sweep() && !view.busy() && !view.stale(); },
                               patience_ms);
    }
    template <typename Widget>
    [[nodiscard]] Widget& part(const char* name) {
        return *view.findChild<Widget*>(QString::fromLatin1(name));
    }
    void click(const char* button) {
        QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton);
    }
    /// By keyboard: from the top of the list to the entry of an input.
    void choose(const char* box, const QString& label) {
        auto& combo = part<QComboBox>(box);
        combo.setFocus();
        const int at = combo.findText(label, Qt::MatchStartsWith);
        QVERIFY2(at > 0, qPrintable(label));
        QTest::keyClick(&combo, Qt::Key_Home);
        QTest::qWait(1);
        for (int i = combo.currentIndex(); i < at; ++i) {
            combo.blockSignals(i + 1 < at); // what is passed over is not meant
            QTest::keyClick(&combo, Qt::Key_Down);
        }
        combo.blockSignals(false);
    }
    void type(const char* field, const QString& text) {
        auto& line = part<NumberField>(field);
        QTest::mouseClick(&line, Qt::LeftButton);
        line.selectAll();
        QTest::keyClicks(&line, text);
        QTest::keyClick(&line, Qt::Key_Return);
    }
    /// Both axes have equal steps, or the second one has equal ratios.
    void clickPoint(ChartPlot& plot, std::size_t point) {
        plot.replot();
        const std::vector<double> values = view.sweep()->valuesAt(point);
        const bool isMap = values.size() > 1;
        const bool hasRatios =
            isMap && view.sweep()->inputs[1].axis.spacing == SweepSpacing::logarithmic;
        const double up = !isMap      ? plot.up().range().center()
                          : hasRatios ? std::log10(values[1])
                                      : values[1];
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.pixelOf({values[0], up}).toPoint());
    }
    Document document;
    SweepView view;
};

class TestSweepView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void withoutASweepItSaysWhatToDoAndStartsOneAtAClick() {
        Bench bench(shaft());
        QVERIFY(bench.part<QLabel>("sweepNotice").text().contains(QStringLiteral("dull wheel")));
        QVERIFY(!bench.part<QPushButton>("sweepRun").isVisible());
        bench.click("sweepAdd");
        QVERIFY(bench.settled());
        const SweepAxis& axis = bench.document.project().sweep->inputs.front();
        QCOMPARE(axis.input, dullness);
        QCOMPARE(axis.from, 0.01);
        QCOMPARE(axis.to, 0.04);
        QVERIFY(!bench.part<QLabel>("sweepNotice").isVisible());
        bench.document.undo();
        QVERIFY(!bench.document.project().sweep);
        QTRY_VERIFY(!bench.view.sweep());
    }

    void everyInputHasANameOfItsOwn() {
        const auto read = loadProject(
            QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/projects/everything.sparkout"));
        Bench bench(read.setup.value().surfaces.front().project);
        const auto& box = bench.part<QComboBox>("sweep1Input");
        std::set<QString> names;
        for (int i = 0; i < box.count(); ++i) {
            QVERIFY2(names.insert(box.itemText(i)).second, qPrintable(box.itemText(i)));
        }
        QVERIFY(names.size() > 60);
    }

    void anInputIsFoundByTypingItsSymbolOrItsKey() {
        Bench bench(shaft());
        auto& box = bench.part<SearchCombo>("sweep1Input");
        auto* search = box.findChild<QLineEdit*>(QStringLiteral("search"));
        for (const char* text : {"dull", "wheel/dullness"}) {
            QTest::keyClicks(&box, QString::fromLatin1(text).left(1));
            QTest::keyClicks(search, QString::fromLatin1(text).mid(1));
            QTest::keyClick(search, Qt::Key_Return);
            QCOMPARE(box.currentText(), QStringLiteral("Wheel › Dullness"));
            QVERIFY(bench.document.project().sweep);
            QCOMPARE(bench.document.project().sweep->inputs.front().input, dullness);
            bench.document.undo();
            QVERIFY(!bench.document.project().sweep);
        }
    }

    void anInputIsChosenByKeyboardAndItsRangeTyped() {
        Bench bench(shaft());
        bench.choose("sweep1Input", QStringLiteral("Wheel › Dullness"));
        QVERIFY(bench.settled());
        QCOMPARE(bench.document.project().sweep->inputs.front().input, dullness);
        bench.type("sweep1To", QStringLiteral("0,05"));
        QVERIFY(bench.settled());
        QCOMPARE(bench.document.project().sweep->inputs.front().to, 0.05);
        QCOMPARE(bench.view.sweep()->inputs[0].values.back(), 0.05);
        // Beyond what a dullness may be nothing is taken; backwards it says so.
        bench.type("sweep1To", QStringLiteral("-3"));
        QVERIFY(bench.part<NumberField>("sweep1To").refused());
        QCOMPARE(bench.document.project().sweep->inputs.front().to, 0.05);
        QTest::keyClick(&bench.part<NumberField>("sweep1To"), Qt::Key_Escape);
        bench.type("sweep1From", QStringLiteral("0.06"));
        QTRY_VERIFY(bench.part<QLabel>("sweepNotice").text().contains(QStringLiteral("0.05")));
        QVERIFY(!bench.part<QPushButton>("sweepRun").isEnabled());
        bench.document.undo();
        QVERIFY(bench.settled());
    }

    // The sweep that undo dropped may not have ended yet when the same is chosen again.
    void theSameInputChosenAgainAfterAnUndoIsRun() {
        Project slow = shaft(); // a second or so, still run by itself
        slow.part->radii_per_section = 180;
        for (const Project& project : {shaft(), slow}) {
            for (const bool finished : {true, false}) {
                Bench bench(project);
                for (int i = 0; i < 3; ++i) {
                    bench.choose("sweep1Input", QStringLiteral("Wheel › Dullness"));
                    QCOMPARE(bench.document.project().sweep->inputs.front().input, dullness);
                    if (finished) {
                        QVERIFY(bench.settled());
                    }
                    bench.document.undo();
                    QVERIFY(!bench.document.project().sweep);
                    if (finished) {
                        QTRY_VERIFY(!bench.view.sweep());
                    }
                }
                bench.choose("sweep1Input", QStringLiteral("Wheel › Dullness"));
                QVERIFY(bench.settled());
                QVERIFY(bench.view.curves()->isVisible());
                QVERIFY(bench.view.curves()->chart().find(0));
                QVERIFY(!bench.part<QLabel>("sweepNotice").isVisible());
            }
        }
    }

    void theCurvesAreTheResultsOfTheSweep() {
        Bench bench(swept(shaft(), {{dullness, 0.01, 0.06, 11}}));
        QVERIFY(bench.settled());
        auto& result = bench.part<QComboBox>("sweepResult");
        result.setCurrentIndex(result.findText(QStringLiteral("Radial runout")));
        const LineChart& chart = bench.view.curves()->chart();
        QVERIFY(chart.find(2) && !chart.find(3));
        const SweepResult& sweep = *bench.view.sweep();
        int curve = 0;
        for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
            if (sweep.quantities[q].name != "radial_runout") {
                continue;
            }
            const std::vector<XY>& drawn = chart.find(curve++)->points;
            QCOMPARE(drawn.size(), std::size_t{11});
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                QVERIFY(drawn[i].x == sweep.inputs[0].values[i]); // QCOMPARE would round
                QVERIFY(drawn[i].y == sweep.points[i].values[q].value);
            }
        }
        QCOMPARE(curve, 3);
        QVERIFY(
            std::ranges::count_if(
                chart.series, [](const ChartSeries& of) { return of.key == SweepShown::limitKey; })
            == 1);
        QCOMPARE(chart.find(SweepShown::limitKey)->points[0].y, 6.0);
        // Shaded are the points that hold, and no others.
        for (std::size_t i = 0; i < 11; ++i) {
            const double value = bench.view.sweep()->inputs[0].values[i];
            bool shaded = false;
            for (const ChartZone& zone : chart.zones) {
                shaded |= std::ranges::any_of(zone.ranges, [value](const ChartSpan& range) {
                    return range.low <= value && value <= range.high;
                });
            }
            QCOMPARE(shaded, bench.view.sweep()->points[i].good);
        }
    }

    void aClickChoosesAPointAndItsValuesAreTakenInOneStep() {
        Bench bench(swept(shaft(), {{dullness, 0.01, 0.05, 9}}));
        QVERIFY(bench.settled());
        const Project before = bench.document.project();
        QVERIFY(!bench.part<QPushButton>("sweepTake").isEnabled());
        bench.clickPoint(*bench.view.curves(), 6);
        QCOMPARE(bench.part<QSpinBox>("sweepPoint").value(), 7);
        const QString values = bench.part<QLabel>("sweepValues").text();
        QVERIFY(values.contains(QStringLiteral("0.04"))
                && values.contains(QStringLiteral("\u00a0s;")));
        const SweepResultPtr shown = bench.view.sweep();
        bench.click("sweepTake");
        QCOMPARE(bench.document.project().wheel->dullness, 0.04);
        QTest::qWait(50);
        // The sweep is the same: only the present value has moved.
        QVERIFY(!bench.view.stale());
        QCOMPARE(bench.view.sweep(), shown);
        bench.document.undo();
        QVERIFY(sameProject(bench.document.project(), before));
    }

    void aPointIsChosenByKeyboard() {
        Bench bench(swept(shaft(), {{dullness, 0.01, 0.05, 9}}));
        QVERIFY(bench.settled());
        auto& box = bench.part<QSpinBox>("sweepPoint");
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_Up);
        QTest::keyClick(&box, Qt::Key_Up);
        QTest::keyClick(&bench.part<QPushButton>("sweepTake"), Qt::Key_Space);
        QCOMPARE(bench.document.project().wheel->dullness, 0.015);
    }

    void twoInputsGiveAMapWithItsLimit() {
        Project project =
            swept(shaft(),
                  {{dullness, 0.005, 0.08, 12},
                   {"/machine/compliance_mm_per_n/nz", 5e-5, 5e-4, 8, SweepSpacing::logarithmic}});
        Bench bench(project);
        bench.click("sweepRun"); // unless it has run already
        QVERIFY(bench.settled());
        QVERIFY(bench.view.map()->isVisible());
        const SweepResult& sweep = *bench.view.sweep();
        auto& result = bench.part<QComboBox>("sweepResult");
        result.setCurrentIndex(result.findText(QStringLiteral("Mean diameter, NZ")));
        const ChartMap cells = bench.view.map()->chart().map.value();
        QCOMPARE(cells.columns, std::size_t{12});
        QCOMPARE(cells.values.size(), std::size_t{12 * 8});
        for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
            if (sweep.quantities[q].name == "diameter" && sweep.quantities[q].section == 1) {
                for (std::size_t x = 0; x < 12; ++x) {
                    for (std::size_t y = 0; y < 8; ++y) {
                        QVERIFY(cells.values[y * 12 + x]
                                == sweep.points[sweep.index(x, y)].values[q].value);
                    }
                }
            }
        }
        bench.clickPoint(*bench.view.map(), sweep.index(3, 5));
        QCOMPARE(bench.part<QSpinBox>("sweepPoint").value(),
                 static_cast<int>(sweep.index(3, 5)) + 1);
        bench.click("sweepTake");
        const auto& taken =
            std::get<ZoneCompliance>(bench.document.project().machine->compliance_mm_per_n);
        QCOMPARE(taken.nz, sweep.inputs[1].values[5]);
        QCOMPARE(bench.document.project().wheel->dullness, sweep.inputs[0].values[3]);
        ChartPlot& map = *bench.view.map();
        QCOMPARE(map.table().rows.size(), std::size_t{96});
        map.up().setRange(map.up().range().center(), map.up().range().upper);
        QCOMPARE(map.table().rows.size(), std::size_t{48});
    }

    void aLongSweepWaitsForRunAndAStopKeepsWhatWasDone() {
        Bench bench(endless());
        QVERIFY(!bench.view.busy() && !bench.view.sweep());
        QVERIFY(bench.part<QLabel>("sweepNotice").isVisible());
        const double stop_ms = leastOfTries_ms(400, [&] { // four times the target
            bench.click("sweepRun");
            const bool busy = bench.view.busy();
            QTest::qWait(500);
            RunningTimer clock;
            bench.click("sweepStop");
            return busy && QTest::qWaitFor([&] { return !bench.view.busy(); }, patience_ms)
                       ? double(clock.elapsed())
                       : std::numeric_limits<double>::infinity();
        });
        qInfo("SWEEP stopped and shown after %g ms, target 100 ms: %s", stop_ms,
              beside(stop_ms, 100));
        QVERIFY(stop_ms <= 400);
        QVERIFY(bench.view.sweep() && bench.view.sweep()->stopped);
        QVERIFY(bench.part<QLabel>("sweepState").text().startsWith(QStringLiteral("Stopped")));
        QVERIFY(bench.part<QPushButton>("sweepRun").isEnabled());
    }

    void afterAnEditTheSweepIsMarkedAndTheNewestWins() {
        Bench bench(swept(shaft(), {{dullness, 0.01, 0.05, 9}}));
        QVERIFY(bench.settled());
        bench.document.edit(endless(), {"Edit", "long"});
        QTest::qWait(30);
        QVERIFY(bench.view.stale() && !bench.view.busy());
        QVERIFY(bench.part<QLabel>("sweepNotice").isVisible());
        bench.click("sweepRun");
        QVERIFY(bench.view.busy());
        bench.document.edit(swept(shaft(), {{dullness, 0.02, 0.03, 5}}), {"Edit", "short"});
        QVERIFY(bench.settled());
        QCOMPARE(bench.view.sweep()->points.size(), std::size_t{5});
    }

    void aNameOrANoteMakesNoOtherSweep() {
        Project project = swept(shaft(), {{dullness, 0.01, 0.05, 5}});
        Project named = project;
        named.title = "Another";
        named.wheel->dullness = 0.033; // which the sweep varies
        QVERIFY(sameSweep(project, named));
        named.part->stock_mm = 0.2;
        QVERIFY(!sameSweep(project, named));
    }

    void aStageThatIsDeletedWhileItIsVariedDoesNoHarm() {
        Project project = endless();
        project.sweep->inputs[0] = {"/cycle/stages/1/radial_feed_mm", 0.0005, 0.004, 101};
        Bench bench(project);
        bench.click("sweepRun");
        QTest::qWait(100);
        QVERIFY(bench.view.busy());
        Project shorter = bench.document.project();
        shorter.cycle->stages.pop_back();
        bench.document.edit(shorter, {"Edit", "delete the stage"});
        QTRY_VERIFY(!bench.view.busy());
        auto& notice = bench.part<QLabel>("sweepNotice");
        QTRY_VERIFY(notice.text().contains(QStringLiteral("/cycle/stages/1/radial_feed_mm")));
        QVERIFY(!bench.part<QPushButton>("sweepRun").isEnabled());
        bench.document.undo();
        QTRY_VERIFY(bench.part<QPushButton>("sweepRun").isEnabled());
        // And of a point whose stage has gone the rest is taken.
        const SweepResult sweep =
            runSweep(swept(shaft(), {{"/cycle/stages/1/stock_mm", 0.02, 0.05, 3}}));
        QVERIFY(sameProject(withPoint(shorter, sweep, 0), shorter));
    }

    void whatHasNoEffectIsSaid() {
        Project project = shaft();
        Bench bench(swept(project, {{"/material/hardness_hrc", 50, 60, 5}}));
        QVERIFY(bench.settled());
        QVERIFY(bench.part<QLabel>("sweepNotice").text().startsWith(QStringLiteral("Nothing")));
    }

    void everyInputHasAUsualRangeThatCanBeRun() {
        for (const Project& project : {shaft(), fixtures::plunge()}) {
            for (const NumberInput& input : numberInputs(project)) {
                const Project with = withSweptInput(project, 0, input.path);
                QVERIFY2(checkSweep(with).empty(), input.path.c_str());
                const SweepAxis& axis = with.sweep->inputs[0];
                QVERIFY(!input.value || (axis.from <= *input.value && *input.value <= axis.to));
            }
        }
    }

    /// x² + y² = 1 on a grid: every piece lies on the circle, and together they are as long.
    void aContourFollowsACircle() {
        std::vector<double> places;
        for (int i = -30; i <= 30; ++i) {
            places.push_back(i * 0.05 + 0.003);
        }
        double length = 0;
        for (const QLineF& piece : zeroLines(places, places, [&](std::size_t i, std::size_t j) {
                 return 1 - places[i] * places[i] - places[j] * places[j];
             })) {
            length += piece.length();
            QVERIFY(std::abs(std::hypot(piece.x1(), piece.y1()) - 1) < 1e-3);
        }
        QVERIFY(std::abs(length - 2 * 3.14159265) < 0.01);
        const auto none = [](std::size_t, std::size_t) { return std::nan(""); };
        QVERIFY(zeroLines(places, places, none).empty());
    }

    // Fields of noise are full of saddles.
    void aContourNeverCrossesItself() {
        QRandomGenerator random(5);
        constexpr std::size_t count = 9;
        for (int round = 0; round < 60; ++round) {
            std::vector<double> across, up, values;
            for (std::size_t i = 0; i < count; ++i) {
                across.push_back((i == 0 ? 0 : across.back()) + 0.1 + random.generateDouble());
                up.push_back((i == 0 ? 0 : up.back()) + 0.1 + random.generateDouble());
            }
            for (std::size_t i = 0; i < count * count; ++i) { // some corners are on the contour
                const double value = random.generateDouble() - 0.5;
                values.push_back(random.bounded(10) == 0 ? 0 : value);
            }
            const std::vector<QLineF> pieces = zeroLines(
                across, up, [&](std::size_t i, std::size_t j) { return values[j * count + i]; });
            QVERIFY(pieces.size() > 20);
            for (std::size_t a = 0; a < pieces.size(); ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    QPointF at;
                    if (pieces[a].length() < 1e-12 || pieces[b].length() < 1e-12
                        || pieces[a].intersects(pieces[b], &at) != QLineF::BoundedIntersection) {
                        continue;
                    }
                    const auto isEnd = [&at](const QLineF& piece) {
                        return QLineF(at, piece.p1()).length() < 1e-9
                               || QLineF(at, piece.p2()).length() < 1e-9;
                    };
                    QVERIFY(isEnd(pieces[a]) && isEnd(pieces[b]));
                }
            }
        }
    }

    void aLongNameOfAnInputHasRoomBesideALowMap() {
        Bench bench(swept(shaft(), {{dullness, 0.005, 0.08, 6},
                                    {"/cycle/stages/0/radial_feed_mm", 0.001, 0.01, 6}}));
        bench.click("sweepRun");
        QVERIFY(bench.settled());
        ChartPlot& map = *bench.view.map();
        const QCPAxisRect& rect = map.cell();
        const QCPAxis& axis = *rect.axis(QCPAxis::atLeft);
        QVERIFY(QFontMetrics(map.font()).horizontalAdvance(axis.label()) > 260);
        for (const int height : {620, 500}) {
            bench.view.resize(640, height);
            QTest::qWait(20);
            map.replot();
            map.replot();
            const int taken = QFontMetrics(axis.labelFont()).horizontalAdvance(axis.label());
            const double share = axis.labelFont().pointSizeF() / map.font().pointSizeF();
            const bool inside =
                taken <= 2 * rect.center().y() && taken <= 2 * (map.height() - rect.center().y());
            QVERIFY2(
                inside || share < 0.65, // smaller is not read
                qPrintable(
                    QStringLiteral("%1 of %2, type %3").arg(taken).arg(rect.height()).arg(share)));
        }
    }

    void theLegendOfAMapHasWhatIsDrawn() {
        Bench bench(swept(shaft(), {{dullness, 0.005, 0.08, 12}, {"/part/stock_mm", 0.1, 0.2, 6}}));
        bench.click("sweepRun");
        QVERIFY(bench.settled());
        ChartPlot& map = *bench.view.map();
        bench.clickPoint(map, bench.view.sweep()->index(3, 3));
        std::map<int, LegendEntry> entries;
        for (const LegendEntry& entry : map.legendEntries()) {
            entries.emplace(entry.key, entry);
        }
        for (const int key : {SweepShown::limitKey, SweepShown::holdsKey}) {
            const auto entry = entries.find(key);
            QCOMPARE(entry != entries.end(), map.chart().find(key) != nullptr);
            QVERIFY(entry == entries.end() || entry->second.halo == onMap::dark);
        }
        QCOMPARE(entries.at(SweepShown::presentKey).swatch, Swatch::rhombus);
        QCOMPARE(entries.at(SweepShown::chosenKey).swatch, Swatch::square);
    }
};

} // namespace sparkout::test_sweep_view

SPARKOUT_TEST(test_sweep_view, TestSweepView)
#include "test_sweep_view.moc"
