// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/state_grid_plot.h"

#include "ui/chart/painted_layer.h"
#include "ui/kit/font_size.h"
#include "ui/kit/theme.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/study/state_grid_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sparkout {

/// The cells of the grid of a StateGridPlot at a moment of its filling: T and m* if they fit, the
/// moves into the current state, the path read back and the proven one. Horizontally a state is at
/// the number of its level, vertically at that of its feed, from 0.
class StateGridLayer : public PaintedLayer {
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

// --- places and contents of the cells -----------------------------------------------------------

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
    for (const StateDifference& fault : exact->faults) {
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

namespace {

constexpr double gridRoom = 0.6; ///< beyond the outer states
constexpr int labelDigits = 3;

} // namespace

StateGridPlot::StateGridPlot(QWidget* parent)
    : ChartPlot(parent)
    , m_levels(new QCPAxisTickerText)
    , m_feeds(new QCPAxisTickerText)
    , m_layer(new StateGridLayer(*this)) {
    setChart([this] { return made(); });
    for (QCPAxis* axis : {&across(), &up()}) {
        connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
                &StateGridPlot::thinLabels);
    }
    connect(this, &QCustomPlot::afterLayout, this, &StateGridPlot::thinLabels);
    onClick([this](const QPointF& at) {
        if (const auto state = stateAt(at)) {
            emit stateClicked(state->first, state->second);
        }
    });
    built();
}

QRectF StateGridPlot::stateRect(int level, std::size_t feed) const {
    return m_layer->cell(level, feed);
}

QString StateGridPlot::cellText(int level, std::size_t feed) const {
    return m_layer->cellText(level, feed);
}

void StateGridPlot::setGrid(StateGridOutcomePtr outcome) {
    const bool same = m_outcome && outcome && outcome->exact && !m_outcome->exact
                      && m_outcome->grid.size == outcome->grid.size
                      && m_outcome->grid.path == outcome->grid.path;
    m_outcome = std::move(outcome);
    if (!same) {
        m_number = m_outcome ? momentCount(m_outcome->grid) : 0;
    }
    remake();
    fit();
}

LineChart StateGridPlot::made() const {
    LineChart chart;
    const bool axial = m_outcome && m_outcome->grid.project.operation->axial();
    chart.across = {
        .label = tr("Stock left per side, mm"), .room = 0, .hasGrid = false, .ticker = m_levels};
    // In two lines: one is longer than the axis of a small window.
    chart.up = {.label = axial ? tr("m: radial feed, mm/dbl stroke\naxial feed, mm/min")
                               : tr("m: radial feed, mm/min"),
                .room = 0,
                .hasGrid = false,
                .ticker = m_feeds};
    if (!m_outcome) {
        return chart;
    }
    const StateGrid& grid = m_outcome->grid;
    chart.across.range = {-gridRoom, grid.size.levels + gridRoom};
    chart.up.range = {-gridRoom, static_cast<double>(grid.feeds.size()) - 1 + gridRoom};
    const auto add = [&chart](GridPart part, const QString& name, const ChartColour& colour,
                              const QPen& pen) {
        chart.series.push_back(
            {.key = static_cast<int>(part), .name = name, .colour = colour, .pen = pen});
    };
    if (!grid.path.empty()) {
        add(GridPart::rulePath, tr("path back along m*"), Drawn::yourCycle, linePen(3));
    }
    if (m_outcome->exact && !m_outcome->exact->path.empty()) {
        add(GridPart::provenPath, tr("proven quickest cycle"), Drawn::everyRequirementHolds,
            linePen(3, Qt::DashLine));
    }
    if (m_outcome->exact && !m_outcome->exact->faults.empty()) {
        add(GridPart::wrong, tr("the rule is wrong here"), Drawn::fails, {});
        chart.series.back().kind = ChartSeries::Kind::points;
        chart.series.back().swatch = Swatch::square;
    }
    add(GridPart::moves, tr("moves into the state (× struck out)"), {}, linePen(2.5));
    return chart;
}

std::optional<std::pair<int, std::size_t>> StateGridPlot::stateAt(const QPointF& at) const {
    if (!m_outcome || !cell().rect().contains(at.toPoint())) {
        return std::nullopt;
    }
    const double level = std::round(across().pixelToCoord(at.x()));
    const double feed = std::round(up().pixelToCoord(at.y()));
    const StateGrid& grid = m_outcome->grid;
    if (level < 1 || level > grid.size.levels || feed < 0
        || feed >= static_cast<double>(grid.feeds.size())) {
        return std::nullopt;
    }
    return std::pair{static_cast<int>(level), static_cast<std::size_t>(feed)};
}

QString StateGridPlot::valuesAt(const QPointF& at) const {
    const auto state = stateAt(at);
    if (!state) {
        return {};
    }
    QString text = StateGridText::moment(m_outcome->grid, {state->first, state->second, 0});
    if (m_outcome->exact) {
        for (const StateDifference& fault : m_outcome->exact->faults) {
            if (fault.level == state->first && fault.feed == state->second) {
                text += u'\n' + tr("Wrong: %1").arg(StateGridText::wrong(fault));
            }
        }
    }
    return text;
}

// --- labels of the states -----------------------------------------------------------------------

/// As many as fit side by side, or one above the other; the last level always has a label.
void StateGridPlot::thinLabels() {
    m_levels->clear();
    m_feeds->clear();
    if (!m_outcome) {
        return;
    }
    const StateGrid& grid = m_outcome->grid;
    const QFontMetrics metrics(font());
    const auto label = [](double value) { return printedNumber(value, labelDigits); };
    int widest = 1;
    for (const double stock : grid.stock_mm) {
        widest = std::max(widest, metrics.horizontalAdvance(label(stock) + QStringLiteral("00")));
    }
    const double pitch = std::abs(across().coordToPixel(1) - across().coordToPixel(0));
    const int every = std::max(1, static_cast<int>(std::ceil(widest / std::max(pitch, 1.0))));
    for (int n = grid.size.levels; n >= 0; n -= every) {
        m_levels->addTick(n, label(grid.stock_mm[static_cast<std::size_t>(n)]));
    }
    const double height = std::abs(up().coordToPixel(1) - up().coordToPixel(0));
    const auto rows = static_cast<std::size_t>(
        std::max(1.0, std::ceil(metrics.height() / std::max(height, 1.0))));
    for (std::size_t m = 0; m < grid.feeds.size(); m += rows) {
        m_feeds->addTick(static_cast<double>(m),
                         QStringLiteral("%1:  %2").arg(m + 1).arg(
                             StateGridText::feed(grid.feeds[m], grid.project.operation)));
    }
}

// --- table, look and words ----------------------------------------------------------------------

CsvTable StateGridPlot::table() const {
    CsvTable table;
    if (!m_outcome) {
        return table;
    }
    const StateGrid& grid = m_outcome->grid;
    const bool axial = grid.project.operation->axial() != nullptr;
    const TimeUnit unit = StateGridText::unit(grid);
    table.header << tr("Level n") << tr("Stock left per side, mm") << tr("Feed m")
                 << (axial ? tr("Radial feed, mm per double stroke") : tr("Radial feed, mm/min"));
    if (axial) {
        table.header << tr("Axial feed, mm/min");
    }
    table.header << unit.titled(QStringLiteral("T")) << tr("m*") << tr("Moves struck out")
                 << tr("States in which the rule is wrong");
    for (int n = 1; n <= grid.size.levels; ++n) {
        for (std::size_t m = 0; m < grid.feeds.size(); ++m) {
            const GridState& state = grid.state(n, m);
            std::vector<CsvCell> row{double(n), grid.stock_mm[static_cast<std::size_t>(n)],
                                     double(m + 1), grid.feeds[m].radial};
            if (axial) {
                row.emplace_back(grid.feeds[m].axialFeed_mm_min);
            }
            row.push_back(state.time_s ? CsvCell(unit.of(*state.time_s)) : CsvCell());
            row.push_back(state.time_s && n > 1 ? CsvCell(double(state.from + 1)) : CsvCell());
            row.emplace_back(StateGridText::struckOut(state));
            QString wrong;
            for (const StateDifference& fault :
                 m_outcome->exact ? m_outcome->exact->faults : std::vector<StateDifference>()) {
                if (fault.level == n && fault.feed == m) {
                    wrong = StateGridText::wrong(fault);
                }
            }
            row.emplace_back(wrong);
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

LegendEntries StateGridPlot::legendEntries() const {
    LegendEntries entries = ChartPlot::legendEntries();
    if (!entries.empty()) {
        LegendEntry noMove = areaEntry(static_cast<int>(GridPart::noMove), Qt::transparent,
                                       tr("no admissible move"));
        noMove.hatch = Hatch::rising;
        noMove.hatchLine = toned(Drawn::fails);
        entries.insert(entries.end() - 1, noMove);
    }
    return entries;
}

void StateGridPlot::setTexts() {
    ChartPlot::setTexts();
    thinLabels();
}

} // namespace sparkout
