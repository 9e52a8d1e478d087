// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/pruned_search.h"

#include "core/optimisation/judge.h"
#include "core/optimisation/time_bound.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <queue>
#include <utility>

namespace sparkout {

namespace {

/// A cycle up to the end of a stage.
struct Prefix {
    std::shared_ptr<const CycleSteps> steps;
    std::size_t stages = 0; ///< of the whole cycle
    GridCycle cycle;        ///< so far
    std::vector<int> counts;
    int taken = 0;  ///< steps of stock
    int merged = 0; ///< further ends of its last stage on the same step
    std::vector<std::pair<double, std::size_t>> next; ///< bound [s] and setting, by bound
};
using PrefixPtr = std::shared_ptr<const Prefix>;

struct Branch {
    double bound_s = 0;
    long long order = 0; ///< among equal bounds the newest first: deeper
    PrefixPtr prefix;
    std::size_t index = 0; ///< in the prefix's next settings
    friend bool operator<(const Branch& a, const Branch& b) {
        return a.bound_s != b.bound_s ? a.bound_s > b.bound_s : a.order < b.order;
    }
};

/// What a prefix takes in memory, about.
std::size_t prefixBytes(const Project& project, const Grid& grid) {
    constexpr std::size_t numbersPerLane = 12, rest = 4096;
    const int sections = project.operation == Operation::traverse ? 3 : project.sections + 1;
    const auto lanes = static_cast<std::size_t>(sections * project.part.radii_per_section);
    return lanes * numbersPerLane * sizeof(double)
           + grid.settings().size() * sizeof(std::pair<double, std::size_t>) + rest;
}

class PrunedSearch {
public:
    PrunedSearch(const Project& project, const Grid& grid, const SearchOptions& options)
        : m_grid(grid)
        , m_options(options)
        , m_judge(grid, options.scenarios)
        , m_runner(project, grid)
        , m_total(makeBlank(project.part).totalInfeed_mm)
        , m_bound(project, grid, m_total)
        , m_gauge(project.gauge.control == Control::gauge)
        , m_most(options.memory_bytes / prefixBytes(project, grid)) {}

    SearchSummary run() {
        begin();
        SearchSummary summary;
        while (const auto branch = take()) {
            if (m_options.stop.stop_requested()) {
                summary.status = SearchStatus::stopped;
                break;
            }
            push(branch->prefix, branch->index + 1);
            explore(*branch->prefix, branch->prefix->next[branch->index].second, branch->bound_s);
            if (m_options.onProgress) {
                m_options.onProgress({m_judge.best(), m_least_s, m_judge.counts.evaluations, 0});
            }
        }
        summary.bound_s = m_least_s;
        summary.best = m_judge.best();
        if (summary.status != SearchStatus::stopped && summary.best) {
            summary.status = SearchStatus::proved;
            summary.bound_s = static_cast<double>(summary.best->time_us) * 1e-6;
        }
        summary.evaluations = m_judge.counts.evaluations;
        summary.visits = m_judge.counts.visits;
        summary.cuts = m_judge.counts.cuts;
        return summary;
    }

private:
    [[nodiscard]] bool isSlower(double least_s) const {
        return std::floor(least_s * (1 - 1e-12) * 1e6 - 1)
               > static_cast<double>(m_judge.bestTime_us());
    }

    void begin() {
        for (const std::size_t stages : m_grid.stageCounts()) {
            seed(stages);
            Prefix root;
            root.steps = m_runner.begin(stages);
            root.stages = stages;
            add(std::move(root), 0);
        }
    }

    /// A first answer to prune by: the quickest feasible cycle with the same feeds in all stages.
    void seed(std::size_t stages) {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t s = 0; s < m_grid.settings().size(); ++s) {
            order.emplace_back(m_bound.rest_s(s, 0, 0, true), s);
        }
        std::sort(order.begin(), order.end());
        for (const auto& [bound_s, setting] : order) {
            if (isSlower(bound_s) || m_options.stop.stop_requested()) {
                return;
            }
            GridCycle cycle(stages, {setting, 1});
            cycle.back().steps = 0;
            if (stages > 1) {
                cycle[stages - 2].steps = m_grid.leastOf(2, static_cast<int>(stages) - 2);
            }
            if (m_judge.decide(cycle, m_runner)) {
                return;
            }
        }
    }

    /// Steps of stock that are taken at least and at most behind the next stage of a prefix.
    [[nodiscard]] int leastTaken(const Prefix& prefix) const {
        return prefix.taken + m_grid.leastOf(prefix.stages - prefix.cycle.size(), prefix.taken);
    }
    [[nodiscard]] int mostTaken(const Prefix& prefix) const {
        return m_grid.mostSteps() - static_cast<int>(prefix.stages - prefix.cycle.size()) + 2;
    }
    [[nodiscard]] static bool isLast(const Prefix& prefix) {
        return prefix.cycle.size() + 1 == prefix.stages;
    }
    /// Least time of all cycles that go on with this setting.
    [[nodiscard]] double boundOf(const Prefix& prefix, const Run& run, std::size_t setting,
                                 int taken) const {
        return run.time_s() * (1 - 1e-12)
               + m_bound.rest_s(setting, run.fed_mm, m_grid.remainder(taken), isLast(prefix));
    }

    void add(Prefix prefix, double least_s) {
        for (std::size_t s = 0; s < m_grid.settings().size(); ++s) {
            if (!prefix.cycle.empty() && !m_grid.mayFollow(prefix.cycle.back().setting, s)) {
                continue;
            }
            const double bound_s =
                std::max(least_s, boundOf(prefix, prefix.steps->run(), s, leastTaken(prefix)));
            if (!isSlower(bound_s)) {
                prefix.next.emplace_back(bound_s, s);
            }
        }
        std::sort(prefix.next.begin(), prefix.next.end());
        push(std::make_shared<const Prefix>(std::move(prefix)), 0);
    }

    // Each prefix that is kept has one branch. When there are too many the newest is taken first,
    // depth first, which keeps few; its bound is not below that of the branch it came from.
    void push(const PrefixPtr& prefix, std::size_t index) {
        if (index < prefix->next.size() && !isSlower(prefix->next[index].first)) {
            Branch branch{prefix->next[index].first, ++m_order, prefix, index};
            if (m_branches.size() < m_most) {
                m_branches.push(std::move(branch));
            } else {
                m_newest.push_back(std::move(branch));
            }
        }
    }

    std::optional<Branch> take() {
        while (!m_newest.empty()) {
            const Branch branch = std::move(m_newest.back());
            m_newest.pop_back();
            if (!isSlower(branch.bound_s)) {
                return branch;
            }
        }
        if (m_branches.empty() || isSlower(m_branches.top().bound_s)) {
            return std::nullopt;
        }
        Branch branch = m_branches.top();
        m_branches.pop();
        m_least_s = std::max(m_least_s, branch.bound_s);
        return branch;
    }

    void explore(const Prefix& from, std::size_t setting, double least_s) {
        if (isLast(from)) {
            runStage(from, setting, {0, 0}, least_s);
        } else if (m_gauge) {
            runStage(from, setting, {leastTaken(from), mostTaken(from)}, least_s);
        } else {
            for (int taken = leastTaken(from); taken <= mostTaken(from); ++taken) {
                runStage(from, setting, {taken, taken}, least_s);
            }
        }
    }

    /// Steps of stock behind a stage, from the first end on to the last.
    struct Ends {
        int taken = 0, last = 0;
    };

    /// Runs the next stage until its last end, and goes on from each end.
    void runStage(const Prefix& from, std::size_t setting, Ends ends, double least_s) {
        const std::unique_ptr<CycleSteps> steps = from.steps->copy();
        Run& run = steps->run();
        const long long visitsBefore = run.visits();
        const std::size_t stage = from.cycle.size();
        int count = 0;
        const bool begun =
            std::any_of(from.counts.begin(), from.counts.end(), [](int each) { return each > 0; });
        while (true) {
            if (begun || count > 0) {
                takeEnds(from, setting, *steps, count, ends, least_s);
            }
            if (ends.taken > ends.last || isSlower(boundOf(from, run, setting, ends.taken))
                || run.mustEnd()
                || !steps->step({nextInfeed(isLast(from), setting, run.fed_mm, ends.taken), stage,
                                 m_grid.settings()[setting].axialFeed_mm_min})) {
                break;
            }
            ++count;
            if (const auto kind = m_runner.cuts().broken(run, stage)) {
                ++m_judge.counts.cuts[static_cast<std::size_t>(*kind)];
                break;
            }
        }
        m_judge.counts.visits += run.visits() - visitsBefore;
    }

    [[nodiscard]] double later(bool last, int taken) const {
        return last ? 0 : m_grid.remainder(taken);
    }

    [[nodiscard]] double nextInfeed(bool last, std::size_t setting, double fed_mm,
                                    int taken) const {
        const double infeed = m_bound.infeed_mm(setting);
        return m_gauge ? infeed : std::clamp(m_total - later(last, taken) - fed_mm, 0.0, infeed);
    }

    [[nodiscard]] bool ended(const CycleSteps& steps, double later_mm) const {
        return m_gauge ? steps.remaining() <= later_mm + stageSlack_mm
                       : steps.run().fed_mm >= m_total - later_mm - stageSlack_mm;
    }

    /// The ends that the state after a step has reached.
    void takeEnds(const Prefix& from, std::size_t setting, const CycleSteps& steps, int count,
                  Ends& ends, double least_s) {
        const int first = ends.taken;
        while (ends.taken <= ends.last && ended(steps, later(isLast(from), ends.taken))) {
            ++ends.taken;
        }
        const bool single = !m_options.scenarios.empty() && from.cycle.size() + 2 != from.stages;
        for (int taken = first; taken < ends.taken; ++taken) {
            end(from, setting, steps, count, {taken, single ? taken : ends.taken - 1}, least_s);
            if (!single) {
                break;
            }
        }
    }

    /// Goes on from ends that fall on one step.
    void end(const Prefix& from, std::size_t setting, const CycleSteps& steps, int count,
             Ends merged, double least_s) {
        Prefix prefix;
        prefix.stages = from.stages;
        prefix.cycle = from.cycle;
        prefix.counts = from.counts;
        prefix.counts.push_back(count);
        prefix.cycle.push_back({setting, isLast(from) ? 0 : merged.taken - from.taken});
        prefix.taken = merged.taken;
        prefix.merged = isLast(from) ? from.merged : merged.last - merged.taken;
        if (!isLast(from)) {
            prefix.steps = steps.copy();
            add(std::move(prefix), least_s);
        } else if (comparedTime_us(steps.run().time_s()) <= m_judge.bestTime_us()) {
            if (m_gauge) {
                m_judge.judge(prefix.cycle, m_runner.finish(prefix.cycle, steps, prefix.counts),
                              prefix.merged);
            } else {
                m_judge.decide(prefix.cycle, m_runner);
            }
        }
    }

    const Grid& m_grid;
    const SearchOptions& m_options;
    Judge m_judge;
    CycleRunner m_runner;
    double m_total; ///< |R_first − R_t| [mm]
    TimeBound m_bound;
    bool m_gauge;
    std::priority_queue<Branch> m_branches;
    std::vector<Branch> m_newest; ///< beyond the most branches in order
    std::size_t m_most;
    long long m_order = 0;
    double m_least_s = 0; ///< no cycle that is left is quicker
};

} // namespace

SearchSummary prunedSearch(const Project& project, const Grid& grid, const SearchOptions& options) {
    return PrunedSearch(project, grid, options).run();
}

} // namespace sparkout
