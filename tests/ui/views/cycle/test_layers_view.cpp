// SPDX-License-Identifier: GPL-3.0-or-later
// The view "Layers": what is painted adds up to the stock, the cursor cuts it off, the surface
// turns.
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/chart/legend.h"
#include "ui/chart/plot_tools.h"
#include "ui/session/cycle_cursor.h"
#include "ui/views/cycle/layers_surface.h"
#include "ui/views/cycle/layers_view.h"
#include "ui/views/cycle/side_plot.h"

#include <QComboBox>
#include <QLabel>

#include <cmath>

namespace sparkout::test_layers_view {

/// A view as it stands in the window, with a run drawn.
struct Bench {
    explicit Bench(const OutcomePtr& outcome) {
        view.shareCycle(&cursor);
        view.resize(700, 620);
        view.show();
        show(outcome);
    }
    void show(const OutcomePtr& outcome) {
        QSignalSpy updated(&view, &View::updated);
        cursor.setOutcome(outcome);
        view.setOutcome(outcome);
        QTRY_COMPARE(updated.count(), 1);
        QTest::qWait(20);
    }
    void choose(const char* box, int index) {
        auto* choice = view.findChild<QComboBox*>(QLatin1String(box));
        choice->setFocus();
        QTest::keyClick(choice, Qt::Key_Home);
        for (int i = 0; i < index; ++i) {
            QTest::keyClick(choice, Qt::Key_Down);
        }
        QTest::qWait(20);
    }
    [[nodiscard]] LayersPlot& plot() { return *view.plot(); }
    [[nodiscard]] LayersSurface& surface() { return *view.surface(); }
    [[nodiscard]] QString text(const char* label) {
        return view.findChild<QLabel*>(QLatin1String(label))->text();
    }
    CycleCursor cursor;
    LayersView view;
};

double micrometresIn(const LayersPlot& plot, double pixels) {
    return std::abs(plot.up().pixelToCoord(pixels) - plot.up().pixelToCoord(0));
}

class TestLayersView : public QObject {
    Q_OBJECT

private slots:
    void theLayersLieOnEachOtherFromBlankToFinal() {
        Project bore = fixtures::plungeProject(2);
        bore.part->surface = Surface::internal;
        bore.wheel->diameter_mm = 20;
        for (const Project& project :
             {fixtures::traverseProject(), fixtures::plungeProject(3), bore}) {
            const OutcomePtr outcome = fixtures::run(project);
            Bench bench(outcome);
            const LayerSeries& series = bench.plot().series();
            QCOMPARE(series.columns.size(), outcome->result.sections.size());
            const bool internal = series.removalSign < 0;
            for (std::size_t j = 0; j < series.columns.size(); ++j) {
                double height = 0;
                for (std::size_t i = 0; i < series.spans.size(); ++i) {
                    const QRectF rect = bench.plot().layerRect(j, i);
                    height += rect.height();
                    if (i > 0) {
                        const QRectF before = bench.plot().layerRect(j, i - 1);
                        const double gap =
                            internal ? before.top() - rect.bottom() : rect.top() - before.bottom();
                        QVERIFY(std::abs(gap) < 1e-6);
                    }
                }
                const LayerColumn& column = series.columns[j];
                const double stock_um = std::abs(column.blank_mm - column.final_mm) * 1e3;
                QVERIFY(std::abs(micrometresIn(bench.plot(), height) - stock_um) < 1e-6 * stock_um);
            }
        }
    }

    void theCurvesAreBlankFinalAndField() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        Bench bench(outcome);
        const LayerSeries& series = outcome->layers;
        const LineChart& chart = bench.plot().chart();
        const std::vector<XY>& last = chart.find(LayersPlot::finalKey)->points;
        for (const LayerColumn& column : series.columns) {
            const double middle = (column.stretch.from_mm + column.stretch.to_mm) / 2;
            const double radius_um = valueAt(last, middle).value();
            QVERIFY(std::abs(radius_um - (column.final_mm - series.target_mm) * 1e3) < 1e-9);
        }
        const double upper = chart.find(LayersPlot::fieldKey)->points.front().y;
        QVERIFY(std::abs(upper - (series.upperLimit_mm - series.target_mm) * 1e3) < 1e-9);
    }

    void theCursorLeavesWhatIsToComeOnThePart() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        const std::size_t all = bench.plot().series().spans.size();
        QCOMPARE(bench.plot().done().count, all);
        bench.cursor.toStroke(5);
        QCOMPARE(bench.plot().done().count, 5u);
        QCOMPARE(bench.surface().done().count, 5u);
        QVERIFY(!bench.plot().layerRect(0, 4).isEmpty());
        QVERIFY(bench.plot().layerRect(0, 5).isEmpty());
        QCOMPARE(bench.plot().table().rows.size(), 5u);
        bench.cursor.setPosition(0);
        QCOMPARE(bench.plot().done().count, 0u);
        QCOMPARE(bench.text("layersSummary"), QStringLiteral("Before the first touch"));
    }

    /// Within a double stroke the newest layer grows to its full height, and no other one moves.
    void theNewestLayerGrowsWithTheCycle() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        bench.cursor.toStroke(6);
        const QRectF full = bench.plot().layerRect(1, 5), below = bench.plot().layerRect(1, 4);
        bench.cursor.toStroke(5);
        double height = 0;
        int grown = 0;
        while (bench.cursor.step(CursorUnit::radius, 1), bench.cursor.stroke() == 6) {
            QCOMPARE(bench.plot().layerRect(1, 4), below);
            const double now = bench.plot().layerRect(1, 5).height();
            QVERIFY(now >= height - 1e-9);
            grown += now > height ? 1 : 0;
            height = now;
        }
        QVERIFY(grown > 10);
        QVERIFY(std::abs(height - full.height()) < 1e-9);
    }

    void aClickOnALayerMovesTheCursorThere() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        const QPoint third = bench.plot().layerRect(1, 2).center().toPoint();
        QTest::mouseMove(&bench.plot(), third);
        QTRY_VERIFY(bench.text("layersValues").contains(QStringLiteral("Double stroke 3")));
        QTest::mouseClick(&bench.plot(), Qt::LeftButton, {}, third);
        QCOMPARE(bench.cursor.stroke(), 3);
        QCOMPARE(bench.plot().done().count, 3u);
    }

    void theLegendHidesAStage() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        auto* legend = bench.view.findChild<LegendStrip*>();
        QCOMPARE(legend->entries().front().key, 1);
        QTest::mouseClick(legend, Qt::LeftButton, {}, legend->entryRect(0).center());
        QVERIFY(bench.plot().layerRect(0, 0).isEmpty());
        const std::size_t last = bench.plot().series().spans.size() - 1;
        QVERIFY(!bench.plot().layerRect(0, last).isEmpty());
        QTest::mouseClick(legend, Qt::LeftButton, {}, legend->entryRect(0).center());
        QVERIFY(!bench.plot().layerRect(0, 0).isEmpty());
    }

    void oneRadiusHasItsOwnLayers() {
        const OutcomePtr outcome = fixtures::run(fixtures::plungeProject(2));
        Bench bench(outcome);
        bench.choose("layersRadius", 4);
        const LayerSeries& series = bench.plot().series();
        QCOMPARE(series.radius.value_or(-1), 3);
        QCOMPARE(series.columns[1].final_mm, outcome->result.sections[1].radii_mm[3]);
        bench.show(fixtures::run(fixtures::plungeProject(2)));
        QCOMPARE(bench.plot().series().radius.value_or(-1), 3);
    }

    void theSurfaceIsTurnedByMouseAndKeys() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        bench.choose("layersContent", 1);
        LayersSurface& surface = bench.surface();
        QVERIFY(surface.isVisible() && !bench.plot().isVisible());
        const double azimuth = surface.azimuth(), elevation = surface.elevation();
        fixtures::drag(&surface, surface.rect().center(), surface.rect().center() + QPoint(80, 30));
        QVERIFY(std::abs(surface.azimuth() - azimuth) > 5);
        QVERIFY(std::abs(surface.elevation() - elevation) > 2);
        surface.setFocus();
        const double turned = surface.azimuth();
        QTest::keyClick(&surface, Qt::Key_Right);
        QVERIFY(std::abs(surface.azimuth() - turned) > 5);
        for (int i = 0; i < 40; ++i) {
            QTest::keyClick(&surface, Qt::Key_Up);
        }
        QVERIFY(surface.elevation() >= 0 && surface.elevation() <= 90);
        const double before = surface.azimuth();
        fixtures::wheel(&surface, QPointF(40, 60), 120);
        QVERIFY(surface.zoom() > 1);
        QVERIFY(std::abs(surface.azimuth() - before) < 1e-9);
        bench.view.tools()->fit->trigger();
        QVERIFY(std::abs(surface.azimuth() - azimuth) < 1e-9);
        QCOMPARE(surface.zoom(), 1.0);
    }

    /// A parallel projection keeps the middle of a line, and at 90° looks down on the ground.
    void theProjectionIsParallel() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        bench.choose("layersContent", 1);
        LayersSurface& surface = bench.surface();
        const QPointF a = surface.project(0, 0, 0), b = surface.project(1, 1, 1);
        const QPointF middle = surface.project(0.5, 0.5, 0.5);
        QVERIFY(QLineF((a + b) / 2, middle).length() < 1e-9);
        PlotHistory::State sight = surface.visibleRange();
        const double half = (sight[3] - sight[2]) / 2;
        sight[2] = 90 - half;
        sight[3] = 90 + half;
        surface.setVisibleRange(sight);
        QVERIFY(QLineF(surface.project(0.2, 0.7, 0), surface.project(0.2, 0.7, 1)).length() < 1e-9);
        QVERIFY(surface.nearness(0.2, 0.7, 1) > surface.nearness(0.2, 0.7, 0));
    }

    /// The wheel's edge lies on what it cuts, and goes along the part with the radii of a stroke.
    void theWheelTouchesWhatItCuts() {
        Project bore = fixtures::plungeProject(2);
        bore.part->surface = Surface::internal;
        bore.wheel->diameter_mm = 20;
        for (const Project& project :
             {fixtures::traverseProject(), fixtures::plungeProject(3), bore}) {
            Bench bench(fixtures::run(project));
            bench.choose("layersContent", 2);
            const SidePlot& side = *bench.view.side();
            QVERIFY(side.isVisible() && !bench.plot().isVisible());
            bench.cursor.toStroke(10);
            int cuts = 0;
            for (int i = 0; i < 200; ++i) {
                bench.cursor.step(CursorUnit::radius, 1);
                const GrindingScene& scene = side.scene();
                QCOMPARE(scene.radius, bench.cursor.radius());
                if (scene.cut_mm > 0) {
                    ++cuts;
                    const double seen = side.up().coordToPixel(
                        side.above_um(side.seen_mm(scene.surfaces[scene.leading])));
                    const QRectF wheel = side.wheelRect();
                    const double edge = scene.removalSign > 0 ? wheel.bottom() : wheel.top();
                    QVERIFY(std::abs(edge - seen) < 1e-6);
                    QVERIFY(bench.text("layersValues").contains(QStringLiteral("yield")));
                }
            }
            QVERIFY(cuts > 50);
        }
    }

    void theWheelGoesFromEndToEndAndBack() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        bench.choose("layersContent", 2);
        const SidePlot& side = *bench.view.side();
        bench.cursor.toStroke(3);
        bench.cursor.step(CursorUnit::stroke, 1);
        const double entry = side.wheelRect().left(); // a double stroke ends where it began
        double farthest = entry;
        const QRect cell = side.cell().rect();
        while (bench.cursor.step(CursorUnit::radius, 1), bench.cursor.stroke() == 5) {
            farthest = std::max(farthest, side.wheelRect().left());
            QVERIFY(side.wheelRect().left() >= cell.left());
            QVERIFY(side.wheelRect().right() <= cell.right() + 1);
        }
        bench.cursor.step(CursorUnit::radius, -1);
        QVERIFY(std::abs(side.wheelRect().left() - entry) < 1e-6);
        QVERIFY(farthest > entry + 100);
    }

    void refusedInputsLeaveTheLastLayers() {
        Bench bench(fixtures::run(fixtures::traverseProject()));
        const std::size_t layers = bench.plot().series().spans.size();
        bench.show(fixtures::refused());
        QCOMPARE(bench.plot().series().spans.size(), layers);
        QVERIFY(bench.plot().isDimmed());
        QVERIFY(bench.text("layersNotice").contains(QStringLiteral("refused")));
    }
};

} // namespace sparkout::test_layers_view

SPARKOUT_TEST(test_layers_view, TestLayersView)
#include "test_layers_view.moc"
