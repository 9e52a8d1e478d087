// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/burn.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// The limiting √a of burn against the stock left, tabulated for the passes of a run: 1/√a as a
/// parabola in each of equal steps of the stock, off by less than 1e-6 of √a up to 1 mm of stock.
/// Made once for a run or a scenario, in some 20 µs.
///
/// A pass needs the lanes only where bound() exceeds the worst so far: the stock left is nowhere
/// less than what the programmed infeed leaves.
class BurnTable {
public:
    /// For stocks from 0 to `deepest`, and U = U_burn.
    BurnTable(const BurnModel& model, double U, double deepest_mm);

    /// √a over the limiting √a at this stock; above 1 the damaged layer is deeper than the stock.
    [[nodiscard]] double usage(double root, double stock_mm) const {
        double at = stock_mm * m_perStep;
        at = at < m_last ? at : m_last;
        at = at > 0 ? at : 0;
        const int i = static_cast<int>(at);
        const Piece& piece = m_pieces.data()[i]; // unchecked: the inner loop
        const double f = at - i;
        return root * (piece.inverse + f * (piece.fall + f * piece.bend));
    }
    /// The limiting √a, rising with the stock; below 0 as at 0, beyond the deepest as there.
    [[nodiscard]] double limit(double stock_mm) const { return 1 / usage(1, stock_mm); }

    struct Worst {
        double usage = 0;
        std::size_t lane = 0;
    };
    /// The worst of `count` lanes after a pass: roots √a of the pass, depths below first touch and
    /// the depth of the target below it (|R_first − R_t|). A worst not above `atLeast` is not
    /// looked for: usage 0. `guess` is a lane to look at first, the last worst one.
    ///
    /// 1/√a falls with the stock and is convex, so over the stocks of neighbouring lanes its
    /// secant is above it: only lanes whose bound by the secant is not below the worst so far are
    /// looked up.
    [[nodiscard]] Worst worst(const double* root, const double* depth_mm, std::size_t count,
                              double totalInfeed_mm, double atLeast = 0,
                              std::size_t guess = 0) const;
    /// No lane of a pass can be worse: its largest √a at the least stock that t_П leaves, t_П that
    /// of the pass's last radius.
    [[nodiscard]] double bound(double largestRoot, double fed_mm, double totalInfeed_mm) const {
        return usage(largestRoot, totalInfeed_mm - fed_mm);
    }

private:
    /// 1/√a over one step, f from 0 to 1: inverse + fall·f + bend·f².
    struct Piece {
        double inverse = 0, fall = 0, bend = 0;
    };

    double m_perStep, m_last; ///< steps a mm, and in all
    std::vector<Piece> m_pieces;
};

} // namespace sparkout
