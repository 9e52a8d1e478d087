// SPDX-License-Identifier: GPL-3.0-or-later
// Time against margin: every cycle that holds is matched by one of the trade-off, which is found
// again by running all cycles of the grid.
#include "core/optimisation/trade_off.h"

#include "tests/core/optimisation/search_checks.h"
#include "tests/registry.h"

#include <QTest>

#include <map>

namespace test_trade_off {

using namespace search_checks;

namespace {

struct Point {
    std::int64_t time_us;
    double margin;
    friend bool operator==(const Point&, const Point&) = default;
};

/// By the definition: the greatest margin of each time that no quicker cycle reaches.
std::vector<Point> plainFront(Project project) {
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
        const auto time_us = static_cast<std::int64_t>(std::llround(result.time_s * 1e6));
        const auto [at, isNew] = best.emplace(time_us, least);
        at->second = isNew ? least : std::max(at->second, least);
    }
    std::vector<Point> front;
    for (const auto& [time_us, margin] : best) {
        if (front.empty() || margin > front.back().margin) {
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

} // namespace

class TestTradeOff : public QObject {
    Q_OBJECT

private slots:
    void itIsThatOfAllCyclesOfTheGrid() {
        std::size_t longest = 0;
        int withSeveral = 0;
        for (unsigned seed = 0; seed < searches(60); ++seed) {
            const Project project = smallCase(seed);
            for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                SearchOptions options;
                options.method = method;
                const SearchSummary quickest = optimise(project, options);
                if (!quickest.best) {
                    continue;
                }
                const TradeOff found = tradeOff(project, quickest, options, 1000);
                QVERIFY(found.isWhole);
                const std::vector<Point> plain = plainFront(project);
                QVERIFY2(pointsOf(found) == plain, qPrintable(QString::number(seed)));
                longest = std::max(longest, plain.size());
                withSeveral += plain.size() > 1 ? 1 : 0;
            }
        }
        QVERIFY(longest > 3 && withSeveral > static_cast<int>(searches(60)) / 5);
    }

    void itEndsAtTheMostAndAtAStop() {
        Project project = smallCase(0);
        for (unsigned seed = 0; plainFront(project).size() < 3; ++seed) {
            project = smallCase(seed);
        }
        const SearchSummary quickest = optimise(project);
        const TradeOff two = tradeOff(project, quickest, {}, 2);
        QVERIFY(two.cycles.size() == 2 && !two.isWhole);
        SearchOptions stopped;
        std::stop_source source;
        source.request_stop();
        stopped.stop = source.get_token();
        const TradeOff one = tradeOff(project, quickest, stopped, 1000);
        QVERIFY(one.cycles.size() == 1 && !one.isWhole);
    }
};

} // namespace test_trade_off

SPARKOUT_TEST(test_trade_off, TestTradeOff)
#include "test_trade_off.moc"
