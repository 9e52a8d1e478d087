// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of dynamic programming, cell by cell: times and predecessors against single runs of
// truncated cycles, the answer against the published rule's search, the states where the rule goes
// wrong against runs of both ways, the proven answer against every path.
#include "core/search/cycle_runner.h"
#include "core/search/state_grid.h"
#include "tests/core/search/search_checks.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <cstdio>

namespace sparkout::test_state_grid {

using namespace search_checks;
using Path = std::vector<std::size_t>;

constexpr double slack_s = 1e-9;

/// Gauged parts with a few feeds; every second one has drives that some feeds overload.
std::vector<Project> gaugedCases(int count) {
    std::vector<Project> cases;
    for (unsigned seed = 0; static_cast<int>(cases.size()) < count; ++seed) {
        Project p = smallCase(seed);
        search_cases::Dice dice(seed);
        p.gauge->control = Control::gauge;
        p.gauge->commands = 5;
        const Optimisation before = *p.optimisation;
        p.optimisation = Optimisation{};
        p.optimisation->non_increasing = before.non_increasing;
        const double scale = dice.uniform(0.5, 2);
        for (const StageFeed& feed : p.operation->feeds) {
            (*p.optimisation).*feed.levels = before.*feed.levels;
        }
        if (p.operation == Operation::plunge) {
            p.optimisation->radial_feed_mm_min =
                std::vector<double>{0.1 * scale, 0.4 * scale, 1.6 * scale};
        }
        if (stateGridFault(p) == StateGridFault::none) {
            cases.push_back(std::move(p));
        }
    }
    return cases;
}

/// The first levels of a path as a whole cycle of less stock on a thicker part: its blank is the
/// same, so are its passes, and its time is that of reaching the level.
SimulationResult truncated(const StateGrid& grid, const Path& path) {
    Project p = grid.project;
    const double left_mm = grid.stock_mm[path.size()];
    const double target_mm = p.part->target_diameter_mm.value_or(
        p.part->diameter_mm + (p.part->lower_deviation_um + p.part->upper_deviation_um) / 2000);
    const double sign = p.part->surface == Surface::internal ? -1 : 1;
    p.part->target_diameter_mm = target_mm + sign * 2 * left_mm;
    p.part->stock_mm -= left_mm;
    p.cycle->stages.clear();
    for (std::size_t n = 0; n < path.size(); ++n) {
        Stage stage;
        stage.*p.operation->radial().value = grid.feeds[path[n]].radial;
        if (const StageFeed* axial = p.operation->axial()) {
            stage.*axial->value = grid.feeds[path[n]].axialFeed_mm_min;
        }
        stage.stock_mm = grid.stock_mm[n] - grid.stock_mm[n + 1];
        p.cycle->stages.push_back(stage);
    }
    return simulateUnchecked(p);
}

/// Whether the passes break a limit that binds in the middle of a cycle.
bool passesBreak(const SimulationResult& result) {
    return std::ranges::any_of(evaluateConstraints(result), [](const ConstraintResult& each) {
        return !each.holds
               && (each.kind == ConstraintKind::wheelPower || each.kind == ConstraintKind::workPower
                   || each.kind == ConstraintKind::selfSharpening);
    });
}

SimulationResult wholeCycle(const StateGrid& grid, const Path& path) {
    return truncated(grid, path);
}

int stagesOf(const Path& path) {
    int stages = 0;
    for (std::size_t n = 0; n < path.size(); ++n) {
        stages += n == 0 || path[n] != path[n - 1] ? 1 : 0;
    }
    return stages;
}

bool mayFollow(const StateGrid& grid, std::size_t before, std::size_t after) {
    return !grid.project.optimisation->non_increasing
           || (grid.feeds[after].radial <= grid.feeds[before].radial
               && grid.feeds[after].axialFeed_mm_min <= grid.feeds[before].axialFeed_mm_min);
}

bool isAllowed(const StateGrid& grid, const Path& path) {
    for (std::size_t n = 1; n < path.size(); ++n) {
        if (!mayFollow(grid, path[n - 1], path[n])) {
            return false;
        }
    }
    return stagesOf(path) <= grid.size.stages;
}

std::int64_t us(double time_s) {
    return comparedTime_us(time_s);
}

class TestStateGrid : public QObject {
    Q_OBJECT

private slots:
    // Eq. 27 by single runs: each move is a truncated cycle from the blank.
    void timesAndPredecessorsAreThoseOfSingleRuns() {
        int projects = 0, compared = 0, struckOut = 0;
        for (Project& p : gaugedCases(samples::sized(24, 8, 100))) {
            ++projects;
            p.material->burn_rise_k.reset(); // its limit is of the stock left
            p.sections_coupled = false;      // their power is judged at the end alone
            const StateGridSize size{4, 3};
            const auto grid = fillStateGrid(p, size);
            QVERIFY(grid);
            const std::size_t feeds = grid->feeds.size();
            std::vector<std::optional<Path>> ways(1, Path{});
            for (int n = 1; n < size.levels; ++n) {
                std::vector<std::optional<Path>> next(feeds);
                for (std::size_t m = 0; m < feeds; ++m) {
                    double least_s = std::numeric_limits<double>::infinity();
                    for (const auto& way : ways) {
                        Path path = way.value_or(Path{});
                        path.push_back(m);
                        if (!way || !isAllowed(*grid, path)) {
                            continue;
                        }
                        const SimulationResult run = truncated(*grid, path);
                        if (run.status != RunStatus::completed || passesBreak(run)) {
                            ++struckOut;
                        } else {
                            least_s = std::min(least_s, run.time_s);
                        }
                    }
                    const GridState& state = grid->state(n, m);
                    QVERIFY(state.time_s.has_value() == std::isfinite(least_s));
                    if (state.time_s) {
                        ++compared;
                        QVERIFY(std::abs(*state.time_s - least_s) < slack_s);
                        next[m] = grid->wayTo(n, m);
                        QVERIFY(next[m]->size() == static_cast<std::size_t>(n));
                        const SimulationResult kept = truncated(*grid, *next[m]);
                        QVERIFY(std::abs(kept.time_s - least_s) < slack_s); // m* reaches it so
                        QVERIFY(n == 1 || ways[state.from].has_value());
                    }
                }
                ways = std::move(next);
            }
        }
        std::printf("%d states compared, %d moves struck out\n", compared, struckOut);
        QVERIFY(compared > 4 * projects && struckOut > 0);
    }

    void everyMoveIsAccountedFor() {
        for (const Project& p : gaugedCases(30)) {
            const auto grid = fillStateGrid(p, {5, 2});
            QVERIFY(grid);
            for (int n = 1; n <= 5; ++n) {
                for (std::size_t m = 0; m < grid->feeds.size(); ++m) {
                    const GridState& state = grid->state(n, m);
                    QVERIFY(state.moves.size() == (n == 1 ? 1 : grid->feeds.size()));
                    const auto kept =
                        std::ranges::count(state.moves, MoveEnd::kept, &StateMove::end);
                    QVERIFY(kept == (state.time_s ? 1 : 0));
                    for (std::size_t b = 0; b < state.moves.size(); ++b) {
                        const StateMove& move = state.moves[b];
                        QVERIFY((move.end == MoveEnd::broken) == move.broken.has_value());
                        if (move.end == MoveEnd::kept) {
                            QVERIFY(n == 1 || state.from == b);
                            QVERIFY(*state.time_s == move.time_s);
                            const double before_s =
                                n == 1 ? 0 : *grid->state(n - 1, state.from).time_s;
                            QVERIFY(std::abs(before_s + move.move_s - move.time_s) < slack_s);
                            QVERIFY(state.stages <= 2);
                        }
                        if (n > 1 && !grid->state(n - 1, b).time_s) {
                            QVERIFY(move.end == MoveEnd::noState);
                        }
                        if (move.end == MoveEnd::slower && n < 5) {
                            QVERIFY(move.time_s >= *state.time_s);
                        }
                    }
                }
            }
        }
    }

    // The program's search by the published rule forgets the same ways.
    void theAnswerIsThePublishedRules() {
        int found = 0, none = 0;
        for (const Project& p : gaugedCases(samples::sized(160, 40, 600))) {
            if (p.operation != Operation::plunge) {
                continue; // the search has the rule for plunge alone
            }
            for (const int levels : {2, 3, 5}) {
                const StateGridSize size{levels, levels};
                const auto grid = fillStateGrid(p, size);
                Project rule = withGridSearch(p, size);
                rule.optimisation->stages = {static_cast<double>(levels)};
                const SearchSummary published = search(rule, SearchMethod::published);
                QVERIFY(grid->time_s.has_value() == published.best.has_value());
                if (grid->time_s) {
                    ++found;
                    QVERIFY(us(*grid->time_s) == published.best->time_us);
                } else {
                    ++none;
                }
            }
        }
        std::printf("published rule: %d answers, %d without one\n", found, none);
        QVERIFY(found > 20 && none > 20);
    }

    void thePathHoldsAndTakesTheTime() {
        int checked = 0;
        for (const Project& p : gaugedCases(60)) {
            const auto grid = fillStateGrid(p, {6, 3});
            if (grid->path.empty()) {
                continue;
            }
            ++checked;
            Project alone = grid->project;
            *alone.cycle = grid->cycle;
            QVERIFY(static_cast<int>(alone.cycle->stages.size()) <= 3);
            QVERIFY(isAllowed(*grid, grid->path));
            const SimulationResult result = simulateUnchecked(alone);
            QVERIFY(holds(result));
            QVERIFY(std::abs(result.time_s - *grid->time_s) < slack_s);
            QVERIFY(grid->wayTo(6, grid->path.back()) == grid->path);
            for (const GridState& last : grid->states.back()) {
                QVERIFY(!last.time_s || us(*last.time_s) >= us(*grid->time_s));
            }
        }
        QVERIFY(checked > 10);
    }

    // Every path of a small grid, run as a cycle of its own.
    void theProvenAnswerIsTheBestOfAllPaths() {
        int feasible = 0;
        for (const Project& p : gaugedCases(samples::sized(40, 12, 200))) {
            const auto grid = fillStateGrid(p, {3, 3});
            const std::size_t feeds = grid->feeds.size();
            std::int64_t best = std::numeric_limits<std::int64_t>::max();
            for (std::size_t code = 0; code < feeds * feeds * feeds; ++code) {
                const Path path{code / feeds / feeds, code / feeds % feeds, code % feeds};
                if (isAllowed(*grid, path)) {
                    const SimulationResult run = wholeCycle(*grid, path);
                    if (holds(run)) {
                        best = std::min(best, us(run.time_s));
                    }
                }
            }
            const ExactAnswer exact = exactAnswer(*grid);
            QVERIFY(exact.isProved());
            QVERIFY(exact.time_s.has_value() == (best < std::numeric_limits<std::int64_t>::max()));
            if (exact.time_s) {
                ++feasible;
                QVERIFY(us(*exact.time_s) == best);
            }
        }
        QVERIFY(feasible > 5);
    }

    // Each fault by runs of its own: the proven way into the state, and what comes of the kept one.
    void theRuleIsWrongWhereItIsSaidToBe() {
        std::array<int, 3> kinds{};
        int missed = 0, slower = 0;
        for (const Project& p : gaugedCases(samples::sized(300, 80, 1000))) {
            const auto grid = fillStateGrid(p, {4, 4});
            const ExactAnswer exact = exactAnswer(*grid);
            const bool lost =
                exact.time_s && (!grid->time_s || us(*grid->time_s) > us(*exact.time_s));
            QVERIFY(!grid->time_s || (exact.time_s && us(*grid->time_s) >= us(*exact.time_s)));
            QVERIFY(exact.faults.empty() != lost);
            if (!lost) {
                continue;
            }
            ++(grid->time_s ? slower : missed);
            QVERIFY(holds(wholeCycle(*grid, exact.path)));
            for (const StateDifference& fault : exact.faults) {
                ++kinds[static_cast<std::size_t>(fault.wrong)];
                const Path way(exact.path.begin(), exact.path.begin() + fault.level);
                QVERIFY(way.back() == fault.feed);
                const SimulationResult run = truncated(*grid, way);
                QVERIFY(std::abs(run.time_s - fault.reached_s) < slack_s);
                const GridState& state = grid->state(fault.level, fault.feed);
                QVERIFY(state.time_s.has_value() == (fault.wrong != WrongState::struckOut));
                if (fault.wrong == WrongState::slower) {
                    QVERIFY(us(*state.time_s) > us(run.time_s));
                }
                if (fault.wrong == WrongState::misleads) {
                    QVERIFY(us(*state.time_s) <= us(run.time_s));
                    Path other = grid->wayTo(fault.level, fault.feed);
                    other.insert(other.end(), exact.path.begin() + fault.level, exact.path.end());
                    const SimulationResult kept = wholeCycle(*grid, other);
                    QVERIFY(!holds(kept) || us(kept.time_s) > us(*exact.time_s));
                    QVERIFY(holds(kept) == fault.time_s.has_value());
                }
            }
        }
        std::printf("the rule misses a cycle in %d cases, finds a slower one in %d; states: %d "
                    "struck out, %d with a quicker way, %d that mislead\n",
                    missed, slower, kinds[0], kinds[1], kinds[2]);
        QVERIFY(missed > 0 && slower > 0 && kinds[0] > 0 && kinds[2] > 0);
    }

    void aGridIsOfGaugedCyclesWithFeeds() {
        Project p = gaugedCases(1).front();
        QVERIFY(stateGridFault(p) == StateGridFault::none);
        p.gauge->control = Control::position;
        QVERIFY(stateGridFault(p) == StateGridFault::positionControl);
        p.gauge->control = Control::gauge;
        for (const StageFeed& feed : p.operation->feeds) {
            (*p.optimisation).*feed.levels = Levels();
        }
        QVERIFY(stateGridFault(p) == StateGridFault::noFeeds);
        p.optimisation.reset();
        QVERIFY(stateGridFault(p) == StateGridFault::noSearch);
    }

    void aStopLeavesNoGrid() {
        const Project p = gaugedCases(1).front();
        std::stop_source stop;
        const auto grid = fillStateGrid(p, {10, 2}, stop.get_token(), [&stop](int level) {
            if (level == 3) {
                stop.request_stop();
            }
        });
        QVERIFY(!grid);
    }

    void fortyFeedsAtMostOfBothKinds() {
        Project p = samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
        p.optimisation = Optimisation{};
        p.optimisation->radial_feed_mm = SteppedLevels{0.001, 0.02, 0.001};
        p.optimisation->axial_feed_mm_min = SteppedLevels{300, 2500, 100};
        const Project searched = withGridSearch(p, {20, 2});
        const Grid grid(searched);
        QVERIFY(grid.fault() == GridFault::none);
        QVERIFY(grid.settings().size() <= mostGridFeeds && grid.settings().size() >= 30);
        QVERIFY(grid.settings().front().radial == 0.001);
        QVERIFY(grid.settings().back().axialFeed_mm_min == 2500);
        QVERIFY(std::abs(grid.settings().back().radial - 0.02) < 1e-12);
    }

    void twentyLevelsByFortyFeedsTakeSeconds() {
        Project plunge = samples::projectIn("resources/examples/plunge-shaft-two-stage.sparkout");
        plunge.optimisation->radial_feed_mm_min = SteppedLevels{0.05, 2.0, 0.05};
        Project traverse = samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
        traverse.optimisation->radial_feed_mm = SteppedLevels{0.001, 0.010, 0.001};
        traverse.optimisation->axial_feed_mm_min = SteppedLevels{500, 2000, 500};
        for (const Project& p : {plunge, traverse}) {
            RunningTimer timer;
            const StateGridSize size{20, p.operation == Operation::plunge ? 2 : 3};
            const auto grid = fillStateGrid(p, size);
            const double filled_s = static_cast<double>(timer.restart()) / 1000;
            const ExactAnswer exact = exactAnswer(*grid);
            std::printf("%zu feeds, 20 levels, %d stages: filled in %.2f s, the proven answer of "
                        "%lld cycles in %.2f s; %.2f min by the rule, %.2f min proven\n",
                        grid->feeds.size(), size.stages, filled_s,
                        static_cast<long long>(exact.gridSize),
                        static_cast<double>(timer.elapsed()) / 1000, grid->time_s.value_or(0) / 60,
                        exact.time_s.value_or(0) / 60);
            QVERIFY(grid->feeds.size() == 40);
            QVERIFY(filled_s < samples::sized(20, 200, 20));
        }
    }
};

} // namespace sparkout::test_state_grid

SPARKOUT_TEST(test_state_grid, TestStateGrid)
#include "test_state_grid.moc"
