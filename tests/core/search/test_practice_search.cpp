// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The searches with delays of gauge and machine and with limits of practice: as exact as without.
#include "core/search/cycle_runner.h"
#include "core/search/robust.h"
#include "core/search/time_bound.h"

#include "tests/core/search/search_checks.h"
#include "tests/registry.h"

#include <array>

namespace sparkout::test_practice_search {

using namespace search_checks;
using search_cases::Dice;

/// Delays of up to some steps: of the gauge, of the change of feed, or both.
Project late(Project p, Dice& dice) {
    const double most_s =
        p.operation == Operation::plunge ? 4 * 60 / p.machine->work_speed_rpm : 25;
    const int which = dice.integer(1, 3);
    if (which & 1) {
        p.gauge->delay_s = dice.uniform(0, most_s);
    }
    if (which & 2) {
        p.machine->feed_change_delay_s = dice.uniform(0, most_s);
    }
    return p;
}

/// Limits near to what the grid's cycles have.
Project limited(Project p, Dice& dice) {
    const double slow = p.wheel->width_mm * p.machine->work_speed_rpm / 600;
    if (dice.chance(0.5)) {
        p.least_overlap = dice.uniform(1, 0.6 * slow);
    }
    if (dice.chance(0.5)) {
        p.least_overlap_last = dice.uniform(1, 1.1 * slow);
    }
    if (dice.chance(0.7)) {
        p.least_steps = dice.integer(1, p.operation == Operation::plunge ? 12 : 4);
    }
    return p;
}

Project practical(unsigned seed) {
    Dice dice(seed + 4242);
    Project p = smallCase(seed);
    p.optimisation->stages =
        std::array<std::vector<double>, 3>{{{1, 2, 3}, {2, 1}, {3, 2}}}[seed % 3];
    if (seed % 5 == 2) {
        p.optimisation->unfed_steps = std::vector<double>{0, 3};
    }
    if (seed % 4 != 0) {
        p = late(std::move(p), dice);
    }
    return seed % 4 != 1 ? limited(std::move(p), dice) : p;
}

class TestPracticeSearch : public QObject {
    Q_OBJECT

private slots:
    void bothSearchesFindTheCycleOfPlainRuns() {
        int found = 0, other = 0;
        for (unsigned seed = 0; seed < searches(200); ++seed) {
            const Project p = practical(seed);
            const PlainSearch plain(p);
            const QByteArray where = "case " + QByteArray::number(seed);
            QVERIFY2(same(search(p, SearchMethod::full), plain), where);
            QVERIFY2(same(search(p, SearchMethod::pruned), plain), where);
            found += plain.best ? 1 : 0;
            Project without = p;
            without.gauge->delay_s.reset();
            without.machine->feed_change_delay_s.reset();
            without.least_overlap.reset();
            without.least_overlap_last.reset();
            without.least_steps.reset();
            const SearchSummary free = search(without, SearchMethod::pruned);
            other += free.best.has_value() && !same(free, plain) ? 1 : 0;
        }
        QVERIFY2(found > static_cast<int>(searches(200)) / 8, QByteArray::number(found));
        QVERIFY2(other > static_cast<int>(searches(200)) / 8, QByteArray::number(other));
    }

    void scenariosAreAsLateAsThePart() {
        int found = 0;
        for (unsigned seed = 0; seed < plainGrids(100); ++seed) {
            const Project p = practical(seed);
            Project dull = p, more = p;
            dull.wheel->dullness = p.wheel->dullness * 1.2;
            more.part->stock_mm = p.part->stock_mm + 0.002;
            SearchOptions options;
            options.scenarios = {dull, more};
            options.method = SearchMethod::full;
            const SearchSummary full = optimise(p, options);
            options.method = SearchMethod::pruned;
            QVERIFY2(same(optimise(p, options), full), QByteArray::number(seed));
            if (!full.best) {
                continue;
            }
            ++found;
            for (Project part : {p, dull, more}) {
                QVERIFY(holds(simulateUnchecked(withBest(std::move(part), full))));
            }
        }
        QVERIFY2(found > 8, QByteArray::number(found));
    }

    void theRobustCycleHoldsWithDelays() {
        int found = 0;
        for (unsigned seed = 0; seed < plainGrids(40); ++seed) {
            const Project p = practical(seed);
            const RobustSummary robust = optimiseRobustly(p, freshStockPhases, {});
            SearchOptions options;
            options.method = SearchMethod::full;
            options.threads = 1;
            options.scenarios = robust.added;
            options.everyStageSteps = true;
            QVERIFY2(same(robust.search, optimise(p, options)), QByteArray::number(seed));
            found += robust.search.best ? 1 : 0;
        }
        QVERIFY2(found > 2, QByteArray::number(found));
    }

    // A delay only adds steps: what bounds the time of every cycle bounds it still.
    void noCycleIsQuickerThanItsBound() {
        int run = 0;
        for (unsigned seed = 0; seed < searches(60); ++seed) {
            Dice dice(seed);
            const Project p = late(smallCase(seed), dice);
            const Grid grid(p);
            const double bound_s = leastTime_s(p, grid);
            Project each = p;
            for (GridCycle cycle; grid.next(cycle);) {
                *each.cycle = grid.cycle(cycle);
                const SimulationResult result = simulateUnchecked(each);
                QVERIFY(result.status != RunStatus::completed || result.time_s >= bound_s);
                ++run;
            }
        }
        QVERIFY(run > 100);
    }
};

} // namespace sparkout::test_practice_search

SPARKOUT_TEST(test_practice_search, TestPracticeSearch)
#include "test_practice_search.moc"
