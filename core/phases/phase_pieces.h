// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
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

} // namespace sparkout
