// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/case_refuter.h"
#include "core/search/stage_runs.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

/// Runs cycles of a grid on another part, in any order. Under gauge control the common first stages
/// of cycles are run once, as in the pruned search (see there), as far as memory allows, and a last
/// stage is not run when LastStageBound proves that it cuts too deep.
class ScenarioRunner {
public:
    /// @param memory_bytes  approximate memory for first stages; 0: each cycle is run from the
    /// blank
    ScenarioRunner(const Project& scenario, const Grid& grid, std::size_t memory_bytes,
                   const std::stop_token& stop);
    ScenarioRunner(const ScenarioRunner&) = delete; // the runs refer to the runner's cuts
    ScenarioRunner& operator=(const ScenarioRunner&) = delete;

    /// Allows cutting cycles with a smaller relative margin from now on; `least` must not fall.
    void demandMargin(double least) { m_runner.demandMargin(least); }

    /// Returns whether a cycle is shown to break a requirement before its last stage is run.
    [[nodiscard]] bool refutes(const GridCycle& cycle, SearchCounts& counts);
    /// Returns the result of simulate() for a cycle; nullopt if its passes or diameters violate a
    /// requirement, which then counts as cut, or if it does not end.
    [[nodiscard]] std::optional<SimulationResult> run(const GridCycle& cycle, SearchCounts& counts);

private:
    struct Before {
        bool operator()(const GridCycle& a, const GridCycle& b) const;
    };
    /// Prefixes of cycles; one without steps does not end or violates a requirement.
    using Prefixes = std::map<GridCycle, CyclePrefix, Before>;

    /// Returns the prefix of a cycle before its last stage; null if the cycle is refuted.
    const CyclePrefix* unrefutedPrefix(const GridCycle& cycle, SearchCounts& counts);
    const CyclePrefix& prefix(const GridCycle& cycle, std::size_t stages, SearchCounts& counts);
    [[nodiscard]] CyclePrefix extend(const CyclePrefix& before, const GridCycle& wanted,
                                     const Prefixes& known, SearchCounts& counts) const;

    CycleRunner m_runner;
    std::optional<StageRuns> m_runs; ///< none: each cycle is run from the blank
    std::map<std::pair<std::size_t, std::size_t>, Prefixes>
        m_known; ///< by numbers of stages, of the cycle and of the prefix
    std::size_t m_kept = 0, m_mostKept = 0;
};

/// Returns whether feasible cycle a of a project is better than b; `grid` is that of their variant
/// where both have the same.
[[nodiscard]] bool isBetter(const FeasibleCycle& a, const FeasibleCycle& b, const Grid& grid,
                            SearchAim aim = SearchAim::leastTime);

/// Decides on cycles by simulating them, and keeps the best one.
class Judge {
public:
    Judge(const Grid& grid, const SearchOptions& options);

    /// Judges a cycle of the grid by its run, and on the scenarios if it can be the best. `merged`
    /// further cycles, each with one more stock step in the stage before the last, have the same
    /// run on the part itself. Returns true when the cycle is the best or awaits its challenge.
    bool judge(const GridCycle& cycle, const SimulationResult& result, int merged = 0);
    /// Runs and judges a cycle. An evaluation that was stopped before the decision is not counted.
    bool decide(const GridCycle& cycle, CycleRunner& runner);
    /// Judges a cycle whose steps are done; under position control it is run again as the project
    /// states it.
    void decideDone(const CyclePrefix& whole, CycleSteps& steps, CycleRunner& runner,
                    int merged = 0);
    /// Returns whether a cycle and each of the `merged` further ones is refuted by a scenario or a
    /// case before its last stage is run; refuted cycles count as evaluated.
    bool isRefuted(GridCycle cycle, int merged);
    /// Keeps only those settings of a last stage with which a cycle that begins like this, and each
    /// of the `merged` further ones, is refuted by a case without following a radius.
    void keepRefuted(GridCycle beforeLast, int merged, std::vector<std::size_t>& settings);
    /// Challenges, the best first, the waiting cycles that take at most `time_s` [s] and would be
    /// the best. A stop ends it.
    void challengeWaiting(double time_s);
    /// Least time [s] of the waiting cycles.
    [[nodiscard]] double leastWaiting_s() const;
    /// Takes a cycle that was found elsewhere if it is the best; returns whether it is.
    bool offer(const FeasibleCycle& found);

    void cut(ConstraintKind kind) {
        ++counts.evaluations;
        ++counts.cuts[static_cast<std::size_t>(kind)];
    }

    [[nodiscard]] const std::optional<FeasibleCycle>& best() const { return m_best; }
    [[nodiscard]] std::int64_t bestTime_us() const { return m_best ? m_best->time_us : noTime_us; }
    /// Greatest time of a cycle that can be better than the best one.
    [[nodiscard]] std::int64_t mostTime_us() const {
        return m_options.marginWithin_us.value_or(bestTime_us());
    }
    /// Least relative margin of a cycle that can be better than the best one; −∞: any feasible one
    /// may be.
    [[nodiscard]] double demandedMargin() const;
    /// Scenarios and cases that challenges added, and whether the best cycle failed in one of them.
    [[nodiscard]] const std::vector<Project>& added() const { return m_added; }
    [[nodiscard]] const std::vector<PhaseCase>& addedCases() const { return m_addedCases; }
    [[nodiscard]] bool isStale() const { return m_stale; }
    SearchCounts counts;

private:
    [[nodiscard]] std::unique_ptr<ScenarioRunner> runner(const Project& scenario,
                                                         std::size_t among) const;
    void add(const PhaseCase& of);
    bool isRefutedByCase(const GridCycle& cycle);
    bool isCycleRefuted(const GridCycle& cycle);
    /// Returns whether a cycle is feasible in the scenarios, and sets its margin to the least one.
    bool holdsOnScenarios(FeasibleCycle& found);
    /// Returns whether a cycle that would be the best is fit for the further parts.
    bool holdsOnAll(FeasibleCycle& found);
    void demandMargin();
    [[nodiscard]] bool isRejected(const FeasibleCycle& found) const;
    bool isChallenged(const FeasibleCycle& found);
    void put(const FeasibleCycle& found);
    /// Returns the least relative margin; nullopt if a requirement is not met.
    std::optional<double> leastMargin(const SimulationResult& result);
    /// Returns the least margin over the part, which is given, and the scenarios.
    std::optional<double> leastMargin(const GridCycle& cycle, double margin);

    const Grid& m_grid;
    const SearchOptions& m_options;
    std::vector<std::unique_ptr<ScenarioRunner>> m_scenarios; ///< the last one with a failure first
    std::vector<std::unique_ptr<CaseRefuter>> m_cases;        ///< likewise
    std::optional<FeasibleCycle> m_best;
    /// Cycles that await their challenge, with the margins of their last check, which only fall,
    /// and cycles with the best one's time, which become better when its margin falls.
    std::vector<FeasibleCycle> m_waiting;
    bool m_beatOther = false; ///< a replaced best cycle had the same time and another variant
    std::vector<Project> m_added;
    std::vector<PhaseCase> m_addedCases;
    bool m_stale = false;
};

} // namespace sparkout
