// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_pieces.h"
#include "core/quality/constraints.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Stocks per side, both ends included [mm].
struct StockRange {
    double from_mm = 0, to_mm = 0;
    friend bool operator==(const StockRange&, const StockRange&) = default;
};

/// A cycle at an end of a piece.
struct PieceEnd {
    std::vector<DeviationRange> deviations;    ///< of each zone or section
    std::vector<ConstraintResult> constraints; ///< none where the cycle does not end
};

/// A piece, and whether its cycles hold what is required.
///
/// Within it every depth of cut, and so time, forces, power, roughness and form, are constant; the
/// diameters grow by 2 µm for each µm of Π; and the stock left below each cut grows with Π, so that
/// the margin to burning never falls. So where a requirement holds at both ends it holds between
/// them.
struct DecidedPiece {
    PhasePiece piece;
    double time_s = 0;
    PieceEnd low, high;
    std::optional<StockRange> holds; ///< stocks for which every requirement holds
    double leastMargin = 0; ///< relative, at the worse end; of a cycle that does not end −1
    std::optional<ConstraintResult> worst; ///< the requirement it is of
    [[nodiscard]] bool holdsWhole() const {
        return holds == StockRange{piece.from_mm, piece.to_mm};
    }
    /// Its stocks for which a requirement fails, one part below those that hold and one above.
    [[nodiscard]] std::vector<StockRange> failing() const;
};

/// Stocks for which a cycle fails, and what fails first there.
struct FailingStocks {
    StockRange stocks;
    RunStatus status = RunStatus::completed;
    std::optional<ConstraintResult> worst; ///< of cycles that end
};

/// Pieces that are listed at most. An infeed of an ordinary cycle has 5 to 30; many small infeeds
/// after a large one may make millions.
inline constexpr std::size_t mostDecidedPieces = 20'000;

struct PhaseDecision {
    /// Not under position control, nor when stopped or refused, nor where there are too many.
    bool isDecided = false;
    bool hasTooMany = false; ///< pieces: more than were allowed
    StockRange range;
    std::vector<DecidedPiece> pieces;   ///< in rising order, all of the range
    std::vector<FailingStocks> failing; ///< in rising order; none: it holds for every stock
    [[nodiscard]] bool holds() const { return isDecided && failing.empty(); }
    /// What fails, whatever the reason: in rising order, none next to another.
    [[nodiscard]] std::vector<StockRange> failingRanges() const;
};

/// Whether the phases of a valid project can be decided: under gauge control.
[[nodiscard]] bool canDecidePhases(const Project& project);

/// Stocks and half the largest infeed of a stage on either side of them.
[[nodiscard]] StockRange widened(const StockRange& stocks, double largestInfeed_mm);

/// The stocks around the stated one over which each way of the last steps of the stages to fall
/// comes up: half the largest infeed of a stage on either side.
[[nodiscard]] StockRange usualPhases(const Project& project);

/// Decides on a piece of a valid project.
[[nodiscard]] DecidedPiece decidePiece(const Project& project, PhasePiece piece,
                                       const std::stop_token& stop = {});

/// Decides whether the project's cycle holds every requirement for each stock of a range, its other
/// inputs as they are.
[[nodiscard]] PhaseDecision decidePhases(const Project& project, StockRange range,
                                         const std::stop_token& stop = {},
                                         std::size_t mostPieces = mostDecidedPieces);

} // namespace sparkout
