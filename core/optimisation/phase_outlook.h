// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/cycle_runner.h"
#include "core/optimisation/optimise.h"
#include "core/optimisation/steady_lag.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// Shows of cycles of a grid that they end too deep for some stock of a case.
///
/// Under gauge control passes do not depend on the stock (phasePieces()). So all stocks share the
/// runs of the stages before the last, on a blank of the least of them: with Π = Π_0 + x a stage
/// with the stocks L behind it ends at the first step that leaves
///
///     Π_rem ≤ L + slack − x,
///
/// Π_rem that of the shared run. A range of x thus parts at the steps of each stage, and each part
/// of it begins the last stage with the radii of one state. From there the radii of
/// LastStageOutlook are followed. Those x that have not ended the cycle before step k,
///
///     x > depth_(k−1) − |R_first − R_t| + slack,  depth that of the deepest radius gauged,
///
/// make k steps at least, and the two opposite radii that are the deepest then, which only grow
/// deeper, leave a diameter of no more than that of Π_0 and 2x. Where that is beyond the field for
/// the least such x, the cycle fails for the stocks next to it.
///
/// Most last stages that cannot stop in time are known without following any radius. Let stocks in
/// a range of length l begin the last stage, of the infeed f, with one state. Let u be the least
/// lag that the deepest radius gauged has behind any of its steps, w the greatest that the deepest
/// two have at the end; SteadyLags bound both. By the step before which the first of these stocks
/// ends its cycle, a stock that just has not ended it is fed f + u beyond its size at least; or all
/// end it at one step, and the least is fed l + u beyond. So for one of them the deepest two are
/// cut min(f, l) + u − w below the size, or more: where that is beyond the field the cycle fails.
/// Until t_П is u beyond the size of the least stock none ends, which gives the steps that w comes
/// nearer to the steady lag by.
///
/// The blank's form changes with the stock by no more than formChange_mm(), and every step shown
/// to end a stage, or not to, is so by more than that and what rounding is; a diameter is too small
/// by more than four times that and 10 nm, as failingStock_mm() counts them. Nothing is said of
/// what the gauge tells late, nor where LastStageOutlook knows nothing.
class PhaseOutlook {
public:
    /// @param memory_bytes  for states to go on from, about
    PhaseOutlook(const PhaseCase& of, const Grid& grid, std::size_t memory_bytes,
                 const std::stop_token& stop);
    PhaseOutlook(const PhaseOutlook&) = delete; // the runs refer to the runner's cuts

    [[nodiscard]] std::int64_t corner() const { return m_corner; }
    [[nodiscard]] bool isHopeless(const GridCycle& cycle);
    /// Leaves those settings of which it is known, without following them, that a last stage behind
    /// these ends too deep for one of the stocks.
    void keepHopeless(const GridCycle& beforeLast, std::vector<std::size_t>& settings);
    [[nodiscard]] ConstraintKind tooDeep() const { return m_runner.cuts().tooDeep(); }

private:
    /// Behind a step of a stage.
    struct State {
        FollowedRadii telling; ///< of a last stage
        double remaining_mm = 0;
    };
    /// One of the deepest two.
    struct Deep {
        double lag_mm = 0;
        double share = 0; ///< of the infeed that it lags behind less in each step
        const SteadyLags::Most* most = nullptr; ///< by setting
    };
    /// Of the stages before the last, for stocks in a range.
    struct End {
        double infeed_mm = 0;             ///< to come before the least of them may be at its size
        double stocks_mm = 0;             ///< length of the range
        double gauged_mm = 0;             ///< least lag gauged
        const double* least_mm = nullptr; ///< SteadyLags there, by setting
        std::array<Deep, 2> deep{};
        bool isTooDeep = false; ///< a diameter of the least of them, already
    };
    /// A stage from a state on, as far as it was run.
    struct Stage {
        std::map<std::size_t, std::shared_ptr<const CycleSteps>> kept; ///< by steps made
        std::unique_ptr<CycleSteps> steps;                             ///< behind the last state
        std::vector<State> states;                                     ///< from none made on
        std::map<std::pair<std::size_t, std::size_t>, Stage> next; ///< by steps made and setting
    };

    [[nodiscard]] Stage begin(std::shared_ptr<const CycleSteps> from);
    [[nodiscard]] State stateOf(const CycleSteps& steps) const;
    [[nodiscard]] const State* stateAt(Stage& stage, std::size_t count, std::size_t place,
                                       std::size_t setting);
    [[nodiscard]] Stage* follower(Stage& stage, std::size_t count,
                                  std::span<const GridStage> before, std::size_t place);
    [[nodiscard]] StockRange stocksOf(const GridCycle& cycle) const;
    [[nodiscard]] Stage& first(std::size_t stages, std::size_t setting);
    /// Takes a state that begins the last stage, and the stocks that begin it so, next to each
    /// other. True: no more.
    using AtLast = std::function<bool(const State&, StockRange)>;
    bool visitLast(Stage& stage, std::span<const GridStage> before, std::size_t place, int taken,
                   StockRange range, const AtLast& atLast);
    [[nodiscard]] bool endsTooDeep(const State& state, const GridCycle& cycle, StockRange range);
    [[nodiscard]] End endOf(const FollowedRadii& telling, StockRange stocks);
    [[nodiscard]] bool isFedTooFar(const End& end, std::size_t setting) const;
    [[nodiscard]] bool isTooDeep(const FollowedRadii& radii, double more_mm) const;
    [[nodiscard]] double larger_mm(double more_mm) const;

    const Grid& m_grid;
    std::int64_t m_corner;
    StockRange m_stocks;
    Project m_part; ///< with the least stock of all
    CycleRunner m_runner;
    std::shared_ptr<const CycleSteps> m_blank; ///< before the first step
    double m_doubt_mm = 0;                     ///< of a stock at which a step ends a stage
    std::vector<double> m_infeeds_mm;          ///< by setting
    std::vector<FollowedFeed> m_feeds;         ///< by setting; empty: nothing is known
    std::optional<SteadyLags> m_lags;          ///< of these feeds
    std::vector<End> m_ends;                   ///< of the stages last asked of
    double m_sure_mm = 0;   ///< less than any radius gauged is cut to at the end, for no more stock
    double m_excess_mm = 0; ///< more of two opposite radii beyond the size is too deep for sure
    std::map<std::pair<std::size_t, std::size_t>, Stage> m_first; ///< by stages and setting
    State m_unbegun;                                              ///< of cycles of one stage
    std::vector<double> m_least_mm; ///< x that have not ended before each step
    std::size_t m_kept_bytes = 0, m_mostKept_bytes;
};

} // namespace sparkout
