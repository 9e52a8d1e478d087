// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/cycle_runner.h"
#include "core/search/last_stage_bound.h"
#include "core/search/optimise.h"
#include "core/simulation/stage_control.h"

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

/// Refutes cycles of a grid that end too deep for some stock of a case.
///
/// Under gauge control passes do not depend on the stock (phasePieces()). All stocks therefore
/// share the runs of the stages before the last, on a blank with the least of them: with Π = Π_0 +
/// x, a stage that is followed by stages with the total stock L ends at the first step by which the
/// control knows of
///
///     Π_rem ≤ L + slack − x,
///
/// where Π_rem is that of the shared run, read no later than the delay of the gauge before. A range
/// of x is divided at the steps of each stage, and each part of it begins the last stage with the
/// radii of one state. From there the critical radii of LastStageBound are followed. Stocks with an
/// x that has not ended the cycle before step k,
///
///     x > depth_(k−1) − |R_first − R_t| + slack,  depth that of the deepest radius gauged,
///
/// make at least k steps (more with a delay), and the two opposite radii that are deepest then,
/// which only grow deeper, leave a diameter of at most that of Π_0 plus 2x. Where that is beyond
/// the field for the least such x, the cycle fails for the stocks next to it.
///
/// Most last stages that cannot stop in time are refuted without following any radius. Let stocks
/// in a range of length l begin the last stage, of the infeed f, with one state. Let u be the least
/// lag of the deepest gauged radius after any of its steps, and w the greatest lag of the deepest
/// two at the end; SteadyLags bounds both. By the step before which the first of these stocks ends
/// its cycle, a stock that has only just not ended it is fed at least f + u beyond its size; or all
/// end it at one step, and the least is fed l + u beyond. So for one of them the deepest two are
/// cut at least min(f, l) + u − w below the size: where that is beyond the field the cycle fails.
/// No stock ends until t_П is u beyond the size of the least stock, which gives the number of steps
/// in which w approaches the steady lag.
///
/// The blank's form changes with the stock by at most formChange_mm(), and every step that is shown
/// to end a stage, or not to, is so by more than that and rounding; a diameter is too small by more
/// than four times that and 10 nm, the tolerance of failingStock(). With a delayed change of the
/// feed, and where LastStageBound has no bound, no cycle is refuted.
class CaseRefuter {
public:
    /// @param memory_bytes  approximate memory for kept states
    CaseRefuter(const PhaseCase& of, const Grid& grid, std::size_t memory_bytes,
                const std::stop_token& stop);
    CaseRefuter(const CaseRefuter&) = delete; // the runs refer to the runner's cuts

    [[nodiscard]] std::int64_t corner() const { return m_corner; }
    [[nodiscard]] bool refutes(const GridCycle& cycle);
    /// Keeps only those settings with which a last stage after these stages ends too deep for one
    /// of the stocks, as far as this is shown without following a radius.
    void keepRefuted(const GridCycle& beforeLast, std::vector<std::size_t>& settings);
    [[nodiscard]] ConstraintKind tooDeep() const { return m_runner.cuts().tooDeep(); }

private:
    /// State after a step of a stage.
    struct State {
        FollowedRadii critical; ///< critical radii of a last stage
        double time_s = 0, remaining_mm = 0;
        double known_mm = 0; ///< remaining stock by which the control acts
    };
    /// One of the two deepest radii.
    struct Deep {
        double lag_mm = 0;
        double share = 0; ///< share of the infeed by which its lag decreases in each step
        const SteadyLags::Most* most = nullptr; ///< by setting
    };
    /// End of the stages before the last, for the stocks in a range.
    struct End {
        double infeed_mm = 0;             ///< infeed before the least of the stocks can be at size
        double stocks_mm = 0;             ///< length of the range
        double gauged_mm = 0;             ///< lag of the deepest gauged radius
        const double* least_mm = nullptr; ///< least steady lags there, by setting
        std::array<Deep, 2> deep{};
        bool isTooDeep = false; ///< a diameter of the least stock is already too deep
    };
    /// A stage that begins at a state, as far as it has been run.
    struct Stage {
        GaugeSignal before; ///< readings before its first step
        GaugeSignal signal; ///< with those of its states
        std::map<std::size_t, std::shared_ptr<const CycleSteps>> kept; ///< by steps made
        std::unique_ptr<CycleSteps> steps; ///< steps up to the last state
        std::vector<State> states;         ///< states after 0, 1, … steps
        std::map<std::pair<std::size_t, std::size_t>, Stage>
            next; ///< next stages, by steps made and setting
    };

    [[nodiscard]] Stage begin(std::shared_ptr<const CycleSteps> from, const GaugeSignal& before);
    [[nodiscard]] State stateOf(const CycleSteps& steps, const GaugeSignal& signal) const;
    [[nodiscard]] const State* stateAt(Stage& stage, std::size_t count, std::size_t place,
                                       std::size_t setting);
    [[nodiscard]] Stage* follower(Stage& stage, std::size_t count,
                                  std::span<const GridStage> before, std::size_t place);
    [[nodiscard]] StockRange stocksOf(const GridCycle& cycle) const;
    [[nodiscard]] Stage& first(std::size_t stages, std::size_t setting);
    /// Receives a state that begins the last stage and the range of stocks that begin it so;
    /// returns true to end the visit.
    using AtLast = std::function<bool(const State&, StockRange)>;
    bool visitLast(Stage& stage, std::span<const GridStage> before, std::size_t place, int taken,
                   StockRange range, const AtLast& atLast);
    [[nodiscard]] bool endsTooDeep(const State& state, const GridCycle& cycle, StockRange range);
    [[nodiscard]] End endOf(const FollowedRadii& critical, StockRange stocks);
    [[nodiscard]] bool isFedTooFar(const End& end, std::size_t setting) const;
    [[nodiscard]] bool isTooDeep(const FollowedRadii& radii, double more_mm) const;
    [[nodiscard]] double larger_mm(double more_mm) const;

    const Grid& m_grid;
    std::int64_t m_corner;
    StockRange m_stocks;
    Project m_part; ///< the part with the least stock of all
    CycleRunner m_runner;
    std::shared_ptr<const CycleSteps> m_blank; ///< state before the first step
    double m_tolerance_mm = 0;         ///< tolerance of a stock at which a step ends a stage
    std::vector<double> m_infeeds_mm;  ///< by setting
    std::vector<FollowedFeed> m_feeds; ///< by setting; empty: no cycle can be refuted
    std::optional<SteadyLags> m_lags;  ///< lags of these feeds
    std::vector<End> m_ends;           ///< ends of the requested last stages
    double m_leastDepth_mm =
        0; ///< less than the final depth of any gauged radius, for the least stock
    double m_excess_mm =
        0; ///< two opposite radii cut farther beyond the size are certainly too deep
    std::map<std::pair<std::size_t, std::size_t>, Stage> m_first; ///< by stages and setting
    State m_blankState;             ///< initial state of cycles with one stage
    std::vector<double> m_least_mm; ///< least x that has not ended before each step
    std::size_t m_kept_bytes = 0, m_mostKept_bytes;
};

} // namespace sparkout
