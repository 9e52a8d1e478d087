// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The greatest margin within a time: the answer is the one found by running all cycles of the grid,
// for any time, on the part alone, in scenarios and for every stock.
#include "core/search/binding.h"
#include "core/search/cycle_runner.h"
#include "core/search/phase_cases.h"
#include "core/search/robust.h"
#include "core/study/search.h"
#include "core/units.h"
#include "tests/core/search/search_checks.h"
#include "tests/registry.h"
#include "words/search_words.h"

namespace sparkout::test_margin_within {

using namespace search_checks;

/// A cycle of a grid that holds.
struct Held {
    PlainCycle plain;
    std::int64_t time_us = 0;
    double margin = 0;
};

double leastMargin(const SimulationResult& result) {
    double least = std::numeric_limits<double>::infinity();
    for (const ConstraintResult& constraint : evaluateConstraints(result)) {
        least = std::min(least, constraint.relativeMargin);
    }
    return least;
}

/// All of them, on the part and in scenarios, in the order of the grid.
std::vector<Held> allHeld(Project project, const std::vector<Project>& scenarios = {}) {
    std::vector<Held> all;
    for (const PlainCycle& each : PlainGrid(project).cycles) {
        *project.cycle = each.cycle;
        setMachine(project, each.machine);
        const SimulationResult result = simulateUnchecked(project);
        bool isHeld = holds(result);
        double margin = isHeld ? leastMargin(result) : 0;
        for (Project scenario : scenarios) {
            setMachine(scenario, each.machine);
            *scenario.cycle = each.cycle;
            const SimulationResult there = simulateUnchecked(scenario);
            isHeld = isHeld && holds(there);
            margin = isHeld ? std::min(margin, leastMargin(there)) : 0;
        }
        if (isHeld) {
            all.push_back({each, std::llround(result.time_s * 1e6), margin});
        }
    }
    return all;
}

/// By the definition: the quickest of those whose margin is that of the greatest, to 1e-9. Null:
/// none.
const Held* bestWithin(const std::vector<Held>& all, std::int64_t within_us) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (const Held& each : all) {
        greatest = each.time_us <= within_us ? std::max(greatest, each.margin) : greatest;
    }
    const Held* best = nullptr;
    for (const Held& each : all) {
        if (each.time_us <= within_us && each.margin > greatest - 1e-9
            && (!best || each.time_us < best->time_us
                || (each.time_us == best->time_us && each.margin > best->margin))) {
            best = &each;
        }
    }
    return best;
}

bool isThat(const SearchSummary& found, const Held* best) {
    return found.best.has_value() == (best != nullptr)
           && (!best
               || (sameCycle(found.cycle, best->plain.cycle) && found.machine == best->plain.machine
                   && found.best->time_us == best->time_us
                   && found.best->leastRelativeMargin == best->margin));
}

/// Too short, the least, some between and any.
std::vector<std::int64_t> timesOf(const std::vector<Held>& all) {
    std::vector<std::int64_t> times{1};
    for (const Held& each : all) {
        times.push_back(each.time_us);
    }
    std::sort(times.begin(), times.end());
    std::vector<std::int64_t> some;
    for (std::size_t i = 0; i < 6; ++i) {
        some.push_back(times[i * (times.size() - 1) / 5]);
    }
    some.push_back(times.back() * 2);
    if (times.size() > 1) {
        some.push_back(times[1]);     // the least
        some.push_back(times[1] - 1); // and what no cycle can do
    }
    std::sort(some.begin(), some.end());
    return some;
}

SearchSummary searchWithin(const Project& project, std::int64_t within_us, SearchMethod method,
                           std::vector<Project> scenarios = {}) {
    SearchOptions options;
    options.method = method;
    options.marginWithin_us = within_us;
    options.scenarios = std::move(scenarios);
    return optimise(project, options);
}

Project withVariants(Project p, unsigned seed) {
    if (seed % 4 == 1) {
        p.optimisation->work_speed_rpm = std::vector<double>{150, 180};
    } else if (seed % 4 == 3) {
        p.optimisation->unfed_steps = std::vector<double>{0, 3};
    }
    return p;
}

/// Other states of the part, of which some cycles hold in all.
std::vector<Project> otherParts(const Project& project) {
    std::vector<Project> parts(2, project);
    parts[0].wheel->dullness *= 1.2;
    parts[1].part->stock_mm += 0.0017;
    parts[1].part->initial_runout_mm += 0.002;
    return parts;
}

/// Few, and in every draw the same.
std::vector<Project> fewPhases(const Project& best, int) {
    return stockPhases(best, 3, 0.3);
}

/// Of fewer grids under the sanitizers.
int fewest(int usual) {
    return samples::sized(usual, usual / 4, usual);
}

class TestMarginWithin : public QObject {
    Q_OBJECT

private slots:
    void theAnswerIsThatOfAllCyclesOfTheGrid() {
        int found = 0, notTheQuickest = 0, none = 0;
        for (unsigned seed = 0; seed < plainGrids(100); ++seed) {
            const Project project = withVariants(smallCase(seed), seed);
            const std::vector<Held> all = allHeld(project);
            for (const std::int64_t within_us : timesOf(all)) {
                const Held* const best = bestWithin(all, within_us);
                for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                    const SearchSummary answer = searchWithin(project, within_us, method);
                    QVERIFY2(isThat(answer, best), qPrintable(QString::number(seed)));
                    QVERIFY(answer.status
                            == (best ? SearchStatus::proved : SearchStatus::infeasible));
                    QCOMPARE(answer.bound_s, 0.0);
                }
                found += best ? 1 : 0;
                none += best ? 0 : 1;
                notTheQuickest += best && best->time_us > all.front().time_us ? 1 : 0;
            }
        }
        QVERIFY(found > fewest(150) && none > fewest(100) && notTheQuickest > fewest(50));
    }

    // What the definition implies, on grids that are too large to run all cycles of.
    void aLongerTimeHasNoSmallerMarginAndTheLeastOneIsThatOfTheQuickest() {
        int grows = 0;
        for (unsigned seed = 0; seed < searches(40); ++seed) {
            Project project = smallCase(seed);
            project.optimisation->stock_step_mm = 0.004;
            const SearchSummary quickest = search(project);
            if (!quickest.best) {
                continue;
            }
            const std::int64_t least_us = quickest.best->time_us;
            QVERIFY(same(searchWithin(project, least_us, SearchMethod::pruned), quickest));
            QVERIFY(!searchWithin(project, least_us - 1, SearchMethod::pruned).best);
            double before = quickest.best->leastRelativeMargin;
            for (const double share : {1.02, 1.1, 1.3, 2.0, 5.0}) {
                const auto within_us = static_cast<std::int64_t>(double(least_us) * share);
                const SearchSummary answer = searchWithin(project, within_us, SearchMethod::pruned);
                QVERIFY(answer.best && answer.best->time_us <= within_us);
                QVERIFY(answer.best->leastRelativeMargin >= before - 1e-9);
                grows += answer.best->leastRelativeMargin > before ? 1 : 0;
                before = answer.best->leastRelativeMargin;
            }
        }
        QVERIFY(grows > fewest(20));
    }

    // Two cycles of a trial whose margins differ by 2e-11: the slower one takes 17 % longer.
    void marginsThatDifferInTheirLastBitsAreEqual() {
        const Project project = samples::projectIn("tests/data/trials/margin-tie.sparkout");
        const std::int64_t within_us = marginWithinOf(project).value();
        const std::vector<Held> all = allHeld(project);
        const Held* const best = bestWithin(all, within_us);
        const auto widest = std::ranges::max_element(
            all, {}, [&](const Held& each) { return each.time_us <= within_us ? each.margin : 0; });
        QVERIFY(best && widest->margin > best->margin && widest->margin - best->margin < 1e-10);
        QVERIFY(static_cast<double>(widest->time_us) > 1.15 * static_cast<double>(best->time_us));
        for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
            const SearchSummary answer = searchWithin(project, within_us, method);
            QVERIFY(isThat(answer, best));
            QCOMPARE(answer.status, SearchStatus::proved);
        }
        const SearchOutcomePtr whole = sparkout::search(project, {.front = true});
        QVERIFY(whole->proved());
        QCOMPARE(comparedTime_us(whole->best()->time_s), best->time_us);
        QVERIFY(whole->found.front().isBest);
        SearchOptions options;
        const SearchSummary quickest = optimise(project, options);
        double before = -1;
        for (const SearchSummary& each : tradeOff(project, quickest, options, 1000).cycles) {
            QVERIFY(each.best->leastRelativeMargin > before + 1e-9); // none for its last bits
            before = each.best->leastRelativeMargin;
        }
    }

    void itHoldsInScenariosToo() {
        int found = 0, others = 0;
        for (unsigned seed = 0; seed < plainGrids(60); ++seed) {
            const Project project = withVariants(smallCase(seed), seed);
            const std::vector<Project> parts = otherParts(project);
            const std::vector<Held> all = allHeld(project, parts), alone = allHeld(project);
            for (const std::int64_t within_us : timesOf(all)) {
                const Held* const best = bestWithin(all, within_us);
                for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                    QVERIFY2(isThat(searchWithin(project, within_us, method, parts), best),
                             qPrintable(QString::number(seed)));
                }
                const Held* const bestAlone = bestWithin(alone, within_us);
                found += best ? 1 : 0;
                others += best && best->margin < bestAlone->margin ? 1 : 0;
            }
        }
        QVERIFY(found > fewest(60) && others > fewest(20));
    }

    // Under gauge control the margin is that over every stock of the range: no cycle of the grid
    // has a greater one, and no stock a smaller one of the answer.
    void underGaugeControlTheMarginIsThatOverEveryStock() {
        int found = 0, less = 0;
        for (unsigned seed = 0; seed < plainGrids(40); ++seed) {
            Project project = smallCase(seed);
            project.gauge->control = Control::gauge;
            project.gauge->datum_mm.reset();
            if (seed % 3 == 0) {
                Batch batch;
                batch.factors.dullness.emplace().uniform =
                    std::vector<double>{project.wheel->dullness, project.wheel->dullness + 0.004};
                project.batch = batch;
                project.optimisation->scenarios = OptimisationScenarios::corners;
            }
            std::vector<Held> all;
            for (Held& each : allHeld(project)) {
                Project cycle = project;
                *cycle.cycle = each.plain.cycle;
                const std::optional<double> margin = overEveryStock(cycle);
                if (margin && !hasIdleStage(simulateUnchecked(cycle))) {
                    constexpr double lastBits = 1e-9;
                    each.margin = std::min(each.margin, *margin);
                    for (const Project& drawn : fewPhases(cycle, 0)) { // no less but for rounding
                        const double there = leastMargin(simulateUnchecked(drawn));
                        QVERIFY2(there > each.margin - lastBits, QByteArray::number(seed));
                        each.margin = std::min(each.margin, there);
                    }
                    all.push_back(each);
                }
            }
            for (const std::int64_t within_us : timesOf(all)) {
                const Held* const best = bestWithin(all, within_us);
                for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                    RobustOptions options;
                    options.search.method = method;
                    options.search.marginWithin_us = within_us;
                    const RobustSummary answer = optimiseRobustly(project, fewPhases, options);
                    QVERIFY2(isThat(answer.search, best), qPrintable(QString::number(seed)));
                    QCOMPARE(answer.holdsInSample, best != nullptr);
                    QCOMPARE(answer.decided.has_value(), best != nullptr);
                }
                if (best) {
                    ++found;
                    Project cycle = project;
                    *cycle.cycle = best->plain.cycle;
                    less += best->margin < leastMargin(simulateUnchecked(cycle)) ? 1 : 0;
                    QVERIFY(isLeastOverStocks(cycle, best->margin));
                }
            }
        }
        QVERIFY(found > fewest(40) && less > fewest(20));
    }

    // Under position control it is sampled: the margin is that over the part and what was drawn,
    // and what would have had a greater one failed in one of the phases it was tried on.
    void underPositionControlItIsSampled() {
        int found = 0;
        for (unsigned seed = 0; seed < searches(40); ++seed) {
            Project project = smallCase(seed);
            project.gauge->control = Control::position;
            std::vector<Held> all;
            for (Held& each : allHeld(project)) {
                Project cycle = project;
                *cycle.cycle = each.plain.cycle;
                bool isHeld = !hasIdleStage(simulateUnchecked(cycle));
                for (const Project& part : fewPhases(cycle, 0)) {
                    const SimulationResult there = simulateUnchecked(part);
                    isHeld = isHeld && holds(there);
                    each.margin = std::min(each.margin, leastMargin(there));
                }
                if (isHeld) {
                    all.push_back(each);
                }
            }
            if (all.empty()) {
                continue;
            }
            RobustOptions options;
            options.search.marginWithin_us = 2 * all.back().time_us;
            const RobustSummary answer = optimiseRobustly(project, fewPhases, options);
            const Held* const best = bestWithin(all, 2 * all.back().time_us);
            QVERIFY(isThat(answer.search, best) || answer.freshFailures > 0);
            QVERIFY(!answer.search.best || answer.freshPhases == freshPhaseCount);
            found += answer.search.best ? 1 : 0;
        }
        QVERIFY(found > fewest(5));
    }

    void aStopKeepsTheLargestSoFar() {
        int kept = 0;
        for (unsigned seed = 0; seed < 40; ++seed) {
            const Project project = smallCase(seed);
            std::stop_source source;
            SearchOptions options;
            options.marginWithin_us = std::int64_t{1} << 50;
            options.stop = source.get_token();
            options.onProgress = [&](const SearchProgress& progress) {
                QCOMPARE(progress.bound_s, 0.0);
                if (progress.best) {
                    source.request_stop();
                }
            };
            const SearchSummary answer = optimise(project, options);
            if (answer.status == SearchStatus::stopped && answer.best) {
                Project best = withBest(project, answer);
                const SimulationResult result = simulateUnchecked(best);
                QVERIFY(holds(result));
                QCOMPARE(leastMargin(result), answer.best->leastRelativeMargin);
                ++kept;
            }
        }
        QVERIFY(kept > 10);
    }

    // A whole search: the project's own words, levels that follow, and what has the least margin.
    void theProjectAsksForIt() {
        int found = 0;
        const auto seeds = static_cast<unsigned>(samples::sized(30, 8, 30));
        for (unsigned seed = 0; seed < seeds; ++seed) {
            Project project = smallCase(seed);
            const SearchSummary quickest = search(project);
            if (!quickest.best) {
                continue;
            }
            project.optimisation->margin_within_min =
                1.5 * quickest.best->time_s / units::secondsPerMinute;
            project.optimisation->adaptive = seed % 2 == 0;
            const SearchOutcome report = *sparkout::search(project, {});
            QVERIFY(report.ran() && (report.best() != nullptr));
            QVERIFY(same(report.search, searchWithin(report.searched, *report.marginWithin_us,
                                                     SearchMethod::full)));
            const Project best = withFound(report.project, *report.answer());
            std::vector<ConstraintKind> least;
            const double margin = report.search.best->leastRelativeMargin;
            for (const ConstraintResult& each :
                 worstByKind(evaluateConstraints(simulateUnchecked(best)))) {
                if (each.relativeMargin == margin) {
                    least.push_back(each.kind);
                }
            }
            QVERIFY(!least.empty() && report.binding == least);
            ++found;
        }
        QVERIFY(found > samples::sized(8, 1, 8));
    }

    void whatLooksForTheLeastTimeAloneIsRefused() {
        Project project = driven(0.6);
        project.optimisation->margin_within_min = 5;
        SearchWish options;
        options.refine = true;
        QVERIFY(!sparkout::search(project, options)->ran());
        QVERIFY(searchRefusal(*sparkout::search(project, options)).find("refinement")
                != std::string::npos);
        options = {};
        options.method = SearchMethod::labels;
        QVERIFY(searchRefusal(*sparkout::search(project, options)).find("This method")
                != std::string::npos);
        options.method = SearchMethod::pruned;
        QVERIFY(sparkout::search(project, options)->ran());
    }

private:
    /// By the list of the pieces, part and corners.
    static std::optional<double> overEveryStock(const Project& project) {
        const PhaseCases cases = phaseCases(project);
        std::vector<Project> parts{project};
        for (int corner = 0; corner < cases.corners; ++corner) {
            parts.push_back(project);
            const auto& ends = *project.batch->factors.dullness->uniform;
            parts.back().wheel->dullness = ends[static_cast<std::size_t>(corner)];
        }
        std::optional<double> least;
        for (const Project& part : parts) {
            const PhaseDecision decision = decidePhases(part, cases.stocks);
            if (!decision.holds()) {
                return std::nullopt;
            }
            for (const DecidedPiece& piece : decision.pieces) {
                least = std::min(least.value_or(piece.leastMargin), piece.leastMargin);
            }
        }
        return least;
    }

    /// Simulated one by one, with what two neighbouring pieces overlap by.
    static bool isLeastOverStocks(Project project, double margin) {
        constexpr double lastBits = 1e-3;
        const StockRange stocks = phaseCases(project).stocks;
        for (int i = 0; i <= 60; ++i) {
            project.part->stock_mm = stocks.from_mm + i / 60.0 * (stocks.to_mm - stocks.from_mm);
            if (leastMargin(simulateUnchecked(project)) < margin - lastBits) {
                return false;
            }
        }
        return true;
    }
};

} // namespace sparkout::test_margin_within

SPARKOUT_TEST(test_margin_within, TestMarginWithin)
#include "test_margin_within.moc"
