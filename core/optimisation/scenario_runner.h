// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/stage_runs.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

/// Runs cycles of a grid on another part, in any order. Under gauge control the stages that cycles
/// begin with alike are run once, as the pruned search does (see there), as far as there is memory
/// for them, and a last stage is not run when LastStageOutlook finds that it cuts too deep.
class ScenarioRunner {
public:
    /// @param memory_bytes  for first stages, about; 0: each cycle is run from the blank
    ScenarioRunner(const Project& scenario, const Grid& grid, std::size_t memory_bytes,
                   const std::stop_token& stop);
    ScenarioRunner(const ScenarioRunner&) = delete; // the runs refer to the runner's cuts
    ScenarioRunner& operator=(const ScenarioRunner&) = delete;

    /// Cycles with less of a relative margin may be cut from now on; it must not fall.
    void demandMargin(double least) { m_runner.demandMargin(least); }

    /// Whether a cycle is known to break a requirement before its last stage is run.
    [[nodiscard]] bool isHopeless(const GridCycle& cycle, SearchCounts& counts);
    /// A cycle as simulate() has it; nothing when its passes or diameters break a requirement,
    /// which then counts as cut, or it does not end.
    [[nodiscard]] std::optional<SimulationResult> run(const GridCycle& cycle, SearchCounts& counts);

private:
    struct Before {
        bool operator()(const GridCycle& a, const GridCycle& b) const;
    };
    /// The first stages of cycles; without steps: they do not end, or break a requirement.
    using Prefixes = std::map<GridCycle, CyclePrefix, Before>;

    /// The stages of a cycle before its last; nothing: it breaks a requirement.
    const CyclePrefix* hopeful(const GridCycle& cycle, SearchCounts& counts);
    const CyclePrefix& prefix(const GridCycle& cycle, std::size_t stages, SearchCounts& counts);
    [[nodiscard]] CyclePrefix goOn(const CyclePrefix& before, const GridCycle& wanted,
                                   const Prefixes& known, SearchCounts& counts) const;

    CycleRunner m_runner;
    std::optional<StageRuns> m_runs; ///< none: each cycle from the blank
    std::map<std::pair<std::size_t, std::size_t>, Prefixes> m_known; ///< by stages, in all and here
    std::size_t m_kept = 0, m_mostKept = 0;
};

} // namespace sparkout
