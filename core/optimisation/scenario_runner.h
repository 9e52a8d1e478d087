// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/stage_runs.h"

#include <map>
#include <memory>
#include <optional>

namespace sparkout {

/// Runs cycles of a grid on another part, in any order. Under gauge control the stages that cycles
/// begin with alike are run once, as the pruned search does (see there), and a last stage is not
/// run when LastStageOutlook tells that it cuts too deep.
class ScenarioRunner {
public:
    ScenarioRunner(const Project& scenario, const Grid& grid);
    ScenarioRunner(const ScenarioRunner&) = delete; // the runs refer to the runner's cuts
    ScenarioRunner& operator=(const ScenarioRunner&) = delete;

    /// Whether a cycle is told to break a requirement before its last stage is run. Position
    /// control: never.
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

    const CyclePrefix& prefix(const GridCycle& cycle, std::size_t stages, SearchCounts& counts);
    [[nodiscard]] CyclePrefix goOn(const CyclePrefix& before, const GridCycle& wanted,
                                   const Prefixes& known, SearchCounts& counts) const;

    CycleRunner m_runner;
    StageRuns m_runs;
    std::vector<Prefixes> m_known; ///< by number of stages of the whole cycle
    std::size_t m_kept = 0;
};

} // namespace sparkout
