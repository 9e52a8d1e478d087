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
/// tells which is the last one. A radius that such steps do not bring to a solution with all u > 0
/// is left to CoupledSections::solve().
class CoupledRadii {
public:
    static constexpr std::size_t sideBySide = 12;
    static constexpr std::size_t thirds = 3; ///< where none of a third moves, it is passed over
    static constexpr std::size_t third = sideBySide / thirds;
    using Set = std::bitset<sideBySide>; ///< of the twelve radii
    static constexpr int mostSteps = 8;  ///< of Newton, each with its correction

    /// What twelve radii have in one section.
    struct alignas(32) Row {
        double of[sideBySide];
    };

    /// `influence` is short.
    CoupledRadii(const SectionInfluence& influence, const std::vector<double>& widths_mm,
                 const ForceLaw& law, VectorUnit unit = widestUnit());

    /// `lag_mm` has a row of h for each section [mm]; `root` one of u ≥ 0 where the steps begin,
    /// and takes what they come to [√mm]. Returns which of those asked for are solved, each as it
    /// would be alone, with every vector unit to the bit; the others keep no meaning.
    [[nodiscard]] Set solve(const Row* lag_mm, Row* root, Set asked);

    /// All that a step reads and writes beside these.
    struct Balance {
        std::vector<double> rows, columns;   ///< numbers of the influence, section by section
        std::vector<double> own, bks, bkr;   ///< G_jj, Δx_j·k_s and Δx_j·k_r
        std::vector<double> twoBks, halfBkr; ///< these twice and by half
        std::vector<Row> inverse;            ///< 1/f′
        std::vector<Row> scale;              ///< 1/Δ
        std::vector<Row> gain;               ///< L_jl = row_j·gain_l
        std::vector<Row> force;              ///< f̂ or y, as far as it is known
        std::vector<Row> change;             ///< δu
    };
    struct Step {
        const Row* lag;
        Row* root;
        std::size_t first = 0; ///< radius, of those that are taken
        Row moving{};          ///< > 0: this radius moves
        Row least{};           ///< the smallest u after the step
        Row most{};            ///< the largest that u² is beyond the tangents
    };
    using Kernel = void (*)(Balance& balance, Step& step);
    struct Kernels { ///< for one third, two and three that lie side by side
        Kernel newton[thirds], correction[thirds];
    };

private:
    Balance m_balance;
    double m_leaves = 1; ///< the bound on |r| is this times what u² is beyond the tangents [1]
    Kernels m_kernels;
};

} // namespace sparkout
