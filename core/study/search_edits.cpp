// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search_edits.h"

#include "core/batch/batch_run.h"
#include "core/batch/judgement.h"
#include "core/file/project_file.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/constraints.h"
#include "core/quality/roughness.h"
#include "core/search/grid.h"
#include "core/search/time_bound.h"
#include "core/search/variants.h"
#include "core/simulation/simulate.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/study/starting_cycle.h"
#include "core/study/starting_numbers.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// A feed from one value to another, and the values that the cycle has.
struct FeedRange {
    double low = 0, high = 0;
    std::vector<double> now{};
};

/// The value by the roughness of the work: below 0.8 µm, from 0.8, from 1.6 µm.
template <class Value>
Value byRoughness(const Project& project, const std::array<Value, 3>& values) {
    const double ra_um = workRoughness_um(*project.part);
    return ra_um < starting::middleRoughness   ? values[0]
           : ra_um < starting::coarseRoughness ? values[1]
                                               : values[2];
}

/// Whether a roughness is required that is only estimated, as a range: then nothing but the limits
/// of the feeds keeps finishing slow.
bool isRoughnessOpen(const Project& project) {
    return project.part->tolerance.roughness_ra_um && !isRoughnessCalibrated(project);
}

/// What an answer must be fit for.
OptimisationScenarios usualScenarios(const Project& project) {
    return project.batch && checkBatch(project).empty() ? OptimisationScenarios::corners
                                                        : OptimisationScenarios::stocks;
}

/// The feeds of a stage that a machine can be set to.
class FeedSteps {
public:
    /// `usual`: the step if the machine gives none.
    FeedSteps(const Project& project, const StageFeed& feed, double usual) {
        const Range hard = tableOf<Optimisation>().find(feed.key)->hard;
        const auto& range = project.machine->limits.*feed.range;
        m_high = hard.high;
        m_step = usual;
        if (range && range->size() == 3) {
            m_low = (*range)[0];
            m_high = std::min(m_high, (*range)[1]);
            m_step = (*range)[2] > 0 ? (*range)[2] : usual;
        }
    }

    /// The nearest that can be set, above 0.
    [[nodiscard]] double nearest(double value) const {
        const double steps = std::round((std::clamp(value, m_low, m_high) - m_low) / m_step);
        const double on = asWritten(m_low + steps * m_step);
        return on > 0 ? on : asWritten(m_low + m_step);
    }
    /// Preferred numbers R10 of a range, both of its ends and the values now, each once, rising
    /// [ISO 3].
    [[nodiscard]] std::vector<double> preferred(const FeedRange& range) const {
        constexpr std::array series{1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};
        std::vector<double> levels{nearest(range.low), nearest(range.high)};
        for (const double each : range.now) {
            levels.push_back(nearest(each));
        }
        for (double decade = std::pow(10, std::floor(std::log10(range.low))); decade < range.high;
             decade *= 10) {
            for (const double each : series) {
                if (each * decade > range.low && each * decade < range.high) {
                    levels.push_back(nearest(each * decade));
                }
            }
        }
        std::ranges::sort(levels);
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        return levels;
    }

private:
    double m_low = 0, m_high = 0, m_step = 0;
};

constexpr double usualStockStep_mm = 1e-3;

/// Whether a cycle roughs, finishes and sparks out, as in a shop, or is fit for every stock. About
/// another one the grid may hold no fit cycle; a starting cycle added to the grid of a fit one
/// would make it too large for a proof in seconds.
bool isUsual(const Project& project) {
    const std::vector<Stage>& stages = project.cycle->stages;
    if (std::ranges::count_if(stages, &Stage::feeds) > 1 && stages.back().sparkOutSteps()) {
        return true;
    }
    const SimulationResult result = simulate(project);
    if (result.status != RunStatus::completed
        || !std::ranges::all_of(evaluateConstraints(result), &ConstraintResult::holds)) {
        return false;
    }
    const std::optional<JudgedStocks> stocks = judgeStocks(result);
    return !stocks || stocks->holds;
}

/// Fills the search of a project.
class UsualSearch {
public:
    explicit UsualSearch(const Project& project)
        : m_project(project), m_isRoughnessOpen(isRoughnessOpen(project)) {
        for (const Stage& stage : project.cycle->stages) {
            if (fedBy(stage) > 0) {
                m_feeding.push_back(stage);
            }
        }
        if (hasCycle()) {
            m_finish = m_feeding.back();
            if (const StageFeed* axial = axialFeed(); axial && m_isRoughnessOpen) {
                const double most = mostFinishAxial();
                m_finish.*axial->value = std::min((m_finish.*axial->value).value_or(most), most);
            }
        }
        if (const auto steps = project.cycle->stages.back().sparkOutSteps()) {
            m_sparkOut = *steps;
        }
    }

    /// Whether there is a cycle to search about.
    [[nodiscard]] bool hasCycle() const { return !m_feeding.empty(); }

    [[nodiscard]] Optimisation search() const {
        Optimisation search;
        search.stages = {2};
        search.stock_step_mm = usualStockStep_mm;
        search.non_increasing = true;
        search.scenarios = usualScenarios(m_project);
        putFeeds(search);
        putStocks(search);
        search.unfed_steps = sparkOuts();
        return search;
    }

private:
    [[nodiscard]] const StageFeed& radial() const { return m_project.operation->radial(); }
    [[nodiscard]] const StageFeed* axialFeed() const { return m_project.operation->axial(); }
    [[nodiscard]] bool isPlunge() const { return !m_project.operation->travels; }
    [[nodiscard]] double rough() const { return fedBy(m_feeding.front()); }
    [[nodiscard]] double finish() const { return fedBy(m_finish); }
    [[nodiscard]] bool hasFinish() const { return m_feeding.size() > 1; }
    /// The radial feed of a stage, or the infeed of its continuous one per double stroke.
    [[nodiscard]] double fedBy(const Stage& stage) const {
        const double feed = (stage.*radial().value).value_or(0);
        return m_project.operation->travels && stage.continuousFeed_mm_min() > 0
                   ? feed + stage.continuousFeed_mm_min() * doubleStroke_min(stage)
                   : feed;
    }
    [[nodiscard]] double doubleStroke_min(const Stage& stage) const {
        const double axial = (stage.*m_project.operation->axial()->value).value_or(1);
        return strokesAndDwells_s(m_project, axial) / units::secondsPerMinute;
    }

    /// The most that finishing feeds beyond the reading that ends it [mm].
    [[nodiscard]] double fedLate_mm() const {
        const double turn_min = 1 / m_project.machine->work_speed_rpm;
        const double step_min = isPlunge() ? turn_min : doubleStroke_min(m_finish);
        return lateSteps(m_project, step_min * units::secondsPerMinute)
               * (isPlunge() ? plungeFinish().high * turn_min : strokeFinish().high);
    }

    [[nodiscard]] FeedRange plungeRough() const {
        constexpr double ofBore = 0.5;
        const Part& part = *m_project.part;
        const bool hard = isHardened(*m_project.material);
        const double removal_mm2_s =
            (hard ? 2.0 : 3.0) * (part.surface == Surface::internal ? ofBore : 1);
        const double most = std::min(removal_mm2_s * units::secondsPerMinute
                                         / (std::numbers::pi * part.diameter_mm),
                                     hard ? 1.2 : 1.6);
        return {rough() / 2, std::max(most, rough()), {rough()}};
    }
    /// Feeds of finishing. The current one is among them, except above `most` where the roughness
    /// is open.
    [[nodiscard]] FeedRange finishRange(double least, double most, double now) const {
        if (m_isRoughnessOpen && now > most) {
            return {std::min(least, most), most};
        }
        return {std::min(least, now), std::max(most, now), {now}};
    }
    [[nodiscard]] FeedRange plungeFinish() const {
        constexpr double least = 0.05;
        return finishRange(least, byRoughness(m_project, std::array{0.08, 0.125, 0.16}),
                           hasFinish() ? finish() : least);
    }
    [[nodiscard]] FeedRange strokeRough() const {
        constexpr double most_mm = 0.025;
        return {rough() / 2, std::max(std::min(1.6 * rough(), most_mm), rough()), {rough()}};
    }
    [[nodiscard]] FeedRange strokeFinish() const {
        constexpr double most_mm = 0.005, ofRough = 0.7;
        const double now = hasFinish() ? finish() : std::min(most_mm, ofRough * rough());
        return finishRange(0.6 * now, std::min(2 * now, most_mm), now);
    }
    [[nodiscard]] double turn_mm_min() const { ///< B·n
        return m_project.wheel->width_mm * m_project.machine->work_speed_rpm;
    }
    /// S_ax of finishing at most, where the roughness is open: that of a starting cycle.
    [[nodiscard]] double mostFinishAxial() const {
        return byRoughness(m_project, starting::axialFinish) * turn_mm_min();
    }

    /// Sets levels of a feed for roughing and finishing, and their assignment.
    void put(Optimisation& search, const StageFeed& feed, double step, const FeedRange& rough,
             const FeedRange& finish) const {
        const FeedSteps steps(m_project, feed, step);
        const std::vector<double> roughing = steps.preferred(rough);
        const std::vector<double> finishing = steps.preferred(finish);
        std::vector<double> levels;
        std::ranges::set_union(roughing, finishing, std::back_inserter(levels));
        search.*feed.levels = levels;
        search.*feed.byStage = std::vector<std::vector<double>>{
            {roughing.front(), roughing.back()}, {finishing.front(), finishing.back()}};
    }

    /// Where the machine has a range for it, sets the continuous infeed that feeds as much per
    /// double stroke.
    void putContinuous(Optimisation& search) const {
        constexpr double usualStep_mm_min = 0.005;
        const StageFeed* const feed = m_project.operation->continuous;
        const auto* const range = feed ? &(m_project.machine->limits.*feed->range) : nullptr;
        if (!range || !*range || (*range)->size() != 3 || !((**range)[1] > 0)) {
            return;
        }
        const auto during = [](FeedRange infeed, double time_min) {
            for (double& each : infeed.now) {
                each /= time_min;
            }
            return FeedRange{infeed.low / time_min, infeed.high / time_min, infeed.now};
        };
        put(search, *feed, usualStep_mm_min,
            during(strokeRough(), doubleStroke_min(m_feeding.front())),
            during(strokeFinish(), doubleStroke_min(m_finish)));
    }

    void putFeeds(Optimisation& search) const {
        constexpr double plungeStep_mm_min = 0.01, infeedStep_mm = 0.0005;
        put(search, radial(), isPlunge() ? plungeStep_mm_min : infeedStep_mm,
            isPlunge() ? plungeRough() : strokeRough(),
            isPlunge() ? plungeFinish() : strokeFinish());
        putContinuous(search);
        if (const StageFeed* axial = axialFeed()) {
            putAxial(search, *axial);
        }
    }

    /// The stages share these levels; where the roughness is open, finishing has bounds of its own.
    void putAxial(Optimisation& search, const StageFeed& axial) const {
        constexpr double least = 0.15, most = 0.4; // of B·n
        constexpr double step_mm_min = 10;
        FeedRange range{least * turn_mm_min(), most * turn_mm_min()};
        for (const Stage& stage : m_feeding) {
            range.now.push_back((stage.*axial.value).value_or(range.low));
        }
        if (m_isRoughnessOpen) {
            put(search, axial, step_mm_min, range,
                {range.low, mostFinishAxial(), {*(m_finish.*axial.value)}});
        } else {
            search.*axial.levels = FeedSteps(m_project, axial, step_mm_min).preferred(range);
        }
    }

    /// The finishing stock has a lower limit: below it the lag of roughing determines the size.
    void putStocks(Optimisation& search) const {
        constexpr double least_mm = 0.015, usual_mm = 0.03, ofNow = 0.75, sparkOut_mm = 0.006;
        const double step_mm = search.stock_step_mm, all_mm = m_project.part->stock_mm;
        const double now_mm = hasFinish() ? m_feeding.back().stock_mm : usual_mm;
        const auto onStep = [step_mm](double stock_mm) {
            return asWritten(std::round(stock_mm / step_mm) * step_mm);
        };
        const double high_mm = std::max(std::min(onStep(2 * now_mm), onStep(all_mm / 2)), step_mm);
        const double low_mm = std::min(onStep(std::max(least_mm, ofNow * now_mm)), high_mm);
        std::vector<std::vector<double>> rows{{step_mm, all_mm}, {low_mm, high_mm}};
        if (m_sparkOut > 0) {
            rows.push_back({0, asWritten(sparkOut_mm + onStep(fedLate_mm()))});
        }
        search.stage_stock_mm = std::move(rows);
    }

    [[nodiscard]] Levels sparkOuts() const {
        if (m_sparkOut == 0) {
            return {};
        }
        std::vector<double> counts{static_cast<double>(m_sparkOut)};
        if (isPlunge()) {
            constexpr double shortest_s = 3, longer = 1.5;
            counts.push_back(std::max(std::round(shortest_s * m_project.machine->work_speed_rpm
                                                 / units::secondsPerMinute),
                                      1.0));
            counts.push_back(std::round(longer * m_sparkOut));
        } else {
            counts.push_back(2);
            counts.push_back(3);
        }
        std::ranges::sort(counts);
        counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
        return counts;
    }

    const Project& m_project;
    bool m_isRoughnessOpen;
    std::vector<Stage> m_feeding;
    Stage m_finish; ///< the last of these; where the roughness is open, with S_ax within its limit
    int m_sparkOut = 0; ///< steps; 0: no spark-out
};

} // namespace

Cycle startingCycleInSteps(const Project& project) {
    const double step_mm =
        project.optimisation ? project.optimisation->stock_step_mm : usualStockStep_mm;
    const auto inSteps = [step_mm](double stock_mm) {
        return asWritten(std::round(stock_mm / step_mm) * step_mm);
    };
    Cycle cycle = startingStages(project);
    Stage &rough = cycle.stages[0], &finish = cycle.stages[1], &sparkOut = cycle.stages[2];
    const double all_mm = project.part->stock_mm;
    finish.stock_mm = inSteps(finish.stock_mm);
    rough.stock_mm = inSteps(all_mm - finish.stock_mm - sparkOut.stock_mm);
    sparkOut.stock_mm = asWritten(std::max(all_mm - finish.stock_mm - rough.stock_mm, 0.0));
    return cycle;
}

Project usualSearch(Project project) {
    Project about = project;
    about.optimisation.reset();
    if (!isUsual(project)) {
        *about.cycle = startingCycleInSteps(about);
    }
    const UsualSearch usual(about);
    if (usual.hasCycle()) {
        Project with = withPracticalLimits(project);
        with.optimisation = usual.search();
        if (!hasErrors(validate(with)) && Variants(with).fault() == GridFault::none) {
            return with;
        }
    }
    Project offered = withOfferedSearch(std::move(project));
    offered.optimisation->scenarios = usualScenarios(offered);
    return offered;
}

namespace {

constexpr double stepsOfStock = 15;

/// The nearest of 1, 2 and 5 times a power of ten.
double roundStep(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double digits = value / power;
    return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

/// The preferred numbers R5 between two of them, inclusive [ISO 3].
std::vector<double> preferred(double from, double to) {
    constexpr std::array series{1.0, 1.6, 2.5, 4.0, 6.3};
    std::vector<double> values{from};
    for (int decade = static_cast<int>(std::floor(std::log10(from))); std::pow(10, decade) < to;
         ++decade) {
        for (const double each : series) {
            const double value =
                decade < 0 ? each / std::round(std::pow(10, -decade)) : each * std::pow(10, decade);
            if (value > from && value < to) {
                values.push_back(value);
            }
        }
    }
    values.push_back(to);
    return values;
}

/// Levels of a feed: preferred numbers over the machine's range, in its steps; without a range from
/// a fortieth of the fastest of these to twice that. Empty if the range has no valid level.
Levels usualLevels(const std::vector<double>& feeds,
                   const std::optional<std::vector<double>>& range, double highest) {
    constexpr double below = 20, above = 2;
    const double fastest = feeds.empty() ? 0 : *std::ranges::max_element(feeds);
    std::vector<double> levels;
    if (range && range->size() == 3) {
        const double low = (*range)[0], high = std::min((*range)[1], highest), step = (*range)[2];
        const double least = low > 0 ? low : step;
        if (!(least > 0) || least > high) {
            return {};
        }
        for (const double each : preferred(least, high)) {
            const double steps = std::round((each - low) / step);
            const double level = each >= high ? high : asWritten(low + steps * step);
            if (level > 0 && level <= high && (levels.empty() || level > levels.back())) {
                levels.push_back(level);
            }
        }
    } else if (fastest > 0 && fastest <= highest) {
        levels =
            preferred(roundStep(fastest / below), std::min(roundStep(fastest * above), highest));
    }
    return levels.empty() ? Levels() : Levels(levels);
}

template <class Member>
std::vector<double> feedsOf(const Cycle& cycle, Member member) {
    std::vector<double> feeds;
    for (const Stage& stage : cycle.stages) {
        if (stage.*member && *(stage.*member) > 0) {
            feeds.push_back(*(stage.*member));
        }
    }
    return feeds;
}

} // namespace

Project withUsualSearch(Project project) {
    const MachineLimits& limits = project.machine->limits;
    Optimisation search;
    const auto stages = std::clamp<std::size_t>(project.cycle->stages.size(), 2, 3);
    search.stages.clear();
    for (std::size_t count = 1; count <= stages; ++count) {
        search.stages.push_back(static_cast<double>(count));
    }
    search.stock_step_mm = std::clamp(roundStep(project.part->stock_mm / stepsOfStock), 1e-4, 5.0);
    search.non_increasing = true;
    search.adaptive = true;
    for (const StageFeed& feed : project.operation->feeds) {
        search.*feed.levels = usualLevels(feedsOf(*project.cycle, feed.value), limits.*feed.range,
                                          tableOf<Optimisation>().find(feed.key)->hard.high);
    }
    project.optimisation = std::move(search);
    return project;
}

Project withPracticalLimits(Project project) {
    constexpr double usualLeastOverlap = 1.05, usualLeastOverlapLast = 2;
    project.least_overlap = project.least_overlap.value_or(usualLeastOverlap);
    project.least_overlap_last = project.least_overlap_last.value_or(usualLeastOverlapLast);
    project.least_steps = project.least_steps.value_or(project.operation->usualLeastSteps);
    return project;
}

Project withOfferedSearch(Project project) {
    return withPracticalLimits(withUsualSearch(std::move(project)));
}

Project withSearchFor(Project project) {
    if (!project.optimisation) {
        return project;
    }
    const Project withUsual = withUsualSearch(project);
    const Optimisation& usual = *withUsual.optimisation;
    Optimisation& asked = *project.optimisation;
    for (const StageFeed& feed : project.operation->feeds) {
        if (asked.*feed.levels == Levels()) {
            asked.*feed.levels = usual.*feed.levels;
        }
    }
    return project;
}

bool sameSearch(const Project& a, const Project& b) {
    const auto searched = [](Project project) {
        *project.cycle = {};
        project.title.clear();
        project.author.clear();
        project.notes.clear();
        project.measured.reset();
        project.runs.clear();
        project.sweep.reset();
        if (project.optimisation) { // the search need not stay unchanged
            const Optimisation& asked = *project.optimisation;
            const auto free = [](const Levels& levels, double own) {
                return levels == Levels() ? own : 0;
            };
            setMachine(project, {free(asked.work_speed_rpm, project.machine->work_speed_rpm),
                                 free(asked.dwell_entry_s, project.machine->dwell_entry_s),
                                 free(asked.dwell_exit_s, project.machine->dwell_exit_s)});
        }
        if (!project.optimisation || !areOfBatch(project.optimisation->scenarios)) {
            project.batch.reset();
        }
        return project;
    };
    return sameProject(searched(a), searched(b));
}

} // namespace sparkout
