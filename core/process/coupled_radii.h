// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/force.h"
#include "core/process/pass_kernel.h"

#include <bitset>
#include <cstddef>
#include <vector>

namespace sparkout {

class SectionInfluence;

/// The balances of CoupledSections of twelve radii side by side, where every section cuts and no
/// wheel contact yields: Newton's steps in u = √a, with f_j(u) = Δx_j·(k_s·u² + k_r·u),
///
///     r_j = u_j² + Σ_l G_jl·f_l − h_j = 0
///
/// in time proportional to J: G is semiseparable (SectionInfluence), and D + G = L·Δ·Lᵀ with L of
/// the same form, D = 2u/f′. u² and f are quadratic, so the tangents give the forces they lead to
/// without r being formed, and without a difference in them:
///
///     (D + G)·f̂ = h + u²·Δx·k_r/f′,      û = (Δx·k_s·u² + f̂)/f′
///
/// G being linear, r is then just what u² and f have beyond their tangents, δu² and Δx·k_s·δu² with
/// δu = û − u, but for rounding. The same L·Δ·Lᵀ takes that away in a correction,
///
///     (D + G)·y = δu²·Δx·k_r/f′,         ε = −(Δx·k_s·δu² + y)/f′,       u ← û + ε
///
/// and leaves (δu + ε)² − δu² in its place: together a step of third order. So
///
///     |r_j| ≤ (1 + max_j Σ_l |G_jl|·Δx_l·k_s)·max_l |δu_l² or ε_l·(2δu_l + ε_l)|
///
/// decides which step is the last. A radius that does not converge to a solution with all u > 0 is
/// left to CoupledSections::solve().
class CoupledRadii {
public:
    static constexpr std::size_t sideBySide = 12;
    static constexpr std::size_t thirds = 3; ///< a third in which nothing moves is skipped
    static constexpr std::size_t third = sideBySide / thirds;
    using Set = std::bitset<sideBySide>; ///< marks some of the twelve radii
    static constexpr int mostSteps = 8;  ///< steps of Newton's method, each with its correction

    /// The values of twelve radii in one section.
    struct alignas(32) Row {
        double of[sideBySide];
    };

    /// `influence` is short.
    CoupledRadii(const SectionInfluence& influence, const std::vector<double>& widths_mm,
                 const ForceLaw& law, VectorUnit unit = widestUnit());

    /// Solves the balances. `lag_mm` has a row of h for each section [mm]; `root` has the starting
    /// values u ≥ 0 and receives the roots [√mm]. Returns the solved ones of `asked`, each
    /// identical to its solution alone, to the bit with every vector unit; the others are
    /// undefined.
    [[nodiscard]] Set solve(const Row* lag_mm, Row* root, Set asked);

    /// The other values that a step reads and writes.
    struct Balance {
        std::vector<double> rows, columns;   ///< values of the influence, section by section
        std::vector<double> own, bks, bkr;   ///< G_jj, Δx_j·k_s and Δx_j·k_r
        std::vector<double> twoBks, halfBkr; ///< these twice and by half
        std::vector<Row> inverse;            ///< 1/f′
        std::vector<Row> scale;              ///< 1/Δ
        std::vector<Row> gain;               ///< L_jl = row_j·gain_l
        std::vector<Row> force;              ///< f̂ or y, as far as it is computed
        std::vector<Row> change;             ///< δu
    };
    struct Step {
        const Row* lag;
        Row* root;
        std::size_t first = 0; ///< first of the radii used
        Row moving{};          ///< > 0: this radius moves
        Row least{};           ///< the smallest u after the step
        Row most{};            ///< largest deviation of u² from the tangents
    };
    using Kernel = void (*)(Balance& balance, Step& step);
    struct Kernels { ///< kernels for one, two and three adjacent thirds
        Kernel newton[thirds], correction[thirds];
    };

private:
    Balance m_balance;
    double m_leaves = 1; ///< ratio of the bound on |r| to the deviation of u²
    Kernels m_kernels;
};

} // namespace sparkout
