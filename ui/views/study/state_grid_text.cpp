// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/state_grid_text.h"

#include "core/project/cycle.h"
#include "ui/text/names.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace sparkout {

StateGridOutcomePtr filledGrid(const Project& project, StateGridSize size,
                               const Job::Means& means) {
    std::optional<StateGrid> grid =
        fillStateGrid(project, size, means.stop, [&means](int level) { *means.done = level; });
    return grid ? std::make_shared<const StateGridOutcome>(
               StateGridOutcome{project, std::move(*grid), std::nullopt})
                : nullptr;
}

StateGridOutcomePtr provenGrid(const StateGridOutcome& filled, const Job::Means& means) {
    auto outcome = std::make_shared<StateGridOutcome>(filled);
    outcome->exact = exactAnswer(filled.grid, means.stop, [&means](const SearchProgress& progress) {
        if (progress.best && progress.best->time_s > 0) {
            const double share = std::clamp(progress.bound_s / progress.best->time_s, 0.0, 1.0);
            *means.done = static_cast<std::int64_t>(share * double(gridProofParts));
        }
    });
    return outcome;
}

int momentsOfFilling(const StateGrid& grid) {
    return grid.size.levels * static_cast<int>(grid.feeds.size());
}

int momentCount(const StateGrid& grid) {
    return momentsOfFilling(grid) + static_cast<int>(grid.path.size());
}

GridMoment momentAt(const StateGrid& grid, int number) {
    const int feeds = static_cast<int>(grid.feeds.size());
    const int filling = momentsOfFilling(grid);
    number = std::clamp(number, 0, momentCount(grid));
    if (number == 0) {
        return {};
    }
    if (number <= filling) {
        return {(number - 1) / feeds + 1, static_cast<std::size_t>((number - 1) % feeds), 0};
    }
    const int stepsBack = number - filling;
    const int level = grid.size.levels - stepsBack + 1;
    return {level, grid.path[static_cast<std::size_t>(level - 1)], stepsBack};
}

int momentOf(const StateGrid& grid, int level, std::size_t feed) {
    return (level - 1) * static_cast<int>(grid.feeds.size()) + static_cast<int>(feed) + 1;
}

namespace {

constexpr int timeDigits = 4, levelDigits = 4;

QString percent(qint64 share) {
    return QString::number(share) + QStringLiteral("\u00a0%");
}

QString counted(std::int64_t count) {
    return QLocale().toString(qlonglong(count));
}

} // namespace

QString StateGridText::progress(qint64 done, qint64 parts, double) {
    return parts == gridProofParts
               ? tr("Proving: %1").arg(percent(100 * done / std::max(parts, qint64(1))))
               : tr("Level %1 of %2").arg(done).arg(parts);
}

QString StateGridText::fault(StateGridFault fault) {
    switch (fault) {
    case StateGridFault::noSearch:
    case StateGridFault::none: break;
    case StateGridFault::noFeeds:
        return tr("The search lists no feeds for this grid. Add them on the page Search.");
    case StateGridFault::positionControl:
        return tr("The levels of stock are gauged: the grid covers cycles under gauge control. "
                  "This project is under position control; the page Gauge changes that.");
    }
    return {};
}

TimeUnit StateGridText::unit(const StateGrid& grid) {
    double longest_s = 0;
    for (const std::vector<GridState>& level : grid.states) {
        for (const GridState& state : level) {
            longest_s = std::max(longest_s, state.time_s.value_or(0));
        }
    }
    return TimeUnit(longest_s);
}

QString StateGridText::amount(double time_s, const TimeUnit& unit) {
    return Names::significant(unit.of(time_s), timeDigits);
}

QString StateGridText::time(double time_s) {
    return Names::time(time_s, timeDigits);
}

QString StateGridText::feed(const StageSetting& setting, Operation operation) {
    const QString radial = printedNumber(setting.radial);
    return operation->axial()
               ? radial + QStringLiteral(" · ") + printedNumber(setting.axialFeed_mm_min)
               : radial;
}

QString StateGridText::state(int level, std::size_t feed) {
    return QStringLiteral("[%1, %2]").arg(level).arg(feed + 1);
}

QString StateGridText::cycle(const Cycle& cycle) {
    QStringList stages;
    for (const Stage& stage : cycle.stages) {
        QStringList numbers;
        for (const std::optional<double>& feed :
             {stage.radial_feed_mm, stage.axial_feed_mm_min, stage.radial_feed_mm_min}) {
            if (feed) {
                numbers << printedNumber(*feed);
            }
        }
        numbers << printedNumber(stage.stock_mm, levelDigits);
        stages << numbers.join(QStringLiteral(" · "));
    }
    return stages.join(QStringLiteral(" → "));
}

QString StateGridText::size(const StateGrid& grid) {
    return tr("Levels: %1, feeds: %2, stages at most: %3")
        .arg(grid.size.levels)
        .arg(grid.feeds.size())
        .arg(grid.size.stages);
}

QString StateGridText::ruleAnswer(const StateGrid& grid) {
    return grid.time_s
               ? tr("Published rule: %1; stages %2.").arg(time(*grid.time_s), cycle(grid.cycle))
               : tr("The published rule finds no cycle: no move into the last level is "
                    "admissible.");
}

QString StateGridText::provenAnswer(const ExactAnswer& exact) {
    const QString cycles = exact.gridSize == std::numeric_limits<std::int64_t>::max()
                               ? tr("more than 9·10¹⁸")
                               : counted(exact.gridSize);
    if (exact.status == SearchStatus::infeasible) {
        return tr("Proved: none of the %1 cycles of the grid meets every requirement.").arg(cycles);
    }
    if (exact.isProved() && exact.time_s) {
        return tr("Proven quickest of the %1 cycles of the grid: %2; stages %3.")
            .arg(cycles, time(*exact.time_s), cycle(exact.cycle));
    }
    const QString none = tr("none of the %1 cycles is below %2").arg(cycles, time(exact.bound_s));
    return exact.time_s
               ? tr("The proof was stopped: best so far %1, %2.").arg(time(*exact.time_s), none)
               : tr("The proof was stopped: no cycle found so far, %1.").arg(none);
}

QString StateGridText::wrong(const StateDifference& fault) {
    switch (fault.wrong) {
    case WrongState::struckOut:
        return tr("struck out, although the proven cycle reaches it after %1")
            .arg(time(fault.reached_s));
    case WrongState::slower:
        return tr("its time is not the least: the proven cycle reaches it after %1")
            .arg(time(fault.reached_s));
    case WrongState::misleads: break;
    }
    const QString kept =
        tr("the kept path is the wrong one to continue: the proven cycle reaches the state after "
           "%1 and continues; the kept path, with the same feeds from here on, %2");
    QString comes = tr("does not reach the size");
    if (fault.breaks) {
        comes = tr("breaks: %1").arg(Names::inSentence(Names::constraint(*fault.breaks)));
    } else if (fault.time_s) {
        comes = tr("takes %1 in %n stage(s)", nullptr, fault.stages).arg(time(*fault.time_s));
    }
    return kept.arg(time(fault.reached_s), comes);
}

QString StateGridText::faults(const StateGrid& grid, const ExactAnswer& exact) {
    if (!exact.faults.empty()) {
        const StateDifference& first = exact.faults.front();
        return tr("The rule fails in %n state(s), first in %1: %2.", nullptr,
                  static_cast<int>(exact.faults.size()))
            .arg(state(first.level, first.feed), wrong(first));
    }
    if (!exact.isProved()) {
        return {};
    }
    return grid.time_s ? tr("The rule is right on this grid.")
                       : tr("The rule is right: there is no cycle to find.");
}

QString StateGridText::answer(const StateGrid& grid, const std::optional<ExactAnswer>& exact) {
    QStringList lines{ruleAnswer(grid)};
    if (exact) {
        lines << provenAnswer(*exact);
        const QString wrongs = faults(grid, *exact);
        if (!wrongs.isEmpty()) {
            lines << wrongs;
        }
    }
    return lines.join(u'\n');
}

QString StateGridText::struckOut(const GridState& state) {
    std::map<QString, int> causes;
    for (const StateMove& move : state.moves) {
        switch (move.end) {
        case MoveEnd::broken:
            ++causes[Names::inSentence(Names::constraintBrief(*move.broken))];
            break;
        case MoveEnd::tooManyStages: ++causes[tr("too many stages")]; break;
        case MoveEnd::rises: ++causes[tr("feed rises")]; break;
        case MoveEnd::notReached: ++causes[tr("level not reached")]; break;
        case MoveEnd::noState:
        case MoveEnd::slower:
        case MoveEnd::kept: break;
        }
    }
    QStringList parts;
    for (const auto& [cause, count] : causes) {
        parts << tr("%1: %2", "a cause and how many moves").arg(cause).arg(count);
    }
    return parts.join(QStringLiteral(", "));
}

QString StateGridText::moves(const StateGrid& grid, int level, std::size_t feed) {
    const GridState& at = grid.state(level, feed);
    const TimeUnit unit = StateGridText::unit(grid);
    const auto inUnit = [&unit](double time_s) { return amount(time_s, unit); };
    QString text;
    if (!at.time_s) {
        text = tr("no admissible move");
    } else if (level == 1) {
        text = tr("T = %1 %2, from the blank").arg(inUnit(*at.time_s), unit.text());
    } else {
        const StateMove& kept = at.moves[at.from];
        text = tr("T = %1 %2 = %3 + %4, m* = %5")
                   .arg(inUnit(*at.time_s), unit.text(), inUnit(*at.time_s - kept.move_s),
                        inUnit(kept.move_s))
                   .arg(at.from + 1);
    }
    const auto slower = std::ranges::count(at.moves, MoveEnd::slower, &StateMove::end);
    if (slower > 0) {
        text += tr("; not quicker: %1").arg(slower);
    }
    const QString out = struckOut(at);
    return out.isEmpty() ? text : text + tr("; struck out: %1").arg(out);
}

QString StateGridText::moment(const StateGrid& grid, const GridMoment& moment) {
    if (moment.level == 0) {
        return tr("The blank: T[0, 0] = 0. Nothing is filled yet.");
    }
    const QString place =
        tr("State %1: %2 mm left, feed %3")
            .arg(state(moment.level, moment.feed),
                 printedNumber(grid.stock_mm[static_cast<std::size_t>(moment.level)], levelDigits),
                 feed(grid.feeds[moment.feed], grid.project.operation));
    const QString what = place + QStringLiteral("; ") + moves(grid, moment.level, moment.feed);
    return moment.stepsBack > 0 ? tr("Backtracking. %1").arg(what) : what;
}

} // namespace sparkout
