// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The cheapest cycle and the one that keeps the wheel longest: found by running all cycles of the
// grid on all parts, laws, and the closed form of a drive's limit.
#include "core/process/force.h"
#include "core/quality/shop_numbers.h"
#include "core/setup/dressing_interval.h"
#include "core/setup/interval_search.h"
#include "core/study/search.h"
#include "tests/core/search/search_checks.h"
#include "tests/registry.h"
#include "words/search_words.h"

#include <cstdio>

namespace sparkout::test_interval_search {

using namespace search_checks;

/// A cycle of a grid that holds for the first part: how long it goes on to, and its margin over so
/// many.
struct Lasting {
    PlainCycle plain;
    std::int64_t time_us = 0;
    double time_s = 0;
    std::vector<double> margins; ///< over the parts 1…n, as many as it holds for
};

std::vector<Lasting> allLasting(Project project, const SurfaceWear& wear, std::int64_t most) {
    std::vector<Lasting> all;
    for (const PlainCycle& each : PlainGrid(project).cycles) {
        *project.cycle = each.cycle;
        setMachine(project, each.machine);
        Lasting lasting{each, 0, 0, {}};
        double margin = std::numeric_limits<double>::infinity();
        RemovedMetal ofPart;
        for (std::int64_t part = 1; part <= most; ++part) {
            *project.wheel = wheelAfter(*wear.setup.surfaces[0].project.wheel, wear.wear(),
                                        static_cast<double>(part - 1) * ofPart);
            const SimulationResult result = simulateUnchecked(project);
            if (!holds(result)) {
                break;
            }
            lasting.time_s = part == 1 ? result.time_s : lasting.time_s;
            lasting.time_us = std::llround(lasting.time_s * 1e6);
            for (const ConstraintResult& constraint : evaluateConstraints(result)) {
                margin = std::min(margin, constraint.relativeMargin);
            }
            lasting.margins.push_back(margin);
            if (part == 1) {
                ofPart = removedMetal(project, shopNumbers(result).cycle.removedVolume_mm3);
            }
        }
        if (!lasting.margins.empty()) {
            all.push_back(std::move(lasting));
        }
    }
    return all;
}

/// The quickest for so many parts by the definition; null: none.
const Lasting* quickestFor(const std::vector<Lasting>& all, std::size_t parts) {
    const Lasting* best = nullptr;
    for (const Lasting& each : all) {
        if (each.margins.size() >= parts
            && (!best || each.time_us < best->time_us
                || (each.time_us == best->time_us
                    && each.margins[parts - 1] > best->margins[parts - 1]))) {
            best = &each;
        }
    }
    return best;
}

/// By trying every number of parts.
struct PlainInterval {
    const Lasting* best = nullptr;
    std::int64_t parts = 0;
    double cost = std::numeric_limits<double>::infinity();

    PlainInterval(const std::vector<Lasting>& all, const Project& project, std::int64_t most) {
        const bool isLife = project.optimisation->objective == SearchObjective::wheel_life;
        for (std::int64_t n = 1; n <= most; ++n) {
            const Lasting* const quickest = quickestFor(all, static_cast<std::size_t>(n));
            if (!quickest) {
                break;
            }
            const double price =
                partCost(*project.optimisation->cost, double(quickest->time_us) * 1e-6, n);
            if (isLife || price < cost || (price == cost && quickest->time_us == best->time_us)) {
                best = quickest;
                parts = n;
                cost = price;
            }
        }
    }
};

bool isThat(const IntervalSummary& found, const PlainInterval& plain) {
    const auto& best = found.search.best;
    return best.has_value() == (plain.best != nullptr)
           && (!best
               || (found.held && found.held->parts == plain.parts
                   && best->time_us == plain.best->time_us
                   && best->leastRelativeMargin
                          == plain.best->margins[static_cast<std::size_t>(plain.parts - 1)]
                   && sameCycle(found.search.cycle, plain.best->plain.cycle)
                   && found.search.machine == plain.best->plain.machine));
}

Project withRates(Project p, unsigned seed) {
    p.optimisation->cost = Cost{};
    p.optimisation->cost->machine_per_h = 60;
    p.optimisation->cost->handling_s = 20;
    p.optimisation->cost->dressing_s = 30.0 * (seed % 5);
    p.optimisation->cost->dressing_cost = 0.3 * (seed % 7);
    if (seed % 4 == 1) {
        p.optimisation->work_speed_rpm = std::vector<double>{150, 180};
    }
    return p;
}

/// A wheel whose dullness some parts multiply, so that cycles end after different numbers.
SurfaceWear wearOf(const Project& project, unsigned seed) {
    Setup setup = plainSetup(project);
    const double exponent = seed % 3 == 0 ? 0.7 : 1;
    const double grown = project.wheel->dullness * (0.02 + 0.06 * (seed % 6));
    const double specific_mm2 = nominalVolume_mm3(project) / project.wheel->width_mm;
    setup.wear.dulling_exponent = exponent;
    setup.wear.dulling_per_mm2 = grown / std::pow(specific_mm2, exponent);
    if (seed % 5 == 2) {
        setup.wear.grinding_ratio = 0.5;
    }
    return {setup, 0};
}

/// Of a plain part whose wheel dulls evenly.
SurfaceWear dulling(const Project& project, double dulling_per_mm2) {
    Setup setup = plainSetup(project);
    setup.wear.dulling_per_mm2 = dulling_per_mm2;
    return {setup, 0};
}

IntervalSummary searched(const Project& project, const SurfaceWear& wear, std::int64_t most,
                         SearchMethod method = SearchMethod::pruned) {
    SearchOptions search;
    search.method = method;
    return searchInterval(project, wear, {.search = search, .most = most});
}

/// One stage at a stiff machine whose drive ends it: every revolution cuts what it is fed.
Project stiffDriven() {
    Project p = driven(1.2);
    p.machine->compliance_mm_per_n = std::vector<double>{1e-12};
    p.optimisation->radial_feed_mm_min = std::vector<double>{0.15, 0.3, 0.45, 0.6, 0.9, 1.2};
    p.machine->wheel_drive_kw = simulateUnchecked(p).peakPower_w / 1000 * 1.05;
    return p;
}

/// The power of the wheel at a cut of a revolution and a dullness [kW].
double power_kw(const Project& project, double feed_mm_min, double dullness) {
    Project dull = project;
    dull.wheel->dullness = dullness;
    const double cut_mm = feed_mm_min / dull.machine->work_speed_rpm;
    const ForceLaw law = forceLaw(dull);
    return dull.machine->wheel_speed_m_s * law.tangential(dull.part->length_mm, std::sqrt(cut_mm))
           / 1000;
}

class TestIntervalSearch : public QObject {
    Q_OBJECT

private slots:
    void theAnswerIsTheBestOfAllCyclesAndAllNumbersOfParts() {
        constexpr std::int64_t most = 9;
        int found = 0, slower = 0, ended = 0, none = 0;
        for (unsigned seed = 0; seed < plainGrids(80); ++seed) {
            Project project = withRates(smallCase(seed), seed);
            const SurfaceWear wear = wearOf(project, seed);
            Project dressed = project; // a dressing compensates the wear that is stated
            dressed.wheel->radius_wear_um = 0;
            const std::vector<Lasting> all = allLasting(dressed, wear, most);
            const Lasting* const quickest = quickestFor(all, 1);
            for (const SearchObjective objective :
                 {SearchObjective::cost, SearchObjective::wheel_life}) {
                project.optimisation->objective = objective;
                const PlainInterval plain(all, project, most);
                for (const SearchMethod method : {SearchMethod::pruned, SearchMethod::full}) {
                    const IntervalSummary answer = searched(project, wear, most, method);
                    QVERIFY2(isThat(answer, plain), qPrintable(QString::number(seed)));
                    QVERIFY(answer.search.status
                            == (plain.best ? SearchStatus::proved : SearchStatus::infeasible));
                    QVERIFY(!plain.best
                            || answer.cost
                                   == partCost(*project.optimisation->cost, plain.best->time_s,
                                               plain.parts));
                }
                found += plain.best ? 1 : 0;
                none += plain.best ? 0 : 1;
                ended += plain.best && plain.parts < most ? 1 : 0;
                slower += plain.best && plain.best->time_us > quickest->time_us ? 1 : 0;
            }
        }
        std::printf("%d answers, %d end before the last part, %d slower than the quickest\n", found,
                    ended, slower);
        QVERIFY(found > samples::sized(40, 10, 240) && none > 0);
        QVERIFY(ended > samples::sized(12, 3, 80) && slower > samples::sized(6, 1, 40));
    }

    /// Weighing dressings more never shortens the interval or the time, on grids that are too large
    /// to run all cycles of; the ends are the quickest cycle and the longest life.
    void theMoreADressingCostsTheLongerTheInterval() {
        int grows = 0;
        for (unsigned seed = 0; seed < searches(30); ++seed) {
            Project project = withRates(smallCase(seed), seed);
            project.optimisation->stock_step_mm = 0.01;
            project.wheel->radius_wear_um = 0; // as just dressed, for the search by time, too
            const SurfaceWear wear = wearOf(project, seed);
            constexpr std::int64_t most = 30;
            const SearchSummary quickest = search(project);
            project.optimisation->objective = SearchObjective::wheel_life;
            const IntervalSummary longest = searched(project, wear, most);
            QCOMPARE(longest.search.best.has_value(), quickest.best.has_value());
            if (!quickest.best) {
                continue;
            }
            project.optimisation->objective = SearchObjective::cost;
            Cost& cost = *project.optimisation->cost;
            cost.dressing_s = 0;
            std::int64_t parts = 0, time_us = 0;
            for (const double dressing : {0.0, 0.01, 0.1, 1.0, 10.0, 1e8}) {
                cost.dressing_cost = dressing;
                const IntervalSummary answer = searched(project, wear, most);
                QVERIFY(answer.search.best && answer.held);
                QVERIFY(answer.held->parts >= parts && answer.search.best->time_us >= time_us);
                grows += parts > 0 && answer.held->parts > parts ? 1 : 0;
                parts = answer.held->parts;
                time_us = answer.search.best->time_us;
                QVERIFY(dressing > 0 || time_us == quickest.best->time_us);
            }
            QCOMPARE(parts, longest.held->parts);
            QVERIFY(same(searched(project, wear, most).search, longest.search));
        }
        QVERIFY(grows > samples::sized(5, 2, 10));
    }

    /// p = 1: the power grows evenly from part to part, and each feed has its life.
    void ofADriveTheLifeOfEachFeedIsItsClosedForm() {
        Project project = withRates(stiffDriven(), 3);
        project.optimisation->cost->dressing_cost = 0.4;
        const double most_kw = *project.machine->wheel_drive_kw;
        const SurfaceWear wear = dulling(project, 3e-6);
        std::int64_t longest = 0;
        double cheapest = std::numeric_limits<double>::infinity(), cheapestFeed = 0;
        for (const double feed : levelValues(project.optimisation->radial_feed_mm_min)) {
            const double sharp_kw = power_kw(project, feed, 0);
            const double slope_kw = power_kw(project, feed, 1) - sharp_kw;
            const double left = (most_kw - sharp_kw) / slope_kw - project.wheel->dullness;
            Project run = project;
            run.cycle->stages = {fixtures::plungeStage(feed, run.part->stock_mm)};
            const SimulationResult result = simulateUnchecked(run);
            const double perPart = 3e-6 * removedVolume_mm3(result) / project.wheel->width_mm;
            const auto life = static_cast<std::int64_t>(std::floor(left / perPart)) + 1;
            const double cost = partCost(*project.optimisation->cost, result.time_s, life);
            longest = std::max(longest, life);
            if (cost < cheapest) {
                cheapest = cost;
                cheapestFeed = feed;
            }
        }
        QVERIFY(longest < mostPartsTried);
        project.optimisation->objective = SearchObjective::wheel_life;
        const IntervalSummary life = searched(project, wear, mostPartsTried);
        QCOMPARE(life.held->parts, longest);
        QCOMPARE(*life.search.cycle.stages[0].radial_feed_mm_min, 0.15);
        QVERIFY(life.held->end == ConstraintKind::wheelPower && !life.held->isAll);
        project.optimisation->objective = SearchObjective::cost;
        const IntervalSummary cost = searched(project, wear, mostPartsTried);
        QVERIFY(std::abs(*cost.cost - cheapest) < 1e-12 * cheapest);
        QCOMPARE(*cost.search.cycle.stages[0].radial_feed_mm_min, cheapestFeed);
        QVERIFY(cheapestFeed > 0.15 && cheapestFeed < 1.2); // neither of the ends
        std::printf("life %lld parts, cheapest at %.2f mm/min; %d searches\n",
                    static_cast<long long>(longest), cheapestFeed, cost.searches);
        QVERIFY(cost.searches < 60); // of the 10,000 numbers of parts
    }

    void withoutWearItIsTheQuickestToTheBit() {
        int found = 0;
        for (unsigned seed = 0; seed < searches(20); ++seed) {
            Project project = withRates(smallCase(seed), seed);
            const SearchSummary quickest = search(project);
            const SurfaceWear none(project);
            for (const SearchObjective objective :
                 {SearchObjective::cost, SearchObjective::wheel_life}) {
                project.optimisation->objective = objective;
                const IntervalSummary answer = searched(project, none, mostPartsTried);
                QVERIFY(same(answer.search, quickest) && !answer.held);
                QVERIFY(!quickest.best || answer.search.best->time_s == quickest.best->time_s);
                QVERIFY(!quickest.best
                        || answer.cost
                               == partCost(*project.optimisation->cost, quickest.best->time_s, {}));
                found += quickest.best ? 1 : 0;
            }
        }
        QVERIFY(found > samples::sized(10, 0, 20));
    }

    /// As dull as can be from a part on, and nothing fails: no dressing is needed.
    void aWheelThatGetsNoDullerNeedsNoDressing() {
        Project project = withRates(stiffDriven(), 3);
        project.machine->wheel_drive_kw = 1000;
        const SurfaceWear wear = dulling(project, 1e-4);
        project.optimisation->objective = SearchObjective::cost;
        const IntervalSummary answer = searched(project, wear, mostPartsTried);
        QVERIFY(answer.held && answer.held->isEndless && answer.held->parts < 1000);
        QCOMPARE(*answer.cost,
                 partCost(*project.optimisation->cost, answer.search.best->time_s, {}));
        project.optimisation->cost->parts_between_dressings = 7; // the most that is allowed
        const IntervalSummary allowed = searched(project, wear, mostPartsTried);
        QVERIFY(allowed.held->parts == 7 && !allowed.held->isEndless && allowed.held->isAll);
        QCOMPARE(*allowed.cost,
                 partCost(*project.optimisation->cost, allowed.search.best->time_s, 7));
    }

    /// Whenever it is stopped, what is given holds for its parts, and none is better than the
    /// bound.
    void aStoppedSearchKeepsTheBestSoFar() {
        Project project = withRates(stiffDriven(), 3);
        const SurfaceWear wear = dulling(project, 3e-5);
        project.optimisation->objective = SearchObjective::cost;
        const IntervalSummary whole = searched(project, wear, 500);
        int stopped = 0, kept = 0;
        for (int after = 1; after < 400; after += 7) {
            std::stop_source stop;
            int left = after;
            SearchOptions search;
            search.stop = stop.get_token();
            search.onProgress = [&](const SearchProgress&) {
                if (--left <= 0) {
                    stop.request_stop();
                }
            };
            const IntervalSummary part =
                searchInterval(project, wear, {.search = search, .most = 500});
            if (part.search.status != SearchStatus::stopped) {
                QVERIFY(same(part.search, whole.search));
                break;
            }
            ++stopped;
            QVERIFY(part.bound && *part.bound <= *whole.cost * (1 + 1e-12));
            if (part.search.best) {
                ++kept;
                QVERIFY(partsHeld(withBest(project, part.search), wear, 500).parts > 0);
            }
        }
        QVERIFY(stopped > 3 && kept > 0);
    }

    /// In a set-up the other surfaces dull the wheel as they are ground: the parts of an answer are
    /// those that the set-up with it holds for.
    void theOtherSurfacesDullTheWheelAsTheyAreGround() {
        Project project = withRates(stiffDriven(), 3);
        project.optimisation->objective = SearchObjective::wheel_life;
        Setup setup = plainSetup(project);
        for (const double runout_mm : {0.02, 0.08}) { // of two others, which nothing ends
            setup.surfaces.push_back(setup.surfaces.front());
            Project& other = setup.surfaces.back().project;
            other.part->initial_runout_mm = runout_mm;
            other.machine->wheel_drive_kw = std::nullopt;
            other.part->lower_deviation_um = -50;
        }
        setup.wear.dulling_per_mm2 = 2e-5;
        std::vector<std::int64_t> lives;
        for (std::size_t surface = 0; surface < setup.surfaces.size(); ++surface) {
            Setup turned = setup; // the searched surface stands first, second, last
            std::swap(turned.surfaces[0], turned.surfaces[surface]);
            const SurfaceWear wear(turned, surface);
            Project searchedFirst = turned.surfaces[surface].project;
            WheelCourse(wear).putWheel(searchedFirst, 1);
            const IntervalSummary answer = searched(searchedFirst, wear, 500);
            QVERIFY(answer.search.best && answer.held && answer.held->parts > 2);
            *turned.surfaces[surface].project.cycle = answer.search.cycle;
            QCOMPARE(answer.held->parts, dressingInterval(turned).parts);
            lives.push_back(answer.held->parts);
        }
        const std::int64_t alone = searched(project, dulling(project, 2e-5), 500).held->parts;
        QVERIFY(std::ranges::all_of(lives, [alone](std::int64_t n) { return n < alone / 2; }));
    }

    void aSurfaceWithoutACycleCountsByItsDrawing() {
        Setup setup = plainSetup(stiffDriven());
        setup.surfaces.resize(3, setup.surfaces.front());
        setup.surfaces[1].project.cycle->stages.clear();
        setup.wear.dulling_per_mm2 = 2e-5;
        const SurfaceWear wear(setup, 0);
        const WheelCourse course = WheelCourse(wear).ofCycle(100);
        Project third = setup.surfaces[2].project, first = setup.surfaces[0].project;
        const double two_mm3 = 100 + nominalVolume_mm3(setup.surfaces[1].project);
        wearWheel(third, setup.wear, removedMetal(third, two_mm3));
        const double all_mm3 = two_mm3 + removedVolume_mm3(simulateUnchecked(third));
        course.putWheel(first, 4);
        QVERIFY(fixtures::close(first.wheel->dullness,
                                setup.surfaces[0].project.wheel->dullness
                                    + 2e-5 * 3 * all_mm3 / first.wheel->width_mm,
                                1e-14));
    }

    void whatCannotBeSearchedTogetherIsRefused() {
        Project project = driven(0.6);
        project.optimisation->objective = SearchObjective::cost;
        const auto refusalOf = [&](const SearchWish& options) {
            const SearchOutcome report = *sparkout::search(project, options);
            return report.ran() ? std::string() : searchRefusal(report);
        };
        QVERIFY(refusalOf({}).find("/optimisation/cost") != std::string::npos);
        project = withRates(project, 1);
        QVERIFY(refusalOf({}).empty());
        SearchWish options;
        options.refine = true;
        QVERIFY(refusalOf(options).find("/optimisation/objective: The refinement") == 0);
        options = {};
        options.method = SearchMethod::labels;
        QVERIFY(refusalOf(options).find("/optimisation/objective: --method labels: This method")
                == 0);
        options = {};
        options.phases = true;
        QVERIFY(refusalOf(options).find("/optimisation/objective") == 0);
        QVERIFY(sparkout::search(project, options)->objectiveFault == ObjectiveFault::otherParts);
        project.optimisation->margin_within_min = 5;
        QVERIFY(refusalOf({}).find("/optimisation/margin_within_min") == 0);
    }

    void theBestOfEachNumberOfStagesIsThatOfItsOwnSearch() {
        int found = 0;
        for (unsigned seed = 0; seed < searches(16); ++seed) {
            Project project = withRates(smallCase(seed), seed);
            project.optimisation->adaptive = false;
            const SurfaceWear wear = wearOf(project, seed);
            for (const SearchObjective objective :
                 {SearchObjective::cost, SearchObjective::wheel_life}) {
                project.optimisation->objective = objective;
                project.optimisation->cost->parts_between_dressings = 12;
                const SearchOutcomePtr outcome =
                    sparkout::search(project, {.front = true, .wear = wear});
                QVERIFY(outcome->ran() && outcome->interval && outcome->front().empty());
                for (const FoundCycle& each : outcome->found) {
                    Project own = project;
                    if (!each.isBest) {
                        own.optimisation->stages = {double(each.cycle.stages.size())};
                    }
                    const IntervalSummary engine = searchInterval(own, wear, {});
                    QVERIFY(each.isBestOfItsNumber && sameCycle(each.cycle, engine.search.cycle));
                    QVERIFY(each.held && each.held->parts == engine.held->parts);
                    QVERIFY(each.cost == engine.cost && outcome->proved());
                    ++found;
                }
            }
        }
        QVERIFY(found > samples::sized(6, 0, 12));
    }
};

} // namespace sparkout::test_interval_search

SPARKOUT_TEST(test_interval_search, TestIntervalSearch)
#include "test_interval_search.moc"
