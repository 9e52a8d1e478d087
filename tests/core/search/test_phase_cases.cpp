// SPDX-License-Identifier: GPL-3.0-or-later
// What a robust answer under gauge control is decided to hold for.
#include "core/batch/scenario_source.h"
#include "core/phases/failing_stock.h"
#include "core/search/case_refuter.h"
#include "core/search/robust.h"
#include "core/simulation/stage_control.h"
#include "tests/core/search/search_cases.h"
#include "tests/core/support/project_samples.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <utility>

namespace sparkout::test_phase_cases {

using search_cases::Dice;
using search_cases::holds;
using search_cases::smallCase;

Factor between(double from, double to) {
    Factor factor;
    factor.uniform = {from, to};
    return factor;
}

/// A small grid under gauge control that asks for the corners of a batch.
Project withCorners(unsigned seed) {
    Project p = smallCase(seed);
    Dice dice(seed + 1000);
    p.gauge->control = Control::gauge;
    p.gauge->datum_mm.reset();
    Batch batch;
    batch.factors.dullness = between(p.wheel->dullness, p.wheel->dullness + 0.005);
    if (dice.chance(0.5)) {
        batch.factors.compliance = between(0.97, 1.03);
    }
    if (dice.chance(0.5)) {
        batch.factors.stock_mm = between(p.part->stock_mm - 0.001, p.part->stock_mm + 0.002);
    }
    p.batch = batch;
    p.optimisation->scenarios = OptimisationScenarios::corners;
    return p;
}

constexpr double fine_mm = 1e-12;

/// Whether its last stage is refuted without following a radius.
bool isRefutedUnfollowed(CaseRefuter& refuter, const GridCycle& cycle) {
    const GridCycle beforeLast(cycle.begin(), cycle.end() - 1);
    std::vector<std::size_t> settings{cycle.back().setting};
    refuter.keepRefuted(beforeLast, settings);
    return !settings.empty();
}

class TestPhaseCases : public QObject {
    Q_OBJECT

private slots:
    void casesAreThoseOfTheBatch() {
        Project p = smallCase(2);
        p.gauge->control = Control::gauge;
        p.batch.reset();
        const StockRange usual = usualPhases(p);
        QCOMPARE(phaseCases(p).stocks, usual);
        QCOMPARE(phaseCases(p).corners, 0);
        Batch batch;
        const double stock_mm = p.part->stock_mm;
        batch.factors.stock_mm = between(stock_mm - 0.001, stock_mm + 0.003);
        p.batch = batch;
        p.optimisation->scenarios = OptimisationScenarios::nominal; // the batch is not asked for
        QCOMPARE(phaseCases(p).stocks, usual);
        p.optimisation->scenarios = OptimisationScenarios::batch;
        QVERIFY(std::abs(phaseCases(p).stocks.from_mm - usual.from_mm + 0.001) < fine_mm);
        QVERIFY(std::abs(phaseCases(p).stocks.to_mm - usual.to_mm - 0.003) < fine_mm);
        QCOMPARE(phaseCases(p).corners, 0);
        p.optimisation->scenarios = OptimisationScenarios::corners;
        QCOMPARE(phaseCases(p).corners, 0); // of the stock alone
        p.batch->factors.dullness = between(0, 0.01);
        p.batch->factors.compliance = between(0.9, 1.1);
        QCOMPARE(phaseCases(p).corners, 4);
    }

    /// Of an answer stocks drawn at random hold at every corner, and the quickest cycle without
    /// corners often does not: they have something to exclude.
    void theAnswerHoldsForEveryStockAtEveryCorner() {
        int answers = 0, excluded = 0;
        const unsigned cases = static_cast<unsigned>(samples::sized(40, 30, 500));
        for (unsigned seed = 0; seed < cases; ++seed) {
            const Project p = withCorners(seed);
            const RobustSummary robust = optimiseRobustly(p, scenariosAskedFor(p));
            if (!robust.holdsInSample) {
                continue;
            }
            ++answers;
            const Project best = withBest(p, robust.search);
            QVERIFY(robust.decided.has_value());
            QCOMPARE(robust.decided->corners, p.batch->factors.compliance ? 4 : 2);
            QVERIFY(!failingCase(best));
            Project corners = best;
            corners.batch->scenarios = Scenarios::corners;
            const ScenarioSource source(std::move(corners));
            Dice dice(seed);
            for (std::int64_t corner = 0; corner < source.parts(); ++corner) {
                Project part = source.project(corner);
                for (int i = 0; i < 40; ++i) {
                    part.part->stock_mm =
                        dice.uniform(robust.decided->stocks.from_mm, robust.decided->stocks.to_mm);
                    QVERIFY2(holds(simulateUnchecked(part)), QByteArray::number(seed));
                }
            }
            Project nominal = p;
            nominal.batch.reset();
            nominal.optimisation->scenarios = OptimisationScenarios::nominal;
            const RobustSummary without = optimiseRobustly(nominal, freshStockPhases);
            Project quickest = p;
            *quickest.cycle = without.search.cycle;
            excluded += failingCase(quickest).has_value() ? 1 : 0;
        }
        QVERIFY2(answers * 5 > static_cast<int>(cases) && excluded > 2,
                 QByteArray::number(answers) + ' ' + QByteArray::number(excluded));
    }

    /// The full search runs every cycle and refutes none; the gauge of every fourth case is late by
    /// up to three revolutions, or by a double stroke.
    void theQuickestIsThatOfTheFullSearch() {
        int answers = 0;
        const unsigned cases = static_cast<unsigned>(samples::sized(60, 20, 2000));
        for (unsigned seed = 0; seed < cases + cases / 3; ++seed) {
            Project p = withCorners(seed % cases);
            if (seed >= cases) {
                p.gauge->delay_s = 0.75 * (1 + seed % 4) * 60 / p.machine->work_speed_rpm;
            }
            RobustOptions full;
            full.search.method = SearchMethod::full;
            full.search.threads = 1;
            const RobustSummary pruned = optimiseRobustly(p, undecidedScenarios(p));
            const RobustSummary all = optimiseRobustly(p, scenariosAskedFor(p), full);
            QCOMPARE(pruned.holdsInSample, all.holdsInSample);
            QCOMPARE(pruned.search.status, all.search.status);
            if (all.search.best) {
                answers += seed < cases ? 1 : 0;
                QCOMPARE(pruned.search.best->time_us, all.search.best->time_us);
            }
        }
        QVERIFY2(answers * 5 > static_cast<int>(cases), QByteArray::number(answers));
    }

    /// Cycles of small grids, with every number of stages: none that holds for each stock of its
    /// range is refuted, and most that fail by a diameter that is too small are.
    void refutedCycleFailsForSomeStock() {
        int refuted = 0, failing = 0, severalStages = 0, notFollowed = 0, late = 0;
        const unsigned cases = static_cast<unsigned>(samples::sized(40, 12, 1000));
        for (unsigned seed = 0; seed < cases; ++seed) {
            Project p = smallCase(seed);
            p.gauge->control = Control::gauge;
            p.gauge->datum_mm.reset();
            p.batch.reset();
            p.part->initial_runout_mm *= seed % 5 == 1 ? 8 : 1; // its form changes with the stock
            if (seed % 4 >= 2) { // in plunge grinding up to three revolutions
                p.gauge->delay_s = 0.75 * (seed % 5) * 60 / p.machine->work_speed_rpm;
            }
            const Grid grid(p);
            const double stock_mm = p.part->stock_mm, wide_mm = 0.001 * (seed % 3);
            const StockRange stocks{stock_mm - wide_mm, stock_mm + wide_mm};
            CaseRefuter refuter({-1, p, stocks}, grid, seed % 4 == 0 ? 0 : 1 << 20, {});
            int cycles = 0;
            for (GridCycle cycle; cycles < 300 && grid.next(cycle); ++cycles) {
                const bool isUnfollowed = isRefutedUnfollowed(refuter, cycle);
                const bool isRefuted = refuter.refutes(cycle) || isUnfollowed;
                notFollowed += isUnfollowed ? 1 : 0;
                if (!isRefuted && cycles % 4 > 0) {
                    continue; // those that hold are not the question
                }
                *p.cycle = grid.cycle(cycle);
                const std::vector<double> infeeds_mm = infeedsOfStages(p);
                const StockRange range = widened(stocks, std::ranges::max(infeeds_mm));
                const bool fails = failingStock(p, range).has_value();
                QVERIFY2(fails || !isRefuted, QByteArray::number(seed));
                failing += fails ? 1 : 0;
                refuted += isRefuted ? 1 : 0;
                severalStages += isRefuted && cycle.size() > 2 ? 1 : 0;
                late += isRefuted && gaugeDelay_s(p) > 0 ? 1 : 0;
            }
        }
        qInfo("%d of %d refuted, %d of more than two stages, %d of all not followed, %d by a late "
              "gauge",
              refuted, failing, severalStages, notFollowed, late);
        QVERIFY(refuted > static_cast<int>(cases) * 5 && severalStages > static_cast<int>(cases));
        QVERIFY(notFollowed > refuted / 4 && late > static_cast<int>(cases));
    }

    void onlyWhatIsNotDecidedIsDrawn() {
        Project p = withCorners(4);
        p.batch->parts = 5;
        QVERIFY(undecidedScenarios(p)(p, 0).empty());
        p.optimisation->scenarios = OptimisationScenarios::batch;
        QCOMPARE(undecidedScenarios(p)(p, 0).size(), std::size_t{5});
        QVERIFY(scenariosAskedFor(p)(p, 0).size() > 5); // and the phases of the part
        p.gauge->control = Control::position;
        QCOMPARE(undecidedScenarios(p)(p, 0).size(), scenariosAskedFor(p)(p, 0).size());
    }

    /// What is returned fails by itself.
    void aCaseThatFailsFails() {
        int failing = 0;
        for (unsigned seed = 0; seed < 60; ++seed) {
            const Project p = withCorners(seed);
            if (const auto found = failingCase(p)) {
                ++failing;
                Project run = *found;
                run.batch.reset();
                QVERIFY2(!holds(simulateUnchecked(run)), QByteArray::number(seed));
            }
        }
        QVERIFY(failing > 20);
    }

    void aStopEndsItWithNothing() {
        const StoppedSource stop;
        QVERIFY(!failingCase(withCorners(1), stop.get_token()));
    }
};

} // namespace sparkout::test_phase_cases

SPARKOUT_TEST(test_phase_cases, TestPhaseCases)
#include "test_phase_cases.moc"
