// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/burn.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace sparkout {

/// 1/√a of the limiting cut over one stretch of stocks, as a polynomial of x = max(stock, low) −
/// centre, stock = total − depth [mm].
struct BurnStretch {
    double total = 0, low = 0, centre = 0;
    std::array<double, 5> c{}; ///< coefficients of x⁰…x⁴

    /// √a relative to its limit for a radius at this depth below first touch.
    [[nodiscard, gnu::always_inline]] double usage(double root, double depth_mm) const {
        const double stock = total - depth_mm;
        const double x = (stock > low ? stock : low) - centre;
        const double xx = x * x;
        return root * ((c[0] + c[1] * x) + xx * ((c[2] + c[3] * x) + xx * c[4]));
    }
    /// The largest usage of `count` lanes.
    [[nodiscard]] double worst(const double* root, const double* depth_mm, std::size_t count) const;
};

/// The limiting √a of burn over the stock left, tabulated for the passes of a run: 1/√a as a
/// parabola in equal steps of the stock, with an error below 1e-6 of √a if it isResolved(). Made
/// once for a run or a scenario, in a few microseconds.
class BurnTable {
public:
    /// For stocks from 0 to `deepest`, and U = U_burn.
    BurnTable(const BurnModel& model, double U, double deepest_mm);

    /// √a relative to the limiting √a at this stock; above 1 the damaged layer is deeper than the
    /// stock.
    [[nodiscard]] double usage(double root, double stock_mm) const {
        double at = stock_mm * m_perStep;
        at = at < m_last ? at : m_last;
        at = at > 0 ? at : 0;
        const int i = static_cast<int>(at);
        const Piece& piece = m_pieces.data()[i]; // unchecked: the inner loop
        const double f = at - i;
        return root * (piece.inverse + f * (piece.fall + f * piece.bend));
    }
    /// Whether the steps are as small as the curve requires. For a very dull wheel with much stock
    /// it bends so close to the surface that they cannot be: the error is a few per cent there.
    [[nodiscard]] bool isResolved() const { return m_isResolved; }
    /// The limiting √a, rising with the stock; constant below 0 and beyond the deepest.
    [[nodiscard]] double limit(double stock_mm) const { return 1 / usage(1, stock_mm); }

    /// 1/√a over the stocks from `low` to `high` of the total infeed |R_first − R_t| as one
    /// polynomial with a relative error below 1e-6; empty if its degree is not sufficient.
    [[nodiscard]] std::optional<BurnStretch> over(double low_mm, double high_mm,
                                                  double totalInfeed_mm) const;

private:
    /// 1/√a over one step, f from 0 to 1: inverse + fall·f + bend·f².
    struct Piece {
        double inverse = 0, fall = 0, bend = 0;
    };

    double m_perStep, m_last; ///< steps a mm, and in all
    bool m_isResolved;
    std::vector<Piece> m_pieces;
};

} // namespace sparkout
