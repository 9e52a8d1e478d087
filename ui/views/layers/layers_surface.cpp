// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/layers_surface.h"

#include "core/units.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"
#include "ui/views/layers/layers_look.h"
#include "ui/views/layers/surface_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

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
