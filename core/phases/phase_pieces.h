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

/// The stocks of an interval by what their cycles do, in rising order [MODEL-14].
///
/// Under gauge control t_П counts from the first touch, so that no depth of cut depends on the
/// stock Π while the same stages run: with G_m, how deep the gauge's section is cut after m steps,
/// the reading is Π_rem = Π + ΔR − G_m, and stage z ends at the first step with
///
///     Π ≤ G_m − ΔR + Σ_{j>z} Π_j.
///
/// All stocks of the interval therefore share one run up to a step where the right side lies within
/// the interval. There those up to it end the stage and the others go on; each part is followed by
/// itself, with a copy of the run. So every stock of the interval is in a piece, and the tree has
/// no more leaves than there are sequences of stage ends.
///
/// The form of the blank does depend on Π a little: a depth below its circumscribed circle changes
/// by less than 2·(ΔR/R)²·δΠ (ellipse; less for the others, nothing for lobes and measured radii),
/// and a pass, whose depth of cut rises with what is fed by no more than that, makes a difference
/// no greater. So a piece is continued by that much beyond its ends: neighbours overlap there, and
/// no stock is missed.
///
/// Position control is not for it: the first step meets the part somewhere within its infeed. After
/// a stop the list is empty; so it is where there are more than `most`.
[[nodiscard]] std::vector<PhasePiece> phasePieces(const Project& project, double from_mm,
                                                  double to_mm, const std::stop_token& stop = {},
                                                  std::size_t most = SIZE_MAX);

/// Takes a piece, and what its cycle makes of the stock `from_mm` of the interval, but for burning:
/// a cut is judged by the stock it leaves of the least blank that comes to it, so by no more than
/// any of the piece leaves. False: no more.
using PieceVisitor = std::function<bool(const PhasePiece& piece, const SimulationResult& result)>;

/// Visits the pieces in no order, each as soon as it is known. Whether all were visited.
bool visitPhasePieces(const Project& project, double from_mm, double to_mm,
                      const PieceVisitor& visit, const std::stop_token& stop = {});

/// By how much a depth below the blank's circumscribed circle changes at most with so much of stock
/// [mm].
[[nodiscard]] double formChange_mm(const Project& project, double stock_mm);

/// The project's cycle on a stock of a piece: that stock's blank, with the piece's steps. At the
/// ends, where neighbours overlap, the control itself may make those of the neighbour.
[[nodiscard]] SimulationResult simulatePiece(const Project& project, const PhasePiece& piece,
                                             double stock_mm, const std::stop_token& stop = {});

} // namespace sparkout
