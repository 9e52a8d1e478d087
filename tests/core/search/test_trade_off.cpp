// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Time against margin: every cycle that holds is matched by one of the trade-off, which is found
// again by running all cycles of the grid.

#include "core/search/cycle_runner.h"
#include "core/search/robust.h"
#include "tests/core/search/search_checks.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <cstdio>
#include <map>

namespace sparkout::test_trade_off {

using namespace search_checks;

struct Point {
    std::int64_t time_us;
    double margin;
    friend bool operator==(const Point&, const Point&) = default;
};

/// Few, and in every draw the same.
std::vector<Project> threePhases(const Project& best, int) {
    return stockPhases(best, 3, 0.3);
}

/// On these phases of a cycle and for every stock of its range; nothing: it fails for one, or a
/// stage makes no step on the part.
std::optional<double> marginOverAll(const Project& project, const SimulationResult& result) {
    const std::optional<ConstraintResult> worst =
        worstOfCases(project, -std::numeric_limits<double>::infinity());
    if (!worst || hasIdleStage(result)) {
        return std::nullopt;
    }
    double least = worst->relativeMargin;
    for (const Project& phase : threePhases(project, 0)) {
        const SimulationResult there = simulateUnchecked(phase);
        if (!holds(there)) {
            return std::nullopt;
        }
        for (const ConstraintResult& constraint : evaluateConstraints(there)) {
            least = std::min(least, constraint.relativeMargin);
        }
    }
    return least;
}

/// By the definition: the greatest margin of each time that no quicker cycle reaches.
std::vector<Point> plainFront(Project project, bool overAll = false) {
    std::map<std::int64_t, double> best;
    for (const PlainCycle& each : PlainGrid(project).cycles) {
        *project.cycle = each.cycle;
        setMachine(project, each.machine);
        const SimulationResult result = simulateUnchecked(project);
        if (!holds(result)) {
            continue;
        }
        double least = std::numeric_limits<double>::infinity();
        for (const ConstraintResult& constraint : evaluateConstraints(result)) {
            least = std::min(least, constraint.relativeMargin);
        }
        if (const auto all = overAll ? marginOverAll(project, result) : std::optional(least)) {
            least = std::min(least, *all);
        } else {
            continue;
        }
        const auto time_us = static_cast<std::int64_t>(std::llround(result.time_s * 1e6));
        const auto [at, isNew] = best.emplace(time_us, least);
        at->second = isNew ? least : std::max(at->second, least);
    }
    std::vector<Point> front;
    for (const auto& [time_us, margin] : best) {
        if (front.empty() || margin > front.back().margin + 1e-9) {
            front.push_back({time_us, margin});
        }
    }
    return front;
}

std::vector<Point> pointsOf(const TradeOff& found) {
    std::vector<Point> points;
    for (const SearchSummary& each : found.cycles) {
        points.push_back({each.best->time_us, each.best->leastRelativeMargin});
    }
    return points;
}

class TestTradeOff : public QObject {
    Q_OBJECT

private slots:
    void itIsThatOfAllCyclesOfTheGrid() {
        std::size_t longest = 0;
        int withSeveral = 0;
        for (unsigned seed = 0; seed < plainGrids(60); ++seed) {
            const Project project = smallCase(seed);
            for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                SearchOptions options;
                options.method = method;
                const SearchSummary quickest = optimise(project, options);
                if (!quickest.best) {
                    continue;
                }
                const TradeOff found = tradeOff(project, quickest, options, 1000);
                QVERIFY(found.isComplete);
                const std::vector<Point> plain = plainFront(project);
                QVERIFY2(pointsOf(found) == plain, qPrintable(QString::number(seed)));
                longest = std::max(longest, plain.size());
                withSeveral += plain.size() > 1 ? 1 : 0;
            }
        }
        QVERIFY(longest > 3 && withSeveral > static_cast<int>(plainGrids(60)) / 5);
    }

    /// Under gauge control over every stock of the range; under position control there is none.
    void aRobustOneIsThatOfAllCyclesOverEveryStock() {
        int withSeveral = 0, found = 0, others = 0;
        for (unsigned seed = 0; seed < plainGrids(80); ++seed) {
            Project project = smallCase(seed);
            if (!canDecidePhases(project)) {
                QVERIFY(tradeOffRobustly(project, threePhases, {}, 1000).cycles.empty());
                continue;
            }
            const std::vector<Point> plain = plainFront(project, true);
            for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                SearchOptions options;
                options.method = method;
                const TradeOff front = tradeOffRobustly(project, threePhases, options, 1000);
                QVERIFY2(pointsOf(front) == plain, qPrintable(QString::number(seed)));
                QVERIFY(front.isComplete || plain.empty());
            }
            found += plain.empty() ? 0 : 1;
            withSeveral += plain.size() > 1 ? 1 : 0;
            others += plain != plainFront(project) ? 1 : 0;
        }
        std::printf("%d robust fronts, %d of several points\n", found, withSeveral);
        QVERIFY(found > samples::sized(10, 3, 60) && withSeveral > samples::sized(2, 0, 16));
        QVERIFY(others > samples::sized(5, 1, 40));
    }

    void itEndsAtTheMostAndAtAStop() {
        Project project = smallCase(0);
        for (unsigned seed = 0; plainFront(project).size() < 3; ++seed) {
            project = smallCase(seed);
        }
        const SearchSummary quickest = optimise(project);
        const TradeOff two = tradeOff(project, quickest, {}, 2);
        QVERIFY(two.cycles.size() == 2 && !two.isComplete);
        SearchOptions stopped;
        const StoppedSource source;
        stopped.stop = source.get_token();
        const TradeOff one = tradeOff(project, quickest, stopped, 1000);
        QVERIFY(one.cycles.size() == 1 && !one.isComplete);
    }
};

} // namespace sparkout::test_trade_off

SPARKOUT_TEST(test_trade_off, TestTradeOff)
#include "test_trade_off.moc"
