// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/burn.h"

#include <cstddef>
#include <vector>

namespace sparkout {

/// The limiting √a of burn against the stock left, tabulated for the passes of a run: between
/// equally spaced stocks a straight line, 3e-6 of √a off at most. Made once for a run or a
/// scenario.
///
/// A pass needs the lanes only where bound() exceeds the worst so far: the stock left is nowhere
/// less than what the programmed infeed leaves.
class BurnTable {
public:
    /// For stocks from 0 to `deepest`, and U = U_burn.
    BurnTable(const BurnModel& model, double U, double deepest_mm);

    /// √a over the limiting √a at this stock; above 1 the damaged layer is deeper than the stock.
    [[nodiscard]] double usage(double root, double stock_mm) const {
        return root / limit(stock_mm);
    }
    /// The limiting √a, rising with the stock; below 0 as at 0, beyond the deepest as there.
    [[nodiscard]] double limit(double stock_mm) const {
        const double deep = stock_mm < m_deepest ? stock_mm : m_deepest;
        const double at = deep > 0 ? deep * m_perStep : 0;
        const auto i = static_cast<std::size_t>(at);
        const Piece& piece = m_pieces[i];
        const double f = at - static_cast<double>(i);
        return piece.root + f * (piece.rise + f * piece.bend);
    }

    struct Worst {
        double usage = 0;
        std::size_t lane = 0;
    };
    /// The worst of `count` lanes after a pass: roots √a of the pass, depths below first touch and
    /// the depth of the target below it (|R_first − R_t|).
    [[nodiscard]] Worst worst(const double* root, const double* depth_mm, std::size_t count,
                              double totalInfeed_mm) const;
    /// No lane of a pass can be worse: its largest √a at the least stock that t_П leaves.
    [[nodiscard]] double bound(double largestRoot, double fed_mm, double totalInfeed_mm) const {
        return usage(largestRoot, totalInfeed_mm - fed_mm);
    }

private:
    /// √a over one step, f from 0 to 1: root + rise·f + bend·f².
    struct Piece {
        double root = 0, rise = 0, bend = 0;
    };

    double m_deepest, m_perStep;
    std::vector<Piece> m_pieces;
};

} // namespace sparkout
