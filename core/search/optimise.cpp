// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/optimise.h"

#include "core/grace_stop.h"
#include "core/process/profile.h"
#include "core/project/optimisation.h"
#include "core/search/cycle_runner.h"
#include "core/search/judge.h"
#include "core/search/pruned_search.h"
#include "core/search/search_journal.h"
#include "core/search/stage_runs.h"
#include "core/search/time_bound.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace sparkout {

const char* searchMethodName(SearchMethod method) {
    switch (method) {
    case SearchMethod::full: return "full";
    case SearchMethod::pruned: return "search";
    case SearchMethod::published: return "dp";
    case SearchMethod::labels: return "labels";
    }
    return "";
}

std::optional<SearchMethod> searchMethodNamed(std::string_view name) {
    for (const SearchMethod method : {SearchMethod::full, SearchMethod::pruned,
                                      SearchMethod::published, SearchMethod::labels}) {
        if (name == searchMethodName(method)) {
            return method;
        }
    }
    return std::nullopt;
}

const char* searchStatusName(SearchStatus status) {
    switch (status) {
    case SearchStatus::proved: return "proved";
    case SearchStatus::infeasible: return "infeasible";
    case SearchStatus::stopped: return "stopped";
    case SearchStatus::found: return "found";
    case SearchStatus::notFound: return "not_found";
    }
    return "";
}

namespace {

// Dynamic programming for plunge cycles: the published rule and an improved one. Both are
// heuristics: a cycle they find is feasible, but a quicker one may be, too, and if they find none
// there may be one. They serve as a comparison with the proven answer.
//
// The thesis of 1999 divides the stock into levels n and lists feeds m; a state [n, m] is a level
// reached with a feed. Among all moves into a state that violate no requirement only the quickest
// is kept, with its predecessor (eq. 27):
//
//     T[n,m] = min over m' of ( T[n−1,m'] + τ )
//
// The rule would be exact if everything after a state were independent of how the state was
// reached. In an elastic system it is not: the deflection stored by every radius of every section
// is part of the state. The quickest way to a level is the one with the largest forces; it leaves
// the largest deflection, and the following stages then overshoot, run out or burn where a slower
// way would not. In 60 small random cases the rule that keeps the quickest predecessor found no
// cycle in 29 where one exists and a slower one in 8; keeping all labels that are not dominated in
// time and deflection was still wrong in about a quarter of 300 [MODEL-8]. In the 193 random cases
// with a cycle of test_dynamic_programming, whose states have the feed as printed, the published
// rule finds none in 30 and a slower one in 6, the labels a slower one in 50; the tests print
// these numbers.
//
// Here a state is a number of finished stages, a level (steps of stock taken by them) and, as
// published, the last feed: the grid limits the stages, of which the thesis has as many as levels.
// A move is a stage, from any earlier level; τ is its simulated time. Size and drawing are checked
// only at the end of a move: a move into the last level is admissible if the whole cycle is
// feasible, any other if its passes exceed no limit.

/// Searches by the published rule: each state keeps one label, the quickest.
[[nodiscard]] SearchSummary publishedProgramming(const Project& project, const Grid& grid,
                                                 const SearchOptions& options);

/// Searches with several labels per state: a state keeps every label that no other beats in both
/// time and stored deflection, t_П less the removal read by the gauge; its feed is part of the
/// state only where feeds must not rise. Labels that the proven bound of their time excludes from
/// being the best are dropped as well.
[[nodiscard]] SearchSummary labelSetting(const Project& project, const Grid& grid,
                                         const SearchOptions& options);

enum class LabelRule { quickest, notDominated };

/// A way to a state.
struct Label {
    CyclePrefix prefix;
    double time_s = 0, deflection_mm = 0;
};

/// A state of a stage: steps of stock taken, and the last feed where it counts.
using StateKey = std::pair<int, std::size_t>;
using StageStates = std::map<StateKey, std::vector<Label>>;

class LabelSearch {
public:
    LabelSearch(const Project& project, const Grid& grid, const SearchOptions& options,
                LabelRule rule)
        : m_grid(grid)
        , m_options(options)
        , m_rule(rule)
        , m_keepsSetting(rule == LabelRule::quickest || project.optimisation->non_increasing)
        , m_judge(grid, options)
        , m_runner(project, grid, options.stop)
        , m_runs(project, grid, m_runner, StageRuns::Bounds::yes) {}

    SearchSummary run() {
        bool ended = true;
        for (const std::size_t stages : m_grid.stageCounts()) {
            ended = ended && search(stages);
        }
        SearchSummary summary;
        summary.best = m_judge.best();
        summary.status = !ended         ? SearchStatus::stopped
                         : summary.best ? SearchStatus::found
                                        : SearchStatus::notFound;
        summary.evaluations = m_judge.counts.evaluations;
        summary.visits = m_judge.counts.visits;
        summary.cuts = m_judge.counts.cuts;
        return summary;
    }

private:
    /// Stage by stage, all states from all previous states. False after a stop.
    bool search(std::size_t stages) {
        StageStates states;
        Label blank;
        blank.prefix.stages = stages;
        blank.prefix.keep(m_runner.begin(stages));
        states[{0, 0}].push_back(std::move(blank));
        for (std::size_t stage = 0; stage < stages; ++stage) {
            StageStates next;
            for (const Label* label : byTime(states)) {
                if (m_options.stop.stop_requested()) {
                    return false;
                }
                extend(label->prefix, next);
            }
            states = std::move(next);
        }
        return true;
    }

    /// The quickest first: states they reach are seldom reached more quickly later.
    static std::vector<const Label*> byTime(const StageStates& states) {
        std::vector<const Label*> all;
        for (const auto& [key, labels] : states) {
            for (const Label& label : labels) {
                all.push_back(&label);
            }
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Label* a, const Label* b) { return a->time_s < b->time_s; });
        return all;
    }

    void extend(const CyclePrefix& from, StageStates& next) {
        for (std::size_t s = 0; s < m_grid.settings().size(); ++s) {
            const int least = from.isBeforeLast() ? 0 : m_runs.leastTaken(from);
            if (m_options.stop.stop_requested()) {
                return;
            }
            if (m_grid.mayExtend(from.cycle, from.stages, s)
                && !isDropped(from, from.steps->run(), s, least)) {
                m_runs.run(
                    from, s,
                    [&](const Run& run, int taken) {
                        return m_options.stop.stop_requested() || isDropped(from, run, s, taken);
                    },
                    [&](const StageRuns::End& end) { reach(from, s, end, next); }, m_judge.counts);
            }
        }
        if (m_options.onProgress) {
            m_options.onProgress({m_judge.best(), 0, m_judge.counts.evaluations, 0});
        }
    }

    /// Whether a label is dropped since it takes longer than the best: it can neither beat that nor
    /// exclude a better one. One that takes longer only by a proven bound could exclude others
    /// before the last stage, so under the published rule the bound counts only there.
    [[nodiscard]] bool isDropped(const CyclePrefix& from, const Run& run, std::size_t setting,
                                 int taken) const {
        const double least_s = m_rule == LabelRule::quickest && !from.isBeforeLast()
                                   ? run.time_s()
                                   : m_runs.bound_s(from, run, setting, taken);
        return std::floor(least_s * (1 - 1e-12) * 1e6 - 1)
               > static_cast<double>(m_judge.bestTime_us());
    }

    void reach(const CyclePrefix& from, std::size_t setting, const StageRuns::End& end,
               StageStates& next) {
        if (from.isBeforeLast()) {
            m_judge.decideDone(m_runs.after(from, setting, end, 0), end.steps, m_runner);
            return;
        }
        const Run& run = end.steps.run();
        Label label;
        label.time_s = run.time_s();
        label.deflection_mm = run.fed_mm - (run.sizeDepth_mm() - end.steps.remaining());
        std::shared_ptr<const CycleSteps> steps; // one for all ends on this step
        for (int taken = end.first; taken <= end.last; ++taken) {
            std::vector<Label>& state = next[{taken, m_keepsSetting ? setting : 0}];
            if (!isKept(state, label)) {
                continue;
            }
            if (!steps) {
                steps = end.steps.copy();
            }
            std::erase_if(state, [&](const Label& other) { return isBeaten(other, label); });
            state.push_back(label);
            state.back().prefix = m_runs.after(from, setting, end, taken);
            state.back().prefix.keep(steps);
        }
    }

    [[nodiscard]] bool isKept(const std::vector<Label>& state, const Label& label) const {
        return std::none_of(state.begin(), state.end(),
                            [&](const Label& other) { return isBeaten(label, other); });
    }

    /// Whether b dominates a.
    [[nodiscard]] bool isBeaten(const Label& a, const Label& b) const {
        return b.time_s <= a.time_s
               && (m_rule == LabelRule::quickest || b.deflection_mm <= a.deflection_mm);
    }

    const Grid& m_grid;
    const SearchOptions& m_options;
    LabelRule m_rule;
    bool m_keepsSetting;
    Judge m_judge;
    CycleRunner m_runner;
    StageRuns m_runs;
};

SearchSummary searchLabels(const Project& project, const Grid& grid, const SearchOptions& options,
                           LabelRule rule) {
    return grid.stageCounts().empty() ? SearchSummary{}
                                      : LabelSearch(project, grid, options, rule).run();
}

SearchSummary publishedProgramming(const Project& project, const Grid& grid,
                                   const SearchOptions& options) {
    return searchLabels(project, grid, options, LabelRule::quickest);
}

SearchSummary labelSetting(const Project& project, const Grid& grid, const SearchOptions& options) {
    return searchLabels(project, grid, options, LabelRule::notDominated);
}

/// Runs every cycle of the grid from the blank, on `threads` threads, until the cycle ends, is
/// slower than the best or violates a requirement. The search can be stopped and resumed. Fills the
/// whole summary except `cycle` and `gridSize`.
[[nodiscard]] SearchSummary fullSearch(const Project& project, const Grid& grid,
                                       const SearchOptions& options);

/// Hands out the cycles of the grid in portions, and collects their results.
class FullSearch {
public:
    FullSearch(const Project& project, const Grid& grid, const SearchOptions& options)
        : m_project(project), m_grid(grid), m_options(options), m_best(grid, options) {
        if (options.resume) {
            m_handed = m_last = options.resume->last;
        }
    }

    SearchSummary run() {
        const unsigned threads = m_options.threads > 0
                                     ? m_options.threads
                                     : std::max(1U, std::thread::hardware_concurrency());
        {
            std::vector<std::jthread> others;
            for (unsigned i = 1; i < threads; ++i) {
                others.emplace_back([this] { work(); });
            }
            work();
        } // waits for the others
        SearchSummary summary;
        summary.best = m_best.best();
        summary.evaluations = m_best.counts.evaluations;
        summary.visits = m_best.counts.visits;
        summary.cuts = m_best.counts.cuts;
        summary.checkpoint = checkpoint();
        if (!m_exhausted || m_cutShort) {
            summary.status = SearchStatus::stopped;
        } else if (summary.best) {
            summary.status = SearchStatus::proved;
            summary.bound_s = summary.best->time_s;
        }
        return summary;
    }

private:
    static constexpr int portionSize = 64;

    /// Cycles that follow each other in the grid.
    struct Portion {
        long long number = 0; ///< in the order of the portions
        std::vector<GridCycle> cycles;
        std::size_t done = 0; ///< number of decided cycles: fewer after a stop
        SearchCounts counts;  ///< counts of these cycles
        [[nodiscard]] bool isDone() const { return done == cycles.size(); }
    };

    [[nodiscard]] SearchCheckpoint checkpoint() const {
        const SearchCounts& counts = m_best.counts;
        return {m_last,        m_best.best(), m_options.variant, counts.evaluations,
                counts.visits, counts.cuts};
    }

    void work() {
        CycleRunner runner(m_project, m_grid, m_options.stop);
        Judge judge(m_grid, m_options);
        for (Portion portion = take(judge); !portion.cycles.empty(); portion = take(judge)) {
            for (const GridCycle& cycle : portion.cycles) {
                const long long before = judge.counts.evaluations;
                judge.decide(cycle, runner);
                if (judge.counts.evaluations == before) {
                    break; // stopped within it
                }
                ++portion.done;
            }
            portion.counts = std::exchange(judge.counts, {});
            giveBack(std::move(portion), judge);
        }
    }

    /// Decided cycles are counted in grid order up to the first undecided one: a resumed search
    /// begins after the last counted cycle, and repeats those that other threads decided beyond it.
    void giveBack(Portion portion, const Judge& judge) {
        const std::scoped_lock lock(m_mutex);
        if (judge.best()) {
            m_best.offer(*judge.best());
        }
        m_done.emplace(portion.number, std::move(portion));
        for (auto first = m_done.find(m_counted); !m_cutShort && first != m_done.end();
             first = m_done.find(m_counted)) {
            const Portion& next = first->second;
            m_best.counts.add(next.counts);
            m_last = next.done > 0 ? next.cycles[next.done - 1] : m_last;
            m_cutShort = !next.isDone();
            m_done.erase(first);
            ++m_counted;
        }
        if (m_options.onProgress) {
            m_options.onProgress({m_best.best(), 0, m_best.counts.evaluations, 0, checkpoint()});
        }
    }

    /// Returns the next cycles; empty at the end or after a stop.
    Portion take(Judge& judge) {
        const std::scoped_lock lock(m_mutex);
        if (m_best.best()) {
            judge.offer(*m_best.best());
        }
        Portion portion;
        portion.number = m_portions;
        GridCycle next = m_handed;
        while (!m_exhausted && portion.cycles.size() < portionSize
               && !m_options.stop.stop_requested()) {
            if (!m_grid.next(next)) {
                m_exhausted = true;
                break;
            }
            m_handed = next;
            portion.cycles.push_back(next);
        }
        m_portions += portion.cycles.empty() ? 0 : 1;
        return portion;
    }

    const Project& m_project;
    const Grid& m_grid;
    const SearchOptions& m_options;
    std::mutex m_mutex; ///< guards the following members
    Judge m_best;
    GridCycle m_handed;                  ///< the last handed out
    GridCycle m_last;                    ///< the last counted
    std::map<long long, Portion> m_done; ///< returned, but not counted yet
    long long m_portions = 0, m_counted = 0;
    bool m_exhausted = false, m_cutShort = false;
};

SearchSummary fullSearch(const Project& project, const Grid& grid, const SearchOptions& options) {
    return FullSearch(project, grid, options).run();
}

SearchSummary search(const Project& project, const Grid& grid, const SearchOptions& options) {
    switch (options.method) {
    case SearchMethod::full: return fullSearch(project, grid, options);
    case SearchMethod::published: return publishedProgramming(project, grid, options);
    case SearchMethod::labels: return labelSetting(project, grid, options);
    case SearchMethod::pruned: break;
    }
    return prunedSearch(project, grid, options);
}

/// Searches variant by variant and combines the results.
class VariantSearch {
public:
    VariantSearch(const Project& project, const SearchOptions& options)
        : m_project(project)
        , m_variants(project, options.stop)
        , m_options(options)
        , m_own(options) {
        const Grace grace(options.stop);
        m_unprepared = m_variants.isCutShort();
        for (std::size_t v = 0; v < m_variants.count() && !m_unprepared; ++v) {
            m_unprepared = grace.isOver();
            if (m_variants.grid(v).fault() == GridFault::none) {
                m_order.emplace_back(leastTime_s(m_variants.project(v), m_variants.grid(v)), v);
            }
        }
        if (options.method != SearchMethod::full) { // a resumed search continues there
            std::sort(m_order.begin(), m_order.end());
        }
        if (options.resume) {
            std::erase_if(m_order,
                          [&](const auto& each) { return each.second < options.resume->variant; });
            m_own.incumbent = options.resume->best;
        }
        if (options.onProgress) {
            m_own.onProgress = [this](const SearchProgress& progress) { note(progress); };
        }
    }

    SearchSummary run() {
        if (m_unprepared) {
            SearchSummary none;
            none.status = SearchStatus::stopped;
            none.gridSize = gridSize(m_project);
            return none;
        }
        m_sum.bound_s = std::numeric_limits<double>::infinity();
        m_size = static_cast<double>(m_variants.size());
        for (m_at = 0; m_at < m_order.size(); ++m_at) {
            searchVariant(m_order[m_at].second);
            if (m_sum.status == SearchStatus::stopped) {
                break;
            }
        }
        finish();
        return m_sum;
    }

private:
    /// Least time of a cycle of the variants after the current one.
    [[nodiscard]] double restBound_s() const {
        double least_s = std::numeric_limits<double>::infinity();
        for (std::size_t i = m_at + 1; i < m_order.size(); ++i) {
            least_s = std::min(least_s, m_order[i].first);
        }
        return least_s;
    }

    void note(const SearchProgress& progress) const {
        SearchProgress all = progress;
        all.bound_s = std::min({progress.bound_s, m_sum.bound_s, restBound_s()});
        all.evaluations += m_sum.evaluations;
        if (m_options.method == SearchMethod::full) {
            all.share = static_cast<double>(all.evaluations) / m_size;
        }
        if (all.checkpoint) {
            addBefore(*all.checkpoint);
        }
        m_options.onProgress(all);
    }

    /// Adds the counts of the earlier variants.
    void addBefore(SearchCheckpoint& checkpoint) const {
        checkpoint.evaluations += m_sum.evaluations;
        checkpoint.visits += m_sum.visits;
        for (std::size_t kind = 0; kind < checkpoint.cuts.size(); ++kind) {
            checkpoint.cuts[kind] += m_sum.cuts[kind];
        }
    }

    void searchVariant(std::size_t variant) {
        m_own.variant = variant;
        const bool resumed = m_options.resume && m_options.resume->variant == variant;
        m_own.resume = resumed ? m_options.resume : std::nullopt;
        const MachineSettings machine = machineSettings(m_variants.project(variant));
        for (Project& scenario : m_own.scenarios) {
            setMachine(scenario, machine);
        }
        for (PhaseCase& each : m_own.cases) {
            setMachine(each.part, machine);
        }
        const SearchSummary found =
            search(m_variants.project(variant), m_variants.grid(variant), m_own);
        m_own.incumbent = found.best;
        m_sum.best = found.best;
        m_sum.checkpoint = found.checkpoint;
        addBefore(m_sum.checkpoint);
        m_sum.evaluations += found.evaluations;
        m_sum.visits += found.visits;
        for (std::size_t kind = 0; kind < found.cuts.size(); ++kind) {
            m_sum.cuts[kind] += found.cuts[kind];
        }
        for (const Project& scenario : found.added) {
            m_own.scenarios.push_back(scenario);
            m_sum.added.push_back(scenario);
        }
        for (const PhaseCase& each : found.addedCases) {
            m_own.cases.push_back(each);
            m_sum.addedCases.push_back(each);
        }
        m_sum.isStale = found.isStale;
        m_sum.status = found.status;
        const bool none = found.status == SearchStatus::infeasible && !found.best;
        m_sum.bound_s = none ? m_sum.bound_s : std::min(m_sum.bound_s, found.bound_s);
    }

    void finish() {
        if (m_options.marginWithin_us) {
            m_sum.bound_s = 0;
        } else if (m_sum.status == SearchStatus::stopped) {
            m_sum.bound_s = std::min(m_sum.bound_s, restBound_s());
        } else if (m_sum.best && !isHeuristic(m_options.method)) {
            m_sum.bound_s = m_sum.best->time_s;
        }
        m_sum.bound_s = m_sum.bound_s < 1e300 ? m_sum.bound_s : 0;
        if (m_sum.best) {
            m_sum.cycle = m_variants.grid(m_sum.best->variant).cycle(m_sum.best->cycle);
            m_sum.machine = machineSettings(m_variants.project(m_sum.best->variant));
        }
        m_sum.gridSize = m_variants.size();
    }

    const Project& m_project;
    Variants m_variants;
    const SearchOptions& m_options;
    SearchOptions m_own;                                 ///< options for the variants
    std::vector<std::pair<double, std::size_t>> m_order; ///< least time [s] and variant
    bool m_unprepared = false;                           ///< stopped before the search
    std::size_t m_at = 0;
    double m_size = 0;
    SearchSummary m_sum;
};

SearchSummary searchOnce(const Project& project, const SearchOptions& options) {
    return options.journal ? options.journal->search(project, options)
                           : searchVariants(project, options);
}

/// The quickest cycle whose margin equals the greatest one, which was found.
SearchSummary quickestOfMargin(const Project& project, const SearchOptions& options,
                               const SearchSummary& widest) {
    SearchOptions search = options;
    search.marginWithin_us.reset();
    search.resume.reset();
    search.incumbent = widest.best;
    search.beyondMargin = widest.best->leastRelativeMargin - equalMargins;
    if (options.onProgress) {
        search.onProgress = [&](SearchProgress progress) {
            progress.bound_s = 0;
            progress.evaluations += widest.evaluations;
            progress.share = 1;
            progress.checkpoint.reset(); // only the first search can be resumed
            options.onProgress(progress);
        };
    }
    SearchSummary found = searchOnce(project, search);
    found.bound_s = 0;
    found.evaluations += widest.evaluations;
    found.visits += widest.visits;
    for (std::size_t kind = 0; kind < found.cuts.size(); ++kind) {
        found.cuts[kind] += widest.cuts[kind];
    }
    found.checkpoint = widest.checkpoint;
    return found;
}

} // namespace

std::optional<std::int64_t> marginWithinOf(const Project& project) {
    const auto within_min =
        project.optimisation ? project.optimisation->margin_within_min : std::nullopt;
    return within_min ? std::optional(comparedTime_us(*within_min * units::secondsPerMinute))
                      : std::nullopt;
}

SearchSummary searchVariants(const Project& project, const SearchOptions& options) {
    return VariantSearch(project, options).run();
}

SearchSummary optimise(const Project& project, const SearchOptions& options) {
    const SearchSummary found = searchOnce(project, options);
    return options.marginWithin_us && found.best && found.status == SearchStatus::proved
               ? quickestOfMargin(project, options, found)
               : found;
}

Project withBest(Project project, const SearchSummary& summary) {
    setMachine(project, summary.machine);
    *project.cycle = summary.cycle;
    return project;
}

} // namespace sparkout
