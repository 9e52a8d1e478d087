// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dynamic_programming/state_grid_layer.h"

#include "ui/dynamic_programming/state_grid_plot.h"
#include "ui/dynamic_programming/state_grid_text.h"
#include "ui/kit/font_size.h"
#include "ui/kit/hatch.h"
#include "ui/text/names.h"

#include <algorithm>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double cellWidth = 0.8, cellHeight = 0.72; ///< relative to the distance of two states
constexpr int cellDigits = 3;
constexpr double textAir = 6;     ///< [px] beside a cell's text
constexpr double leastFont = 0.7; ///< relative to the plot's
constexpr double strikeSize = 3;  ///< [px] size of the cross on a struck-out move
constexpr double mostCorner = 9;  ///< [px] size of the mark of a wrong state
constexpr double pathShift = 2;   ///< [px] distance of two paths in one state
constexpr double frameWidth = 2.5, pathWidth = 3;
constexpr int cellTint = 28; ///< opacity of a reached state, up to 255
constexpr float pathOpacity = 0.28F, moveOpacity = 0.45F, hatchOpacity = 0.35F;

QColor faded(QColor colour, float opacity) {
    colour.setAlphaF(colour.alphaF() * opacity);
    return colour;
}

} // namespace

StateGridLayer::StateGridLayer(const StateGridPlot& plot)
    : PaintedLayer(plot.cell(), QStringLiteral("main"), Edges::smooth), m_plot(plot) {}

const StateGrid& StateGridLayer::grid() const {
    return m_plot.outcome()->grid;
}

bool StateGridLayer::shows(GridPart part) const {
    return m_plot.shows(static_cast<int>(part));
}

QColor StateGridLayer::failing() const {
    return m_plot.toned(Drawn::fails);
}

// --- where and what -----------------------------------------------------------------------------

QRectF StateGridLayer::boxAt(double level, double feed) const {
    return QRectF(m_plot.pixelOf({level - cellWidth / 2, feed - cellHeight / 2}),
                  m_plot.pixelOf({level + cellWidth / 2, feed + cellHeight / 2}))
        .normalized();
}

QRectF StateGridLayer::cell(int level, std::size_t feed) const {
    return boxAt(level, static_cast<double>(feed));
}

QRectF StateGridLayer::blankCell() const {
    return boxAt(0, (static_cast<double>(grid().feeds.size()) - 1) / 2);
}

bool StateGridLayer::isFilled(int level, std::size_t feed) const {
    return momentOf(grid(), level, feed) <= m_plot.moment();
}

QString StateGridLayer::textOf(const GridState& state, int level, Room room) const {
    if (!state.time_s || room == Room::none) {
        return {};
    }
    const QString time = Names::significant(m_unit.of(*state.time_s), cellDigits);
    if (level == 1 || room == Room::time) {
        return time;
    }
    return time + (room == Room::oneLine ? QStringLiteral(" | ") : QStringLiteral("\n"))
           + QString::number(state.from + 1);
}

QString StateGridLayer::cellText(int level, std::size_t feed) const {
    return m_plot.outcome() && isFilled(level, feed)
               ? textOf(grid().state(level, feed), level, m_room)
               : QString();
}

/// Chooses one size for all cells, and writes less if not everything fits.
void StateGridLayer::chooseFont(const QFont& usual) {
    const QRectF box = cell(1, 0);
    const QFontMetricsF metrics(usual);
    m_unit = StateGridText::unit(grid());
    m_room = Room::none;
    for (const Room room : {Room::oneLine, Room::twoLines, Room::time}) {
        double widest = 1;
        for (int n = 1; n <= grid().size.levels; ++n) {
            for (const GridState& state : grid().states[static_cast<std::size_t>(n - 1)]) {
                for (const QString& line : textOf(state, n, room).split(u'\n')) {
                    widest = std::max(widest, metrics.horizontalAdvance(line));
                }
            }
        }
        const double high = metrics.height() * (room == Room::twoLines ? 2 : 1);
        const double times = std::min({1.0, (box.width() - textAir) / widest, box.height() / high});
        if (times >= leastFont) {
            m_room = room;
            m_font = enlarged(usual, times);
            return;
        }
    }
}

// --- drawing ------------------------------------------------------------------------------------

void StateGridLayer::draw(QCPPainter* painter) {
    if (!m_plot.outcome()) {
        return;
    }
    chooseFont(m_plot.font());
    const GridMoment now = momentAt(grid(), m_plot.moment());
    const auto& exact = m_plot.outcome()->exact;
    drawCells(*painter);
    if (shows(GridPart::rulePath) && now.stepsBack > 0) {
        drawPath(*painter, grid().path, grid().size.levels - now.stepsBack + 1,
                 QPen(m_plot.toned(Drawn::yourCycle), pathWidth), -pathShift);
    }
    const bool all = m_plot.moment() >= momentsOfFilling(grid());
    if (shows(GridPart::provenPath) && all && exact && !exact->path.empty()) {
        drawPath(*painter, exact->path, 1,
                 QPen(m_plot.toned(Drawn::everyRequirementHolds), pathWidth, Qt::DashLine),
                 pathShift);
    }
    if (shows(GridPart::moves) && now.level > 0) {
        drawMoves(*painter);
    }
    if (shows(GridPart::wrong)) {
        drawWrong(*painter);
    }
    if (now.level > 0) {
        painter->setPen(QPen(m_plot.ink(), frameWidth));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(cell(now.level, now.feed));
    }
}

void StateGridLayer::drawCells(QCPPainter& painter) const {
    painter.setFont(m_font);
    const QColor ink = m_plot.ink(), frame = faded(ink, moveOpacity);
    const QColor tint = style::dimmed(
        style::thinned(m_plot.palette().color(QPalette::Text), cellTint), m_plot.isDimmed());
    const auto box = [&](const QRectF& area, const QColor& fill, const QString& text) {
        painter.setPen(QPen(frame, 1));
        painter.setBrush(fill);
        painter.drawRect(area);
        if (!text.isEmpty()) {
            painter.setPen(ink);
            painter.drawText(area, static_cast<int>(Qt::AlignCenter), text);
        }
    };
    box(blankCell(), tint, m_room == Room::none ? QString() : QStringLiteral("0"));
    for (int n = 1; n <= grid().size.levels; ++n) {
        for (std::size_t m = 0; m < grid().feeds.size(); ++m) {
            const QRectF area = cell(n, m);
            const bool reached = grid().state(n, m).time_s.has_value();
            if (!isFilled(n, m)) {
                painter.setPen(QPen(faded(frame, moveOpacity), 1, Qt::DotLine));
                painter.setBrush(Qt::NoBrush);
                painter.drawRect(area);
            } else if (reached) {
                box(area, tint, cellText(n, m));
            } else if (shows(GridPart::noMove)) {
                box(area, Qt::transparent, {});
                paintHatch(painter, area, Hatch::rising, faded(failing(), hatchOpacity));
            }
        }
    }
}

/// Draws a path from a level on through its states, shifted apart from the other.
void StateGridLayer::drawPath(QCPPainter& painter, const std::vector<std::size_t>& path, int from,
                              const QPen& pen, double shift) const {
    QPolygonF line;
    if (from == 1) {
        line << blankCell().center() + QPointF(0, shift);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(pen.color(), pathOpacity));
    for (int n = from; n <= grid().size.levels; ++n) {
        const QRectF area = cell(n, path[static_cast<std::size_t>(n - 1)]);
        painter.drawRect(area);
        line << area.center() + QPointF(0, shift);
    }
    // Only between the cells, which have the times.
    painter.setPen(pen);
    for (qsizetype i = 1; i < line.size(); ++i) {
        const double half = cell(1, 0).width() / 2;
        const QLineF whole(line[i - 1], line[i]);
        painter.drawLine(QLineF(whole.p1() + QPointF(half, 0), whole.p2() - QPointF(half, 0)));
    }
}

void StateGridLayer::drawMoves(QCPPainter& painter) const {
    const GridMoment now = momentAt(grid(), m_plot.moment());
    const GridState& state = grid().state(now.level, now.feed);
    const QRectF to = cell(now.level, now.feed);
    const QPointF end(to.left(), to.center().y());
    const auto drawMove = [&](std::size_t i, bool kept) {
        const StateMove& move = state.moves[i];
        if (move.end == MoveEnd::noState || (move.end == MoveEnd::kept) != kept) {
            return;
        }
        const QRectF from = now.level == 1 ? blankCell() : cell(now.level - 1, i);
        const QLineF line(QPointF(from.right(), from.center().y()), end);
        const bool admissible = kept || move.end == MoveEnd::slower;
        painter.setPen(kept         ? QPen(m_plot.ink(), frameWidth)
                       : admissible ? QPen(faded(m_plot.ink(), moveOpacity), 1)
                                    : QPen(faded(failing(), moveOpacity), 1, Qt::DashLine));
        painter.drawLine(line);
        if (!admissible) {
            const QPointF at = line.pointAt(0.25);
            const QPointF along(strikeSize, strikeSize), across(strikeSize, -strikeSize);
            painter.setPen(QPen(failing(), 1.5));
            painter.drawLine(QLineF(at - along, at + along));
            painter.drawLine(QLineF(at - across, at + across));
        }
    };
    for (const bool kept : {false, true}) { // the kept one on top
        for (std::size_t i = 0; i < state.moves.size(); ++i) {
            drawMove(i, kept);
        }
    }
}

void StateGridLayer::drawWrong(QCPPainter& painter) const {
    const auto& exact = m_plot.outcome()->exact;
    if (!exact) {
        return;
    }
    painter.setBrush(Qt::NoBrush);
    for (const StateFault& fault : exact->faults) {
        if (isFilled(fault.level, fault.feed)) {
            const QRectF area = cell(fault.level, fault.feed).adjusted(-2, -2, 2, 2);
            painter.setPen(QPen(failing(), frameWidth));
            painter.drawRect(area);
            const double corner = std::min({area.height() / 2, area.width() / 2, mostCorner});
            painter.setPen(Qt::NoPen);
            painter.setBrush(failing());
            painter.drawPolygon(QPolygonF{area.topRight(), area.topRight() - QPointF(corner, 0),
                                          area.topRight() + QPointF(0, corner)});
            painter.setBrush(Qt::NoBrush);
        }
    }
}

} // namespace sparkout
