// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"
#include "core/optimisation/pass_cuts.h"
#include "core/simulation/cycle_steps.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

inline constexpr std::int64_t noTime_us = std::numeric_limits<std::int64_t>::max();

/// The time that cycles are compared by.
[[nodiscard]] std::int64_t comparedTime_us(double time_s);
[[nodiscard]] inline double seconds(std::int64_t time_us) {
    return static_cast<double>(time_us) * 1e-6;
}

/// Whether a stage made no step, as its stock was gone before it began.
[[nodiscard]] inline bool hasIdleStage(const SimulationResult& result) {
    return std::find(result.countsByStage.begin(), result.countsByStage.end(), 0)
           != result.countsByStage.end();
}

/// What a step of a stage with this setting feeds, unless it is cut short.
[[nodiscard]] StepFeed stepFeedOf(const Project& project, const StageSetting& setting,
                                  std::size_t stage);

/// What a search adds up beside the best cycle.
struct SearchCounts {
    long long evaluations = 0, visits = 0;
    std::array<long long, constraintKinds> cuts{};
    void add(const SearchCounts& other);
};

/// Runs the cycles of a grid on one part, each from the blank and with the passes of simulate().
/// What does not depend on the cycle (blank, limits) is made once.
class CycleRunner {
public:
    /// The project of the grid, or another state of its part. A stop ends its runs, within one
    /// radius where sections deflect each other; what comes of them then is no decision.
    CycleRunner(const Project& project, const Grid& grid, const std::stop_token& stop);

    /// A cycle at the end of which all is as simulate() has it; nothing when it was stopped: slower
    /// than `slowest_us`, or its passes or diameters break a requirement, which then counts as cut.
    [[nodiscard]] std::optional<SimulationResult>
    run(const GridCycle& cycle, std::int64_t slowest_us, SearchCounts& counts);
    /// The steps of a cycle with so many stages before the first, to copy.
    [[nodiscard]] std::shared_ptr<const CycleSteps> begin(std::size_t stages) const;
    /// Closes the books of a run of this cycle, begun by a copy of begin().
    [[nodiscard]] SimulationResult finish(const GridCycle& cycle, CycleSteps& steps,
                                          const std::vector<int>& stepsByStage);
    [[nodiscard]] const PassCuts& cuts() const { return m_cuts; }
    /// Cycles with less of a relative margin may be cut from now on.
    void demandMargin(double least) { m_cuts.demandMargin(least); }
    [[nodiscard]] bool isGauged() const { return m_gauged; }

private:
    /// The steps refer to the project, whose cycle is put in place when they finish.
    struct Start {
        std::unique_ptr<Project> project;
        std::shared_ptr<const CycleSteps> steps;
    };

    const Grid* m_grid;
    PassCuts m_cuts;
    bool m_gauged;
    std::vector<Start> m_starts; ///< by number of stages
};

} // namespace sparkout
