// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/refine.h"

#include "core/grace_stop.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/search/cycle_runner.h"
#include "core/search/grid.h"
#include "core/simulation/simulate.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace sparkout {

namespace {

constexpr double refineSlack = 1e-9; ///< relative tolerance at the ends of a range
}

double RefineSpace::Setting::stepAt(double value) const {
    constexpr int digits = 3;
    return step > 0 ? step : std::pow(10.0, std::floor(std::log10(value)) + 1 - digits);
}

double RefineSpace::Setting::rounded(double value) const {
    const double by = stepAt(value);
    double steps = std::round((value - base) / by);
    const double slack = refineSlack * high;
    if (base + steps * by > high + slack) {
        --steps;
    } else if (base + steps * by < low - slack) {
        ++steps;
    }
    return asWritten(base + steps * by);
}

RefineSpace::RefineSpace(const Project& project, Cycle cycle)
    : m_operation(project.operation)
    , m_cycle(std::move(cycle))
    , m_stock_mm(project.part->stock_mm)
    , m_leastLast_mm(refinedStock_mm)
    , m_mostLast_mm(project.part->stock_mm)
    , m_nonIncreasing(project.optimisation->non_increasing) {
    const Optimisation& asked = *project.optimisation;
    for (const StageFeed* feed : m_operation->searchedFeeds()) {
        addFeeds(*feed, asked, project.machine->limits);
    }
    addStocks(asked);
}

void RefineSpace::addStocks(const Optimisation& asked) {
    const std::size_t stages = m_cycle.stages.size();
    const NumberRows& rows = asked.stage_stock_mm;
    for (std::size_t z = 0; z + 1 < stages; ++z) {
        Setting stock{z, nullptr, refinedStock_mm, m_stock_mm, 0, refinedStock_mm};
        if (rows && z < rows->size()) {
            stock.low = std::max(stock.low, (*rows)[z][0]);
            stock.high = std::min(stock.high, (*rows)[z][1]);
        }
        if (stock.low < stock.high) {
            m_settings.push_back(stock);
        }
    }
    if (!m_cycle.stages.back().feeds()) {
        m_leastLast_mm = 0;
    }
    if (asked.last_stock_mm && stages > 1) {
        m_leastLast_mm = std::max(m_leastLast_mm, asked.last_stock_mm->front());
        m_mostLast_mm = asked.last_stock_mm->back();
    }
    if (rows && rows->size() >= stages) {
        m_leastLast_mm = std::max(m_leastLast_mm, (*rows)[stages - 1][0]);
        m_mostLast_mm = std::min(m_mostLast_mm, (*rows)[stages - 1][1]);
    }
}

/// Adds feeds between the levels of the grid, within the machine's range. A feed with a single
/// value is fixed.
void RefineSpace::addFeeds(const StageFeed& feed, const Optimisation& asked,
                           const MachineLimits& limits) {
    const auto& range = limits.*feed.range;
    const NumberRows& byStage = asked.*feed.byStage;
    const std::vector<double> values = levelValues(asked.*feed.levels);
    if (values.empty()) {
        return;
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    Setting setting;
    setting.feed = feed.value;
    setting.low = *least;
    setting.high = *most;
    if (range && range->size() == 3) {
        setting.low = std::max(setting.low, (*range)[0]);
        setting.high = std::min(setting.high, (*range)[1]);
        setting.base = (*range)[2] > 0 ? (*range)[0] : 0;
        setting.step = (*range)[2];
    }
    for (std::size_t z = 0; z < m_cycle.stages.size(); ++z) {
        Setting own = setting;
        own.stage = z;
        if (byStage && z < byStage->size()) {
            own.low = std::max(own.low, (*byStage)[z][0]);
            own.high = std::min(own.high, (*byStage)[z][1]);
        }
        const double middle = own.rounded((own.low + own.high) / 2);
        const double slack = refineSlack * own.high;
        if ((m_cycle.stages[z].*feed.value).value_or(0) > 0 && own.low < own.high
            && middle >= own.low - slack && middle <= own.high + slack) {
            m_settings.push_back(own);
        }
    }
}

std::vector<double> RefineSpace::valuesOf(const Cycle& cycle) const {
    std::vector<double> values;
    for (const Setting& setting : m_settings) {
        const Stage& stage = cycle.stages[setting.stage];
        const double value = setting.isStock() ? stage.stock_mm : *(stage.*setting.feed);
        values.push_back(std::clamp(value, setting.low, setting.high));
    }
    return values;
}

std::optional<Cycle> RefineSpace::cycleOf(const std::vector<double>& values) const {
    Cycle cycle = m_cycle;
    double taken_mm = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Stage& stage = cycle.stages[m_settings[i].stage];
        if (m_settings[i].isStock()) {
            stage.stock_mm = values[i];
        } else {
            stage.*m_settings[i].feed = values[i];
        }
    }
    for (std::size_t z = 0; z + 1 < cycle.stages.size(); ++z) {
        taken_mm += cycle.stages[z].stock_mm;
    }
    Stage& last = cycle.stages.back();
    last.stock_mm = asWritten(m_stock_mm - taken_mm);
    const double slack = refineSlack * m_stock_mm;
    if (last.stock_mm < m_leastLast_mm - slack || last.stock_mm > m_mostLast_mm + slack) {
        return std::nullopt;
    }
    for (std::size_t z = 1; m_nonIncreasing && z < cycle.stages.size(); ++z) {
        for (const StageFeed* feed : m_operation->searchedFeeds()) {
            const std::optional<double>& own = cycle.stages[z].*feed->value;
            if (own && *own > (cycle.stages[z - 1].*feed->value).value_or(*own)) {
                return std::nullopt;
            }
        }
    }
    return cycle;
}

std::vector<double> RefineSpace::rounded(std::vector<double> values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = m_settings[i].rounded(values[i]);
    }
    return values;
}

namespace {

/// The results of a cycle on all parts.
struct Tried {
    double value = 0; ///< the minimised value
    bool holds = false;
    std::int64_t time_us = 0;
    double time_s = 0;
    double margin = 0; ///< least relative margin
    bool isStopped = false;
};

class Refinement {
public:
    Refinement(const Project& project, const Cycle& cycle, const RefineOptions& options,
               std::vector<Project> scenarios, long long runs)
        : m_space(project, cycle)
        , m_options(options)
        , m_parts(std::move(scenarios))
        , m_mostRuns(runs + options.mostRuns) {
        m_parts.insert(m_parts.begin(), project);
        for (Project& part : m_parts) {
            part.runs.clear();
            setMachine(part, machineSettings(project));
        }
        m_best.runs = runs;
        const GraceStop grace(options.stop);                // sufficient for most
        const Tried given = tryCycle(cycle, grace.token()); // reference for the answer
        m_best.cycle = cycle;
        if (given.isStopped) {
            return; // its result is unknown
        }
        m_best.time_us = given.time_us;
        m_best.time_s = given.time_s;
        m_best.leastRelativeMargin = given.margin;
    }

    /// The given cycle, before the refinement is run.
    [[nodiscard]] const RefineSummary& given() const { return m_best; }

    RefineSummary run() {
        if (m_space.settings().empty() || mustStop()) {
            return m_best;
        }
        const std::vector<double> given = m_space.valuesOf(m_best.cycle);
        for (const bool again : {false, true}) { // from the given cycle, then the best found
            for (const double firstStep : {0.1, 0.3, 0.03}) { // each finds minima that others miss
                const auto from = again ? m_space.valuesOf(m_best.cycle) : given;
                descend(m_space.rounded(offTheSteps(from, firstStep)));
            }
            descend(m_space.rounded(m_space.valuesOf(m_best.cycle)));
        }
        return m_best;
    }

private:
    [[nodiscard]] bool mustStop() const {
        return m_options.stop.stop_requested() || m_best.runs >= m_mostRuns;
    }

    Tried tryCycle(const Cycle& cycle, const std::stop_token& stop) {
        ++m_best.runs;
        Tried tried{0, true, 0, 0, std::numeric_limits<double>::infinity()};
        double broken = 0;
        for (Project& part : m_parts) {
            *part.cycle = cycle;
            const SimulationResult result = simulateUnchecked(part, nullptr, stop);
            if (&part == &m_parts.front()) {
                tried.holds = !m_options.everyStageSteps || !hasIdleStage(result);
                tried.time_s = result.time_s;
                tried.time_us = comparedTime_us(result.time_s);
                const double beyond = std::min(0.0, result.remainingStock_mm);
                tried.value = result.time_s * (1 + beyond / part.part->stock_mm);
                m_scale_s = m_scale_s > 0 ? m_scale_s : result.time_s;
            }
            broken = std::max(broken, brokenBy(result, tried));
        }
        constexpr double leastCost = 0.05, cost = 2; // relative to the first cycle's time
        tried.value += tried.holds ? 0 : m_scale_s * (leastCost + cost * broken);
        return tried;
    }

    /// The sum of the violations, relative to the limits.
    static double brokenBy(const SimulationResult& result, Tried& tried) {
        constexpr double mostEach = 5;
        if (result.status != RunStatus::completed) {
            tried.isStopped = tried.isStopped || result.status == RunStatus::stopped;
            tried.holds = false;
            return 2 * mostEach;
        }
        double broken = 0;
        for (const ConstraintResult& each : evaluateConstraints(result)) {
            tried.holds = tried.holds && each.holds;
            tried.margin = std::min(tried.margin, each.relativeMargin);
            broken += each.holds ? 0 : std::min(-each.relativeMargin, mostEach);
        }
        return broken;
    }

    /// Evaluates settings; `counts`: the cycle can be set, and may be the answer.
    double worth(const std::vector<double>& values, bool counts) {
        const auto known = m_known.find(values);
        if (known != m_known.end()) {
            return known->second;
        }
        constexpr double notInTheGrid = 100; // times the first cycle's time
        const std::optional<Cycle> cycle = m_space.cycleOf(values);
        double value = m_scale_s * notInTheGrid;
        if (cycle) {
            const Tried tried = tryCycle(*cycle, m_options.stop);
            value = tried.value;
            const bool better = tried.time_us < m_best.time_us
                                || (m_best.isQuicker && tried.time_us == m_best.time_us
                                    && tried.margin > m_best.leastRelativeMargin);
            if (counts && tried.holds && better) {
                m_best.cycle = *cycle;
                m_best.time_us = tried.time_us;
                m_best.time_s = tried.time_s;
                m_best.leastRelativeMargin = tried.margin;
                m_best.isQuicker = true;
            }
        }
        if (counts) {
            m_known.emplace(values, value);
        }
        return value;
    }

    /// See 1 in the header; each setting is a share of its range.
    std::vector<double> offTheSteps(const std::vector<double>& given, double firstStep) {
        const auto& settings = m_space.settings();
        std::vector<double> shares;
        for (std::size_t i = 0; i < given.size(); ++i) {
            shares.push_back((given[i] - settings[i].low) / (settings[i].high - settings[i].low));
        }
        const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(
            nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(shares.size())), nlopt_destroy);
        m_nlopt = search.get();
        nlopt_set_lower_bounds1(m_nlopt, 0);
        nlopt_set_upper_bounds1(m_nlopt, 1);
        nlopt_set_initial_step1(m_nlopt, firstStep);
        nlopt_set_xtol_rel(m_nlopt, 1e-4);
        nlopt_set_maxeval(m_nlopt, m_options.mostRuns / 8);
        nlopt_set_min_objective(m_nlopt, &Refinement::objective, this);
        double value = 0;
        nlopt_optimize(m_nlopt, shares.data(), &value); // the best found is kept, whatever ends it
        m_nlopt = nullptr;
        return valuesAt(shares.data());
    }

    [[nodiscard]] std::vector<double> valuesAt(const double* shares) const {
        std::vector<double> values;
        for (const RefineSpace::Setting& setting : m_space.settings()) {
            values.push_back(setting.low + *shares++ * (setting.high - setting.low));
        }
        return values;
    }

    static double objective(unsigned, const double* shares, double*, void* refinement) {
        auto& self = *static_cast<Refinement*>(refinement);
        if (self.mustStop()) {
            nlopt_force_stop(self.m_nlopt);
            return std::numeric_limits<double>::max();
        }
        return self.worth(self.valuesAt(shares), false);
    }

    /// Point 2: larger strides first.
    void descend(std::vector<double> at) {
        if (mustStop()) {
            return;
        }
        double value = worth(at, true);
        for (int stride = 16; stride >= 1;) {
            const auto [next, there] = bestNeighbour(at, value, stride);
            if (mustStop()) {
                return;
            }
            if (there < value) {
                at = next;
                value = there;
            } else {
                stride /= 2;
            }
        }
    }

    /// Changes one setting by some steps, and a feed together with a stock.
    std::pair<std::vector<double>, double> bestNeighbour(const std::vector<double>& at,
                                                         double value, int stride) {
        std::vector<double> best = at;
        for (std::size_t i = 0; i < at.size(); ++i) {
            for (const int up : {stride, -stride}) {
                std::vector<double> one = moved(at, i, up);
                tryNeighbour(one, best, value);
                for (std::size_t j = 0; j < at.size(); ++j) {
                    if (j != i && m_space.settings()[j].isStock()) {
                        tryNeighbour(moved(one, j, stride), best, value);
                        tryNeighbour(moved(one, j, -stride), best, value);
                    }
                }
            }
        }
        return {best, value};
    }

    void tryNeighbour(const std::vector<double>& values, std::vector<double>& best, double& value) {
        if (mustStop()) {
            return;
        }
        const double there = worth(values, true);
        if (there < value) {
            best = values;
            value = there;
        }
    }

    [[nodiscard]] std::vector<double> moved(std::vector<double> at, std::size_t i,
                                            int steps) const {
        const RefineSpace::Setting& setting = m_space.settings()[i];
        const double to = at[i] + steps * setting.stepAt(at[i]);
        at[i] = setting.rounded(std::clamp(to, setting.low, setting.high));
        return at;
    }

    RefineSpace m_space;
    const RefineOptions& m_options;
    std::vector<Project> m_parts; ///< the part itself first
    long long m_mostRuns;
    RefineSummary m_best;
    double m_scale_s = 0;
    std::map<std::vector<double>, double> m_known; ///< cycles that can be set
    nlopt_opt m_nlopt = nullptr;
};

/// Returns the first drawn scenario in which the cycle fails, then a stock for which it fails, or
/// one of the fresh phases, then a bad fresh part; none if there is none, or after a stop. Counts
/// the cycles tested on fresh phases.
FreshPartsTrial triedOnOthers(const Project& project, const RefineSummary& found,
                              const RefineOptions& options, int round, int& candidates) {
    Project best = project;
    *best.cycle = found.cycle;
    for (Project& scenario : options.source(best, round)) {
        *scenario.cycle = found.cycle;
        const SimulationResult result = simulateUnchecked(scenario, nullptr, options.stop);
        const std::vector<ConstraintResult> all = evaluateConstraints(result);
        if (result.status == RunStatus::stopped) {
            return {};
        }
        if (result.status != RunStatus::completed
            || std::any_of(all.begin(), all.end(), [](const auto& each) { return !each.holds; })) {
            return {std::move(scenario), {}};
        }
    }
    ++candidates;
    constexpr std::uint32_t otherThanTheSearch = 1U << 31U;
    auto bad = canDecidePhases(best)
                   ? failingCase(best, options.stop)
                   : failingPhase(best, otherThanTheSearch + static_cast<std::uint32_t>(round),
                                  options.stop);
    return bad ? FreshPartsTrial{std::move(bad), {}}
               : triedOnFreshParts(best, freshDraw(found.time_us), options.stop);
}

} // namespace

RefineSummary refine(const Project& project, const Cycle& cycle, const RefineOptions& options) {
    constexpr int mostRounds = 10;
    RefineSummary given;
    long long runs = 0;
    int candidates = options.candidates;
    std::vector<Project> scenarios = options.scenarios;
    for (int round = 0; round < mostRounds; ++round) {
        Refinement refinement(project, cycle, options, scenarios, runs);
        if (round == 0) {
            given = refinement.given();
        }
        RefineSummary summary = refinement.run();
        runs = summary.runs;
        if (!summary.isQuicker) {
            break;
        }
        if (!options.source) {
            return summary;
        }
        FreshPartsTrial trial = triedOnOthers(project, summary, options, round, candidates);
        if (options.stop.stop_requested()
            || (!trial.bad && options.asksCapability && !trial.good.isCapable)) {
            break; // a stopped test proves nothing
        }
        if (!trial.bad) {
            summary.candidate = candidates;
            summary.freshParts = trial.good;
            return summary;
        }
        scenarios.push_back(std::move(*trial.bad));
    }
    given.runs = runs; // nothing quicker passed the test
    return given;
}

} // namespace sparkout
