// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/phase_outlook.h"
#include "core/optimisation/scenario_runner.h"

namespace sparkout {

/// Whether a is the better of two feasible cycles of a project, the grid that of their variant
/// where they have one.
[[nodiscard]] bool isBetter(const FeasibleCycle& a, const FeasibleCycle& b, const Grid& grid,
                            SearchAim aim = SearchAim::leastTime);

/// Decides on cycles by their simulation, and keeps the best.
class Judge {
public:
    Judge(const Grid& grid, const SearchOptions& options);

    /// A cycle of the grid as it was run, on the scenarios too if it can be the best. True: it is,
    /// or waits for its challenge. On the part itself so many further cycles, with one step of
    /// stock more in the stage before the last each, came out the same.
    bool judge(const GridCycle& cycle, const SimulationResult& result, int merged = 0);
    /// Runs and judges a cycle. Where a stop came before it was decided it does not count as an
    /// evaluation.
    bool decide(const GridCycle& cycle, CycleRunner& runner);
    /// The same of one whose steps are done; under position control it is run again as the project
    /// states it.
    void decideDone(const CyclePrefix& whole, CycleSteps& steps, CycleRunner& runner,
                    int merged = 0);
    /// Whether a cycle and each of the `merged` further ones is known to break a requirement in a
    /// scenario or for a stock of a case, before the last stage is run; then it is decided.
    bool isHopeless(GridCycle cycle, int merged);
    /// Leaves those settings of a last stage with which a cycle that begins so, and each of the
    /// `merged` further ones, is known to end too deep for a stock of a case without following it.
    void keepHopeless(GridCycle beforeLast, int merged, std::vector<std::size_t>& settings);
    /// Challenges those of the waiting cycles that take no longer than this [s] and would be the
    /// best, the best first. Not when it is to stop.
    void settle(double time_s);
    /// The least time [s] of those that wait on.
    [[nodiscard]] double leastWaiting_s() const;
    /// A best cycle found elsewhere.
    bool offer(const FeasibleCycle& found);

    /// Counts a cycle as cut before its end.
    void cut(ConstraintKind kind) {
        ++counts.evaluations;
        ++counts.cuts[static_cast<std::size_t>(kind)];
    }

    [[nodiscard]] const std::optional<FeasibleCycle>& best() const { return m_best; }
    [[nodiscard]] std::int64_t bestTime_us() const { return m_best ? m_best->time_us : noTime_us; }
    /// No cycle that takes longer can be better.
    [[nodiscard]] std::int64_t mostTime_us() const {
        return m_options.marginWithin_us.value_or(bestTime_us());
    }
    /// No cycle with a smaller relative margin can be better; −∞: any that holds may be.
    [[nodiscard]] double demandedMargin() const;
    /// Scenarios of challenges, and whether the best failed in one of them.
    [[nodiscard]] const std::vector<Project>& added() const { return m_added; }
    [[nodiscard]] const std::vector<PhaseCase>& addedCases() const { return m_addedCases; }
    [[nodiscard]] bool isStale() const { return m_stale; }
    SearchCounts counts;

private:
    [[nodiscard]] std::unique_ptr<ScenarioRunner> runner(const Project& scenario,
                                                         std::size_t among) const;
    void add(const PhaseCase& of);
    bool endsTooDeep(const GridCycle& cycle);
    bool isHopeless(const GridCycle& cycle);
    /// Whether it holds on the scenarios, its margin then the least.
    bool holdsOnScenarios(FeasibleCycle& found);
    /// The same on the further parts, as far as it is then the best.
    bool holdsOnAll(FeasibleCycle& found);
    void demandMargin();
    bool isChallenged(const FeasibleCycle& found);
    void put(const FeasibleCycle& found);
    /// The least relative margin; nothing when a requirement fails.
    std::optional<double> leastMargin(const SimulationResult& result);
    /// The same on the scenarios, from that of the part.
    std::optional<double> leastMargin(const GridCycle& cycle, double margin);

    const Grid& m_grid;
    const SearchOptions& m_options;
    std::vector<std::unique_ptr<ScenarioRunner>> m_scenarios; ///< the one that failed last first
    std::vector<std::unique_ptr<PhaseOutlook>> m_cases;       ///< likewise
    std::optional<FeasibleCycle> m_best;
    /// For their challenge, margins as when they were looked at last, which only fall; and those of
    /// the best one's time, which are better when its margin falls.
    std::vector<FeasibleCycle> m_waiting;
    bool m_beatOther = false; ///< it was of the best one's time, of another variant
    std::vector<Project> m_added;
    std::vector<PhaseCase> m_addedCases;
    bool m_stale = false;
};

} // namespace sparkout
