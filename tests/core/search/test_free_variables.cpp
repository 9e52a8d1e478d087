// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Work speed, dwells, a spark-out and bounds of single stages, free beside feeds and stocks: the
// searches against plain runs of every cycle, and the laws of what may be chosen.
#include "core/project/validate.h"
#include "core/quality/shop_numbers.h"
#include "core/search/binding.h"
#include "core/search/limit.h"
#include "core/search/refine.h"
#include "core/search/robust.h"

#include "tests/core/search/search_checks.h"
#include "tests/registry.h"

#include <map>

namespace sparkout::test_free_variables {

using namespace search_checks;

/// Rows of least and most about the levels, of which some fix a stage.
NumberRows rowsAbout(search_cases::Dice& dice, const Levels& levels) {
    const std::vector<double> values = levelValues(levels);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    std::vector<std::vector<double>> rows;
    for (int z = dice.integer(1, 2); z > 0; --z) {
        const double low = dice.chance(0.5) ? *least : *most, high = dice.chance(0.7) ? *most : low;
        rows.push_back({low, high});
    }
    return rows;
}

/// A small case with some of them free.
Project freeCase(unsigned seed) {
    search_cases::Dice dice(seed + 7919);
    Project p = smallCase(seed);
    Optimisation& asked = *p.optimisation;
    asked.stages = dice.chance(0.5) ? std::vector<double>{1, 2} : std::vector<double>{2};
    const bool traverse = p.operation == Operation::traverse;
    if (dice.chance(0.4)) {
        asked.work_speed_rpm = std::vector<double>{dice.uniform(100, 200), dice.uniform(150, 300)};
        asked.least_ratio_distance = 1e-6; // not the default: also at whole ratios
    }
    if (traverse && dice.chance(0.3)) {
        asked.dwell_entry_s = std::vector<double>{0, dice.uniform(0.2, 1)};
    }
    if (traverse && dice.chance(0.3)) {
        asked.dwell_exit_s = SteppedLevels{0, 0.5, 0.5};
    }
    if (dice.chance(0.6)) {
        const int most = traverse ? 2 : 20;
        asked.unfed_steps = std::vector<double>{static_cast<double>(dice.integer(1, most)), 0};
    }
    if (dice.chance(0.3)) {
        const int least = dice.integer(1, 2);
        asked.stage_stock_mm = {{0.01 * least, 0.01 * (least + dice.integer(0, 1))}};
    }
    if (Variants(p).count() < 3 && dice.chance(0.3)) {
        asked.stages = {3, 2};
        asked.stage_stock_mm = {{0.005, 0.05}, {0.01, 0.01}};
    }
    if (dice.chance(0.3)) {
        (traverse ? asked.stage_radial_feed_mm : asked.stage_radial_feed_mm_min) =
            rowsAbout(dice, traverse ? asked.radial_feed_mm : asked.radial_feed_mm_min);
    }
    if (traverse && dice.chance(0.2)) {
        asked.stage_axial_feed_mm_min = rowsAbout(dice, asked.axial_feed_mm_min);
    }
    if (traverse && dice.chance(0.5)) {
        asked.continuous_feed_mm_min =
            std::vector<double>{dice.uniform(0.02, 0.06), dice.uniform(0.05, 0.3)};
        asked.radial_feed_mm = std::vector<double>{levelValues(asked.radial_feed_mm).front()};
        asked.stage_radial_feed_mm.reset();
        if (dice.chance(0.3)) {
            asked.stage_continuous_feed_mm_min = rowsAbout(dice, asked.continuous_feed_mm_min);
        }
        if (dice.chance(0.5)) {
            p.machine->limits.continuous_feed_mm_min = std::vector<double>{0.01, 0.25, 0};
        }
    }
    return p;
}

unsigned cases() {
    return searches(125);
}

class TestFreeVariables : public QObject {
    Q_OBJECT

private slots:
    void theCasesAreValidAndOfEveryKind() {
        std::map<std::string, int> seen;
        for (unsigned seed = 0; seed < cases(); ++seed) {
            const Project p = freeCase(seed);
            for (const Issue& issue : validate(p)) {
                QVERIFY2(issue.severity != Severity::error, issue.path.c_str());
            }
            const Optimisation& asked = *p.optimisation;
            seen["speed"] += levelCount(asked.work_speed_rpm) > 0 ? 1 : 0;
            seen["dwell"] += levelCount(asked.dwell_entry_s) + levelCount(asked.dwell_exit_s) > 0;
            seen["spark-out"] += levelCount(asked.unfed_steps) > 0 ? 1 : 0;
            seen["stock"] += asked.stage_stock_mm ? 1 : 0;
            seen["radial"] += asked.stage_radial_feed_mm || asked.stage_radial_feed_mm_min ? 1 : 0;
            seen["axial"] += asked.stage_axial_feed_mm_min ? 1 : 0;
            seen["continuous"] += levelCount(asked.continuous_feed_mm_min) > 0 ? 1 : 0;
            seen["nothing"] += Variants(p).count() == 0 ? 1 : 0;
        }
        QCOMPARE(seen.size(), std::size_t{8});
        for (const auto& [kind, times] : seen) {
            QVERIFY2(kind == "nothing" ? times * 3 < static_cast<int>(cases())
                                       : times * 15 > static_cast<int>(cases()),
                     (kind + " " + std::to_string(times)).c_str());
        }
    }

    void theGridHasTheCyclesOfItsDefinitionInItsOrder() {
        for (unsigned seed = 0; seed < cases(); ++seed) {
            const Project p = seed % 2 == 0 ? freeCase(seed) : smallCase(seed);
            const Variants variants(p);
            const PlainGrid plain(p);
            std::size_t at = 0;
            for (std::size_t v = 0; v < variants.count(); ++v) {
                const Grid& grid = variants.grid(v);
                if (grid.fault() != GridFault::none) {
                    continue;
                }
                GridCycle before;
                for (GridCycle cycle; grid.next(cycle); ++at) {
                    QVERIFY2(at < plain.cycles.size(), QByteArray::number(seed));
                    QVERIFY2(sameCycle(grid.cycle(cycle), plain.cycles[at].cycle),
                             QByteArray::number(seed));
                    QVERIFY(machineSettings(variants.project(v)) == plain.cycles[at].machine);
                    QVERIFY(grid.contains(cycle));
                    QVERIFY(before.empty() || grid.before(before, cycle));
                    before = cycle;
                }
            }
            QVERIFY2(at == plain.cycles.size(), QByteArray::number(seed));
            QVERIFY(gridSize(p) == static_cast<std::int64_t>(at));
        }
    }

    void bothSearchesFindTheCycleOfPlainRuns() {
        int found = 0, sparks = 0, slower = 0, continuous = 0;
        for (unsigned seed = 0; seed < cases(); ++seed) {
            const Project p = freeCase(seed);
            const PlainSearch plain(p);
            const SearchSummary pruned = search(p);
            const SearchSummary full = search(p, SearchMethod::full);
            const QByteArray where = "case " + QByteArray::number(seed);
            QVERIFY2(same(pruned, plain), where);
            QVERIFY2(same(full, plain), where);
            const auto proof = plain.best ? SearchStatus::proved : SearchStatus::infeasible;
            QVERIFY2(pruned.status == proof && full.status == proof, where);
            if (plain.best) {
                ++found;
                QVERIFY(pruned.bound_s == pruned.best->time_s);
                QVERIFY2(steplessLimit_s(p) <= pruned.best->time_s, where);
                Project alone = withBest(p, pruned);
                QVERIFY(holds(simulateUnchecked(alone)));
                sparks += pruned.cycle.stages.back().spark_out != SparkOut() ? 1 : 0;
                continuous += pruned.cycle.stages.front().continuousFeed_mm_min() > 0 ? 1 : 0;
                slower += pruned.machine.work_speed_rpm < p.machine->work_speed_rpm ? 1 : 0;
            }
        }
        QVERIFY2(found > static_cast<int>(cases()) / 5, QByteArray::number(found));
        const int enough = static_cast<int>(cases()) / 40;
        QVERIFY2(sparks >= enough && slower >= enough && continuous >= enough,
                 QByteArray::number(sparks) + " " + QByteArray::number(slower) + " "
                     + QByteArray::number(continuous));
    }

    /// The same where work speeds with a rotation ratio near a whole number are left out.
    void bothSearchesLeaveOutWholeRatios() {
        int some = 0, all = 0, found = 0;
        for (unsigned seed = 0; seed < searches(60); ++seed) {
            Project p = freeCase(seed);
            p.optimisation->least_ratio_distance = seed % 2 == 0 ? 0.15 : 0.4;
            const PlainSearch plain(p);
            const SearchSummary pruned = search(p);
            const QByteArray where = "case " + QByteArray::number(seed);
            QVERIFY2(same(pruned, plain), where);
            QVERIFY2(same(search(p, SearchMethod::full), plain), where);
            QVERIFY2(gridSize(p) == Variants(p).size(), where);
            const SearchedSpeeds speeds = searchedSpeeds(p);
            QVERIFY2((Variants(p).fault() == GridFault::wholeRatio) == speeds.allowed.empty(),
                     where);
            some += !speeds.leftOut.empty() && !speeds.allowed.empty() ? 1 : 0;
            all += speeds.allowed.empty() ? 1 : 0;
            found += pruned.best ? 1 : 0;
        }
        QVERIFY2(some > 2 && all > 2 && found > 2, QByteArray::number(some) + " "
                                                       + QByteArray::number(all) + " "
                                                       + QByteArray::number(found));
    }

    /// The speeds allowed are those listed, or the machine's; the answer has one of them.
    void aWholeRatioIsNoVariant() {
        Project p = driven(0.6);
        const double wheel_rpm = wheelSpeed_rpm(p);
        const double whole = wheel_rpm / 7, close = wheel_rpm / 7.04, off = wheel_rpm / 7.5;
        p.optimisation->work_speed_rpm = std::vector<double>{whole, close, off};
        QCOMPARE(Variants(p).count(), std::size_t{1}); // by default, the runout is not given
        p.wheel->runout.emplace().amplitude_um = 1;
        QCOMPARE(Variants(p).count(), std::size_t{3});
        p.wheel->runout.reset();
        p.optimisation->least_ratio_distance = 1e-6; // off the whole ratio alone
        QCOMPARE(Variants(p).count(), std::size_t{2});
        p.optimisation->least_ratio_distance = 0.05;
        QCOMPARE(Variants(p).count(), std::size_t{1});
        QCOMPARE(searchedSpeeds(p).leftOut, (std::vector<double>{whole, close}));
        for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
            const SearchSummary found = search(p, method);
            QVERIFY(found.best.has_value());
            QCOMPARE(found.machine.work_speed_rpm, off);
            QCOMPARE(found.gridSize, gridSize(p));
        }
        p.optimisation->work_speed_rpm = {};
        for (const double own : {off, close}) {
            p.machine->work_speed_rpm = own;
            const bool isLeftOut = own == close;
            QVERIFY(Variants(p).fault() == (isLeftOut ? GridFault::wholeRatio : GridFault::none));
            QCOMPARE(gridSize(p) == 0, isLeftOut);
            QCOMPARE(search(p).best.has_value(), !isLeftOut);
        }
    }

    // The bound in the progress holds for the variants still to be searched, too.
    void aStoppedSearchKeepsItsBound() {
        int stopped = 0;
        for (unsigned seed = 0; seed < searches(60); ++seed) {
            const Project p = freeCase(seed);
            const SearchSummary whole = search(p);
            std::stop_source stop;
            SearchOptions options;
            options.stop = stop.get_token();
            options.onProgress = [&](const SearchProgress& progress) {
                if (whole.best) {
                    QVERIFY(progress.bound_s <= whole.best->time_s);
                }
                if (progress.evaluations > 3) {
                    stop.request_stop();
                }
            };
            const SearchSummary part = optimise(p, options);
            QVERIFY(noSlower(whole, part));
            QVERIFY(!whole.best || part.bound_s <= whole.best->time_s);
            stopped += part.status == SearchStatus::stopped ? 1 : 0;
        }
        QVERIFY2(stopped > 10, QByteArray::number(stopped));
    }

    void aStoppedFullSearchGoesOnInItsVariant() {
        int later = 0;
        for (unsigned seed = 0; seed < searches(40); ++seed) {
            const Project p = freeCase(seed);
            const SearchSummary whole = search(p, SearchMethod::full);
            std::stop_source stop;
            SearchOptions options;
            options.method = SearchMethod::full;
            options.threads = 1;
            options.stop = stop.get_token();
            options.onProgress = [&](const SearchProgress& progress) {
                if (progress.evaluations * 2 > whole.evaluations) {
                    stop.request_stop();
                }
            };
            const SearchSummary first = optimise(p, options);
            if (first.status != SearchStatus::stopped) {
                continue;
            }
            later += first.checkpoint.variant > 0 ? 1 : 0;
            SearchOptions rest;
            rest.method = SearchMethod::full;
            rest.resume = first.checkpoint;
            const SearchSummary second = optimise(p, rest);
            QVERIFY(same(second, whole));
            QCOMPARE(first.evaluations + second.evaluations, whole.evaluations);
        }
        QVERIFY2(later > 2, QByteArray::number(later));
    }

    void scenariosAreRunWithTheMachineOfTheVariant() {
        int found = 0;
        for (unsigned seed = 0; seed < searches(60); ++seed) {
            const Project p = freeCase(seed);
            Project dull = p;
            dull.wheel->dullness = p.wheel->dullness * 1.5;
            SearchOptions options;
            options.scenarios = {dull};
            const SearchSummary pruned = optimise(p, options);
            options.method = SearchMethod::full;
            QVERIFY(same(pruned, optimise(p, options)));
            if (pruned.best) {
                ++found;
                QVERIFY(holds(simulateUnchecked(withBest(dull, pruned))));
            }
        }
        QVERIFY(found > 5);
    }

    void robustHeuristicAndRefinedCyclesHoldWithTheMachineFound() {
        int robust = 0, refined = 0, labels = 0;
        for (unsigned seed = 0; seed < 40; ++seed) {
            const Project p = freeCase(seed);
            const auto phases = [](const Project& best, int) { return stockPhases(best, 4); };
            const RobustSummary summary = optimiseRobustly(p, phases);
            if (summary.holdsInSample) {
                ++robust;
                for (const Project& part : stockPhases(withBest(p, summary.search), 4)) {
                    QVERIFY(holds(simulateUnchecked(part)));
                }
                RefineOptions options;
                options.mostRuns = 60;
                options.scenarios = summary.added;
                Project best = withBest(p, summary.search);
                const RefineSummary off = refine(best, *best.cycle, options);
                refined += off.isQuicker ? 1 : 0;
                *best.cycle = off.cycle;
                QVERIFY(holds(simulateUnchecked(best)));
                QVERIFY(off.time_us <= summary.search.best->time_us);
                QVERIFY(off.cycle.stages.back().spark_out
                        == summary.search.cycle.stages.back().spark_out);
            }
            if (p.operation == Operation::plunge) {
                const SearchSummary found = search(p, SearchMethod::labels);
                QVERIFY(noSlower(search(p), found));
                QVERIFY(!found.best || holds(simulateUnchecked(withBest(p, found))));
                labels += found.best ? 1 : 0;
            }
        }
        QVERIFY2(robust > 5 && refined > 2 && labels > 3, QByteArray::number(robust) + " "
                                                              + QByteArray::number(refined) + " "
                                                              + QByteArray::number(labels));
    }

    // A step of the first stage passes four ends; from the first of them the second stage, of three
    // steps of stock, does not come as far as from the fourth.
    void endsOnOneStepAreNotOneWhereTheNextStageIsBounded() {
        Project p = driven(1.2);
        p.machine->wheel_drive_kw.reset();
        p.gauge->commands = 5;
        p.optimisation->stages = {3};
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.3, 0.9, 7.2};
        p.optimisation->stage_radial_feed_mm_min = {{7.2, 7.2}, {0.9, 0.9}, {0.3, 0.3}};
        for (const double most_mm : {0.09, 0.1, 0.11, 0.12}) {
            p.optimisation->stage_stock_mm = {{0.01, most_mm}, {0.03, 0.03}};
            const SearchSummary pruned = search(p);
            QVERIFY(pruned.best.has_value());
            QVERIFY(same(pruned, PlainSearch(p)));
        }
    }

    // A drive that allows 0.6 mm/min at 180 rev/min and nothing faster: only the work speed can
    // help.
    void aWorkSpeedThatBreaksTheDriveBinds() {
        Project p = driven(0.6);
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.6};
        p.optimisation->work_speed_rpm = std::vector<double>{180, 240};
        const SearchSummary best = search(p);
        QVERIFY(best.best.has_value());
        Project other = withBest(p, best);
        other.machine->work_speed_rpm = best.machine.work_speed_rpm == 180 ? 240 : 180;
        const SimulationResult result = simulateUnchecked(other);
        QVERIFY(!holds(result) || std::llround(result.time_s * 1e6) >= best.best->time_us);
        const bool binds = !holds(result) && std::llround(result.time_s * 1e6) < best.best->time_us;
        QVERIFY(bindingRequirements(p, *best.best)->empty() == !binds);
    }

    void aGridOfTooManyVariantsIsRefused() {
        Project p = driven(0.6);
        p.optimisation->least_ratio_distance = 1e-6;
        p.optimisation->work_speed_rpm = SteppedLevels{100, 200, 0.1};
        QVERIFY(Variants(p).fault() == GridFault::tooManyVariants);
        QVERIFY(search(p).status == SearchStatus::infeasible);
        p.optimisation->work_speed_rpm = SteppedLevels{100, 200, 10};
        QVERIFY(Variants(p).fault() == GridFault::none);
        QCOMPARE(Variants(p).count(), std::size_t{11});
    }
};

} // namespace sparkout::test_free_variables

SPARKOUT_TEST(test_free_variables, TestFreeVariables)
#include "test_free_variables.moc"
