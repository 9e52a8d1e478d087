// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/handout/state_grid_sheet.h"

#include "core/study/search_edits.h"
#include "ui/dynamic_programming/state_grid_plot.h"
#include "ui/dynamic_programming/state_grid_text.h"
#include "ui/report/format/plot_figure.h"
#include "ui/text/number_text.h"

#include <QElapsedTimer>

#include <memory>
#include <stop_token>
#include <utility>

namespace sparkout::report {

namespace {

constexpr int gridHeight = 470;
constexpr qint64 longestProof_ms = 10'000;
constexpr int sheetDigits = 4;

QString orDash(const QString& text) {
    return text.isEmpty() ? QStringLiteral("–") : text;
}

StateGridOutcomePtr filledGrid(const Project& project, const std::function<void()>& breathe) {
    auto outcome = std::make_shared<StateGridOutcome>();
    outcome->project = project;
    auto grid = fillStateGrid(project, usualStateGrid(project), {}, [&breathe](int) { breathe(); });
    outcome->grid = std::move(*grid); // not stopped
    std::stop_source stop;
    QElapsedTimer timer;
    timer.start();
    outcome->exact = exactAnswer(outcome->grid, stop.get_token(), [&](const SearchProgress&) {
        breathe();
        if (timer.hasExpired(longestProof_ms)) {
            stop.request_stop();
        }
    });
    return outcome;
}

} // namespace

Table StateGridSheet::wayBack(const StateGrid& grid) {
    Table table;
    const TimeUnit unit = StateGridText::unit(grid);
    table.head = QStringList{tr("State"),          tr("Stock left, mm"),
                             tr("Feed"),           unit.titled(QStringLiteral("T")),
                             QStringLiteral("m*"), tr("Moves struck out")};
    table.texts = {true, false, false, false, false, true};
    for (int n = grid.size.levels; n >= 1; --n) {
        const std::size_t feed = grid.path[static_cast<std::size_t>(n - 1)];
        const GridState& state = grid.state(n, feed);
        const QString out = StateGridText::struckOut(state);
        table.rows.push_back(
            {StateGridText::state(n, feed),
             printedNumber(grid.stock_mm[static_cast<std::size_t>(n)], sheetDigits),
             StateGridText::feed(grid.feeds[feed], grid.project.operation),
             StateGridText::amount(*state.time_s, unit),
             orDash(n > 1 ? QString::number(state.from + 1) : QString()), orDash(out)});
    }
    return table;
}

Table StateGridSheet::wrongStates(const ExactAnswer& exact) {
    Table table;
    table.head = QStringList{tr("State"), tr("Where the rule is wrong")};
    table.texts = {true, true};
    for (const StateFault& fault : exact.faults) {
        table.rows.push_back(
            {StateGridText::state(fault.level, fault.feed), StateGridText::wrong(fault)});
    }
    return table;
}

std::vector<Block> StateGridSheet::blocks(const OutcomePtr& outcome,
                                          const std::function<void()>& breathe) {
    Project project = outcome->result.project;
    if (!project.optimisation) {
        project = withUsualSearch(std::move(project));
    }
    project = withSearchFor(std::move(project));
    const QString fault = StateGridText::fault(stateGridFault(project));
    if (!fault.isEmpty()) {
        return {Paragraph{fault}};
    }
    const StateGridOutcomePtr filled = filledGrid(project, breathe);
    const StateGrid& grid = filled->grid;
    std::vector<Block> blocks{Paragraph{tr(
        "A cell [n, m] holds the minimum time T[n,m] in which n levels of stock are removed, the "
        "last with feed m, and m*, the feed before it: T[n,m] = min over m' of (T[n−1,m'] + τ), "
        "T[0,0] = 0, over the moves that break no requirement. The minimum time of the last level "
        "is that of the cycle; its feeds are read back along m*.")}};
    StateGridPlot plot;
    setUpForPaper(plot, gridHeight);
    plot.setGrid(filled);
    plot.restyle();
    plot.fit();
    const QString caption =
        tr("The grid of dynamic programming: T, %1, and m*").arg(StateGridText::unit(grid).text());
    blocks.emplace_back(plotFigure(plot, plot.legendEntries(), caption,
                                   StateGridText::answer(grid, filled->exact)));
    for (const QString& line : StateGridText::answer(grid, filled->exact).split(u'\n')) {
        blocks.emplace_back(Paragraph{line});
    }
    if (!grid.path.empty()) {
        blocks.emplace_back(wayBack(grid));
    }
    if (!filled->exact->faults.empty()) {
        blocks.emplace_back(wrongStates(*filled->exact));
    }
    return blocks;
}

} // namespace sparkout::report
