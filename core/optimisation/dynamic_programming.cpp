// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/dynamic_programming.h"

#include "core/optimisation/judge.h"
#include "core/optimisation/stage_runs.h"
#include "core/project/optimisation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

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

} // namespace

SearchSummary publishedProgramming(const Project& project, const Grid& grid,
                                   const SearchOptions& options) {
    return searchLabels(project, grid, options, LabelRule::quickest);
}

SearchSummary labelSetting(const Project& project, const Grid& grid, const SearchOptions& options) {
    return searchLabels(project, grid, options, LabelRule::notDominated);
}

} // namespace sparkout
