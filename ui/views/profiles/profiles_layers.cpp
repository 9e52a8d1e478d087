// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profiles/profiles_layers.h"
#include "ui/plot/plot_style.h"
#include "ui/text/names.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace sparkout {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int spokeStep = 30;            ///< [°]
constexpr double leastLinesApart = 1.05; ///< distance of the grid's circles, in line heights
constexpr int mostCircles = 100;
constexpr double wholeCircle_px = 2000; ///< larger circles are drawn as visible arcs
constexpr double margin_px = 20;

QPointF direction(double angle) {
    return {std::cos(angle), -std::sin(angle)}; // the pixels' y runs downwards
}

} // namespace

PolarLayer::PolarLayer(QCPAxisRect* rect, const QString& layer)
    : PaintedLayer(*rect, layer, Edges::smooth) {}

QPointF PolarLayer::centre() const {
    return {m_rect->axis(QCPAxis::atBottom)->coordToPixel(0),
            m_rect->axis(QCPAxis::atLeft)->coordToPixel(0)};
}

double PolarLayer::scale() const {
    const QCPAxis* axis = m_rect->axis(QCPAxis::atBottom);
    return axis->coordToPixel(1) - axis->coordToPixel(0);
}

PolarLayer::VisiblePart PolarLayer::visiblePart() const {
    const QRectF rect = m_rect->rect();
    const QPointF c = centre();
    const QPointF middle = rect.center() - c;
    const double half = std::hypot(rect.width(), rect.height()) / 2;
    const double away = std::hypot(middle.x(), middle.y());
    if (away <= half) {
        return {0, away + half, 0, 2 * std::numbers::pi};
    }
    const double spread = std::asin(half / away);
    return {away - half, away + half, std::atan2(-middle.y(), middle.x()) - spread, 2 * spread};
}

QPolygonF PolarLayer::arc(const VisiblePart& part, double radius_px) const {
    constexpr int parts = 120;
    QPolygonF points;
    for (int i = 0; i <= parts; ++i) {
        points << centre() + radius_px * direction(part.from + part.span * i / parts);
    }
    return points;
}

// Only the visible part of a very large circle is drawn, since dashes are slow.
void PolarLayer::drawCircle(QCPPainter* painter, double radius) const {
    const double r = radius * scale();
    const VisiblePart seen = visiblePart();
    if (r < seen.near - margin_px || r > seen.far + margin_px) {
        return;
    }
    if (r <= wholeCircle_px) {
        painter->drawEllipse(centre(), r, r);
    } else {
        painter->drawPolyline(arc(seen, r));
    }
}

// --- ring and circle ----------------------------------------------------------------------------

void PolarRing::setRing(double inner, double outer, double reach) {
    m_inner = std::max(inner, 0.0);
    m_outer = std::max(outer, 0.0);
    m_reach = reach;
}

void PolarRing::setLook(const QPen& edge, const QColor& fill) {
    m_edge = edge;
    m_fill = fill;
}

void PolarRing::draw(QCPPainter* painter) {
    const VisiblePart seen = visiblePart();
    const double inner = std::max(m_inner * scale(), seen.near - margin_px);
    const double outer = std::min(std::min(m_outer, m_reach) * scale(), seen.far + margin_px);
    if (outer <= inner) {
        return;
    }
    QPainterPath ring;
    if (outer <= wholeCircle_px) {
        ring.addEllipse(centre(), outer, outer);
        ring.addEllipse(centre(), std::max(inner, 0.0), std::max(inner, 0.0)); // odd-even: a hole
    } else {
        QPolygonF polygon = arc(seen, outer);
        const QPolygonF back = arc(seen, std::max(inner, 0.0));
        std::copy(back.crbegin(), back.crend(), std::back_inserter(polygon));
        ring.addPolygon(polygon);
    }
    painter->fillPath(ring, m_fill);
    painter->setPen(m_edge);
    painter->setBrush(Qt::NoBrush);
    for (const double edge : {m_inner, m_outer}) {
        if (edge > 0 && edge <= m_reach) {
            drawCircle(painter, edge);
        }
    }
}

void PolarCircle::draw(QCPPainter* painter) {
    painter->setPen(m_pen);
    painter->setBrush(Qt::NoBrush);
    drawCircle(painter, m_radius);
}

// --- grid ---------------------------------------------------------------------------------------

void PolarGrid::setScale(const PolarScale& scale, double reach) {
    m_scale = scale;
    m_reach = reach;
}

void PolarGrid::setLine(std::vector<ProfilePoint> line) {
    m_line = std::move(line);
}

void PolarGrid::draw(QCPPainter* painter) {
    painter->setFont(mParentPlot->font());
    painter->setBrush(Qt::NoBrush);
    drawSpokes(painter);
    const std::vector<Mark> circles = marks();
    painter->setPen(QPen(style::thinned(mParentPlot->palette().color(QPalette::Text), 50), 0));
    for (const Mark& mark : circles) {
        drawCircle(painter, mark.radius);
    }
    drawLabels(painter, circles);
}

void PolarGrid::drawSpokes(QCPPainter* painter) {
    const double reach = m_reach * scale();
    const QPalette palette = mParentPlot->palette();
    painter->setPen(QPen(style::thinned(palette.color(QPalette::Text), 130), 0));
    drawCircle(painter, m_reach);
    for (int angle = 0; angle < 360; angle += spokeStep) {
        painter->setPen(
            QPen(style::thinned(palette.color(QPalette::Text), angle % 90 == 0 ? 90 : 40), 0));
        painter->drawLine(centre(), centre() + reach * direction(angle * degree));
    }
    m_names.clear();
    // Names are outside the rim if there is room, otherwise just inside a large enough circle.
    constexpr double share = 0.2; ///< share of the radius that a name may cover
    const QFontMetricsF metrics(mParentPlot->font());
    for (int angle = 0; angle < 360; angle += 90) {
        const QString name = mParentPlot->locale().toString(angle) + QChar(0x00B0);
        const QSizeF size(metrics.horizontalAdvance(name) + 4, metrics.height() - 2);
        const QPointF to = direction(angle * degree);
        const QPointF half(to.x() * (size.width() / 2 + 1), to.y() * (size.height() / 2 + 1));
        QRectF box(QPointF(), size);
        box.moveCenter(centre() + reach * to + half);
        if (!QRectF(m_rect->rect()).contains(box)) {
            if (size.width() > share * reach) {
                continue;
            }
            box.moveCenter(centre() + reach * to - half);
        }
        drawText(painter, box, name);
        m_names.push_back(box);
    }
}

void PolarGrid::drawText(QCPPainter* painter, const QRectF& box, const QString& text) const {
    const QPalette palette = mParentPlot->palette();
    const QColor ground = style::thinned(palette.color(QPalette::Base), 190);
    painter->fillRect(box, ground);
    painter->setPen(palette.color(QPalette::Text));
    painter->drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
}

std::vector<PolarGrid::Mark> PolarGrid::marks() const {
    const QFontMetricsF metrics(mParentPlot->font());
    const double apart = leastLinesApart * metrics.height() / scale(); // in units of the axes
    const double step_um = roundUp125(apart / m_scale.magnification * units::umPerMm);
    const auto drawn = [&](int n) {
        return m_scale.at(m_scale.reference_mm + n * step_um / units::umPerMm);
    };
    const double perStep = drawn(1) - drawn(0);
    const int first = static_cast<int>(std::ceil((0.25 * apart - drawn(0)) / perStep));
    const int last = static_cast<int>(std::floor((m_reach - drawn(0)) / perStep + 1e-9));
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step_um) + 1e-9)));
    std::vector<Mark> marks;
    for (int n = first; n <= last && n - first < mostCircles; ++n) {
        const QString number = Names::fixed(n * step_um, n == 0 ? 0 : decimals);
        marks.push_back({drawn(n), n > 0 ? QLatin1Char('+') + number : number});
    }
    return marks;
}

/// @param away 1: just outside its circle, −1: just inside
QRectF PolarGrid::labelBox(const Mark& mark, double angle, double away) const {
    const QFontMetricsF metrics(mParentPlot->font());
    QRectF box(0, 0, metrics.horizontalAdvance(mark.text) + 4, metrics.height() - 2);
    box.moveCenter(centre()
                   + (mark.radius * scale() + away * (box.height() / 2 + 2)) * direction(angle));
    return box;
}

bool PolarGrid::isCrossed(const QRectF& box) const {
    QPointF before;
    for (std::size_t i = 0; i < m_line.size(); ++i) {
        const QPointF here = centre() + scale() * QPointF(m_line[i].x, -m_line[i].y);
        if (i > 0) {
            const QLineF edge(before, here);
            const QRectF around = QRectF(before, here).normalized().adjusted(-2, -2, 2, 2);
            const QLineF down(box.topLeft(), box.bottomRight()),
                up(box.bottomLeft(), box.topRight());
            if (around.intersects(box)
                && (box.contains(here) || edge.intersects(down) == QLineF::BoundedIntersection
                    || edge.intersects(up) == QLineF::BoundedIntersection)) {
                return true;
            }
        }
        before = here;
    }
    return false;
}

/// Whether a label fits here: visible, within the rim, clear of the angle names and the profile.
bool PolarGrid::hasRoom(const QRectF& box) const {
    const QPointF away = box.center() - centre();
    return QRectF(m_rect->rect()).contains(box)
           && std::hypot(away.x(), away.y()) + box.height() / 2 <= m_reach * scale()
           && std::ranges::none_of(m_names,
                                   [&](const QRectF& name) { return name.intersects(box); })
           && !isCrossed(box);
}

/// The labels that fit along a spoke without touching each other.
std::vector<PolarGrid::Label> PolarGrid::labelsAlong(const std::vector<Mark>& marks,
                                                     double angle) const {
    std::vector<Label> labels;
    for (const Mark& mark : marks) {
        for (const double away : {1.0, -1.0}) {
            const QRectF box = labelBox(mark, angle, away);
            const bool touches = !labels.empty() && labels.back().box.intersects(box);
            if (hasRoom(box) && !touches) {
                labels.push_back({box, mark.text});
                break;
            }
        }
    }
    return labels;
}

void PolarGrid::drawLabels(QCPPainter* painter, const std::vector<Mark>& marks) {
    m_labels.clear();
    m_boxes.clear();
    // Places the values along the spoke with room for most of them, preferably a steep one.
    std::vector<Label> best;
    for (const double angle : {70.0, 110.0, 250.0, 290.0, 20.0, 160.0, 200.0, 340.0}) {
        std::vector<Label> labels = labelsAlong(marks, angle * degree);
        if (labels.size() > best.size()) {
            best = std::move(labels);
        }
    }
    for (const Label& label : best) {
        drawText(painter, label.box, label.text);
        m_labels << label.text;
        m_boxes.push_back(label.box);
    }
}

// --- pointer ------------------------------------------------------------------------------------

PolarPointer::PolarPointer(QCPAxisRect* rect) : PolarLayer(rect, QStringLiteral("overlay")) {}

void PolarPointer::point(double angle, double here, double across) {
    m_shown = true;
    m_angle = angle;
    m_here = here;
    m_across = across;
}

void PolarPointer::draw(QCPPainter* painter) {
    if (!m_shown) {
        return;
    }
    const QColor text = mParentPlot->palette().color(QPalette::Text);
    // In a gap there is no radius.
    const bool hasHere = std::isfinite(m_here), hasAcross = std::isfinite(m_across);
    const QPointF here = centre() + (hasHere ? m_here : 0) * scale() * direction(m_angle);
    const QPointF across = centre() - (hasAcross ? m_across : 0) * scale() * direction(m_angle);
    painter->setPen(QPen(text, 1, Qt::DotLine));
    painter->drawLine(here, across);
    painter->setPen(QPen(text, 1.5));
    painter->setBrush(Qt::NoBrush);
    if (hasHere) {
        painter->drawEllipse(here, 5, 5);
    }
    if (hasAcross) {
        painter->drawRect(QRectF(across - QPointF(4, 4), QSizeF(8, 8)));
    }
}

} // namespace sparkout
