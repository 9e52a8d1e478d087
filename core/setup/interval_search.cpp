// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/interval_search.h"

#include "core/grace_stop.h"
#include "core/phases/sampled_phases.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/shop_numbers.h"
#include "core/search/cycle_runner.h"
#include "core/search/variants.h"
#include "core/setup/dressing_interval.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <tuple>
#include <utility>

namespace sparkout {

namespace {

/// The parts between dressings given by the project's rates.
std::optional<std::int64_t> allowedParts(const Project& project) {
    const bool isGiven = project.optimisation && project.optimisation->cost;
    return isGiven
               ? std::optional<std::int64_t>(project.optimisation->cost->parts_between_dressings)
               : std::nullopt;
}

/// Whether a project may be run with the wheel it has.
bool isRunnable(const Project& project) {
    return !hasErrors(validate(project));
}

/// The key for comparing numbers of parts: its value, the time and the number; less is better.
using Worth = std::tuple<double, std::int64_t, std::int64_t>;

/// Numbers of parts with a common lower bound of the quickest cycle's time.
struct Numbers {
    std::int64_t first = 0, last = 0;
    std::int64_t least_us = 0;
};

class IntervalSearch {
public:
    IntervalSearch(const Project& project, const SurfaceWear& wear, const IntervalOptions& options)
        : m_project(project)
        , m_isLife(objectiveOf(project) == SearchObjective::wheel_life)
        , m_course(wear, options.search.stop)
        , m_options(options.search)
        , m_variants(project, options.search.stop) {
        const std::optional<std::int64_t> allowed = allowedParts(project);
        m_most = std::min(options.most, allowed.value_or(options.most));
        m_mayBeEndless = !allowed && !wear.wear().grinding_ratio;
    }

    IntervalSummary run() {
        m_open = {{1, last(), 0}};
        while (!m_open.empty() && !stopped()) {
            const auto next = std::min_element(
                m_open.begin(), m_open.end(),
                [this](const Numbers& a, const Numbers& b) { return boundOf(a) < boundOf(b); });
            const Numbers numbers = *next;
            if (m_best && boundOf(numbers) >= worthOf(m_best->time_us, m_parts)) {
                break; // no other one has any either
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

    /// The greatest number of parts; if the wheel may stop changing, one more than are tried
    /// represents any number.
    [[nodiscard]] std::int64_t last() const { return m_mayBeEndless ? m_most + 1 : m_most; }
    [[nodiscard]] bool isAny(std::int64_t parts) const { return parts > m_most; }

    [[nodiscard]] Worth worthOf(std::int64_t time_us, std::int64_t parts) const {
        return {valueOf(seconds(time_us), parts), time_us, -parts};
    }
    [[nodiscard]] double valueOf(double time_s, std::int64_t parts) const {
        return m_isLife ? -static_cast<double>(parts)
                        : partCost(*m_project.optimisation->cost, time_s,
                                   isAny(parts) ? std::nullopt : std::optional(parts));
    }
    [[nodiscard]] Worth boundOf(const Numbers& numbers) const {
        return worthOf(numbers.least_us, numbers.last);
    }

    /// At first from the lowest upwards, since with far too dull wheels all cycles are tried before
    /// they are excluded.
    static std::int64_t middleOf(const Numbers& numbers) {
        return std::min(numbers.first + (numbers.last - numbers.first) / 2,
                        std::max(2 * numbers.first - 1, numbers.first));
    }

    void lookInto(Numbers numbers, std::vector<Numbers>::iterator at) {
        const std::int64_t parts = middleOf(numbers);
        const SearchSummary found = quickestFor(parts, numbers.least_us);
        if (!found.best) {
            if (stopped()) {
                return; // they remain open
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

    /// Chooses among the cycles of the least time the one with the greatest margin over all parts
    /// of the answer, not only those of its search.
    void settleTies() {
        const SearchSummary found = quickestFor(m_parts, m_best->time_us);
        if (found.best && !stopped()) {
            take(found, m_parts, m_parts);
        }
    }

    /// The quickest cycle that is fit for this many parts, given a lower bound of its time.
    SearchSummary quickestFor(std::int64_t parts, std::int64_t least_us) {
        ++m_summary.searches;
        SearchOptions options = m_options;
        options.quickest_us = least_us;
        if (parts > 1) {
            options.wholeMargin = [this, parts](const FeasibleCycle& found, double least) {
                return marginOver(found, parts, least);
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

    /// Reports the best of all searches, and the bound for the first part alone.
    void note(const SearchProgress& progress) const {
        SearchProgress all = progress;
        all.evaluations += m_summary.search.evaluations;
        if (m_best) {
            all.best = m_best;
            all.bound_s = m_leastTime_s;
        }
        m_options.onProgress(all);
    }

    [[nodiscard]] Project projectOf(const FeasibleCycle& found) const {
        Project project = m_variants.project(found.variant);
        project.runs.clear();
        *project.cycle = m_variants.grid(found.variant).cycle(found.cycle);
        return project;
    }

    /// A cycle that is fit for the first part, and the wheel with it.
    struct Tried {
        Project project;
        WheelCourse course;
        double margin = 0; ///< relative, for the first part
        std::int64_t
            wornOut{}; ///< first part from which the wheel no longer changes; m_most + 1: none
    };

    /// Empty after a stop.
    [[nodiscard]] std::optional<Tried> begin(const FeasibleCycle& found) const {
        Tried begun{projectOf(found), m_course, 0};
        begun.course.putWheel(begun.project, 1);
        const std::optional<CycleTrial> trial = tried(begun.project, m_options.stop);
        if (!trial || !trial->holds) {
            return std::nullopt;
        }
        begun.course = m_course.ofCycle(trial->removed_mm3, m_options.stop);
        begun.margin = trial->leastMargin;
        begun.wornOut = m_most + 1;
        std::int64_t low = 0;
        while (begun.wornOut - low > 1) { // none is worn out up to low
            const std::int64_t middle = low + (begun.wornOut - low) / 2;
            (begun.course.isWornOut(middle) ? begun.wornOut : low) = middle;
        }
        return stopped() ? std::nullopt : std::optional(std::move(begun));
    }

    /// The last of this many parts that differs from the previous.
    [[nodiscard]] std::int64_t lastOf(const Tried& begun, std::int64_t parts) const {
        return std::min({parts, begun.wornOut, m_most});
    }

    /// The margin on a part; empty if it fails there, if its wheel is refused, or after a stop.
    [[nodiscard]] std::optional<double> marginAt(Tried& begun, std::int64_t part) const {
        begun.course.putWheel(begun.project, part);
        if (!isRunnable(begun.project)) {
            return std::nullopt;
        }
        const std::optional<CycleTrial> trial = tried(begun.project, m_options.stop);
        return trial && trial->holds ? std::optional(trial->leastMargin) : std::nullopt;
    }

    /// The least margin over all these parts, beginning with the last and those that excluded
    /// cycles before. Called on the threads of a full search.
    WholeMargin marginOver(const FeasibleCycle& found, std::int64_t parts, double least) {
        std::optional<Tried> begun = begin(found);
        if (!begun || (isAny(parts) && begun->wornOut > m_most)) {
            return {};
        }
        const std::int64_t last = lastOf(*begun, parts);
        double margin = begun->margin;
        const std::vector<std::int64_t> telling = tellingBelow(last);
        const auto holds = [&](std::int64_t part) {
            const std::optional<double> there = marginAt(*begun, part);
            if (!there) {
                note(part);
            }
            margin = std::min(margin, there.value_or(margin));
            return there && margin >= least;
        };
        const auto isTold = [&](std::int64_t part) {
            return std::ranges::find(telling, part) != telling.end();
        };
        bool all = last < 2 || holds(last);
        for (std::size_t i = 0; all && i < telling.size(); ++i) {
            all = holds(telling[i]);
        }
        for (std::int64_t part = last - 1; all && part > 1; --part) {
            all = isTold(part) || holds(part);
        }
        return all && margin >= least ? WholeMargin{margin} : WholeMargin{};
    }

    [[nodiscard]] std::vector<std::int64_t> tellingBelow(std::int64_t last) {
        const std::scoped_lock lock(m_mutex);
        std::vector<std::int64_t> telling = m_telling;
        std::erase_if(telling, [last](std::int64_t part) { return part >= last; });
        return telling;
    }

    /// Records a part for which a cycle fails.
    void note(std::int64_t telling) {
        constexpr std::size_t most = 8;
        const std::scoped_lock lock(m_mutex);
        if (stopped() || telling < 2) {
            return;
        }
        std::erase(m_telling, telling);
        m_telling.insert(m_telling.begin(), telling);
        m_telling.resize(std::min(m_telling.size(), most));
    }

    /// The life of a cycle that is fit for this many parts.
    [[nodiscard]] std::int64_t lifeOf(const FeasibleCycle& found, std::int64_t parts) const {
        std::optional<Tried> begun = begin(found);
        if (!begun || isAny(parts)) {
            return parts;
        }
        const std::int64_t end = lastOf(*begun, m_most);
        std::int64_t held = std::min(parts, end);
        while (held < end && marginAt(*begun, held + 1)) {
            ++held;
        }
        return held < end ? held : begun->wornOut <= m_most ? last() : m_most;
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

    /// The bound of all open numbers, and of the best.
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

    /// With the wheel as worn by the answer.
    [[nodiscard]] std::vector<Project> tellingParts() {
        std::vector<Project> parts;
        std::optional<Tried> begun = begin(*m_best);
        if (!begun) {
            return parts;
        }
        const std::int64_t last = lastOf(*begun, m_parts);
        std::vector<std::int64_t> numbers = tellingBelow(last);
        numbers.push_back(last);
        for (const std::int64_t number : numbers) {
            begun->course.putWheel(begun->project, number);
            if (number > 1 && isRunnable(begun->project)) {
                parts.push_back(begun->project);
            }
        }
        return parts;
    }

    const Project& m_project;
    bool m_isLife;
    WheelCourse m_course; ///< before the cycle is known
    const SearchOptions& m_options;
    Variants m_variants;
    std::int64_t m_most = 0;     ///< parts that are tried
    bool m_mayBeEndless = false; ///< no number of parts is given
    std::vector<Numbers> m_open; ///< apart from each other
    std::optional<FeasibleCycle> m_best;
    SearchSummary m_answer;
    std::int64_t m_parts = 0;       ///< parts for which the best is fit
    std::int64_t m_searchedFor = 0; ///< parts over which its margin is taken
    double m_leastTime_s = 0;
    std::vector<std::int64_t> m_telling; ///< parts that shut out cycles, the last one first
    std::mutex m_mutex;                  ///< guards these
    IntervalSummary m_summary;
};

/// The quickest cycle, with the project's number of parts between dressings.
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
    const std::optional<std::int64_t> allowed = allowedParts(project);
    const std::int64_t last = std::min(most, allowed.value_or(most));
    WheelCourse course(wear, stop);
    PartsHeld held;
    Project part = project;
    part.runs.clear();
    double sum_s = 0;
    while (held.parts < last && !held.isEndless && !stop.stop_requested()) {
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
        if (held.parts == 0) {
            course = course.ofCycle(removedVolume_mm3(result), stop);
        }
        sum_s += result.time_s;
        ++held.parts;
        held.isEndless = !allowed && course.isWornOut(held.parts);
    }
    held.meanTime_s = held.parts > 0 ? sum_s / static_cast<double>(held.parts) : 0;
    held.isAll = held.isEndless || held.parts == last;
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

IntervalSummary searchInterval(const Project& given, const SurfaceWear& wear,
                               const IntervalOptions& options) {
    const bool wears = wear.wear().isGiven();
    Project project = given;
    if (wears) {
        project.wheel->radius_wear_um = 0; // a dressing compensates it
    }
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
