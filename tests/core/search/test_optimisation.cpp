// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the quickest cycle: the pruned search and the full one against plain runs.
#include "core/project/validate.h"

#include "tests/check_line.h"
#include "tests/core/search/search_checks.h"
#include "tests/core/support/reference_simulation.h"
#include "tests/registry.h"

#include <array>
#include <map>

namespace sparkout::test_optimisation {

using namespace search_checks;

unsigned caseCount() {
    return static_cast<unsigned>(samples::sized(500, 100, 3000));
}

std::int64_t timeOf(const SearchSummary& summary) {
    return summary.best ? summary.best->time_us : -1;
}

/// Whether the second implementation, which shares no code with the engine, can run a project.
bool isForReference(const Project& p) {
    return !p.sections_coupled && !p.machine->wheel_contact;
}

/// The second implementation's word on the best cycle: its time, and that it holds the diameters
/// and the runout.
bool holdsInReference(const Project& p, const SearchSummary& summary) {
    const Project best = withBest(p, summary);
    const reference::Result result = reference::simulate(nlohmann::json::parse(writeProject(best)));
    const std::optional<double> runout_um = best.part->tolerance.radial_runout_um;
    constexpr double um = 1e-6; // the agreement with the engine
    bool holds = result.status == "completed"
                 && fixtures::close(result.time_min * 60,
                                    static_cast<double>(summary.best->time_us) * 1e-6, 1e-6);
    for (const reference::Place& place : result.places) {
        holds &= place.diameter_deviation_min_um >= best.part->lower_deviation_um - um
                 && place.diameter_deviation_max_um <= best.part->upper_deviation_um + um
                 && (!runout_um || place.radial_runout_um <= *runout_um + um);
    }
    return holds;
}

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
                QVERIFY(fixtures::within(sum, p.part->stock_mm, 1e-12));
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
            seen["contact"] += p.machine->wheel_contact ? 1 : 0;
            seen["free gauge"] += p.gauge->position_mm ? 1 : 0;
            seen["bore"] += p.part->surface == Surface::internal ? 1 : 0;
            seen["roundness"] += p.part->tolerance.roundness_um ? 1 : 0;
            seen["position"] += p.gauge->control == Control::position ? 1 : 0;
            seen["three stages"] += p.optimisation->stages.size() == 3 ? 1 : 0;
        }
        QCOMPARE(seen.size(), std::size_t{9});
        for (const auto& [kind, times] : seen) {
            QVERIFY2(times * 30 >= static_cast<int>(caseCount()),
                     (kind + " " + std::to_string(times)).c_str());
        }
    }

    void bothSearchesFindTheCycleOfPlainRunsWithFewerVisits() {
        int found = 0, foundAgain = 0;
        long long plainVisits = 0, prunedVisits = 0;
        for (unsigned seed = 0; seed < caseCount(); ++seed) {
            const Project p = smallCase(seed);
            const PlainSearch plain(p);
            const SearchSummary full = search(p, SearchMethod::full);
            const SearchSummary pruned = search(p, SearchMethod::pruned);
            const QByteArray where = "case " + QByteArray::number(seed);
            QVERIFY2(same(full, plain), where);
            QVERIFY2(same(pruned, plain), where);
            const auto proof = plain.best ? SearchStatus::proved : SearchStatus::infeasible;
            QVERIFY2(full.status == proof && pruned.status == proof, where);
            QVERIFY2(full.visits <= plain.visits, where); // it only stops earlier
            found += plain.best ? 1 : 0;
            if (plain.best && isForReference(p)) {
                QVERIFY2(holdsInReference(p, pruned), where);
                ++foundAgain;
            }
            plainVisits += plain.visits;
            prunedVisits += pruned.visits;
        }
        // the cases must not all be easy or all be infeasible
        const int all = static_cast<int>(caseCount());
        QVERIFY2(found > all / 5 && found < all - all / 20, QByteArray::number(found));
        QVERIFY2(foundAgain > found / 3, QByteArray::number(foundAgain));
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
            QVERIFY2(same(pruned, plain), QByteArray::number(seed));
            if (plain.best && pruned.best->cycle.size() == 3) {
                const GridCycle& cycle = pruned.best->cycle;
                equal +=
                    cycle[0].setting == cycle[1].setting || cycle[1].setting == cycle[2].setting
                        ? 1
                        : 0;
            }
        }
        QVERIFY2(equal > 5, QByteArray::number(equal));
    }

    void theBestCycleHoldsWhenItIsRunAlone() {
        int found = 0;
        for (unsigned seed = 0; seed < 100; ++seed) {
            Project p = smallCase(seed);
            const SearchSummary best = search(p, SearchMethod::pruned);
            if (!best.best) {
                continue;
            }
            *p.cycle = best.cycle;
            const SimulationResult alone = simulateUnchecked(p);
            QVERIFY(holds(alone));
            QVERIFY(std::llround(alone.time_s * 1e6) == best.best->time_us);
            ++found;
        }
        checkLine("19", found, found, found > 0,
                  QStringLiteral("best cycles of 100 random problems run alone: each meets every "
                                 "requirement and takes the time claimed"));
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
                    QVERIFY(progress.bound_s <= whole.best->time_s);
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
            for (const std::size_t bytes :
                 {std::size_t{0}, std::size_t{50'000}, std::size_t{400'000}}) {
                SearchOptions options;
                options.memory_bytes = bytes;
                options.onProgress = [&](const SearchProgress& progress) {
                    if (whole.best) {
                        QVERIFY(progress.bound_s <= whole.best->time_s);
                    }
                };
                const SearchSummary little = optimise(p, options);
                QVERIFY(little.status == whole.status);
                QVERIFY(same(little, whole));
            }
        }
    }

    void scenariosNeverSpeedItUpAndBothMethodsAgree() {
        int found = 0;
        for (unsigned seed = 0; seed < searches(150); ++seed) {
            const Project p = smallCase(seed);
            Project dull = p, more = p;
            dull.wheel->dullness = p.wheel->dullness * 1.5;
            more.part->stock_mm = p.part->stock_mm + 0.003;
            SearchOptions options;
            options.scenarios = {dull, more};
            options.method = SearchMethod::full;
            const SearchSummary full = optimise(p, options);
            options.method = SearchMethod::pruned;
            const SearchSummary pruned = optimise(p, options);
            QVERIFY(same(full, pruned));
            found += full.best ? 1 : 0;
            if (full.best) {
                for (Project part : {p, dull, more}) {
                    *part.cycle = full.cycle;
                    QVERIFY(holds(simulateUnchecked(part)));
                }
            }
            QVERIFY(noSlower(search(p, SearchMethod::pruned), pruned));
        }
        QVERIFY(found > static_cast<int>(searches(150)) / 8);
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

} // namespace sparkout::test_optimisation

SPARKOUT_TEST(test_optimisation, TestOptimisation)
#include "test_optimisation.moc"
