// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/layers_surface.h"

#include "core/units.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/profiles_look.h"
#include "ui/chart/view_plot.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/cycle/layers_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

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

namespace {

/// Draws the surface of the layers in its box from back to front, with the scales of the box.
class SurfaceScene : public PaintedLayer {
public:
    explicit SurfaceScene(LayersSurface& surface);

protected:
    void draw(QCPPainter* painter) override;

private:
    struct Facet {
        QPolygonF corners;
        double nearness = 0;
        QColor colour, line;
        bool newest = false; ///< at the cursor
    };
    [[nodiscard]] std::vector<Facet> facets(const SurfaceGrid& grid) const;
    void drawFacets(QCPPainter& painter, const SurfaceGrid& grid) const;
    void drawBox(QCPPainter& painter, const SurfaceGrid& grid) const;
    /// @param along 0: length, 1: numbers, 2: feed
    void drawScale(QCPPainter& painter, const SurfaceScale& scale, int along) const;

    LayersSurface& m_surface;
};

constexpr double tickLength = 0.025; ///< length of ticks, in edges of the box
constexpr double numberAway = 0.075, nameAway = 0.3;
constexpr double mostTicks = 5;

using Point = std::array<double, 3>; ///< in the box, 0…1 each

SurfaceScene::SurfaceScene(LayersSurface& surface)
    : PaintedLayer(surface, QStringLiteral("main"), Edges::smooth), m_surface(surface) {}

std::vector<SurfaceScene::Facet> SurfaceScene::facets(const SurfaceGrid& grid) const {
    const auto share = [&grid](int along, double value) {
        return value / std::max(grid.scales[static_cast<std::size_t>(along)].most, 1e-9);
    };
    std::vector<Facet> facets;
    const auto add = [&](const SurfaceSheet& sheet, std::size_t i, std::size_t j) {
        Facet facet;
        facet.colour = sheet.colour(i, j);
        facet.line = sheet.newest ? sheet.line : facet.colour.darker(130);
        facet.newest = sheet.newest;
        for (const auto& [row, column] :
             {std::pair{i, j}, {i, j + 1}, {i + 1, j + 1}, {i + 1, j}}) {
            const double x = share(0, sheet.lengths_mm[column]);
            const double y = share(1, sheet.numbers[row]);
            const double z = share(2, sheet.feed_um(row, column));
            facet.corners << m_surface.project(x, y, z);
            facet.nearness += m_surface.nearness(x, y, z) / 4;
        }
        facets.push_back(std::move(facet));
    };
    for (const SurfaceSheet& sheet : grid.sheets) {
        for (std::size_t i = 0; i + 1 < sheet.numbers.size(); ++i) {
            for (std::size_t j = 0; j + 1 < sheet.columns(); ++j) {
                add(sheet, i, j);
            }
        }
    }
    std::ranges::stable_sort(facets, {}, &Facet::nearness);
    return facets;
}

void SurfaceScene::draw(QCPPainter* painter) {
    if (m_surface.series().columns.empty()) {
        return;
    }
    const SurfaceGrid grid = m_surface.grid();
    drawBox(*painter, grid);
    drawFacets(*painter, grid);
    for (const int along : {0, 1, 2}) {
        drawScale(*painter, grid.scales[static_cast<std::size_t>(along)], along);
    }
}

void SurfaceScene::drawFacets(QCPPainter& painter, const SurfaceGrid& grid) const {
    for (const Facet& facet : facets(grid)) {
        painter.setPen(QPen(facet.line, facet.newest ? 1.5 : 0.5));
        painter.setBrush(facet.colour);
        painter.drawPolygon(facet.corners);
    }
}

/// Ground and the two walls at the back.
void SurfaceScene::drawBox(QCPPainter& painter, const SurfaceGrid& grid) const {
    const auto face = [&](std::size_t level, double at) {
        QPolygonF corners;
        for (int corner = 0; corner < 4; ++corner) {
            Point point{};
            point[level] = at;
            point[(level + 1) % 3] = corner == 1 || corner == 2 ? 1 : 0;
            point[(level + 2) % 3] = corner >= 2 ? 1 : 0;
            corners << m_surface.project(point[0], point[1], point[2]);
        }
        painter.setPen(QPen(grid.edge, 1));
        painter.setBrush(grid.wall);
        painter.drawPolygon(corners);
    };
    face(2, 0);
    face(0, m_surface.nearness(0, 0.5, 0.5) < m_surface.nearness(1, 0.5, 0.5) ? 0 : 1);
    face(1, m_surface.nearness(0.5, 0, 0.5) < m_surface.nearness(0.5, 1, 0.5) ? 0 : 1);
}

/// Draws numbers along an unobstructed edge of the box, with the name beyond them.
void SurfaceScene::drawScale(QCPPainter& painter, const SurfaceScale& scale, int along) const {
    const double frontX = m_surface.nearness(0, 0.5, 0) > m_surface.nearness(1, 0.5, 0) ? 0 : 1;
    const double frontY = m_surface.nearness(0.5, 0, 0) > m_surface.nearness(0.5, 1, 0) ? 0 : 1;
    // The upright edge is the leftmost one.
    Point upright{0, 0, 0};
    for (const Point& corner : {Point{0, 1, 0}, Point{1, 0, 0}, Point{1, 1, 0}}) {
        if (m_surface.project(corner[0], corner[1], 0).x()
            < m_surface.project(upright[0], upright[1], 0).x()) {
            upright = corner;
        }
    }
    const auto at = [&](double share, double away) {
        Point point = along == 0   ? Point{share, frontY, 0}
                      : along == 1 ? Point{frontX, share, 0}
                                   : Point{upright[0], upright[1], share};
        QPointF pixel = m_surface.project(point[0], point[1], point[2]);
        if (along == 2) {
            return pixel - QPointF(away * m_surface.height() * 0.6, 0);
        }
        point[along == 0 ? 1 : 0] += (along == 0 ? frontY : frontX) > 0.5 ? away : -away;
        return m_surface.project(point[0], point[1], point[2]);
    };
    painter.setFont(m_surface.font());
    painter.setPen(m_surface.palette().color(QPalette::Text));
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(at(0, 0), at(1, 0));
    const QFontMetrics metrics(m_surface.font());
    const auto write = [&](const QPointF& middle, const QString& text, bool toTheLeft) {
        const double width = metrics.horizontalAdvance(text) + 2, height = metrics.height();
        const QRectF box(middle.x() - (toTheLeft ? width : width / 2), middle.y() - height / 2,
                         width, height);
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    };
    const double size = std::max(scale.most, 1e-9);
    const double step = roundUp125(along == 1 ? std::max(size / mostTicks, 1.0) : size / mostTicks);
    // Two zeros meet in the corner: the upright one is left out.
    for (double value = along == 2 ? step : 0; value <= size * (1 + 1e-9); value += step) {
        painter.drawLine(at(value / size, 0), at(value / size, tickLength));
        write(at(value / size, along == 2 ? tickLength * 1.5 : numberAway), printedNumber(value, 6),
              along == 2);
    }
    if (along == 2) { // above the edge, from its left end
        const QPointF top = at(1, 0) - QPointF(0, metrics.height() * 1.2);
        const double width = metrics.horizontalAdvance(scale.title) + 2;
        const QPointF middle(std::max(top.x(), width / 2 + 4), top.y());
        painter.fillRect(QRectF(middle.x() - width / 2, middle.y() - metrics.height() / 2.0, width,
                                metrics.height()),
                         m_surface.palette().color(QPalette::Base));
        write(middle, scale.title, false);
    } else {
        write(at(0.5, nameAway), scale.title, false);
    }
}

constexpr double firstAzimuth = -52, firstElevation = 28; ///< [°]
constexpr double azimuthSize = 180, elevationSize = 120;  ///< [°] angle of a drag across the plot
constexpr double leastZoom = 0.5, mostZoom = 8;
constexpr double shareOfWidth = 0.56, shareOfHeight = 0.66; ///< edge of the box in the plot
constexpr double flatness = 0.62;                           ///< height of the box over its width

double radians(double degrees) {
    return degrees / 180 * std::numbers::pi;
}

} // namespace

LayersSurface::LayersSurface(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeNone);
    m_rect = new QCPAxisRect(this, true);
    plotLayout()->addElement(0, 0, m_rect);
    m_rect->setAutoMargins(QCP::msNone);
    for (QCPAxis* axis : style::axesOf(*m_rect)) {
        axis->setVisible(false);
        axis->grid()->setVisible(false);
    }
    new SurfaceScene(*this);
    for (const bool sideways : {true, false}) {
        QCPAxis* axis = m_rect->axis(sideways ? QCPAxis::atBottom : QCPAxis::atLeft);
        connect(axis, QOverload<const QCPRange&, const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                [this, sideways](const QCPRange& range, const QCPRange& before) {
                    keepAngles(range, before, sideways);
                });
    }
    fit();
    built();
}

// --- angles -------------------------------------------------------------------------------------

void LayersSurface::fit() {
    setVisibleRange({-firstAzimuth - azimuthSize / 2, -firstAzimuth + azimuthSize / 2,
                     firstElevation - elevationSize / 2, firstElevation + elevationSize / 2});
}

PlotHistory::State LayersSurface::visibleRange() const {
    const QCPRange x = m_rect->axis(QCPAxis::atBottom)->range();
    const QCPRange y = m_rect->axis(QCPAxis::atLeft)->range();
    return {x.lower, x.upper, y.lower, y.upper};
}

void LayersSurface::setVisibleRange(const PlotHistory::State& range) {
    if (range.size() != 4) {
        return;
    }
    m_setting = true;
    m_rect->axis(QCPAxis::atBottom)->setRange(range[0], range[1]);
    m_rect->axis(QCPAxis::atLeft)->setRange(range[2], range[3]);
    m_setting = false;
}

/// A range that only moved turns the box; a change of size of the lower one zooms it, and the other
/// one follows. The eye stays above the ground.
void LayersSurface::keepAngles(const QCPRange& range, const QCPRange& before, bool sideways) {
    if (m_setting) {
        return;
    }
    const bool sized = std::abs(range.size() - before.size()) > 1e-6 * before.size();
    const double size = sideways && sized ? range.size() : azimuthSize / zoom();
    const double share = std::clamp(size / azimuthSize, 1 / mostZoom, 1 / leastZoom);
    const double middle = sized ? before.center() : range.center();
    const double across = sideways ? middle : -azimuth();
    const double up = sideways ? elevation() : std::clamp(middle, 0.0, 90.0);
    setVisibleRange({across - azimuthSize * share / 2, across + azimuthSize * share / 2,
                     up - elevationSize * share / 2, up + elevationSize * share / 2});
}

/// Opposite to the axis, so that the front of the box follows the mouse.
double LayersSurface::azimuth() const {
    return -m_rect->axis(QCPAxis::atBottom)->range().center();
}

double LayersSurface::elevation() const {
    return m_rect->axis(QCPAxis::atLeft)->range().center();
}

double LayersSurface::zoom() const {
    return azimuthSize / m_rect->axis(QCPAxis::atBottom)->range().size();
}

QPointF LayersSurface::project(double x, double y, double z) const {
    const double a = radians(azimuth()), e = radians(elevation());
    const double X = x - 0.5, Y = y - 0.5, Z = (z - 0.5) * flatness;
    const double right = X * std::cos(a) - Y * std::sin(a);
    const double away = X * std::sin(a) + Y * std::cos(a);
    const double up = Z * std::cos(e) + away * std::sin(e);
    return QRectF(m_rect->rect()).center() + QPointF(right, -up) * edge();
}

double LayersSurface::edge() const {
    const QSizeF area = m_rect->rect().size();
    return std::min(area.width() * shareOfWidth, area.height() * shareOfHeight) * zoom();
}

double LayersSurface::nearness(double x, double y, double z) const {
    const double a = radians(azimuth()), e = radians(elevation());
    const double away = (x - 0.5) * std::sin(a) + (y - 0.5) * std::cos(a);
    return (z - 0.5) * flatness * std::sin(e) - away * std::cos(e);
}

// --- contents -----------------------------------------------------------------------------------

void LayersSurface::setSeries(LayerSeries series) {
    m_series = std::move(series);
    m_done = allLayers(m_series);
    emit contentChanged();
}

void LayersSurface::setDone(LayersDone done) {
    m_done = std::move(done);
}

SurfaceGrid LayersSurface::grid() const {
    return makeSurfaceGrid(m_series, m_done, choice(), palette(), isDimmed());
}

LegendEntries LayersSurface::legendEntries() const {
    return LayersLook::stages(m_series, choice(), palette());
}

CsvTable LayersSurface::table() const {
    CsvTable table;
    table.header << tr("Number of double strokes or revolutions");
    for (const LayerColumn& column : m_series.columns) {
        table.header
            << tr("%1, accumulated actual feed, µm").arg(Names::zone(column.zone, column.section));
    }
    for (std::size_t i = 0; i < m_done.count; ++i) {
        if (!showsStage(m_series.spans[i].stage)) {
            continue;
        }
        std::vector<CsvCell> row{double(m_series.spans[i].last)};
        for (std::size_t j = 0; j < m_series.columns.size(); ++j) {
            row.push_back(sumDone_mm(m_series, m_done, j, i + 1) * units::umPerMm);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

void LayersSurface::restyle() {
    setBackground(palette().brush(QPalette::Base));
}

} // namespace sparkout
