// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/cycle_runner.h"
#include "core/search/last_stage_bound.h"
#include "core/search/time_bound.h"
#include "core/simulation/stage_control.h"

#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace sparkout {

/// A prefix: a cycle up to the end of a stage.
struct CyclePrefix {
    std::shared_ptr<const CycleSteps> steps; ///< kept state to extend
    int since = 0;                 ///< number of last steps that must be repeated from that state
    double time_s = 0, fed_mm = 0; ///< after all its steps
    FollowedRadii critical;        ///< also after all its steps; critical radii of a last stage
    std::size_t stages = 0;        ///< number of stages of the whole cycle
    GridCycle cycle;               ///< the finished stages
    std::vector<int> counts;       ///< steps of each stage
    int taken = 0;                 ///< steps of stock taken
    int running = 0;               ///< number of steps already made of the next stage
    std::optional<GaugeSignal> signal; ///< readings of these steps; not given: no step was made
    /// Keeps the state after its steps.
    void keep(std::shared_ptr<const CycleSteps> done);
    /// Records the values after its steps by which the next stages are bounded.
    void recordState(const CycleSteps& done);
    [[nodiscard]] bool isBeforeLast() const { return cycle.size() + 1 == stages; }
    [[nodiscard]] int stepCount() const { return std::accumulate(counts.begin(), counts.end(), 0); }
    [[nodiscard]] bool hasSteps() const { return stepCount() > 0; }
};

/// Returns the approximate memory of the state of a prefix [bytes].
[[nodiscard]] std::size_t prefixBytes(const Project& project);

/// Extends prefixes by one stage, through all ends that the grid allows.
class StageRuns {
public:
    /// Without bounds, bound_s() and bound() must not be called; making them takes time
    /// proportional to the square of the number of settings.
    enum class Bounds { no, yes };
    StageRuns(const Project& project, const Grid& grid, const CycleRunner& runner, Bounds bounds);

    /// Ends of a stage that fall on one step: steps of stock taken by its end, from `first` to
    /// `last`; both are 0 for the last stage.
    struct End {
        CycleSteps& steps; ///< those of a last stage may be finished
        int count = 0;     ///< number of steps in the stage
        int first = 0, last = 0;
        GaugeSignal signal;
    };
    /// Returns whether the run should be dropped before the end with this number of stock steps
    /// taken.
    using DropCheck = std::function<bool(const Run& run, int taken)>;
    using AtEnd = std::function<void(const End& end)>;
    /// Runs a stage: under gauge control once, under position control once for each end. A run that
    /// violates a requirement counts as cut and ends.
    void run(const CyclePrefix& from, std::size_t setting, const DropCheck& isDropped,
             const AtEnd& atEnd, SearchCounts& counts) const;
    /// Runs a stage to the end with this number of stock steps taken, with a copy of the prefix's
    /// steps; nullopt if the end is not reached.
    [[nodiscard]] std::optional<End> runTo(int taken, const CyclePrefix& from, CycleSteps& steps,
                                           std::size_t setting, SearchCounts& counts) const;
    /// Returns whether last stages can be bounded by the critical radii: under gauge control, where
    /// radii do not depend on each other.
    [[nodiscard]] bool canBoundLastStage() const { return !m_feeds.empty(); }
    /// Bounds a last stage with this setting, or its first `mostSteps` steps.
    [[nodiscard]] LastStageBound
    lastStageBound(const CyclePrefix& from, std::size_t setting,
                   int mostSteps = std::numeric_limits<int>::max()) const;
    /// Returns whether a diameter is beyond the tolerance before the last stage begins.
    [[nodiscard]] bool isTooDeep(const CyclePrefix& beforeLast) const;
    /// Returns the prefix after the stage, without its state.
    [[nodiscard]] CyclePrefix after(const CyclePrefix& from, std::size_t setting, const End& end,
                                    int taken) const;

    /// Least and greatest number of stock steps taken by the end of a prefix's next stage.
    [[nodiscard]] int leastTaken(const CyclePrefix& prefix) const;
    [[nodiscard]] int mostTaken(const CyclePrefix& prefix) const;
    /// Repeats the last `count` steps of a prefix on those before them; returns false after a stop.
    [[nodiscard]] bool repeatSteps(const CyclePrefix& prefix, CycleSteps& steps, int count) const;

    /// Returns the least time [s] of all cycles that extend the prefix with this setting, from its
    /// end or from a moment of its run. At the end of the cycle the wheel has been fed beyond the
    /// size by the lag of the gauge's deepest radius.
    [[nodiscard]] double bound_s(const CyclePrefix& prefix, std::size_t setting, int taken) const {
        return bound_s(prefix, prefix.time_s, prefix.fed_mm, setting, taken);
    }
    [[nodiscard]] double bound_s(const CyclePrefix& prefix, const Run& run, std::size_t setting,
                                 int taken) const {
        return bound_s(prefix, run.time_s(), run.fed_mm, setting, taken);
    }
    [[nodiscard]] const TimeBound& bound() const { return *m_bound; }
    [[nodiscard]] bool isGauged() const { return m_gauge; }

private:
    struct Ends {
        int taken = 0, last = 0;
    };
    void runTo(Ends ends, const CyclePrefix& from, CycleSteps& steps, std::size_t setting,
               const DropCheck& isDropped, const AtEnd& atEnd, SearchCounts& counts) const;
    [[nodiscard]] double bound_s(const CyclePrefix& prefix, double time_s, double fed_mm,
                                 std::size_t setting, int taken) const;
    [[nodiscard]] double leastLag_mm(const CyclePrefix& prefix, std::size_t setting) const;
    [[nodiscard]] double later(bool last, int taken) const;
    [[nodiscard]] StepFeed nextFeed(double later_mm, std::size_t setting, std::size_t stage,
                                    double fed_mm) const;
    [[nodiscard]] bool ended(const Run& run, const GaugeSignal& signal, double later_mm,
                             bool last) const;

    const Grid& m_grid;
    const PassCuts& m_cuts;
    std::shared_ptr<const CycleSteps> m_part; ///< initial state of the part
    double m_total;                           ///< |R_first − R_t| [mm]
    double m_fedAtSize_mm;                    ///< under position control
    std::vector<StepFeed> m_steps;            ///< by setting
    std::vector<FollowedFeed> m_feeds;        ///< by setting; empty: no radius can be followed
    std::optional<TimeBound> m_bound;
    mutable std::optional<SteadyLags> m_lags; ///< lags by setting, computed on demand
    bool m_gauge;
    GaugeSignal m_signal; ///< before the first reading
};

} // namespace sparkout
