// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/layers/side_scene.h"

#include "core/units.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/views/layers/layers_look.h"
#include "ui/views/layers/side_plot.h"

#include <algorithm>

namespace sparkout {

namespace {
constexpr int metalAlpha = 40, goalAlpha = 60, grainAlpha = 150;
constexpr double arrowHead = 5;  ///< [px]
constexpr double leastArrow = 4; ///< shorter yields have no arrow [px]
constexpr double besideText = 6; ///< [px]
} // namespace

SideScene::SideScene(SidePlot& plot)
    : PaintedLayer(plot, QStringLiteral("main"), Edges::sharp), m_plot(plot) {}

QRect SideScene::clipRect() const {
    return m_plot.painted().adjusted(0, 0, 1, 0);
}

double SideScene::xOf(double length_mm) const {
    return m_plot.across().coordToPixel(length_mm);
}

double SideScene::yOf(double radius_mm) const {
    return m_plot.up().coordToPixel(m_plot.above_um(radius_mm));
}

void SideScene::draw(QCPPainter* painter) {
    if (m_plot.scene().surfaces.empty()) {
        return;
    }
    m_plot.drawPartAxis(*painter);
    painter->setClipRect(m_plot.cell().rect().adjusted(0, 0, 1, 1));
    drawBody(*painter);
    drawField(*painter);
    drawGauge(*painter);
    drawWheel(*painter);
    drawYield(*painter);
}

/// Draws the tolerance of the finished part without load.
void SideScene::drawField(QCPPainter& painter) const {
    if (!m_plot.shows(SidePlot::fieldKey)) {
        return;
    }
    const LayerSeries& limits = m_plot.limits();
    const QColor green = m_plot.colourOf(SidePlot::fieldKey);
    const QRectF field(QPointF(xOf(0), yOf(limits.upperLimit_mm)),
                       QPointF(xOf(limits.length_mm), yOf(limits.lowerLimit_mm)));
    painter.setPen(QPen(green, 1));
    painter.setBrush(style::thinned(green, goalAlpha));
    painter.drawRect(field);
}

void SideScene::drawBody(QCPPainter& painter) const {
    const GrindingScene& scene = m_plot.scene();
    const QColor text = m_plot.colourOf(SidePlot::surfaceKey);
    const double foot =
        scene.removalSign > 0 ? m_plot.cell().bottom() + 1.0 : double(m_plot.cell().top());
    const bool whole = m_plot.shows(SidePlot::surfaceKey);
    for (const SceneSurface& surface : scene.surfaces) {
        const double left = xOf(surface.stretch.from_mm), right = xOf(surface.stretch.to_mm);
        const double seen = yOf(m_plot.seen_mm(surface));
        if (whole) {
            painter.fillRect(
                QRectF(QPointF(left, std::min(seen, foot)), QPointF(right, std::max(seen, foot))),
                style::thinned(text, metalAlpha));
            painter.setPen(QPen(text, 2));
            painter.drawLine(QLineF(left, seen, right, seen));
        }
        if (surface.yield_mm > 0 && m_plot.shows(SidePlot::unloadedKey)) {
            const double still = yOf(surface.radius_mm);
            painter.setPen(QPen(text, 1, Qt::DashLine));
            painter.drawLine(QLineF(left, still, right, still));
        }
    }
}

void SideScene::drawWheel(QCPPainter& painter) const {
    if (!m_plot.shows(SidePlot::wheelKey)) {
        return;
    }
    const QRectF wheel = m_plot.wheelRect();
    const QColor colour = m_plot.colourOf(SidePlot::wheelKey);
    painter.fillRect(wheel, QBrush(style::thinned(colour, grainAlpha), Qt::Dense4Pattern));
    painter.setPen(QPen(colour, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(wheel);
}

/// Draws an arrow from the undeflected to the deflected surface, under the middle of the wheel.
void SideScene::drawYield(QCPPainter& painter) const {
    const GrindingScene& scene = m_plot.scene();
    const SceneSurface& at = scene.surfaces[scene.leading];
    const double from = yOf(at.radius_mm), to = yOf(m_plot.seen_mm(at));
    const bool shown = m_plot.shows(SidePlot::unloadedKey) && std::abs(to - from) >= leastArrow;
    if (!shown) {
        return;
    }
    const double middle_mm = std::clamp((scene.wheel.from_mm + scene.wheel.to_mm) / 2,
                                        at.stretch.from_mm, at.stretch.to_mm);
    const double x = xOf(middle_mm), head = to > from ? -arrowHead : arrowHead;
    const QColor colour = m_plot.palette().color(QPalette::Text);
    painter.setAntialiasing(true);
    painter.setPen(QPen(colour, 2));
    painter.drawLine(QLineF(x, from, x, to));
    painter.drawLine(QLineF(x, to, x - arrowHead, to + head));
    painter.drawLine(QLineF(x, to, x + arrowHead, to + head));
    painter.setAntialiasing(false);
    const QString text =
        SidePlot::tr("y %1 µm").arg(Names::significant(at.yield_mm * units::umPerMm));
    const QFontMetrics metrics(m_plot.font());
    const bool below = to > from; // beyond the arrow, in the metal
    QRectF box(x + besideText, below ? to + 2 : to - metrics.height() - 2,
               metrics.horizontalAdvance(text) + 2, metrics.height());
    if (box.right() > m_plot.cell().right()) {
        box.moveRight(x - besideText);
    }
    painter.setFont(m_plot.font());
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

void SideScene::drawGauge(QCPPainter& painter) const {
    const double x = xOf(m_plot.scene().gauge_mm);
    const QColor colour =
        style::dimmed(style::colour(style::Drawn::gauge, m_plot.palette()), m_plot.isDimmed());
    const QCPAxisRect& cell = m_plot.cell();
    painter.setPen(QPen(colour, 1, Qt::DashDotLine));
    painter.drawLine(QLineF(x, cell.top(), x, cell.bottom()));
    const QFontMetrics metrics(m_plot.font());
    const QString name = SidePlot::tr("gauge");
    const QRectF box(x + 3, cell.bottom() - metrics.height() - 2.0,
                     metrics.horizontalAdvance(name) + 2, metrics.height());
    painter.setFont(m_plot.font());
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, name);
}

} // namespace sparkout
