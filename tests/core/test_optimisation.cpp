// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the quickest cycle: the pruned search against the full one, and the laws that
// hold for the best cycle of any grid.
#include "core/optimisation/binding.h"
#include "core/optimisation/limit.h"
#include "core/optimisation/optimise.h"
#include "core/optimisation/robust.h"
#include "core/project/validate.h"
#include "core/quality/constraints.h"
#include "core/simulation/simulate.h"

#include "tests/core/project_fixtures.h"
#include "tests/core/project_samples.h"
#include "tests/core/search_cases.h"
#include "tests/registry.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace test_optimisation {

using namespace sparkout;
using search_cases::holds;
using search_cases::smallCase;

namespace {

/// The best cycle of a grid by its definition: every cycle is simulated to its end.
struct PlainSearch {
    std::optional<FeasibleCycle> best;
    long long visits = 0;

    explicit PlainSearch(Project project) {
        const Grid grid(project);
        for (GridCycle cycle; grid.next(cycle);) {
            project.cycle = grid.cycle(cycle);
            const SimulationResult result = simulate(project);
            visits += result.visits;
            const auto time_us = static_cast<std::int64_t>(std::llround(result.time_s * 1e6));
            bool feasible = result.status == RunStatus::completed;
            double margin = std::numeric_limits<double>::infinity();
            for (const ConstraintResult& each : evaluateConstraints(result)) {
                feasible = feasible && each.holds;
                margin = std::min(margin, each.relativeMargin);
            }
            if (feasible
                && (!best || time_us < best->time_us
                    || (time_us == best->time_us && margin > best->leastRelativeMargin))) {
                best = {cycle, time_us, margin};
            }
        }
    }
};

bool same(const std::optional<FeasibleCycle>& a, const std::optional<FeasibleCycle>& b) {
    return a.has_value() == b.has_value()
           && (!a
               || (a->cycle == b->cycle && a->time_us == b->time_us
                   && a->leastRelativeMargin == b->leastRelativeMargin));
}

unsigned caseCount() {
    return static_cast<unsigned>(samples::sized(500, 100, 3000));
}

/// Fewer under the sanitizers.
unsigned searches(int usual) {
    return static_cast<unsigned>(samples::sized(usual, usual * 2 / 5, usual * 4));
}

SearchSummary search(const Project& project, SearchMethod method, unsigned threads = 1) {
    SearchOptions options;
    options.method = method;
    options.threads = threads;
    return optimise(project, options);
}

std::int64_t timeOf(const SearchSummary& summary) {
    return summary.best ? summary.best->time_us : -1;
}

/// No worse: as quick or quicker, where the other found one.
bool noSlower(const SearchSummary& a, const SearchSummary& b) {
    return !b.best || (a.best && a.best->time_us <= b.best->time_us);
}

} // namespace

class TestOptimisation : public QObject {
    Q_OBJECT

private slots:
    void theGridHasItsCyclesOnceAndInOrder() {
        for (unsigned seed = 0; seed < 40; ++seed) {
            const Project p = smallCase(seed);
            const Grid grid(p);
            GridCycle cycle, before;
            std::int64_t count = 0;
            while (grid.next(cycle)) {
                QVERIFY(before.empty() || grid.before(before, cycle));
                before = cycle;
                ++count;
                double sum = 0;
                for (const Stage& stage : grid.cycle(cycle).stages) {
                    QVERIFY(stage.stock_mm > 1e-6);
                    sum += stage.stock_mm;
                }
                QVERIFY(fixtures::within(sum, p.part.stock_mm, 1e-12));
                const double last_mm = grid.cycle(cycle).stages.back().stock_mm;
                const auto& bounds = p.optimisation->last_stock_mm;
                QVERIFY(cycle.size() == 1 || !bounds
                        || (last_mm > bounds->front() - 1e-9 && last_mm < bounds->back() + 1e-9));
            }
            QVERIFY(count == grid.size());
        }
    }

    void theCasesAreValidAndOfEveryKind() {
        std::map<std::string, int> seen;
        for (unsigned seed = 0; seed < caseCount(); ++seed) {
            const Project p = smallCase(seed);
            for (const Issue& issue : validate(p)) {
                QVERIFY2(issue.severity != Severity::error, issue.path.c_str());
            }
            ++seen[p.operation == Operation::traverse ? "traverse" : "plunge"];
            seen["coupled"] += p.sections_coupled ? 1 : 0;
            seen["contact"] += p.machine.wheel_contact ? 1 : 0;
            seen["free gauge"] += p.gauge.position_mm ? 1 : 0;
            seen["bore"] += p.part.surface == Surface::internal ? 1 : 0;
            seen["roundness"] += p.part.tolerance.roundness_um ? 1 : 0;
            seen["position"] += p.gauge.control == Control::position ? 1 : 0;
            seen["three stages"] += p.optimisation->stages.size() == 3 ? 1 : 0;
        }
        QCOMPARE(seen.size(), std::size_t{9});
        for (const auto& [kind, times] : seen) {
            QVERIFY2(times * 30 >= static_cast<int>(caseCount()),
                     (kind + " " + std::to_string(times)).c_str());
        }
    }

    void bothSearchesFindTheCycleOfPlainRunsWithFewerVisits() {
        int found = 0;
        long long plainVisits = 0, prunedVisits = 0;
        for (unsigned seed = 0; seed < caseCount(); ++seed) {
            const Project p = smallCase(seed);
            const PlainSearch plain(p);
            const SearchSummary full = search(p, SearchMethod::full);
            const SearchSummary pruned = search(p, SearchMethod::pruned);
            const QByteArray where = "case " + QByteArray::number(seed);
            QVERIFY2(same(full.best, plain.best), where);
            QVERIFY2(same(pruned.best, plain.best), where);
            const auto proof = plain.best ? SearchStatus::proved : SearchStatus::infeasible;
            QVERIFY2(full.status == proof && pruned.status == proof, where);
            QVERIFY2(full.visits <= plain.visits, where); // it only stops earlier
            found += plain.best ? 1 : 0;
            plainVisits += plain.visits;
            prunedVisits += pruned.visits;
        }
        // the cases must not all be easy or all be hopeless
        const int all = static_cast<int>(caseCount());
        QVERIFY2(found > all / 5 && found < all - all / 20, QByteArray::number(found));
        QVERIFY2(prunedVisits < plainVisits / 5,
                 QByteArray::number(prunedVisits) + " of " + QByteArray::number(plainVisits));
    }

    // Two stages with equal feeds are one, but where a bound of the last stock forbids the sum, or
    // the shorter cycle is not in the grid or comes later.
    void equalNeighboursAreFoundWhereOnlyMoreStagesAllowThem() {
        int equal = 0;
        for (unsigned seed = 0; seed < searches(200); ++seed) {
            Project p = smallCase(seed);
            p.optimisation->stages =
                std::array<std::vector<double>, 3>{{{1, 2, 3}, {1, 3}, {3, 2}}}[seed % 3];
            p.optimisation->last_stock_mm.reset();
            if (seed % 3 == 0) {
                p.optimisation->last_stock_mm = std::vector<double>{0.01, 0.01};
            }
            const PlainSearch plain(p);
            const SearchSummary pruned = search(p, SearchMethod::pruned);
            QVERIFY2(same(pruned.best, plain.best), QByteArray::number(seed));
            if (plain.best && plain.best->cycle.size() == 3) {
                const GridCycle& cycle = plain.best->cycle;
                equal +=
                    cycle[0].setting == cycle[1].setting || cycle[1].setting == cycle[2].setting
                        ? 1
                        : 0;
            }
        }
        QVERIFY2(equal > 5, QByteArray::number(equal));
    }

    void theBestCycleHoldsWhenItIsRunAlone() {
        for (unsigned seed = 0; seed < 100; ++seed) {
            Project p = smallCase(seed);
            const SearchSummary best = search(p, SearchMethod::pruned);
            if (!best.best) {
                continue;
            }
            p.cycle = best.cycle;
            const SimulationResult alone = simulate(p);
            QVERIFY(holds(alone));
            QVERIFY(std::llround(alone.time_s * 1e6) == best.best->time_us);
        }
    }

    void threadsDoNotChangeTheAnswer() {
        for (unsigned seed = 0; seed < 20; ++seed) {
            const Project p = smallCase(seed);
            const SearchSummary one = search(p, SearchMethod::full, 1);
            const SearchSummary three = search(p, SearchMethod::full, 3);
            QVERIFY(timeOf(one) == timeOf(three));
            QVERIFY(!one.best || one.best->cycle == three.best->cycle);
        }
    }

    void aStoppedFullSearchGoesOn() {
        int stopped = 0;
        for (unsigned seed = 0; seed < 30; ++seed) {
            const Project p = smallCase(seed);
            const SearchSummary whole = search(p, SearchMethod::full);
            std::stop_source stop;
            SearchOptions options;
            options.method = SearchMethod::full;
            options.threads = 1;
            options.stop = stop.get_token();
            options.onProgress = [&stop](const SearchProgress& progress) {
                if (progress.evaluations > 0) {
                    stop.request_stop();
                }
            };
            const SearchSummary first = optimise(p, options);
            if (first.status != SearchStatus::stopped) {
                continue;
            }
            ++stopped;
            SearchOptions rest;
            rest.method = SearchMethod::full;
            rest.resume = first.checkpoint;
            const SearchSummary second = optimise(p, rest);
            QVERIFY(timeOf(second) == timeOf(whole));
            QVERIFY(!whole.best || second.best->cycle == whole.best->cycle);
            QCOMPARE(first.evaluations + second.evaluations, whole.evaluations);
        }
        QVERIFY(stopped > 5);
    }

    void aStoppedPrunedSearchKeepsItsBound() {
        for (unsigned seed = 0; seed < 60; ++seed) {
            const Project p = smallCase(seed);
            const SearchSummary whole = search(p, SearchMethod::pruned);
            std::stop_source stop;
            SearchOptions options;
            options.stop = stop.get_token();
            int calls = 0;
            options.onProgress = [&](const SearchProgress& progress) {
                if (whole.best) {
                    QVERIFY(progress.bound_s <= whole.best->time_us * 1e-6 + 2e-6);
                }
                if (++calls == 5) {
                    stop.request_stop();
                }
            };
            const SearchSummary part = optimise(p, options);
            QVERIFY(noSlower(whole, part));
        }
    }

    void withoutMemoryTheAnswerIsTheSame() {
        for (unsigned seed = 0; seed < 60; ++seed) {
            const Project p = smallCase(seed);
            const SearchSummary whole = search(p, SearchMethod::pruned);
            for (const std::size_t bytes : {std::size_t{0}, std::size_t{50'000}}) {
                SearchOptions options;
                options.memory_bytes = bytes;
                options.onProgress = [&](const SearchProgress& progress) {
                    if (whole.best) {
                        QVERIFY(progress.bound_s <= whole.best->time_us * 1e-6 + 2e-6);
                    }
                };
                const SearchSummary little = optimise(p, options);
                QVERIFY(little.status == whole.status);
                QVERIFY(same(little.best, whole.best));
            }
        }
    }

    // Each requirement that binds, dropped or loosened, lets a quicker cycle of the grid in.
    void whatBindsBreaksInAQuickerCycle() {
        int bound = 0;
        for (unsigned seed = 0; seed < 60; ++seed) {
            Project p = smallCase(seed);
            const SearchSummary best = search(p, SearchMethod::pruned);
            if (!best.best) {
                continue;
            }
            std::vector<ConstraintKind> broken; // by all quicker cycles of the grid
            const Grid grid(p);
            for (GridCycle cycle; grid.next(cycle);) {
                p.cycle = grid.cycle(cycle);
                const SimulationResult result = simulate(p);
                for (const ConstraintResult& each : evaluateConstraints(result)) {
                    if (!each.holds && std::llround(result.time_s * 1e6) < best.best->time_us) {
                        broken.push_back(each.kind);
                    }
                }
            }
            for (const ConstraintKind kind : bindingRequirements(p, *best.best)) {
                QVERIFY(std::find(broken.begin(), broken.end(), kind) != broken.end());
                ++bound;
            }
        }
        QVERIFY(bound > 10);
    }

    // One stage, one feed too many: what the next feed breaks binds, and nothing else.
    void theRequirementThatTheNextFeedBreaksBinds() {
        Project p = fixtures::plunge();
        p.material.burn_rise_k.reset();
        p.part.lower_deviation_um = -200;
        p.part.upper_deviation_um = 200;
        p.part.tolerance = {};
        p.optimisation = Optimisation{};
        p.optimisation->stages = {1};
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.3, 0.6, 1.2};
        p.cycle.stages = {fixtures::plungeStage(0.6, p.part.stock_mm)};
        p.machine.wheel_drive_kw = simulate(p).peakPower_w / 1000 * 1.001;
        const SearchSummary best = search(p, SearchMethod::pruned);
        QVERIFY(best.best && best.best->cycle[0].setting == 1);
        QVERIFY(bindingRequirements(p, *best.best)
                == std::vector<ConstraintKind>{ConstraintKind::wheelPower});
        p.machine.wheel_drive_kw.reset();
        const SearchSummary free = search(p, SearchMethod::pruned);
        QVERIFY(free.best && free.best->cycle[0].setting == 2);
        QVERIFY(bindingRequirements(p, *free.best).empty());
    }

    void relaxingALimitNeverSlows() {
        for (unsigned seed = 0; seed < 60; ++seed) {
            const Project tight = smallCase(seed);
            Project loose = tight;
            loose.part.tolerance.radial_runout_um = *tight.part.tolerance.radial_runout_um * 2;
            if (tight.material.burn_rise_k) {
                loose.material.burn_rise_k = *tight.material.burn_rise_k * 1.3;
            }
            if (tight.machine.wheel_drive_kw) {
                loose.machine.wheel_drive_kw = *tight.machine.wheel_drive_kw * 1.5;
            }
            QVERIFY(
                noSlower(search(loose, SearchMethod::pruned), search(tight, SearchMethod::pruned)));
        }
    }

    void moreStagesNeverSlow() {
        for (unsigned seed = 0; seed < 60; ++seed) {
            Project few = smallCase(seed), more = few;
            few.optimisation->stages = {1};
            more.optimisation->stages = {1, 2};
            QVERIFY(
                noSlower(search(more, SearchMethod::pruned), search(few, SearchMethod::pruned)));
        }
    }

    void scenariosNeverSpeedItUpAndBothMethodsAgree() {
        int found = 0;
        for (unsigned seed = 0; seed < searches(150); ++seed) {
            const Project p = smallCase(seed);
            Project dull = p, more = p;
            dull.wheel.dullness = p.wheel.dullness * 1.5;
            more.part.stock_mm = p.part.stock_mm + 0.003;
            SearchOptions options;
            options.scenarios = {dull, more};
            options.method = SearchMethod::full;
            const SearchSummary full = optimise(p, options);
            options.method = SearchMethod::pruned;
            const SearchSummary pruned = optimise(p, options);
            QVERIFY(same(full.best, pruned.best));
            found += full.best ? 1 : 0;
            if (full.best) {
                for (Project part : {p, dull, more}) {
                    part.cycle = full.cycle;
                    QVERIFY(holds(simulate(part)));
                }
            }
            QVERIFY(noSlower(search(p, SearchMethod::pruned), pruned));
        }
        QVERIFY(found > 20);
    }

    void noCycleOfAGridIsQuickerThanTheSteplessLimit() {
        int burning = 0;
        for (unsigned seed = 0; seed < searches(150); ++seed) {
            const Project p = smallCase(seed);
            const SearchSummary best = search(p, SearchMethod::pruned);
            const double limit_s = steplessLimit_s(p);
            QVERIFY(limit_s > 0);
            QVERIFY(!best.best || limit_s <= best.best->time_us * 1e-6);
            Project free = p;
            free.material.burn_rise_k.reset();
            free.machine.wheel_drive_kw.reset();
            burning += steplessLimit_s(free) < limit_s * 0.99 ? 1 : 0;
            QVERIFY(steplessLimit_s(free) <= limit_s * (1 + 1e-9));
        }
        QVERIFY2(burning > 5, QByteArray::number(burning)); // else no requirement was tried
    }

    // One radius, no elastic yield, η = 0, one power limit: each revolution takes what the drive
    // allows, N/(b·k_t·V_k), so T = Π·b·k_t·V_k/(N·n).
    void theLimitOfADriveIsItsClosedForm() {
        Project p = fixtures::plunge();
        p.wheel.dullness = 0;
        p.material.burn_rise_k.reset();
        p.machine.wheel_drive_kw = 2;
        p.machine.limits.plunge_feed_mm_min = std::vector<double>{0.01, 100, 0.01};
        const double Vk = 35, Vd = std::numbers::pi * 30 * 180 / 60 / 1000; // m/s
        const double kt = p.material.shear_strain * 2000 * Vd / Vk;         // N/mm²
        const double a = 2000 / (40 * kt * Vk);                             // W/(mm·N/mm²·m/s)
        QVERIFY(fixtures::close(steplessLimit_s(p), 0.2 / a / 3, 1e-6));
    }

    void theRobustCycleHoldsInEveryPhaseOfTheStock() {
        int added = 0;
        for (unsigned seed = 0; seed < 30; ++seed) {
            const Project p = smallCase(seed);
            const auto phases = [](const Project& best, int) { return stockPhases(best); };
            const RobustSummary robust = optimiseRobustly(p, phases);
            added += static_cast<int>(robust.added.size());
            if (!robust.search.best) {
                continue;
            }
            QVERIFY(robust.holdsInSample);
            QVERIFY(robust.search.best->time_us >= robust.nominalTime_us);
            Project best = p;
            best.cycle = robust.search.cycle;
            for (const Project& scenario : stockPhases(best)) {
                QVERIFY(holds(simulate(scenario)));
            }
        }
        QVERIFY(added > 0); // else the nominal part would have done
    }

    void anEmptyGridIsInfeasible() {
        Project p = fixtures::plunge();
        QVERIFY(optimise(p).status == SearchStatus::infeasible);
        p.optimisation = Optimisation{};
        for (const SearchMethod method : {SearchMethod::full, SearchMethod::pruned,
                                          SearchMethod::published, SearchMethod::labels}) {
            const SearchSummary summary = search(p, method);
            QVERIFY(summary.status == SearchStatus::infeasible);
            QVERIFY(summary.gridSize == 0);
        }
    }
};

} // namespace test_optimisation

SPARKOUT_TEST(test_optimisation, TestOptimisation)
#include "test_optimisation.moc"
