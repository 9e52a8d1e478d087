// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/surface_scene.h"

#include "core/units.h"
#include "ui/views/layers_surface.h"
#include "ui/views/plot_style.h"
#include "ui/views/profiles_series.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace sparkout {

namespace {

constexpr std::size_t mostRows = 120; ///< of facets over the numbers
constexpr double tickLength = 0.025;  ///< of the box's edge
constexpr double numberAway = 0.075, nameAway = 0.3;
constexpr double mostTicks = 5;
constexpr int boxAlpha = 110, gridAlpha = 40;
constexpr int steepest = 135, flattest = 100; ///< lightness of facets, in percent

using Point = std::array<double, 3>; ///< of the box, 0…1 each

} // namespace

SurfaceScene::SurfaceScene(LayersSurface& surface)
    : QCPLayerable(&surface, QStringLiteral("main")), m_surface(surface) {}

void SurfaceScene::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(true);
}

QRect SurfaceScene::clipRect() const {
    return m_surface.viewport();
}

/// Over each zone or section the surface is level; between them it falls steeply.
std::vector<SurfaceScene::Facet> SurfaceScene::facets() const {
    const LayerSeries& series = m_surface.series();
    const double numbers = series.spans.back().last;
    const double highest = std::max(series.largestSum_mm(), 1e-12);
    std::vector<std::size_t> columns(series.columns.size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    const auto stretch = [&series](std::size_t j) { return series.columns[j].stretch; };
    std::ranges::sort(columns, {}, [&](std::size_t j) { return stretch(j).from_mm; });
    const std::size_t done = m_surface.done().count;
    const std::size_t together = (series.spans.size() + mostRows - 1) / mostRows;
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < done;) {
        const int stage = series.spans[i].stage;
        std::size_t end = i;
        while (end < done && end - i < together && series.spans[end].stage == stage) {
            ++end;
        }
        const double y0 = i > 0 ? series.spans[i - 1].last / numbers : 0;
        const double y1 = series.spans[end - 1].last / numbers;
        const auto add = [&](double x0, double x1, std::size_t a, std::size_t b) {
            const auto height = [&](std::size_t column, std::size_t n) {
                return sumDone_mm(series, m_surface.done(), column, n) / highest;
            };
            const double z[] = {height(a, i), height(b, i), height(b, end), height(a, end)};
            const double x[] = {x0, x1, x1, x0}, y[] = {y0, y0, y1, y1};
            Facet facet;
            for (int corner = 0; corner < 4; ++corner) {
                facet.corners << m_surface.project(x[corner], y[corner], z[corner]);
                facet.nearness += m_surface.nearness(x[corner], y[corner], z[corner]) / 4;
            }
            const double slope = std::min((z[3] - z[0]) / std::max(y1 - y0, 1e-9) / 4, 1.0);
            const int lightness = flattest + static_cast<int>((steepest - flattest) * slope);
            facet.colour = LayersLook::stage(stage, m_surface.palette()).lighter(lightness);
            facet.edge = end == done && done < series.spans.size();
            facets.push_back(std::move(facet));
        };
        if (m_surface.showsStage(stage)) {
            for (std::size_t j = 0; j < columns.size(); ++j) {
                const Stretch at = stretch(columns[j]);
                add(at.from_mm / series.length_mm, at.to_mm / series.length_mm, columns[j],
                    columns[j]);
                if (j + 1 < columns.size()) {
                    add(at.to_mm / series.length_mm, at.to_mm / series.length_mm, columns[j],
                        columns[j + 1]);
                }
            }
        }
        i = end;
    }
    std::ranges::stable_sort(facets, {}, &Facet::nearness);
    return facets;
}

void SurfaceScene::draw(QCPPainter* painter) {
    if (m_surface.series().columns.empty()) {
        return;
    }
    drawBox(*painter);
    const QColor text = m_surface.palette().color(QPalette::Text);
    for (const Facet& facet : facets()) {
        const QColor colour = style::dimmed(facet.colour, m_surface.isDimmed());
        painter->setPen(QPen(facet.edge ? text : colour.darker(130), facet.edge ? 1.5 : 0.5));
        painter->setBrush(colour);
        painter->drawPolygon(facet.corners);
    }
    for (const int along : {0, 1, 2}) {
        drawScale(*painter, along);
    }
}

/// Ground and the two walls at the back.
void SurfaceScene::drawBox(QCPPainter& painter) const {
    QColor line = m_surface.palette().color(QPalette::Text);
    line.setAlpha(boxAlpha);
    QColor grid = line;
    grid.setAlpha(gridAlpha);
    const auto face = [&](std::size_t level, double at) {
        QPolygonF corners;
        for (int corner = 0; corner < 4; ++corner) {
            Point point{};
            point[level] = at;
            point[(level + 1) % 3] = corner == 1 || corner == 2 ? 1 : 0;
            point[(level + 2) % 3] = corner >= 2 ? 1 : 0;
            corners << m_surface.project(point[0], point[1], point[2]);
        }
        painter.setPen(QPen(line, 1));
        painter.setBrush(grid);
        painter.drawPolygon(corners);
    };
    face(2, 0);
    face(0, m_surface.nearness(0, 0.5, 0.5) < m_surface.nearness(1, 0.5, 0.5) ? 0 : 1);
    face(1, m_surface.nearness(0.5, 0, 0.5) < m_surface.nearness(0.5, 1, 0.5) ? 0 : 1);
}

/// Numbers along an edge of the box that nothing covers, with the name beyond them.
void SurfaceScene::drawScale(QCPPainter& painter, int along) const {
    const LayerSeries& series = m_surface.series();
    const double frontX = m_surface.nearness(0, 0.5, 0) > m_surface.nearness(1, 0.5, 0) ? 0 : 1;
    const double frontY = m_surface.nearness(0.5, 0, 0) > m_surface.nearness(0.5, 1, 0) ? 0 : 1;
    const double most[] = {series.length_mm, double(series.spans.back().last),
                           series.largestSum_mm() * units::umPerMm};
    const bool traverse = series.operation == Operation::traverse;
    const QString names[] = {LayersSurface::tr("Length, mm"),
                             traverse ? LayersSurface::tr("Double stroke")
                                      : LayersSurface::tr("Revolution"),
                             LayersSurface::tr("Accumulated actual feed, µm")};
    // The upright edge is the one farthest to the left.
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
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double size = std::max(most[along], 1e-9);
    const double step = roundUp125(along == 1 ? std::max(size / mostTicks, 1.0) : size / mostTicks);
    // Two zeros meet in the corner: the upright one is left out.
    for (double value = along == 2 ? step : 0; value <= size * (1 + 1e-9); value += step) {
        painter.drawLine(at(value / size, 0), at(value / size, tickLength));
        write(at(value / size, along == 2 ? tickLength * 1.5 : numberAway),
              locale.toString(value, 'g', 6), along == 2);
    }
    if (along == 2) { // over the edge, from its left end
        const QPointF top = at(1, 0) - QPointF(0, metrics.height() * 1.2);
        const double width = metrics.horizontalAdvance(names[2]) + 2;
        const QPointF middle(std::max(top.x(), width / 2 + 4), top.y());
        painter.fillRect(QRectF(middle.x() - width / 2, middle.y() - metrics.height() / 2.0, width,
                                metrics.height()),
                         m_surface.palette().color(QPalette::Base));
        write(middle, names[2], false);
    } else {
        write(at(0.5, nameAway), names[along], false);
    }
}

} // namespace sparkout
