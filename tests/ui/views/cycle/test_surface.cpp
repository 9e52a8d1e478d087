// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the layers: what its grid holds of the run, and that it is painted in the theme's
// colours.
#include "core/units.h"
#include "tests/registry.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/views/cycle/layers_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sparkout::test_surface {

/// A surface alone, with a run.
struct Alone {
    explicit Alone(const Project& project) : outcome(fixtures::run(project)) {
        surface.resize(640, 420);
        surface.setSeries(outcome->layers);
    }
    OutcomePtr outcome;
    LayersSurface surface;
};

bool has(const QImage& picture, const QColor& colour) {
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (picture.pixel(x, y) == colour.rgb()) {
                return true;
            }
        }
    }
    return false;
}

/// What a zone or section has had taken off it after so many double strokes or revolutions [µm].
double sumAfter_um(const LayerSeries& series, const LayerColumn& column, double number) {
    const auto span = std::ranges::find(series.spans, static_cast<int>(number), &LayerSpan::last);
    const auto index = static_cast<std::size_t>(std::distance(series.spans.begin(), span));
    return span == series.spans.end() ? 0 : column.sum_mm[index] * units::umPerMm;
}

class TestSurface : public QObject {
    Q_OBJECT

private slots:
    void init() { applyTheme(Theme::light); }

    /// Point by point: level over each zone or section, from its one end to its other.
    void theGridHasThePointsOfTheRun() {
        for (const Project& project : {fixtures::traverseProject(), fixtures::plungeProject(3)}) {
            const Alone alone(project);
            const LayerSeries& series = alone.outcome->layers;
            std::size_t rows = 0;
            for (const SurfaceSheet& sheet : alone.surface.grid().sheets) {
                QCOMPARE(sheet.columns(), 2 * series.columns.size());
                QCOMPARE(sheet.feeds_um.size(), sheet.numbers.size() * sheet.columns());
                for (std::size_t i = 0; i < sheet.numbers.size(); ++i, ++rows) {
                    for (const LayerColumn& column : series.columns) {
                        const double sum_um = sumAfter_um(series, column, sheet.numbers[i]);
                        int found = 0;
                        for (std::size_t j = 0; j < sheet.columns(); ++j) {
                            const double x = sheet.lengths_mm[j];
                            const bool isEnd =
                                x == column.stretch.from_mm || x == column.stretch.to_mm;
                            found += isEnd && std::abs(sheet.feed_um(i, j) - sum_um) < 1e-9 ? 1 : 0;
                        }
                        QVERIFY(found >= 2);
                    }
                }
            }
            QVERIFY(rows > 20);
        }
    }

    void theScalesAreThoseOfTheRun() {
        const Alone alone(fixtures::traverseProject());
        const SurfaceGrid grid = alone.surface.grid();
        const LayerSeries& series = alone.outcome->layers;
        QCOMPARE(grid.scales[0], (SurfaceScale{QStringLiteral("Length, mm"), series.length_mm}));
        QCOMPARE(grid.scales[1],
                 (SurfaceScale{QStringLiteral("Double stroke"), double(series.spans.back().last)}));
        QCOMPARE(grid.scales[2], (SurfaceScale{QStringLiteral("Accumulated actual feed, µm"),
                                               series.largestSum_mm() * units::umPerMm}));
        const Alone plunge(fixtures::plungeProject(2));
        QCOMPARE(plunge.surface.grid().scales[1].title, QStringLiteral("Revolution"));
    }

    /// Ground, walls and the colours of facets, in every theme.
    void itIsPaintedInTheColoursOfTheGrid() {
        for (const Theme theme : {Theme::light, Theme::dark, Theme::contrast}) {
            applyTheme(theme);
            Alone alone(fixtures::traverseProject());
            const SurfaceGrid grid = alone.surface.grid();
            const QImage picture =
                alone.surface.toPixmap(alone.surface.width(), alone.surface.height()).toImage();
            QVERIFY(has(picture, alone.surface.palette().color(QPalette::Base)));
            QVERIFY(has(picture, grid.wall));
            for (const SurfaceSheet& sheet : grid.sheets) {
                QVERIFY(std::ranges::any_of(
                    sheet.colours, [&](const QColor& colour) { return has(picture, colour); }));
            }
        }
    }
};

} // namespace sparkout::test_surface

SPARKOUT_TEST(test_surface, TestSurface)
#include "test_surface.moc"
