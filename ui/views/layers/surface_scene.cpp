// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/surface_scene.h"

#include "ui/charts/magnified_profile.h"
#include "ui/text/number_text.h"
#include "ui/views/layers/layers_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr double tickLength = 0.025; ///< length of ticks, in edges of the box
constexpr double numberAway = 0.075, nameAway = 0.3;
constexpr double mostTicks = 5;

using Point = std::array<double, 3>; ///< in the box, 0…1 each

} // namespace

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

} // namespace sparkout
