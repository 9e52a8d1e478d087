// SPDX-License-Identifier: GPL-3.0-or-later
// Searches of parts whose cycles take long, sections that deflect each other: a stop ends them
// within a cycle, and what was stopped decides nothing.
#include "core/grace_stop.h"
#include "core/process/compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/system_compliance.h"
#include "core/search/binding.h"
#include "core/search/cycle_runner.h"
#include "core/search/limit.h"
#include "core/search/refine.h"
#include "core/study/search.h"
#include "tests/core/search/search_cases.h"
#include "tests/core/support/project_samples.h"
#include "tests/processor_time.h"
#include "tests/ready_made.h"
#include "tests/registry.h"

#include <QElapsedTimer>

#include <chrono>
#include <stop_token>
#include <thread>

namespace sparkout::test_search_stops {

using namespace std::chrono_literals;

constexpr double most_ms = 100 * under_sanitizers;

/// A slender shaft of sections that deflect each other, all of them at every radius.
Project coupled(int sections, int radii) {
    Project p = fixtures::plunge();
    p.part->radii_per_section = radii;
    fixtures::putOnSlenderShaft(p);
    p.sections = sections;
    p.sections_coupled = true;
    Optimisation grid;
    grid.stages = {1, 2, 3};
    grid.stock_step_mm = p.part->stock_mm / 20;
    grid.radial_feed_mm_min = SteppedLevels{0.1, 2, 0.1};
    p.optimisation = grid;
    return p;
}

/// Of which a cycle takes seconds: as many sections as there may be, ten times the stock, and a
/// wheel contact that yields, with which each radius is solved by itself.
Project slow() {
    Project p = coupled(200, 360);
    p.machine->wheel_contact = WheelContact{std::vector<std::vector<double>>{{1000, 50}}};
    p.part->stock_mm *= 10;
    p.optimisation->stock_step_mm *= 10;
    for (Stage& stage : p.cycle->stages) {
        stage.stock_mm *= 10;
    }
    return p;
}

/// Time [ms] that the work goes on for after the stop, so long after its begin; the least of some
/// tries.
double stoppedAfter_ms(const char* what, std::chrono::milliseconds delay,
                       const std::function<void(const std::stop_token&)>& work, int tries = 3) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) {
        std::stop_source stop;
        QElapsedTimer since;
        std::jthread stopper([&] {
            std::this_thread::sleep_for(delay);
            since.start();
            stop.request_stop();
        });
        work(stop.get_token());
        const bool stopped = stop.stop_requested();
        const double took_ms = stopped ? static_cast<double>(since.nsecsElapsed()) * 1e-6 : 0;
        stopper.join();
        least = std::min(least, took_ms);
    }
    qInfo("STOP %s: %.1f ms", what, least);
    return least;
}

class TestSearchStops : public QObject {
    Q_OBJECT

private slots:
    void everySearchStopsWithinACycle_data() {
        addColumns<int, bool>("method", "robust");
        QTest::newRow("full") << int(SearchMethod::full) << false;
        QTest::newRow("pruned") << int(SearchMethod::pruned) << false;
        QTest::newRow("published") << int(SearchMethod::published) << false;
        QTest::newRow("labels") << int(SearchMethod::labels) << false;
        QTest::newRow("robust") << int(SearchMethod::pruned) << true;
    }
    void everySearchStopsWithinACycle() {
        QFETCH(int, method);
        QFETCH(bool, robust);
        const Project p = slow();
        SearchOptions options;
        options.method = static_cast<SearchMethod>(method);
        options.scenarios = stockPhases(p, 2);
        SearchSummary found;
        const double took_ms =
            stoppedAfter_ms(QTest::currentDataTag(), 200ms, [&](const std::stop_token& stop) {
                options.stop = stop;
                found = robust ? optimiseRobustly(p, freshStockPhases, {.search = options}).search
                               : optimise(p, options);
            });
        QVERIFY(found.status == SearchStatus::stopped);
        QVERIFY(!found.best); // none came to its end
        QCOMPARE(found.evaluations, 0LL);
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
    }

    // The corners of a batch: the margins by time look for their first answer in seeds and phase
    // cases, which report no progress. They end when their time is up, as long as the searches of
    // all numbers of stages took and two seconds, and a stop at any moment ends all.
    void aWholeSearchOfCornersKeepsItsTimeAndStops() {
        Project p = samples::projectIn("resources/examples/shaft-30h6-factory.sparkout");
        p.optimisation->scenarios = OptimisationScenarios::corners;
        const bool isLong = std::getenv("SPARKOUT_LONG") != nullptr;
        if (isLong) {
            const RunningTimer took;
            const auto elapsed_s = [&took] { return static_cast<double>(took.elapsed()) / 1e3; };
            double answer_s = 0, margins_s = 0; // when they begin
            SearchEvents events;
            events.note = [&](const SearchState& state) {
                margins_s =
                    margins_s == 0 && state.looksFor == FoundBy::margin ? elapsed_s() : margins_s;
            };
            events.answer = [&](const SearchOutcomePtr& answer) {
                answer_s = elapsed_s();
                QVERIFY(answer->proved() && answer->isFrontComing);
            };
            const SearchOutcomePtr whole = search(p, {.front = true}, {}, events);
            const double all_s = elapsed_s();
            qInfo("answer after %.1f s, margins from %.1f s, end after %.1f s", answer_s, margins_s,
                  all_s);
            QVERIFY(whole->proved() && answer_s > 0 && margins_s > answer_s);
            QVERIFY2(all_s < 2 * margins_s + 2 + busy * most_ms / 1e3, QByteArray::number(all_s));
        }
        std::mt19937 random(14);
        const int stops = isLong ? 200 : 3;
        double worst_ms = 0;
        for (int i = 0; i < stops; ++i) {
            // Most in the search itself, some where the margins begin.
            const int last_ms = !isLong ? 300 : i % 8 == 0 ? 8'000 : 1'000;
            const std::chrono::milliseconds delay(random() % last_ms);
            const auto whole = [&](const std::stop_token& stop) {
                (void)search(p, {.front = true}, stop);
            };
            worst_ms =
                std::max(worst_ms, stoppedAfter_ms("whole search", delay, whole, isLong ? 1 : 3));
        }
        QVERIFY2(worst_ms < busy * most_ms, QByteArray::number(worst_ms));
    }

    void whatFollowsASearchStopsWithinACycle() {
        const Project p = slow();
        const Grid grid(p);
        FeasibleCycle best;
        best.cycle = grid.uniform(2, 3);
        best.time_us = noTime_us; // all others are quicker
        std::optional<std::vector<ConstraintKind>> binding;
        double took_ms = stoppedAfter_ms("binding", 100ms, [&](const std::stop_token& stop) {
            binding = bindingRequirements(p, best, {p}, stop);
        });
        QVERIFY(!binding);
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
        RefineOptions options;
        RefineSummary refined;
        took_ms = stoppedAfter_ms("refine", 100ms, [&](const std::stop_token& stop) {
            options.stop = stop;
            refined = refine(p, grid.cycle(best.cycle), options);
        });
        QVERIFY(!refined.isQuicker && refined.time_us == 0);
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
        took_ms = stoppedAfter_ms("fresh phases", 100ms, [&](const std::stop_token& stop) {
            QVERIFY(!failingPhase(p, 1, stop));
        });
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
    }

    // The moment's grace after a stop is counted from its begin and ends a run, too.
    void theGraceAfterAStopIsAMoment() {
        const StoppedSource stop;
        RunningTimer took;
        const GraceStop grace(stop.get_token());
        QVERIFY(!grace.token().stop_requested());
        QVERIFY(simulateUnchecked(slow(), nullptr, grace.token()).status == RunStatus::stopped);
        const double took_ms = static_cast<double>(took.nsecsElapsed()) * 1e-6;
        qInfo("%.1f ms", took_ms);
        QVERIFY(took_ms > 29 && took_ms < busy * most_ms);
        std::stop_source later;
        const GraceStop unstopped(later.get_token());
        std::this_thread::sleep_for(60ms);
        QVERIFY(!unstopped.token().stop_requested());
        later.request_stop();
        QVERIFY(unstopped.token().stop_requested()); // its moment was over
    }

    void theComplianceAlongAShaftStops() {
        const Project p = fixtures::restedShaft();
        std::vector<CompliantPlace> along;
        const double took_ms =
            stoppedAfter_ms("compliance", 20ms, [&](const std::stop_token& stop) {
                along = complianceAlong(p, 100'000, stop);
            });
        QVERIFY(along.size() < 100'000);
        QVERIFY2(took_ms < busy * most_ms, QByteArray::number(took_ms));
    }

    // A balance that needs many factors ends before the next one.
    void theBalanceOfSectionsStops() {
        constexpr std::size_t count = 200;
        const Project p = slow();
        const std::vector<CompliantPoint> points = compliantPoints(p);
        std::vector<double> places;
        for (const CompliantPoint& point : points) {
            places.push_back(point.position_mm);
        }
        CoupledSections sections(influenceRows(p, places, places),
                                 std::vector<double>(count, p.part->length_mm / count),
                                 forceLaw(p));
        std::vector<double> lag, root(count, 0.0);
        for (std::size_t j = 0; j < count; ++j) {
            lag.push_back(0.02 * static_cast<double>(j % 7));
        }
        std::vector<double> other = root;
        QVERIFY(sections.solve(lag.data(), root.data()).iterations > 1);
        const StoppedSource stop;
        const auto stopped = sections.solve(lag.data(), other.data(), stop.get_token());
        QVERIFY(!stopped.converged);
        QCOMPARE(stopped.iterations, 0);
    }

    void aFullSearchGoesOnFromWithinAPortion() {
        int within = 0;
        for (unsigned seed = 0; seed < 4; ++seed) {
            Project p = search_cases::smallCase(seed);
            p.part->radii_per_section = 360; // a portion takes longer than the stop
            SearchOptions options;
            options.method = SearchMethod::full;
            const SearchSummary whole = optimise(p, options);
            options.threads = 1 + seed % 3;
            long long evaluations = 0;
            SearchSummary last;
            for (int round = 0; round < 100'000; ++round) {
                std::stop_source stop;
                options.stop = stop.get_token();
                const std::jthread stopper([&stop, round] {
                    std::this_thread::sleep_for(3ms + round * 1ms);
                    stop.request_stop();
                });
                last = optimise(p, options);
                evaluations += last.evaluations;
                if (last.status != SearchStatus::stopped) {
                    break;
                }
                within += last.evaluations % 64 != 0 ? 1 : 0;
                options.resume = last.checkpoint;
            }
            QVERIFY(last.status == whole.status);
            QCOMPARE(last.best.has_value(), whole.best.has_value());
            QVERIFY(!whole.best || last.best->cycle == whole.best->cycle);
            QVERIFY2(evaluations == whole.evaluations, QByteArray::number(evaluations) + " of "
                                                           + QByteArray::number(whole.evaluations));
        }
        QVERIFY2(within > 0, QByteArray::number(within));
    }

    // The most settings, shares of stock, variants and stages: the window counts them as it shows
    // them.
    void theLargestGridIsCountedInNoTime() {
        const auto evenly = [](double from, double to, int count) {
            std::vector<double> values;
            for (int i = 0; i < count; ++i) {
                values.push_back(from + (to - from) * i / std::max(count - 1, 1));
            }
            return values;
        };
        for (const bool nonIncreasing : {false, true}) {
            for (const bool bounded : {false, true}) {
                for (const int feeds : {1, 2, 20, 70}) {
                    Project p = fixtures::traverse();
                    Optimisation grid;
                    grid.stages = {1, 2, 3, 4, 5};
                    grid.radial_feed_mm = evenly(0.001, 0.02, feeds);
                    grid.axial_feed_mm_min = evenly(200, 4000, feeds);
                    grid.work_speed_rpm = evenly(60, 400, 250);
                    grid.unfed_steps = std::vector<double>{0, 2};
                    grid.stock_step_mm = p.part->stock_mm / 9999;
                    grid.non_increasing = nonIncreasing;
                    if (bounded) {
                        grid.stage_stock_mm = std::vector(4, std::vector<double>{1e-4, 1});
                    }
                    p.optimisation = grid;
                    constexpr double target_ms = 5;
                    double least_ms = std::numeric_limits<double>::infinity();
                    std::int64_t size = 0;
                    for (int i = 0; i < 20; ++i) {
                        const double begin_ms = processorTime_ms();
                        size = gridSize(p);
                        least_ms = std::min(least_ms, processorTime_ms() - begin_ms);
                    }
                    qInfo("GRID %d feeds, %.4g cycles: %.2f ms", feeds, double(size), least_ms);
                    QVERIFY(size > 0);
                    const bool isJudged = !qEnvironmentVariableIsSet("SPARKOUT_QUICK");
                    QVERIFY2(!isJudged || least_ms < 4 * target_ms, // not under the sanitizers
                             QByteArray::number(least_ms));
                }
            }
        }
    }
};

} // namespace sparkout::test_search_stops

SPARKOUT_TEST(test_search_stops, TestSearchStops)
#include "test_search_stops.moc"
