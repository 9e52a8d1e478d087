// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of an operation card against the set-up and its run.
#include "core/setup/operation_card.h"
#include "tests/core/setup/setup_samples.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout::test_operation_card {

using namespace setup_samples;

bool isNear(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(1.0, std::max(std::abs(a), std::abs(b)));
}

Setup anySetup() {
    for (std::uint64_t seed = 0;; ++seed) {
        if (auto setup = randomSetup(seed)) {
            return *setup;
        }
    }
}

auto count(const OperationCard& card, CardEntry entry, std::optional<std::size_t> surface) {
    return std::ranges::count_if(card.lines, [&](const CardLine& line) {
        return line.entry == entry && line.surface == surface;
    });
}

/// A stage's line says what the set-up has and what came out of the run.
void compareStage(const CardRegime& regime, const SimulationResult& result, std::size_t z) {
    const Project& project = result.project;
    const Stage& stage = project.cycle->stages.at(z);
    QCOMPARE(regime.stage, static_cast<int>(z) + 1);
    QCOMPARE(regime.diameter_mm, project.part->diameter_mm);
    QCOMPARE(regime.length_mm, project.part->length_mm);
    QCOMPARE(regime.stock_mm, stage.stock_mm);
    QCOMPARE(regime.steps, result.countsByStage.at(z));
    QCOMPARE(regime.main_min, result.timeByStage_s.at(z) / 60);
    QCOMPARE(regime.workSpeed_rpm, project.machine->work_speed_rpm);
    QVERIFY(isNear(regime.workSpeed_m_min, std::numbers::pi * project.part->diameter_mm
                                               * project.machine->work_speed_rpm / 1000));
    QCOMPARE(regime.feeds, stage.feeds());
    const bool traverse = project.operation == Operation::traverse;
    QCOMPARE(regime.countsStrokes, traverse);
    if (stage.feeds()) {
        QCOMPARE(regime.radialFeed, traverse ? *stage.radial_feed_mm : *stage.radial_feed_mm_min);
    }
    QCOMPARE(regime.axialFeed_mm_min, traverse ? stage.axial_feed_mm_min : std::nullopt);
}

class TestOperationCard : public QObject {
    Q_OBJECT

private slots:
    void everySurfaceHasItsTransitionAndEveryStageItsLine() {
        int surfaces = 0;
        for (std::uint64_t seed = 0; seed < 80; ++seed) {
            const auto setup = randomSetup(seed);
            if (!setup) {
                continue;
            }
            const SetupRun run = runSetup(*setup);
            const OperationCard card = operationCard(*setup, run);
            for (std::size_t i = 0; i < setup->surfaces.size(); ++i) {
                QCOMPARE(count(card, CardEntry::grind, i), 1);
                QCOMPARE(count(card, CardEntry::tooling, i), 1);
                const auto measured = std::ranges::count_if(card.lines, [i](const CardLine& line) {
                    return std::ranges::find(line.measured, i) != line.measured.end();
                });
                QCOMPARE(measured, 1);
                if (i >= run.surfaces.size()) {
                    QCOMPARE(count(card, CardEntry::regime, i), 0);
                    continue;
                }
                const SimulationResult& result = run.surfaces[i].result;
                std::size_t z = 0;
                for (const CardLine& line : card.lines) {
                    if (line.entry == CardEntry::regime && line.surface == i) {
                        compareStage(*line.regime, result, z++);
                    }
                }
                QCOMPARE(z, result.project.cycle->stages.size());
                ++surfaces;
            }
            QCOMPARE(count(card, CardEntry::install, {}), 1);
            QCOMPARE(count(card, CardEntry::remove, {}), 1);
            QCOMPARE(card.lines.front().entry, CardEntry::install);
            QCOMPARE(card.lines.back().entry, CardEntry::remove);
        }
        QVERIFY(surfaces > 50);
    }

    /// Surfaces that are measured with the same are one transition; another kind is its own.
    void surfacesOfOneKindAreCheckedTogether() {
        Setup setup = anySetup();
        setup.surfaces.resize(1);
        setup.surfaces.front().project.part->tolerance = {};
        setup.surfaces.resize(3, setup.surfaces.front());
        setup.surfaces[1].project.part->tolerance.roundness_um = 4;
        const auto controls = [&setup] {
            std::vector<std::vector<std::size_t>> all;
            for (const CardLine& line : operationCard(setup, {}).lines) {
                if (line.entry == CardEntry::control) {
                    all.push_back(line.measured);
                }
            }
            return all;
        };
        using Groups = std::vector<std::vector<std::size_t>>;
        QCOMPARE(controls(), (Groups{{0, 2}, {1}}));
        setup.surfaces[2].project.part->tolerance.cylindricity_um = 5;
        QCOMPARE(controls(), (Groups{{0}, {1, 2}}));
        setup.surfaces[0].project.part->tolerance.roundness_um = 3;
        QCOMPARE(controls(), (Groups{{0, 1, 2}}));
    }

    /// The main times of the transitions are the cycles' and add up to the operation's; so do the
    /// auxiliary ones, unless their sum is given.
    void timesAddUp() {
        int completed = 0;
        for (std::uint64_t seed = 0; seed < 80; ++seed) {
            auto setup = randomSetup(seed);
            if (!setup) {
                continue;
            }
            SetupTimes times;
            times.approach_s = 3;
            times.retreat_s = 2;
            times.gauging_s = 11;
            times.positioning_s = 7;
            times.handling_s = 40;
            setup->times = times;
            const SetupRun run = runSetup(*setup);
            const OperationCard card = operationCard(*setup, run);
            QCOMPARE(card.time.has_value(), run.isCompleted(*setup));
            if (!card.time) {
                continue;
            }
            ++completed;
            double main = 0, auxiliary = 0, stages = 0;
            for (const CardLine& line : card.lines) {
                main += line.main_min.value_or(0);
                auxiliary += line.auxiliary_min.value_or(0);
                stages += line.regime ? line.regime->main_min : 0;
            }
            QVERIFY(isNear(main, run.time.main_min));
            QVERIFY(isNear(auxiliary, run.time.auxiliary_min));
            QVERIFY2(std::abs(stages - main) < 1e-9 * main, qPrintable(QString::number(seed)));
            setup->times.auxiliary_min = 5;
            for (const CardLine& line : operationCard(*setup, runSetup(*setup)).lines) {
                QVERIFY(!line.auxiliary_min);
            }
        }
        QVERIFY(completed > 5);
    }

    /// The gauge ends each stage at the stock of those after it, the last one at size.
    void commandsOfTheGaugeAreTheStockOfLaterStages() {
        Setup one = anySetup();
        one.surfaces.resize(1);
        Project& project = one.surfaces.front().project;
        project.gauge->control = Control::gauge;
        project.cycle->stages.resize(3, project.cycle->stages.front());
        for (std::size_t z = 0; z < 3; ++z) {
            project.cycle->stages[z].stock_mm = z == 0 ? 0.1 : z == 1 ? 0.03 : 0.01;
        }
        const OperationCard card = operationCard(one, {});
        const auto line = std::ranges::find(card.lines, CardEntry::settings, &CardLine::entry);
        QVERIFY(line != card.lines.end());
        QCOMPARE(line->commands_mm.size(), 3U);
        QVERIFY(isNear(line->commands_mm[0], 0.04));
        QVERIFY(isNear(line->commands_mm[1], 0.01));
        QCOMPARE(line->commands_mm[2], 0.0);
        QVERIFY(std::ranges::none_of(card.lines,
                                     [](const CardLine& l) { return l.regime.has_value(); }));
        QVERIFY(!card.time);
        project.gauge->control = Control::position;
        for (const CardLine& l : operationCard(one, {}).lines) {
            QVERIFY(l.commands_mm.empty());
        }
    }

    /// Transitions are numbered on; tooling and regimes belong to the one before.
    void transitionsAreNumberedFromOne() {
        const Setup setup = anySetup();
        int last = 0;
        for (const CardLine& line : operationCard(setup, runSetup(setup)).lines) {
            if (symbolOf(line.entry) == CardSymbol::transition) {
                ++last;
            }
            QCOMPARE(line.transition, last);
        }
        QCOMPARE(last, 3 + 2 * static_cast<int>(setup.surfaces.size()));
    }
};

} // namespace sparkout::test_operation_card

SPARKOUT_TEST(test_operation_card, TestOperationCard)
#include "test_operation_card.moc"
