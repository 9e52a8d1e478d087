// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/interval_search.h"

#include "core/dressing/part_cost.h"
#include "core/grace_stop.h"
#include "core/optimisation/cycle_runner.h"
#include "core/optimisation/variants.h"
#include "core/phases/cycle_trial.h"
#include "core/project/validate.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

/// Between dressings, as the project's rates have it.
std::optional<std::int64_t> allowedParts(const Project& project) {
    const bool isGiven = project.optimisation && project.optimisation->cost;
    return isGiven
               ? std::optional<std::int64_t>(project.optimisation->cost->parts_between_dressings)
               : std::nullopt;
}

/// The parts of a project from one dressing to the next, up to the last that need be told apart.
class WornCourse {
public:
    WornCourse(const Project& project, const SurfaceWear& wear, std::int64_t most)
        : m_wear(wear), m_last(most) {
        const std::optional<std::int64_t> allowed = allowedParts(project);
        m_last = std::min(m_last, allowed.value_or(most));
        std::int64_t low = 0;
        while (m_last - low > 1) { // none is worn out up to low, m_last is or is the last
            const std::int64_t middle = low + (m_last - low) / 2;
            (m_wear.isWornOut(middle) ? m_last : low) = middle;
        }
        m_isEndless = !allowed && m_wear.isWornOut(m_last);
    }

    [[nodiscard]] std::int64_t last() const { return m_last; }
    [[nodiscard]] bool isEndless() const { return m_isEndless; } ///< who holds for the last
    void putWheel(Project& project, std::int64_t part) const {
        *project.wheel = m_wear.wheel(part);
    }

private:
    const SurfaceWear& m_wear;
    std::int64_t m_last;
    bool m_isEndless = false;
};

/// Whether a project may be run with the wheel it has.
bool isRunnable(const Project& project) {
    return !hasErrors(validate(project));
}

/// What a number of parts is compared by: its value, the time and the number; less is better.
using Worth = std::tuple<double, std::int64_t, std::int64_t>;

/// Numbers of parts, of none of which the quickest cycle is quicker.
struct Numbers {
    std::int64_t first = 0, last = 0;
    std::int64_t least_us = 0;
};

class IntervalSearch {
public:
    IntervalSearch(const Project& project, const SurfaceWear& wear, const IntervalOptions& options)
        : m_project(project)
        , m_isLife(objectiveOf(project) == SearchObjective::wheel_life)
        , m_course(project, wear, options.most)
        , m_options(options.search)
        , m_variants(project, options.search.stop) {}

    IntervalSummary run() {
        m_open = {{1, m_course.last(), 0}};
        while (!m_open.empty() && !stopped()) {
            const auto next = std::min_element(
                m_open.begin(), m_open.end(),
                [this](const Numbers& a, const Numbers& b) { return boundOf(a) < boundOf(b); });
            const Numbers numbers = *next;
            if (m_best && boundOf(numbers) >= worthOf(m_best->time_us, m_parts)) {
                break; // nor is any other
            }
            lookInto(numbers, next);
        }
        if (m_best && !stopped() && m_parts != m_searchedFor) {
            settleTies();
        }
        finish();
        return std::move(m_summary);
    }

private:
    [[nodiscard]] bool stopped() const { return m_options.stop.stop_requested(); }

    [[nodiscard]] Worth worthOf(std::int64_t time_us, std::int64_t parts) const {
        return {valueOf(seconds(time_us), parts), time_us, -parts};
    }
    [[nodiscard]] double valueOf(double time_s, std::int64_t parts) const {
        const bool isEndless = parts == m_course.last() && m_course.isEndless();
        return m_isLife ? -static_cast<double>(parts)
                        : partCost(*m_project.optimisation->cost, time_s,
                                   isEndless ? std::nullopt : std::optional(parts));
    }
    [[nodiscard]] Worth boundOf(const Numbers& numbers) const {
        return worthOf(numbers.least_us, numbers.last);
    }

    /// From the first upwards at first, as wheels that are far too dull shut all cycles out only
    /// after all were tried.
    static std::int64_t middleOf(const Numbers& numbers) {
        return std::min(numbers.first + (numbers.last - numbers.first) / 2,
                        std::max(2 * numbers.first - 1, numbers.first));
    }

    void lookInto(Numbers numbers, std::vector<Numbers>::iterator at) {
        const std::int64_t parts = middleOf(numbers);
        const SearchSummary found = quickestFor(parts, numbers.least_us);
        if (!found.best) {
            if (stopped()) {
                return; // they stay open
            }
            m_summary.search.status = SearchStatus::infeasible;
            const auto isBeyond = [parts](const Numbers& each) { return each.first >= parts; };
            m_open.erase(at);
            std::erase_if(m_open, isBeyond);
            add({numbers.first, parts - 1, numbers.least_us});
            return;
        }
        const std::int64_t life = lifeOf(*found.best, parts);
        const std::int64_t time_us = found.best->time_us;
        if (!m_best || worthOf(time_us, life) < worthOf(m_best->time_us, m_parts)) {
            take(found, life, parts);
        }
        if (stopped()) {
            return;
        }
        m_open.erase(at);
        add({numbers.first, parts - 1, numbers.least_us});
        add({life + 1, numbers.last, time_us});
    }

    void add(const Numbers& numbers) {
        if (numbers.first <= numbers.last) {
            m_open.push_back(numbers);
        }
    }

    void take(const SearchSummary& found, std::int64_t life, std::int64_t searchedFor) {
        m_best = found.best;
        m_answer = found;
        m_parts = life;
        m_searchedFor = searchedFor;
    }

    /// Of the cycles of the least time the one with the greatest margin over all parts of the
    /// answer, not over those alone that it was searched for.
    void settleTies() {
        const SearchSummary found = quickestFor(m_parts, m_best->time_us);
        if (found.best && !stopped()) {
            take(found, m_parts, m_parts);
        }
    }

    /// The quickest cycle that holds for so many parts, where none is quicker than that.
    SearchSummary quickestFor(std::int64_t parts, std::int64_t least_us) {
        ++m_summary.searches;
        SearchOptions options = m_options;
        options.quickest_us = least_us;
        if (parts > 1) {
            const std::optional<Project> last = part(m_project, parts);
            if (!last || !areRunnable(parts)) {
                return {}; // whatever the cycle
            }
            options.scenarios.push_back(*last);
            options.wholeMargin = [this, parts](const FeasibleCycle& found, double least) {
                return marginBetween(found, parts, least);
            };
        }
        if (m_options.onProgress) {
            options.onProgress = [this](const SearchProgress& progress) { note(progress); };
        }
        SearchSummary found = optimise(m_project, options);
        SearchSummary& sum = m_summary.search;
        sum.gridSize = found.gridSize;
        sum.evaluations += found.evaluations;
        sum.visits += found.visits;
        for (std::size_t kind = 0; kind < found.cuts.size(); ++kind) {
            sum.cuts[kind] += found.cuts[kind];
        }
        if (parts == 1) {
            m_leastTime_s = found.bound_s;
        }
        return found;
    }

    /// The best of all searches so far, and that none is quicker for the first part alone.
    void note(const SearchProgress& progress) const {
        SearchProgress all = progress;
        all.evaluations += m_summary.search.evaluations;
        if (m_best) {
            all.best = m_best;
            all.bound_s = m_leastTime_s;
        }
        m_options.onProgress(all);
    }

    /// Nothing: with the wheel that comes to it the project is refused.
    [[nodiscard]] std::optional<Project> part(Project project, std::int64_t number) const {
        project.runs.clear();
        m_course.putWheel(project, number);
        return isRunnable(project) ? std::optional(std::move(project)) : std::nullopt;
    }

    /// Whether the parts up to this one may be run with their wheels.
    [[nodiscard]] bool areRunnable(std::int64_t parts) {
        while (m_runnable < parts && part(m_project, m_runnable + 1)) {
            ++m_runnable;
        }
        return m_runnable >= parts;
    }

    [[nodiscard]] Project projectOf(const FeasibleCycle& found) const {
        Project project = m_variants.project(found.variant);
        project.runs.clear();
        *project.cycle = m_variants.grid(found.variant).cycle(found.cycle);
        return project;
    }

    /// Over the parts from 2 on before the last, those first that shut out cycles before. In the
    /// threads of a full search.
    WholeMargin marginBetween(const FeasibleCycle& found, std::int64_t last, double least) {
        const std::scoped_lock lock(m_mutex);
        Project project = projectOf(found);
        double margin = std::numeric_limits<double>::infinity();
        const auto holds = [&](std::int64_t number) {
            m_course.putWheel(project, number);
            const std::optional<CycleTrial> trial = tried(project, m_options.stop);
            if (!trial || !trial->holds || trial->leastMargin < least) {
                return false;
            }
            margin = std::min(margin, trial->leastMargin);
            return true;
        };
        const std::vector<std::int64_t> telling = m_telling;
        for (const std::int64_t number : telling) {
            if (number < last && !holds(number)) {
                note(number);
                return {};
            }
        }
        for (std::int64_t number = last - 1; number > 1; --number) {
            if (std::find(telling.begin(), telling.end(), number) == telling.end()
                && !holds(number)) {
                note(number);
                return {};
            }
        }
        return {margin};
    }

    void note(std::int64_t telling) {
        constexpr std::size_t most = 8;
        std::erase(m_telling, telling);
        m_telling.insert(m_telling.begin(), telling);
        m_telling.resize(std::min(m_telling.size(), most));
    }

    /// Of a cycle that holds for so many parts.
    [[nodiscard]] std::int64_t lifeOf(const FeasibleCycle& found, std::int64_t parts) {
        Project project = projectOf(found);
        while (parts < m_course.last() && areRunnable(parts + 1)) {
            m_course.putWheel(project, parts + 1);
            const std::optional<CycleTrial> trial = tried(project, m_options.stop);
            if (!trial || !trial->holds) {
                break;
            }
            ++parts;
        }
        return parts;
    }

    void finish() {
        SearchSummary& sum = m_summary.search;
        if (m_best) {
            sum.best = m_best;
            sum.cycle = m_answer.cycle;
            sum.machine = m_answer.machine;
            sum.status = SearchStatus::proved;
            m_summary.parts = tellingParts();
        }
        sum.bound_s = m_leastTime_s;
        if (stopped()) {
            sum.status = SearchStatus::stopped;
            m_summary.bound = openBound();
        }
    }

    /// Of all that is still open, and of the best.
    [[nodiscard]] std::optional<double> openBound() const {
        std::optional<double> bound;
        for (const Numbers& each : m_open) {
            const double value = std::get<0>(boundOf(each));
            bound = std::min(bound.value_or(value), value);
        }
        if (m_best) {
            const double value = std::get<0>(worthOf(m_best->time_us, m_parts));
            bound = std::min(bound.value_or(value), value);
        }
        return bound && m_isLife ? std::optional(-*bound) : bound;
    }

    [[nodiscard]] std::vector<Project> tellingParts() const {
        std::vector<Project> parts;
        std::vector<std::int64_t> numbers = m_telling;
        numbers.push_back(m_parts);
        for (const std::int64_t number : numbers) {
            if (number > 1 && number <= m_parts) {
                if (auto made = part(m_project, number)) {
                    parts.push_back(std::move(*made));
                }
            }
        }
        return parts;
    }

    const Project& m_project;
    bool m_isLife;
    WornCourse m_course;
    const SearchOptions& m_options;
    Variants m_variants;
    std::vector<Numbers> m_open; ///< apart from each other
    std::optional<FeasibleCycle> m_best;
    SearchSummary m_answer;
    std::int64_t m_parts = 0;       ///< that the best holds for
    std::int64_t m_searchedFor = 0; ///< where its margin is taken over
    std::int64_t m_runnable = 1;
    double m_leastTime_s = 0;
    std::vector<std::int64_t> m_telling; ///< parts that shut out cycles, the last one first
    std::mutex m_mutex;
    IntervalSummary m_summary;
};

/// The quickest cycle, dressed after as many parts as the project states.
IntervalSummary withoutWear(const Project& project, const SearchOptions& options) {
    IntervalSummary summary;
    summary.searches = 1;
    summary.search = optimise(project, options);
    return summary;
}

} // namespace

SearchObjective objectiveOf(const Project& project) {
    return project.optimisation ? project.optimisation->objective : SearchObjective::time;
}

ObjectiveFault objectiveFault(const Project& project, bool isRobust) {
    const SearchObjective objective = objectiveOf(project);
    if (objective == SearchObjective::time) {
        return ObjectiveFault::none;
    }
    const Optimisation& asked = *project.optimisation;
    if (objective == SearchObjective::cost && !asked.cost) {
        return ObjectiveFault::noRates;
    }
    if (asked.margin_within_min) {
        return ObjectiveFault::otherAim;
    }
    return isRobust || asked.scenarios != OptimisationScenarios::nominal
               ? ObjectiveFault::otherParts
               : ObjectiveFault::none;
}

PartsHeld partsHeld(const Project& project, const SurfaceWear& wear, std::int64_t most,
                    const std::stop_token& stop) {
    const WornCourse course(project, wear, most);
    PartsHeld held;
    Project part = project;
    part.runs.clear();
    double sum_s = 0;
    while (held.parts < course.last()) {
        course.putWheel(part, held.parts + 1);
        if (!isRunnable(part)) {
            break;
        }
        const SimulationResult result = simulateUnchecked(part, nullptr, stop);
        if (result.status != RunStatus::completed) {
            break;
        }
        const ConstraintResult* worst = nullptr;
        const std::vector<ConstraintResult> all = evaluateConstraints(result);
        for (const ConstraintResult& each : all) {
            if (!each.holds && (!worst || each.relativeMargin < worst->relativeMargin)) {
                worst = &each;
            }
        }
        if (worst) {
            held.end = worst->kind;
            break;
        }
        sum_s += result.time_s;
        ++held.parts;
    }
    held.meanTime_s = held.parts > 0 ? sum_s / static_cast<double>(held.parts) : 0;
    held.isAll = held.parts == course.last();
    held.isEndless = held.isAll && course.isEndless();
    return held;
}

double IntervalSummary::value(SearchObjective objective) const {
    if (objective == SearchObjective::wheel_life && held) {
        return held->isEndless ? -std::numeric_limits<double>::infinity()
                               : -static_cast<double>(held->parts);
    }
    return objective == SearchObjective::cost && cost ? *cost
           : search.best                              ? search.best->time_s
                                                      : std::numeric_limits<double>::infinity();
}

IntervalSummary searchInterval(const Project& project, const SurfaceWear& wear,
                               const IntervalOptions& options) {
    const bool wears = wear.wear.isGiven();
    IntervalSummary summary =
        wears ? IntervalSearch(project, wear, options).run() : withoutWear(project, options.search);
    if (!summary.search.best) {
        return summary;
    }
    const double time_s = summary.search.best->time_s;
    if (!wears) {
        summary.cost = costPerPart(project, time_s);
        return summary;
    }
    const GraceStop grace(options.search.stop);
    summary.held = partsHeld(withBest(project, summary.search), wear, options.most, grace.token());
    if (const std::optional<Cost>& rates = project.optimisation->cost) {
        summary.cost =
            partCost(*rates, time_s,
                     summary.held->isEndless ? std::nullopt : std::optional(summary.held->parts));
    }
    return summary;
}

} // namespace sparkout
