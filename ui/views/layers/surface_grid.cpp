// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/surface_grid.h"

#include "core/units.h"
#include "ui/views/layers/layers_look.h"
#include "ui/views/layers/layers_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sparkout {

namespace {

constexpr std::size_t mostRows = 120; ///< greatest number of facets over the numbers
constexpr int boxAlpha = 110, wallAlpha = 40;
constexpr int steepest = 135, flattest = 100; ///< lightness of facets, in percent
constexpr int darkerLine = 130;               ///< percentage for the lines of a facet
constexpr double dimShare = 0.35;

QColor mixed(const QColor& over, const QColor& under, double share) {
    const auto part = [share](float a, float b) {
        return static_cast<float>(share * a + (1 - share) * b);
    };
    return QColor::fromRgbF(part(over.redF(), under.redF()), part(over.greenF(), under.greenF()),
                            part(over.blueF(), under.blueF()));
}

class SheetMaker {
public:
    SheetMaker(const LayerSeries& series, const LayersDone& done, const QPalette& palette, bool dim)
        : m_series(series)
        , m_done(done)
        , m_palette(palette)
        , m_dim(dim)
        , m_order(series.columns.size()) {
        std::iota(m_order.begin(), m_order.end(), std::size_t{0});
        std::ranges::sort(m_order, {},
                          [&](std::size_t j) { return series.columns[j].stretch.from_mm; });
    }

    /// Adds the layers from `begin` to before `end`, of one stage, as one row of facets.
    void add(std::vector<SurfaceSheet>& sheets, std::size_t begin, std::size_t end) const {
        const int stage = m_series.spans[begin].stage;
        const bool newest = end == m_done.count && end < m_series.spans.size();
        const double first = begin > 0 ? m_series.spans[begin - 1].last : 0;
        if (sheets.empty() || newest || sheets.back().stage != stage
            || sheets.back().numbers.back() != first) {
            sheets.push_back(start(stage, newest));
            addPoints(sheets.back(), begin, first);
        }
        addFacets(sheets.back(), begin, end);
        addPoints(sheets.back(), end, m_series.spans[end - 1].last);
    }

private:
    [[nodiscard]] QColor shown(const QColor& colour) const {
        return m_dim ? mixed(colour, m_palette.color(QPalette::Base), dimShare) : colour;
    }

    [[nodiscard]] SurfaceSheet start(int stage, bool newest) const {
        SurfaceSheet sheet;
        sheet.stage = stage;
        sheet.newest = newest;
        for (const std::size_t j : m_order) {
            const Stretch& stretch = m_series.columns[j].stretch;
            sheet.lengths_mm.insert(sheet.lengths_mm.end(), {stretch.from_mm, stretch.to_mm});
        }
        sheet.line = newest ? m_palette.color(QPalette::Text)
                            : shown(LayersLook::stage(stage, m_palette)).darker(darkerLine);
        return sheet;
    }

    void addPoints(SurfaceSheet& sheet, std::size_t count, double number) const {
        sheet.numbers.push_back(number);
        for (const std::size_t j : m_order) {
            const double feed = sumDone_mm(m_series, m_done, j, count) * units::umPerMm;
            sheet.feeds_um.insert(sheet.feeds_um.end(), {feed, feed});
        }
    }

    /// Steeper facets are lighter; a step between two zones has the colour of the one before it.
    void addFacets(SurfaceSheet& sheet, std::size_t begin, std::size_t end) const {
        const double highest = std::max(m_series.largestSum_mm(), 1e-12);
        const double numbers = m_series.spans.back().last;
        const double first = begin > 0 ? m_series.spans[begin - 1].last : 0;
        const double share = (m_series.spans[end - 1].last - first) / numbers;
        for (const std::size_t j : m_order) {
            const double rise =
                (sumDone_mm(m_series, m_done, j, end) - sumDone_mm(m_series, m_done, j, begin))
                / highest;
            const double slope = std::min(rise / std::max(share, 1e-9) / 4, 1.0);
            const int lightness = flattest + static_cast<int>((steepest - flattest) * slope);
            const QColor colour =
                shown(LayersLook::stage(sheet.stage, m_palette).lighter(lightness));
            sheet.colours.push_back(colour);
            if (j != m_order.back()) {
                sheet.colours.push_back(colour);
            }
        }
    }

    const LayerSeries& m_series;
    const LayersDone& m_done;
    const QPalette& m_palette;
    bool m_dim;
    std::vector<std::size_t> m_order; ///< order of the columns along the length
};

} // namespace

/// The surface is level over each zone or section, with steps between them.
SurfaceGrid makeSurfaceGrid(const LayerSeries& series, const LayersDone& done,
                            const CurveChoice& choice, const QPalette& palette, bool dim) {
    SurfaceGrid grid;
    const QColor text = palette.color(QPalette::Text);
    grid.wall = mixed(text, palette.color(QPalette::Base), wallAlpha / 255.0);
    grid.edge = mixed(text, grid.wall, boxAlpha / 255.0);
    const bool strokes = series.operation->travels;
    grid.scales = {{{LayersSurface::tr("Length, mm"), series.length_mm},
                    {strokes ? LayersSurface::tr("Double stroke") : LayersSurface::tr("Revolution"),
                     double(series.strokeCount())},
                    {LayersSurface::tr("Accumulated actual feed, µm"),
                     series.largestSum_mm() * units::umPerMm}}};
    const std::size_t together = (series.spans.size() + mostRows - 1) / mostRows;
    const SheetMaker maker(series, done, palette, dim);
    for (std::size_t i = 0; i < done.count && !series.columns.empty();) {
        const int stage = series.spans[i].stage;
        std::size_t end = i;
        while (end < done.count && end - i < together && series.spans[end].stage == stage) {
            ++end;
        }
        if (choice.shows(stage)) {
            maker.add(grid.sheets, i, end);
        }
        i = end;
    }
    return grid;
}

} // namespace sparkout
