// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dynamic_programming/grid_moment.h"
#include "ui/dynamic_programming/state_grid_outcome.h"
#include "ui/plot/painted_layer.h"
#include "ui/text/time_unit.h"

#include <optional>
#include <set>

namespace sparkout {

/// The parts that can be hidden.
enum class GridPart { rulePath, provenPath, wrong, noMove, moves };

/// The cells of a grid of states at a moment of its filling: T and m* if they fit, the moves into
/// the current state, the path read back and the proven one. Horizontally a state is at the number
/// of its level, vertically at that of its feed, from 0.
class StateGridLayer : public PaintedLayer {
    Q_OBJECT
public:
    explicit StateGridLayer(QCPAxisRect& rect);

    struct Colours {
        QColor ink, cell, rule, proven, fails, current;
    };

    void setGrid(StateGridOutcomePtr outcome);
    void setMoment(int number) { m_number = number; }
    void setColours(const Colours& colours) { m_colours = colours; }
    void setHidden(std::set<GridPart> hidden) { m_hidden = std::move(hidden); }
    [[nodiscard]] const Colours& colours() const { return m_colours; }
    [[nodiscard]] int moment() const { return m_number; }
    /// The rectangle of a state, in pixels.
    [[nodiscard]] QRectF cell(int level, std::size_t feed) const;
    /// The text in its cell; empty if it does not fit, or is not filled.
    [[nodiscard]] QString cellText(int level, std::size_t feed) const;

protected:
    void draw(QCPPainter* painter) override;

private:
    enum class Room { none, time, twoLines, oneLine };

    [[nodiscard]] QString textOf(const GridState& state, int level, Room room) const;
    [[nodiscard]] const StateGrid& grid() const { return m_outcome->grid; }
    [[nodiscard]] bool shows(GridPart part) const { return !m_hidden.contains(part); }
    [[nodiscard]] bool isFilled(int level, std::size_t feed) const;
    [[nodiscard]] QRectF blankCell() const;
    [[nodiscard]] QRectF boxAt(double level, double feed) const;
    void chooseFont(const QFont& usual);
    void drawCells(QCPPainter& painter) const;
    void drawPath(QCPPainter& painter, const std::vector<std::size_t>& path, int from,
                  const QPen& pen, double shift) const;
    void drawMoves(QCPPainter& painter) const;
    void drawWrong(QCPPainter& painter) const;

    StateGridOutcomePtr m_outcome;
    TimeUnit m_unit;
    int m_number = 0;
    std::set<GridPart> m_hidden;
    Colours m_colours;
    QFont m_font;
    Room m_room = Room::none;
};

} // namespace sparkout
