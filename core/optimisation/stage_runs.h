// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/cycle_runner.h"
#include "core/optimisation/last_stage_outlook.h"
#include "core/optimisation/steady_lag.h"
#include "core/optimisation/time_bound.h"
#include "core/simulation/gauge_signal.h"

#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace sparkout {

/// A cycle up to the end of a stage.
struct CyclePrefix {
    std::shared_ptr<const CycleSteps> steps; ///< to go on from
    int since = 0;                     ///< of its last steps that are to be made from there on
    double time_s = 0, fed_mm = 0;     ///< behind all of them
    FollowedRadii telling;             ///< likewise, of a last stage
    std::size_t stages = 0;            ///< of the whole cycle
    GridCycle cycle;                   ///< so far
    std::vector<int> counts;           ///< steps of each stage
    int taken = 0;                     ///< steps of stock
    int running = 0;                   ///< steps already made of the next stage
    std::optional<GaugeSignal> signal; ///< of these steps; none made: not given
    /// Its steps, to go on from.
    void keep(std::shared_ptr<const CycleSteps> done);
    /// What is to be known behind its steps to judge by what follows.
    void note(const CycleSteps& done);
    [[nodiscard]] bool isBeforeLast() const { return cycle.size() + 1 == stages; }
    [[nodiscard]] int stepCount() const { return std::accumulate(counts.begin(), counts.end(), 0); }
    [[nodiscard]] bool hasSteps() const { return stepCount() > 0; }
};

/// What the steps in a prefix of the project take in memory, about.
[[nodiscard]] std::size_t prefixBytes(const Project& project);

/// Goes on from cycles by one stage, through all the ends that the grid leaves it.
class StageRuns {
public:
    /// Without bounds bound_s() and bound() are not to be called; they take the square of the
    /// settings to make.
    enum class Bounds { no, yes };
    StageRuns(const Project& project, const Grid& grid, const CycleRunner& runner, Bounds bounds);

    /// Ends that fall on one step: steps of stock behind the stage from `first` to `last`; of the
    /// last stage both are 0.
    struct End {
        CycleSteps& steps; ///< of the last stage they may be finished
        int count = 0;     ///< of steps in the stage
        int first = 0, last = 0;
        GaugeSignal signal;
    };
    /// Whether it is no use to run on to the end with so many steps of stock behind it.
    using Useless = std::function<bool(const Run& run, int taken)>;
    using AtEnd = std::function<void(const End& end)>;
    /// Under gauge control the stage is run once, under position control once for each end. A run
    /// that breaks a requirement counts as cut and ends.
    void run(const CyclePrefix& from, std::size_t setting, const Useless& useless,
             const AtEnd& atEnd, SearchCounts& counts) const;
    /// To the end with so many steps of stock behind the stage, with a copy of the prefix's steps;
    /// nothing: it is not reached.
    [[nodiscard]] std::optional<End> runTo(int taken, const CyclePrefix& from, CycleSteps& steps,
                                           std::size_t setting, SearchCounts& counts) const;
    /// Whether a few radii judge last stages: under gauge control.
    [[nodiscard]] bool canTell() const { return !m_feeds.empty(); }
    /// What they show of one with this setting, or of its first steps.
    [[nodiscard]] LastStageOutlook outlook(const CyclePrefix& from, std::size_t setting,
                                           int mostSteps = std::numeric_limits<int>::max()) const;
    /// Whether a diameter is beyond the field before the last stage begins.
    [[nodiscard]] bool isTooDeep(const CyclePrefix& beforeLast) const;
    /// The prefix behind the stage, without steps.
    [[nodiscard]] CyclePrefix after(const CyclePrefix& from, std::size_t setting, const End& end,
                                    int taken) const;

    /// Steps of stock that are taken at least and at most behind the next stage of a prefix.
    [[nodiscard]] int leastTaken(const CyclePrefix& prefix) const;
    [[nodiscard]] int mostTaken(const CyclePrefix& prefix) const;
    /// Makes the last so many steps of a prefix once more, behind those before; false: it was
    /// stopped.
    [[nodiscard]] bool again(const CyclePrefix& prefix, CycleSteps& steps, int count) const;

    /// Least time [s] of all cycles that go on with this setting, or with so much done of it.
    /// Behind the last stage the wheel is fed beyond the size by the lag of the gauge's deepest
    /// radius.
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
               const Useless& useless, const AtEnd& atEnd, SearchCounts& counts) const;
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
    std::shared_ptr<const CycleSteps> m_part; ///< its first steps
    double m_total;                           ///< |R_first − R_t| [mm]
    double m_fedAtSize_mm;                    ///< by position control
    std::vector<StepFeed> m_steps;            ///< by setting
    std::vector<FollowedFeed> m_feeds;        ///< by setting; empty: no radius can be followed
    std::optional<TimeBound> m_bound;
    mutable std::optional<SteadyLags> m_lags; ///< of the settings; found when they are asked for
    bool m_gauge;
    GaugeSignal m_signal; ///< before the first reading
};

} // namespace sparkout
