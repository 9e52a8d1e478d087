// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/stage_runs.h"

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

} // namespace sparkout
