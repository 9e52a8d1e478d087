// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dynamic_programming/state_grid_plot.h"

#include "ui/dynamic_programming/state_grid_text.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

using style::Drawn;

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
        for (const StateFault& fault : m_outcome->exact->faults) {
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
                 << tr("Where the rule is wrong");
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
            for (const StateFault& fault :
                 m_outcome->exact ? m_outcome->exact->faults : std::vector<StateFault>()) {
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
