// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// A search whose levels follow its answer, and where an answer stands at the edge of its grid.
#include "core/study/search_levels.h"

#include "core/search/grid.h"
#include "core/study/new_project.h"
#include "core/study/search.h"
#include "core/study/search_edits.h"
#include "tests/core/search/search_cases.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <set>

namespace sparkout::test_search_levels {

using search_cases::holds;
using search_cases::smallCase;

/// A small grid on a machine with ranges that reach far beyond it.
Project wideMachine(unsigned seed) {
    Project p = smallCase(seed);
    p.machine->limits.radial_feed_mm = std::vector<double>{0.0005, 0.05, 0.0005};
    p.machine->limits.axial_feed_mm_min = std::vector<double>{100, 5000, 50};
    p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.02, 5, 0.01};
    p.optimisation->stages = {1, 2};
    p.optimisation->adaptive = true;
    return p;
}

std::vector<double> levelsOf(const Project& p, const StageFeed& feed) {
    std::vector<double> levels = levelValues((*p.optimisation).*feed.levels);
    std::ranges::sort(levels);
    return levels;
}

bool isStepOf(double value, const std::vector<double>& range) {
    const double steps = (value - range[0]) / range[2];
    return value >= range[0] - 1e-9 && value <= range[1] + 1e-9
           && (std::abs(steps - std::round(steps)) < 1e-6 || value == range[1]);
}

class TestSearchLevels : public QObject {
    Q_OBJECT

private slots:
    /// Each grid holds those before it, so no answer is slower; it is the best of the last grid by
    /// every cycle of it; and it stands at no edge that the machine would let it pass.
    void theLevelsFollowTheAnswer() {
        int extended = 0, quicker = 0;
        const auto cases = static_cast<unsigned>(samples::sized(24, 12, 150));
        for (unsigned seed = 0; seed < cases; ++seed) {
            const Project p = wideMachine(seed);
            if (p.sections_coupled) {
                continue; // slow, and nothing else
            }
            Project fixed = p;
            fixed.optimisation->adaptive = false;
            const SearchOutcome once = *sparkout::search(fixed, {}), all = *sparkout::search(p, {});
            QCOMPARE(once.rounds, 1);
            QCOMPARE((all.best() != nullptr), (once.best() != nullptr));
            if (!(all.best() != nullptr)) {
                continue;
            }
            const QByteArray which = QByteArray::number(seed);
            QVERIFY2(all.search.best->time_s <= once.search.best->time_s, which);
            QVERIFY2(holds(simulateUnchecked(withFound(all.project, *all.answer()))), which);
            for (const StageFeed& feed : p.operation->feeds) {
                const std::vector<double> before = levelsOf(p, feed),
                                          after = levelsOf(all.searched, feed);
                QVERIFY2(std::ranges::includes(after, before), which);
                for (const double level : after) {
                    QVERIFY2(std::ranges::binary_search(before, level)
                                 || isStepOf(level, *(p.machine->limits.*feed.range)),
                             which);
                }
            }
            QVERIFY2(all.rounds == 10 || std::ranges::all_of(all.edges, &LevelEdge::isLimit),
                     which);
            Project last = all.searched;
            last.optimisation->adaptive = false;
            SearchWish full;
            full.method = SearchMethod::full;
            if (!p.operation->axial()) { // of two feeds it has a hundred thousand cycles
                QVERIFY2(sparkout::search(last, full)->search.best->time_us
                             == all.search.best->time_us,
                         which);
            }
            extended +=
                std::ranges::any_of(once.edges, [](const LevelEdge& edge) { return !edge.isLimit; })
                    ? 1
                    : 0;
            quicker += all.search.best->time_s < 0.95 * once.search.best->time_s ? 1 : 0;
        }
        QVERIFY2(extended > 2 && quicker > 2,
                 QByteArray::number(extended) + ' ' + QByteArray::number(quicker));
    }

    /// What an edge is, and what ends it.
    void edgesAreNamed() {
        Project p = fixtures::plunge();
        p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.02, 5, 0.01};
        p.optimisation = Optimisation{};
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.3, 0.1, 0.6};
        Cycle cycle = *p.cycle;
        cycle.stages.resize(2);
        cycle.stages[0].radial_feed_mm_min = 0.6;
        cycle.stages[1].radial_feed_mm_min = 0.3; // inside
        std::vector<LevelEdge> edges = edgesReached(p, cycle);
        QCOMPARE(edges.size(), std::size_t{1});
        QVERIFY(edges[0].stage == 0 && edges[0].isMost && !edges[0].isLimit);
        QCOMPARE(*edges[0].limit, 5.0);
        cycle.stages[1].radial_feed_mm_min = 0.1;
        QCOMPARE(edgesReached(p, cycle).size(), std::size_t{2});
        QVERIFY(!edgesReached(p, cycle)[1].isMost);
        QCOMPARE(*edgesReached(p, cycle)[1].limit, 0.02);
        p.optimisation->stage_radial_feed_mm_min =
            std::vector<std::vector<double>>{{0.1, 0.6}, {0.05, 0.6}};
        edges = edgesReached(p, cycle);
        QVERIFY(edges[0].isLimit && edges[0].isOfStage && *edges[0].machine == 5);
        QVERIFY(!edges[1].isLimit && edges[1].isOfStage && *edges[1].limit == 0.05);
        p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.1, 0.6, 0.01};
        edges = edgesReached(p, cycle);
        QVERIFY(edges[0].isLimit && edges[1].isLimit);
        QVERIFY(!edges[0].isOfStage && !edges[1].isOfStage); // the machine's range ends there, too
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.6}; // not searched
        QVERIFY(edgesReached(p, cycle).empty());
    }

    /// A feed that is fixed stays so, in a whole grid or in a stage.
    void whatIsFixedStaysFixed() {
        Project p = wideMachine(2);
        for (unsigned seed = 3; p.operation != Operation::traverse; ++seed) {
            p = wideMachine(seed);
        }
        p.optimisation->axial_feed_mm_min = std::vector<double>{1500};
        const SearchOutcome report = *sparkout::search(p, {});
        QCOMPARE(levelsOf(report.searched, *p.operation->axial()), std::vector<double>{1500});
    }

    /// A further round that is stopped leaves the answer of the round before.
    void aStopLeavesTheRoundBefore() {
        Project p;
        SearchOutcome once;
        int calls = 0;
        const SearchEvents counted{.note = [&calls](const SearchState&) { ++calls; }};
        for (unsigned seed = 0; calls == 0 || sparkout::search(p, {})->rounds < 2; ++seed) {
            p = wideMachine(seed);
            if (p.sections_coupled) {
                continue; // slow
            }
            Project fixed = p;
            fixed.optimisation->adaptive = false;
            calls = 0;
            once = *sparkout::search(fixed, {}, {}, counted);
        }
        std::stop_source stop;
        const SearchOutcome stopped =
            *sparkout::search(p, {}, stop.get_token(), {.note = [&](const SearchState&) {
                                  if (--calls < 0) {
                                      stop.request_stop();
                                  }
                              }});
        QVERIFY(stopped.areLevelsCutShort);
        QCOMPARE(stopped.rounds, 1);
        QCOMPARE(stopped.search.status, SearchStatus::proved); // of its grid
        QVERIFY(stopped.search.best->cycle == once.search.best->cycle);
    }

    /// The usual levels reach from end to end of the machine's ranges, by preferred numbers.
    void theUsualSearchSpansTheMachine() {
        for (const char* name : {"complete", "smallest-plunge"}) {
            Project p = samples::project(name);
            p.machine->limits.radial_feed_mm = std::vector<double>{0.0005, 0.02, 0.0005};
            p.machine->limits.axial_feed_mm_min = std::vector<double>{50, 5000, 50};
            p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.02, 5, 0.01};
            const Project usual = withUsualSearch(p);
            QVERIFY(usual.optimisation->adaptive && usual.optimisation->non_increasing);
            for (const StageFeed& feed : p.operation->feeds) {
                const std::vector<double>& range = *(p.machine->limits.*feed.range);
                const std::vector<double> levels = levelsOf(usual, feed);
                QVERIFY(levels.size() >= 8 && levels.size() <= 16);
                QCOMPARE(levels.front(), range[0]);
                QCOMPARE(levels.back(), range[1]);
                for (std::size_t i = 0; i < levels.size(); ++i) {
                    QVERIFY(isStepOf(levels[i], range));
                    QVERIFY(i == 0 || levels[i] / levels[i - 1] < 2.001);
                }
            }
        }
    }

    /// The search that is offered asks for what a shop would run, where the project does not say.
    void theOfferedSearchHasPracticalLimits() {
        Project p = samples::project("complete");
        p.optimisation.reset();
        p.least_overlap.reset();
        p.least_overlap_last = 3;
        p.least_steps.reset();
        const Project offered = withOfferedSearch(p);
        QCOMPARE(offered.least_overlap, 1.05);
        QCOMPARE(offered.least_overlap_last, 3.0); // as it was given
        QCOMPARE(offered.least_steps, p.operation->usualLeastSteps);
        QVERIFY(offered.optimisation->non_increasing && offered.optimisation->adaptive);
        Project plain = offered;
        plain.optimisation = withUsualSearch(p).optimisation;
        QVERIFY(sameProject(plain, offered));
        const Project fresh = newProject(Operation::traverse);
        QVERIFY(sameProject(withPracticalLimits(fresh), fresh));
    }

    /// An answer that a practical limit keeps from being quicker says which.
    void whatBindsNamesAPracticalLimit() {
        std::set<ConstraintKind> named;
        for (unsigned seed = 0; seed < 60; ++seed) {
            Project p = smallCase(seed);
            const SearchOutcome free = *sparkout::search(p, {});
            p.least_steps = 4;
            if (p.operation->axial()) {
                p.least_overlap_last = // only the slower of its feeds has
                    p.wheel->width_mm * p.machine->work_speed_rpm / 1000;
            }
            const SearchOutcome report = *sparkout::search(p, {});
            if (!(free.best() != nullptr) || !(report.best() != nullptr)
                || report.search.best->time_us == free.search.best->time_us) {
                continue;
            }
            const SimulationResult result =
                simulateUnchecked(withFound(report.project, *report.answer()));
            for (const ConstraintResult& each : evaluateConstraints(result)) {
                QVERIFY(each.holds);
            }
            named.insert(report.binding->begin(), report.binding->end());
        }
        QVERIFY(named.contains(ConstraintKind::leastSteps));
        QVERIFY(named.contains(ConstraintKind::leastOverlapLast));
    }
};

} // namespace sparkout::test_search_levels

SPARKOUT_TEST(test_search_levels, TestSearchLevels)
#include "test_search_levels.moc"
