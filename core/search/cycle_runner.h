// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/search/optimise.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/run.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// Cuts a cycle before its end when its passes have violated a requirement. The nearness to
/// burning, the largest power and the largest depth only grow, so a violation is final. A cycle is
/// cut only where the excess is greater than the error of the check; other cycles are left to the
/// evaluation after their end. Where a margin is demanded, the limit of a power is lower by it, and
/// that of a diameter lies within the tolerance by that share of its width: both only approach
/// them.
class PassCuts {
public:
    explicit PassCuts(const Project& project);
    /// Allows cutting cycles with a smaller relative margin from now on.
    void demandMargin(double least);
    /// Returns the requirement broken after a step of a stage, counted from 0.
    [[nodiscard]] std::optional<ConstraintKind> broken(const Run& run, std::size_t stage) const;

    /// Returns the requirement violated by a diameter at the end of a cycle, outside the drawing's
    /// tolerance by more than rounding. Most cycles fail by it; it is found without evaluating the
    /// whole result.
    [[nodiscard]] std::optional<ConstraintKind> brokenAtEnd(const Run& run) const;
    /// Returns whether a deviation of a diameter [mm] is beyond the end of the tolerance that
    /// cutting approaches.
    [[nodiscard]] bool isTooDeep(double deviation_mm) const { return left_mm(deviation_mm) < 0; }
    /// Returns the amount by which a diameter of this deviation may still be reduced, in a bore
    /// enlarged [mm].
    [[nodiscard]] double left_mm(double deviation_mm) const {
        return m_isBore ? m_most_mm - deviation_mm : deviation_mm - m_least_mm;
    }
    [[nodiscard]] ConstraintKind tooDeep() const {
        return m_isBore ? ConstraintKind::diameterMax : ConstraintKind::diameterMin;
    }

private:
    std::size_t m_points;         ///< number of points whose diameters count
    double m_low_mm, m_high_mm;   ///< ends of the tolerance
    double m_least_mm, m_most_mm; ///< ends of the deviations
    bool m_isBore;
    std::vector<std::pair<ConstraintKind, PassBound>> m_bounds;
    std::vector<double> m_most; ///< greatest values by bound, for the demanded margin
};

inline constexpr std::int64_t noTime_us = std::numeric_limits<std::int64_t>::max();

/// Rounds a time to the whole microseconds by which cycles are compared.
[[nodiscard]] std::int64_t comparedTime_us(double time_s);
[[nodiscard]] inline double seconds(std::int64_t time_us) {
    return static_cast<double>(time_us) * 1e-6;
}

/// Returns whether a stage made no step because its stock was removed before it began.
[[nodiscard]] inline bool hasIdleStage(const SimulationResult& result) {
    return std::find(result.countsByStage.begin(), result.countsByStage.end(), 0)
           != result.countsByStage.end();
}

/// Returns the infeed of a full step of a stage with this setting.
[[nodiscard]] StepFeed stepFeedOf(const Project& project, const StageSetting& setting,
                                  std::size_t stage);

/// Totals that a search keeps besides the best cycle.
struct SearchCounts {
    long long evaluations = 0, visits = 0;
    std::array<long long, constraintKinds> cuts{};
    void add(const SearchCounts& other);
};

/// Runs the cycles of a grid on one part, each from the blank and with the passes of simulate().
/// Blank and limits, which do not depend on the cycle, are computed once.
class CycleRunner {
public:
    /// The project is that of the grid or another state of its part. A stop ends a run, within one
    /// radius where sections deflect each other; the result must then be discarded.
    CycleRunner(const Project& project, const Grid& grid, const std::stop_token& stop);

    /// Runs a cycle to its end with the result of simulate(). Returns nullopt if the run was cut:
    /// it was slower than `slowest_us`, or its passes or diameters violated a requirement, which
    /// then counts as cut.
    [[nodiscard]] std::optional<SimulationResult>
    run(const GridCycle& cycle, std::int64_t slowest_us, SearchCounts& counts);
    /// Returns the initial state of a cycle with this number of stages, to be copied.
    [[nodiscard]] std::shared_ptr<const CycleSteps> begin(std::size_t stages) const;
    /// Computes the result of a run of this cycle that began with a copy of begin().
    [[nodiscard]] SimulationResult finish(const GridCycle& cycle, CycleSteps& steps,
                                          const std::vector<int>& stepsByStage);
    [[nodiscard]] const PassCuts& cuts() const { return m_cuts; }
    /// From now on cycles with a smaller relative margin may be cut.
    void demandMargin(double least) { m_cuts.demandMargin(least); }
    [[nodiscard]] bool isGauged() const { return m_gauged; }

private:
    /// The steps refer to the project; its cycle is set when they finish.
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
