// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dynamic_programming/grid_moment.h"
#include "ui/plot/painted_layer.h"
#include "ui/text/time_unit.h"

#include <vector>

namespace sparkout {

class StateGridPlot;

/// The parts that can be hidden: keys of the legend.
enum class GridPart { rulePath, provenPath, wrong, noMove, moves };

/// The cells of the grid of a StateGridPlot at a moment of its filling: T and m* if they fit, the
/// moves into the current state, the path read back and the proven one. Horizontally a state is at
/// the number of its level, vertically at that of its feed, from 0.
class StateGridLayer : public PaintedLayer {
    Q_OBJECT
public:
    explicit StateGridLayer(const StateGridPlot& plot);

    /// The rectangle of a state, in pixels.
    [[nodiscard]] QRectF cell(int level, std::size_t feed) const;
    /// The text in its cell; empty if it does not fit, or is not filled.
    [[nodiscard]] QString cellText(int level, std::size_t feed) const;

protected:
    void draw(QCPPainter* painter) override;

private:
    enum class Room { none, time, twoLines, oneLine };

    [[nodiscard]] QString textOf(const GridState& state, int level, Room room) const;
    [[nodiscard]] const StateGrid& grid() const;
    [[nodiscard]] bool shows(GridPart part) const;
    [[nodiscard]] QColor failing() const;
    [[nodiscard]] bool isFilled(int level, std::size_t feed) const;
    [[nodiscard]] QRectF blankCell() const;
    [[nodiscard]] QRectF boxAt(double level, double feed) const;
    void chooseFont(const QFont& usual);
    void drawCells(QCPPainter& painter) const;
    void drawPath(QCPPainter& painter, const std::vector<std::size_t>& path, int from,
                  const QPen& pen, double shift) const;
    void drawMoves(QCPPainter& painter) const;
    void drawWrong(QCPPainter& painter) const;

    const StateGridPlot& m_plot;
    TimeUnit m_unit;
    QFont m_font;
    Room m_room = Room::none;
};

} // namespace sparkout
