// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/quality/constraints.h"
#include "core/result.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// Stocks of the blank whose cycles make the same steps.
struct PhasePiece {
    double from_mm = 0, to_mm = 0; ///< Π, per side
    std::vector<int> counts;       ///< steps of each stage
    RunStatus status = RunStatus::completed;
};

/// Divides the stocks of an interval into pieces with the same steps, in rising order [MODEL-14].
///
/// Under gauge control t_П counts from the first touch, so that no depth of cut depends on the
/// stock Π while the same stages run: with G_m, how deep the gauge's section is cut after m steps,
/// the reading is Π_rem = Π + ΔR − G_m, and stage z ends at the first step with
///
///     Π ≤ G_m − ΔR + Σ_{j>z} Π_j.
///
/// All stocks of the interval therefore share one run up to a step where the right side lies within
/// the interval. There the stocks up to it end the stage and the others continue; each part is
/// followed separately, with a copy of the run. So every stock of the interval is in a piece, and
/// the tree has no more leaves than there are sequences of stage ends.
///
/// The form of the blank depends slightly on Π: a depth below its circumscribed circle changes by
/// less than 2·(ΔR/R)²·δΠ (ellipse; less for the others, zero for lobes and measured radii), and a
/// pass, whose depth of cut rises by no more than its infeed, does not increase the difference. So
/// a piece is extended by that much beyond its ends: neighbours overlap there, and no stock is
/// missed.
///
/// The method does not apply to position control, where the first step meets the part somewhere
/// within its infeed. The list is empty after a stop, and if there are more than `most` pieces.
[[nodiscard]] std::vector<PhasePiece> phasePieces(const Project& project, double from_mm,
                                                  double to_mm, const std::stop_token& stop = {},
                                                  std::size_t most = SIZE_MAX);

/// Receives a piece and the result of its cycle on the stock `from_mm` of the interval, exact
/// except for burning: a cut is judged by the stock that it leaves on the smallest blank that
/// reaches it, so by no more than any stock of the piece leaves. Returns false to end the visit.
using PieceVisitor = std::function<bool(const PhasePiece& piece, const SimulationResult& result)>;

/// Visits the pieces in no particular order, each as soon as it is known; returns whether all were
/// visited.
bool visitPhasePieces(const Project& project, double from_mm, double to_mm,
                      const PieceVisitor& visit, const std::stop_token& stop = {});

/// Returns the greatest change of a depth below the blank's circumscribed circle for this change of
/// stock [mm].
[[nodiscard]] double formChange_mm(const Project& project, double stock_mm);

/// Runs the project's cycle on a stock of a piece: that stock's blank, with the piece's steps. At
/// the ends, where neighbours overlap, the control itself may make the steps of the neighbour.
[[nodiscard]] SimulationResult simulatePiece(const Project& project, const PhasePiece& piece,
                                             double stock_mm, const std::stop_token& stop = {});

/// Range of stocks per side, including both ends [mm].
struct StockRange {
    double from_mm = 0, to_mm = 0;
    friend bool operator==(const StockRange&, const StockRange&) = default;
};

/// Result of the cycle at an end of a piece.
struct PieceEnd {
    std::vector<DeviationRange> deviations;    ///< by zone or section
    std::vector<ConstraintResult> constraints; ///< empty: the cycle does not end
};

/// A piece with the decision on its cycles.
///
/// Within a piece every depth of cut, and so time, forces, power, roughness and form, are constant;
/// the diameters grow by 2 µm for each µm of Π; and the stock left below each cut grows with Π, so
/// that the margin to burning never falls. A requirement that is met at both ends is therefore met
/// between them.
struct DecidedPiece {
    PhasePiece piece;
    double time_s = 0;
    PieceEnd low, high;
    std::optional<StockRange> holds; ///< stocks for which every requirement is met
    double leastMargin = 0;          ///< relative, at the worse end; −1: the cycle does not end
    std::optional<ConstraintResult> worst; ///< requirement with this margin
    [[nodiscard]] bool holdsWhole() const {
        return holds == StockRange{piece.from_mm, piece.to_mm};
    }
    /// Returns its failing stocks, one range below the good ones and one above.
    [[nodiscard]] std::vector<StockRange> failing() const;
};

/// Stocks for which a cycle fails, with the worst requirement there.
struct FailingStocks {
    StockRange stocks;
    RunStatus status = RunStatus::completed;
    std::optional<ConstraintResult> worst; ///< only for cycles that end
    std::optional<double> wheel_deg{};     ///< the angle ψ_0 of a wheel out of true
};

/// Greatest number of listed pieces. An infeed of an ordinary cycle has 5 to 30; many small infeeds
/// after a large one may make millions.
inline constexpr std::size_t mostDecidedPieces = 20'000;

struct PhaseDecision {
    /// False under position control, when stopped or refused, and if there are too many pieces.
    bool isDecided = false;
    bool hasTooMany = false; ///< there are more pieces than allowed
    StockRange range;
    std::vector<DecidedPiece> pieces; ///< in rising order, over the whole range
    /// In rising order, of several phases of the wheel overlapping; empty: it is fit for every
    /// stock
    std::vector<FailingStocks> failing;
    [[nodiscard]] bool holds() const { return isDecided && failing.empty(); }
    /// Returns the failing ranges, whatever the reason, in rising order and joined where adjacent.
    [[nodiscard]] std::vector<StockRange> failingRanges() const;
};

/// Returns whether the phases of a valid project can be decided: only under gauge control.
[[nodiscard]] bool canDecidePhases(const Project& project);

/// Returns a range widened by half the largest infeed of a stage on either side.
[[nodiscard]] StockRange widened(const StockRange& stocks, double largestInfeed_mm);

/// Returns the stocks around the stated one, half the largest infeed of a stage on either side,
/// over which the last steps of the stages take every possible position.
[[nodiscard]] StockRange usualPhases(const Project& project);

[[nodiscard]] DecidedPiece decidePiece(const Project& project, PhasePiece piece,
                                       const std::stop_token& stop = {});

/// How many angles ψ_0 of a wheel out of true, evenly over the turn, every stock is decided for;
/// the pieces are those of the stated one. It turns the waves of a round blank, and leaves their
/// height.
inline constexpr int phasesOfWheel = 4;

/// The project with its wheel at the other of these angles; empty without waves of the wheel.
[[nodiscard]] std::vector<Project> atOtherWheelPhases(const Project& project);

/// Decides whether the project's cycle meets every requirement for each stock of a range, with its
/// other inputs unchanged; of a wheel out of true at phasesOfWheel angles.
[[nodiscard]] PhaseDecision decidePhases(const Project& project, StockRange range,
                                         const std::stop_token& stop = {},
                                         std::size_t mostPieces = mostDecidedPieces);

/// Share of a batch that fails because of the stock alone, with the other inputs unchanged.
struct FailingShare {
    double failing = 0;   ///< share of parts with a failing stock
    double undecided = 0; ///< share of parts with a stock outside the decided range
};

/// Computes the shares from a decision and the distribution of the stock, F(x) being the share of
/// parts with a smaller stock:
///
///     failing = Σ (F(to) − F(from)) over the stocks that fail,  undecided = 1 − (F(to) − F(from))
///
/// of the range. A stock in overlapping pieces counts once. No stock is sampled.
[[nodiscard]] FailingShare failingShare(const PhaseDecision& decision,
                                        const std::function<double(double stock_mm)>& shareBelow);

[[nodiscard]] std::span<const Output<PhaseDecision>> phasesOutputs();
[[nodiscard]] std::span<const Output<DecidedPiece>> phasePieceOutputs();
[[nodiscard]] std::span<const Output<FailingStocks>> failingStocksOutputs();
/// Returns the outputs of the requirement nearest to its limit in a piece or in failing stocks.
[[nodiscard]] std::span<const Output<ConstraintResult>> phaseWorstOutputs();

/// Returns the object of `phases --json`: the pieces of the range, and the stocks for which the
/// cycle fails.
[[nodiscard]] std::string phasesJson(const PhaseDecision& decision);

} // namespace sparkout
