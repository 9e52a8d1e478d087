// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dynamic_programming/state_grid_plot.h"

#include "core/units.h"
#include "ui/dynamic_programming/state_grid_text.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double gridRoom = 0.6; ///< beyond the outer states
constexpr int labelDigits = 3;
constexpr int cellTint = 28; ///< opacity of a reached state, up to 255
constexpr std::array parts{GridPart::rulePath, GridPart::provenPath, GridPart::wrong,
                           GridPart::noMove, GridPart::moves};

} // namespace

StateGridPlot::StateGridPlot(QWidget* parent)
    : ViewPlot(parent), m_rect(addRect()), m_layer(new StateGridLayer(*m_rect)) {
    for (QCPAxis* axis : {across(), up()}) {
        axis->setTicker(QSharedPointer<QCPAxisTickerText>::create());
        axis->grid()->setVisible(false);
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
    const int before = moment();
    m_outcome = std::move(outcome);
    m_layer->setGrid(m_outcome);
    if (same) {
        m_layer->setMoment(before);
    }
    contentSet();
}

void StateGridPlot::setMoment(int number) {
    m_layer->setMoment(number);
}

void StateGridPlot::fit() {
    if (m_outcome) {
        const StateGrid& grid = m_outcome->grid;
        style::setSafeRange(*across(), -gridRoom, grid.size.levels + gridRoom);
        style::setSafeRange(*up(), -gridRoom,
                            static_cast<double>(grid.feeds.size()) - 1 + gridRoom);
    }
}

std::optional<std::pair<int, std::size_t>> StateGridPlot::stateAt(const QPointF& at) const {
    if (!m_outcome || !m_rect->rect().contains(at.toPoint())) {
        return std::nullopt;
    }
    const double level = std::round(across()->pixelToCoord(at.x()));
    const double feed = std::round(up()->pixelToCoord(at.y()));
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
    const auto ticker = [](const QCPAxis& axis) {
        return axis.ticker().staticCast<QCPAxisTickerText>();
    };
    ticker(*across())->clear();
    ticker(*up())->clear();
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
    const double pitch = std::abs(across()->coordToPixel(1) - across()->coordToPixel(0));
    const int every = std::max(1, static_cast<int>(std::ceil(widest / std::max(pitch, 1.0))));
    for (int n = grid.size.levels; n >= 0; n -= every) {
        ticker(*across())->addTick(n, label(grid.stock_mm[static_cast<std::size_t>(n)]));
    }
    const double height = std::abs(up()->coordToPixel(1) - up()->coordToPixel(0));
    const auto rows = static_cast<std::size_t>(
        std::max(1.0, std::ceil(metrics.height() / std::max(height, 1.0))));
    for (std::size_t m = 0; m < grid.feeds.size(); m += rows) {
        ticker(*up())->addTick(static_cast<double>(m),
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
    table.header << tr("Level n") << tr("Stock left per side, mm") << tr("Feed m")
                 << (axial ? tr("Radial feed, mm per double stroke") : tr("Radial feed, mm/min"));
    if (axial) {
        table.header << tr("Axial feed, mm/min");
    }
    table.header << tr("T, min") << tr("m*") << tr("Moves struck out")
                 << tr("Where the rule is wrong");
    for (int n = 1; n <= grid.size.levels; ++n) {
        for (std::size_t m = 0; m < grid.feeds.size(); ++m) {
            const GridState& state = grid.state(n, m);
            std::vector<CsvCell> row{double(n), grid.stock_mm[static_cast<std::size_t>(n)],
                                     double(m + 1), grid.feeds[m].radial};
            if (axial) {
                row.emplace_back(grid.feeds[m].axialFeed_mm_min);
            }
            row.push_back(state.time_s ? CsvCell(*state.time_s / units::secondsPerMinute)
                                       : CsvCell());
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

void StateGridPlot::restyle() {
    ViewPlot::restyle();
    const QColor text = ink();
    m_layer->setColours(
        {text, style::dimmed(style::thinned(palette().color(QPalette::Text), cellTint), isDimmed()),
         toned(Drawn::yourCycle), toned(Drawn::everyRequirementHolds), toned(Drawn::fails), text});
}

void StateGridPlot::showChoice() {
    ViewPlot::showChoice();
    std::set<GridPart> hidden;
    for (const GridPart part : parts) {
        if (!shows(static_cast<int>(part))) {
            hidden.insert(part);
        }
    }
    m_layer->setHidden(std::move(hidden));
}

LegendEntries StateGridPlot::legendEntries() const {
    if (!m_outcome) {
        return {};
    }
    const StateGridLayer::Colours& colours = m_layer->colours();
    const auto key = [](GridPart part) { return static_cast<int>(part); };
    LegendEntries entries;
    if (!m_outcome->grid.path.empty()) {
        entries.push_back(
            lineEntry(key(GridPart::rulePath), QPen(colours.rule, 3), tr("path back along m*")));
    }
    if (m_outcome->exact && !m_outcome->exact->path.empty()) {
        entries.push_back(lineEntry(key(GridPart::provenPath),
                                    QPen(colours.proven, 3, Qt::DashLine),
                                    tr("proven quickest cycle")));
    }
    if (m_outcome->exact && !m_outcome->exact->faults.empty()) {
        entries.push_back(
            areaEntry(key(GridPart::wrong), colours.fails, tr("the rule is wrong here")));
        entries.back().swatch = Swatch::square;
    }
    entries.push_back(areaEntry(key(GridPart::noMove), Qt::transparent, tr("no admissible move")));
    entries.back().hatch = Hatch::rising;
    entries.back().hatchLine = colours.fails;
    entries.push_back(lineEntry(key(GridPart::moves), QPen(colours.ink, 2.5),
                                tr("moves into the state (× struck out)")));
    return entries;
}

void StateGridPlot::setTexts() {
    across()->setLabel(tr("Stock left per side, mm"));
    const bool axial = m_outcome && m_outcome->grid.project.operation->axial();
    // In two lines: one is longer than the axis of a small window.
    up()->setLabel(axial ? tr("m: radial feed, mm/dbl stroke\naxial feed, mm/min")
                         : tr("m: radial feed, mm/min"));
    thinLabels();
}

} // namespace sparkout
