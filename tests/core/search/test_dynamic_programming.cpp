// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Dynamic programming for plunge cycles against the full search: what it finds holds and is never
// quicker than the proven best, and how often it is wrong, as it says of itself.
#include "core/search/optimise.h"

#include "tests/core/search/search_checks.h"
#include "tests/registry.h"

#include <array>
#include <cstdio>

namespace sparkout::test_dynamic_programming {

using namespace search_checks;

constexpr std::array heuristics{SearchMethod::published, SearchMethod::labels};

/// Plunge parts with the grid of the thesis: as many stages as levels of stock, any feed at each.
std::vector<Project> plungeCases(int count) {
    std::vector<Project> cases;
    for (unsigned seed = 0; static_cast<int>(cases.size()) < count; ++seed) {
        Project p = smallCase(seed);
        if (p.operation != Operation::plunge) {
            continue;
        }
        search_cases::Dice dice(seed);
        const int levels = dice.integer(2, 5);
        const double scale = dice.uniform(0.5, 2);
        p.gauge->commands = 5;
        p.optimisation->stages = {static_cast<double>(levels)};
        p.optimisation->stock_step_mm = p.part->stock_mm / levels;
        p.optimisation->last_stock_mm.reset();
        p.optimisation->radial_feed_mm_min =
            std::vector<double>{0.1 * scale, 0.2 * scale, 0.4 * scale, 0.8 * scale, 1.6 * scale};
        cases.push_back(std::move(p));
    }
    return cases;
}

/// The two-stage example in the thesis's grid: so many stages of equal stocks, any feed at each.
Project example(int stages, std::vector<double> feeds) {
    Project p = samples::projectIn("resources/examples/plunge-shaft-two-stage.sparkout");
    p.part->radii_per_section = 12;
    p.optimisation->stages = {static_cast<double>(stages)};
    p.optimisation->stock_step_mm = p.part->stock_mm / stages;
    p.optimisation->non_increasing = false;
    p.optimisation->radial_feed_mm_min = std::move(feeds);
    return p;
}

/// The same on a soft shaft with a field of 4 µm.
Project softShaft() {
    Project p = example(3, {0.2, 0.6, 1.6});
    p.machine->compliance_mm_per_n = std::vector<double>{3e-4, 3e-4, 3e-4, 3e-4};
    p.part->lower_deviation_um = 8;
    p.part->upper_deviation_um = 12;
    return p;
}

/// How often a method was wrong, of the cases that have a cycle.
struct Tally {
    int feasible = 0, missed = 0, slower = 0;
    double worst = 0; ///< time over the best, less 1

    void add(const SearchSummary& exact, const SearchSummary& heuristic) {
        if (!exact.best) {
            return;
        }
        ++feasible;
        if (!heuristic.best) {
            ++missed;
        } else if (heuristic.best->time_us > exact.best->time_us) {
            ++slower;
            worst = std::max(worst, static_cast<double>(heuristic.best->time_us)
                                            / static_cast<double>(exact.best->time_us)
                                        - 1);
        }
    }
    void print(const char* name) const {
        std::printf("%s: of %d cases with a cycle none found in %d, a slower one in %d, at most "
                    "%.0f %% slower\n",
                    name, feasible, missed, slower, worst * 100);
    }
};

class TestDynamicProgramming : public QObject {
    Q_OBJECT

private slots:
    void whatIsFoundHoldsAndIsNeverQuickerThanTheBest() {
        std::array<Tally, heuristics.size()> tallies;
        int number = 0; // the pruned search is as exact, which test_optimisation shows, and quicker
        for (const Project& p : plungeCases(samples::sized(300, 60, 2000))) {
            const SearchSummary exact =
                search(p, number++ < samples::sized(60, 10, 60) ? SearchMethod::full
                                                                : SearchMethod::pruned);
            for (std::size_t i = 0; i < heuristics.size(); ++i) {
                const SearchSummary found = search(p, heuristics[i]);
                tallies[i].add(exact, found);
                QVERIFY(found.status
                        == (found.best ? SearchStatus::found : SearchStatus::notFound));
                QVERIFY(found.bound_s == 0); // nothing is proved
                if (found.best) {
                    QVERIFY(exact.best && found.best->time_us >= exact.best->time_us);
                    Project alone = p;
                    *alone.cycle = found.cycle;
                    const SimulationResult result = simulateUnchecked(alone);
                    QVERIFY(holds(result));
                    QVERIFY(std::llround(result.time_s * 1e6) == found.best->time_us);
                }
            }
        }
        tallies[0].print("published");
        tallies[1].print("labels");
        // wrong where they say that they can be, right more often than not
        QVERIFY(tallies[0].feasible > 30);
        for (const Tally& tally : tallies) {
            QVERIFY(tally.missed + tally.slower > 0);
            QVERIFY(tally.missed + tally.slower < tally.feasible / 2);
        }
        QVERIFY(tallies[1].missed < tallies[0].missed); // what keeping more labels is for
    }

    // One level, one stage: there is nothing to forget.
    void withOneStageBothFindTheBest() {
        for (Project p : plungeCases(60)) {
            p.optimisation->stages = {1};
            const SearchSummary exact = search(p, SearchMethod::full);
            for (const SearchMethod method : heuristics) {
                const SearchSummary found = search(p, method);
                QVERIFY(found.best.has_value() == exact.best.has_value());
                QVERIFY(!found.best || found.best->cycle == exact.best->cycle);
            }
        }
    }

    void theRuleAsPublishedFindsNoneWhereOneExists() {
        const Project p = softShaft();
        const SearchSummary exact = search(p, SearchMethod::full);
        QVERIFY(exact.status == SearchStatus::proved);
        const SearchSummary published = search(p, SearchMethod::published);
        QVERIFY(published.status == SearchStatus::notFound);
        QVERIFY(!published.best && published.cycle.stages.empty());
        const SearchSummary labels = search(p, SearchMethod::labels);
        QVERIFY(labels.best && labels.best->time_us > exact.best->time_us); // not for nothing
    }

    void theRuleAsPublishedIsSlower() {
        const Project p = example(4, {0.2, 0.3, 0.5, 0.8, 1.2});
        const SearchSummary exact = search(p, SearchMethod::full);
        const SearchSummary published = search(p, SearchMethod::published);
        QVERIFY(exact.best && published.best);
        QVERIFY(published.best->time_us > exact.best->time_us * 11 / 10);
    }

    void scenariosAreHeldToo() {
        int found = 0;
        for (const Project& p : plungeCases(60)) {
            Project dull = p;
            dull.wheel->dullness = p.wheel->dullness * 1.5;
            for (const SearchMethod method : heuristics) {
                SearchOptions options;
                options.method = method;
                options.scenarios = {dull};
                const SearchSummary summary = optimise(p, options);
                for (Project part : {p, dull}) {
                    *part.cycle = summary.cycle;
                    QVERIFY(!summary.best || holds(simulateUnchecked(part)));
                }
                found += summary.best ? 1 : 0;
            }
        }
        QVERIFY(found > 20);
    }

    void aStopKeepsTheBestSoFar() {
        const Project p = example(4, {0.2, 0.3, 0.5, 0.8, 1.2});
        for (const SearchMethod method : heuristics) {
            std::stop_source stop;
            SearchOptions options;
            options.method = method;
            options.stop = stop.get_token();
            long long calls = 0;
            options.onProgress = [&](const SearchProgress& progress) {
                ++calls;
                if (progress.best) {
                    stop.request_stop();
                }
            };
            const SearchSummary stopped = optimise(p, options);
            QVERIFY(calls > 0 && stopped.status == SearchStatus::stopped);
            QVERIFY(stopped.best && stopped.bound_s == 0);
            QVERIFY(stopped.best->time_us >= search(p, method).best->time_us);
        }
    }
};

} // namespace sparkout::test_dynamic_programming

SPARKOUT_TEST(test_dynamic_programming, TestDynamicProgramming)
#include "test_dynamic_programming.moc"
