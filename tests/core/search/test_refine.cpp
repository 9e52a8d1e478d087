// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// Off the grid: what is found holds, can be set, lies between the levels and is never slower than
// the best of the grid.
#include "core/search/refine.h"

#include "core/quality/ranges.h"
#include "tests/core/search/search_checks.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

namespace sparkout::test_refine {

using namespace search_checks;

using Feed = std::optional<double> Stage::*;

std::vector<double> levelsOf(const Optimisation& grid, Feed feed) {
    return levelValues(feed == &Stage::radial_feed_mm      ? grid.radial_feed_mm
                       : feed == &Stage::axial_feed_mm_min ? grid.axial_feed_mm_min
                                                           : grid.radial_feed_mm_min);
}

bool isMultiple(double value, double step) {
    return std::abs(value / step - std::round(value / step)) < 1e-6;
}

/// Can it be set: between the levels, and by the machine's steps or in three digits?
bool canBeSet(const Project& p, const Stage& stage, Feed feed) {
    const std::vector<double> levels = levelsOf(*p.optimisation, feed);
    const double value = *(stage.*feed);
    const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
    if (value < *least * (1 - 1e-9) || value > *most * (1 + 1e-9)) {
        return false;
    }
    if (feed == &Stage::radial_feed_mm && p.machine->limits.radial_feed_mm) {
        return isMultiple(value - p.machine->limits.radial_feed_mm->front(),
                          p.machine->limits.radial_feed_mm->back());
    }
    return isMultiple(value, std::pow(10.0, std::floor(std::log10(value)) - 2));
}

/// The laws of a quicker cycle.
bool isOfTheGridsKind(const Project& p, const Cycle& cycle) {
    double sum = 0;
    for (std::size_t z = 0; z < cycle.stages.size(); ++z) {
        const Stage& stage = cycle.stages[z];
        sum += stage.stock_mm;
        for (const Feed feed :
             {&Stage::radial_feed_mm, &Stage::axial_feed_mm_min, &Stage::radial_feed_mm_min}) {
            const bool given = (stage.*feed).has_value();
            if (given && !canBeSet(p, stage, feed)) {
                return false;
            }
            if (given && z > 0 && p.optimisation->non_increasing
                && stage.*feed > cycle.stages[z - 1].*feed) {
                return false;
            }
        }
        if (z + 1 < cycle.stages.size() && !isMultiple(stage.stock_mm, 1e-4)) {
            return false;
        }
    }
    const double last = cycle.stages.back().stock_mm;
    const auto& bounds = p.optimisation->last_stock_mm;
    const bool within = !bounds || cycle.stages.size() == 1
                        || (last > bounds->front() - 1e-9 && last < bounds->back() + 1e-9);
    return within && last > 0 && std::abs(sum - p.part->stock_mm) < 1e-9;
}

class TestRefine : public QObject {
    Q_OBJECT

private slots:
    void whatIsFoundHoldsCanBeSetAndIsNeverSlower() {
        int best = 0, quicker = 0;
        RefineOptions options;
        options.mostRuns = 300;
        for (unsigned seed = 0; seed < static_cast<unsigned>(samples::sized(120, 40, 400));
             ++seed) {
            const Project p = smallCase(seed);
            const SearchSummary grid = optimise(p);
            if (!grid.best) {
                continue;
            }
            ++best;
            const RefineSummary refined = refine(p, grid.cycle, options);
            QVERIFY(refined.runs <= 300);
            QVERIFY(refined.isQuicker == (refined.time_us < grid.best->time_us));
            QVERIFY(refined.time_us <= grid.best->time_us);
            Project alone = p;
            *alone.cycle = refined.cycle;
            const SimulationResult result = simulateUnchecked(alone);
            QVERIFY(holds(result));
            QVERIFY(std::llround(result.time_s * 1e6) == refined.time_us);
            if (refined.isQuicker) {
                ++quicker;
                QVERIFY2(isOfTheGridsKind(p, refined.cycle),
                         ("case " + std::to_string(seed)).c_str());
            }
        }
        QVERIFY2(quicker > best / 3,
                 QByteArray::number(quicker) + " of " + QByteArray::number(best));
    }

    // One feed alone: all of three digits can be tried.
    void oneFeedIsTheBestOfAllThatCanBeSet() {
        Project p = driven(0.87);
        const SearchSummary grid = optimise(p);
        QVERIFY(grid.best && grid.best->cycle[0].setting == 1); // 0.6
        const RefineSummary refined = refine(p, grid.cycle);
        std::int64_t least_us = grid.best->time_us;
        for (int thousandths = 600; thousandths < 1000; ++thousandths) {
            p.cycle->stages = {fixtures::plungeStage(thousandths * 1e-3, p.part->stock_mm)};
            const SimulationResult result = simulateUnchecked(p);
            if (holds(result)) {
                least_us = std::min<std::int64_t>(least_us, std::llround(result.time_s * 1e6));
            }
        }
        QVERIFY(least_us < grid.best->time_us);
        QVERIFY(refined.time_us == least_us);
    }

    // The proven best of a grid as fine as the machine's steps, within a hundredth.
    void fromACoarseGridItComesNearTheBestOfAFineOne() {
        Project p = readExample("shaft-30h6-factory");
        p.optimisation->radial_feed_mm = std::vector<double>{0.001, 0.01};
        p.optimisation->axial_feed_mm_min = std::vector<double>{600, 3000};
        Project fine = p;
        fine.optimisation->stock_step_mm = 0.002;
        fine.optimisation->radial_feed_mm = SteppedLevels{0.001, 0.01, 0.0005};
        fine.optimisation->axial_feed_mm_min = SteppedLevels{600, 3000, 50};
        checkNear(p, fine);
        p = readExample("plunge-shaft-two-stage");
        p.optimisation->stages = {1, 2};
        p.optimisation->stock_step_mm = 0.02;
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.1, 0.3, 0.8};
        fine = p;
        fine.optimisation->stock_step_mm = 0.0005;
        fine.optimisation->radial_feed_mm_min = SteppedLevels{0.1, 0.8, 0.01};
        checkNear(p, fine);
    }

    void theMachinesStepsAndRangesAreKept() {
        Project p = driven(0.87);
        p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.35, 0.83, 0.05};
        const RefineSummary refined = refine(p, optimise(p).cycle);
        QVERIFY(refined.isQuicker);
        *p.cycle = refined.cycle;
        for (const MachineRange& check : checkMachineRanges(p)) {
            QVERIFY(check.value >= check.low && check.value <= check.high && check.onStep);
        }
        QCOMPARE(*refined.cycle.stages[0].radial_feed_mm_min, 0.8); // 0.85 is out of its range
    }

    void withOneLevelThereIsNothingToRefine() {
        Project p = driven(0.87);
        p.optimisation->radial_feed_mm_min = std::vector<double>{0.6};
        const SearchSummary grid = optimise(p);
        const RefineSummary refined = refine(p, grid.cycle);
        QVERIFY(!refined.isQuicker && refined.time_us == grid.best->time_us);
        QVERIFY(refined.cycle.stages[0].radial_feed_mm_min == 0.6);
    }

    void itHoldsInTheScenariosAndInWhatIsDrawn() {
        int quicker = 0;
        const auto phases = [](const Project& best, int) { return stockPhases(best, 8); };
        for (unsigned seed = 0; seed < 40; ++seed) {
            const Project p = smallCase(seed);
            Project dull = p;
            dull.wheel->dullness = p.wheel->dullness * 1.5;
            RobustOptions robust;
            robust.search.scenarios = {dull};
            const RobustSummary grid = optimiseRobustly(p, phases, robust);
            if (!grid.search.best || !grid.holdsInSample) {
                continue;
            }
            RefineOptions options;
            options.mostRuns = 150;
            options.scenarios = grid.added;
            options.scenarios.push_back(dull);
            options.source = phases;
            const RefineSummary refined = refine(p, grid.search.cycle, options);
            QVERIFY(refined.time_us <= grid.search.best->time_us);
            quicker += refined.isQuicker ? 1 : 0;
            Project best = p;
            *best.cycle = refined.cycle;
            std::vector<Project> parts = stockPhases(best, 8);
            *dull.cycle = refined.cycle;
            parts.push_back(dull);
            for (const Project& part : parts) {
                QVERIFY(holds(simulateUnchecked(part)));
            }
        }
        QVERIFY2(quicker > 3, QByteArray::number(quicker));
    }

    void aStopKeepsWhatIsGiven() {
        const Project p = driven(0.87);
        const SearchSummary grid = optimise(p);
        const StoppedSource stop;
        RefineOptions options;
        options.stop = stop.get_token();
        const RefineSummary refined = refine(p, grid.cycle, options);
        QVERIFY(!refined.isQuicker && refined.time_us == grid.best->time_us);
        QCOMPARE(refined.runs, 1LL);
    }

private:
    static Project readExample(const std::string& name) {
        const std::string file = "resources/examples/" + name + ".sparkout";
        return samples::projectIn(file);
    }

    static void checkNear(const Project& coarse, const Project& fine) {
        const SearchSummary grid = optimise(coarse), best = optimise(fine);
        QVERIFY(best.status == SearchStatus::proved);
        const RefineSummary refined = refine(coarse, grid.cycle);
        QVERIFY(refined.time_us < grid.best->time_us * 0.96); // there was something to find
        QVERIFY(refined.time_us <= best.best->time_us * 1.01);
    }
};

} // namespace sparkout::test_refine

SPARKOUT_TEST(test_refine, TestRefine)
#include "test_refine.moc"
