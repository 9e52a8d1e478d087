// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_pieces.h"
#include "core/quality/constraints.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

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
};

/// Greatest number of listed pieces. An infeed of an ordinary cycle has 5 to 30; many small infeeds
/// after a large one may make millions.
inline constexpr std::size_t mostDecidedPieces = 20'000;

struct PhaseDecision {
    /// False under position control, when stopped or refused, and if there are too many pieces.
    bool isDecided = false;
    bool hasTooMany = false; ///< there are more pieces than allowed
    StockRange range;
    std::vector<DecidedPiece> pieces;   ///< in rising order, over the whole range
    std::vector<FailingStocks> failing; ///< in rising order; empty: it is fit for every stock
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

/// Decides whether the project's cycle meets every requirement for each stock of a range, with its
/// other inputs unchanged.
[[nodiscard]] PhaseDecision decidePhases(const Project& project, StockRange range,
                                         const std::stop_token& stop = {},
                                         std::size_t mostPieces = mostDecidedPieces);

} // namespace sparkout
