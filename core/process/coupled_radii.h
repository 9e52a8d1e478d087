// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/force.h"
#include "core/process/pass_kernel.h"

#include <bitset>
#include <cstddef>
#include <vector>

namespace sparkout {

class SectionInfluence;

/// The balances of CoupledSections of eight radii side by side, where every section cuts and no
/// wheel contact yields: Newton's steps in u = √a, with f_j(u) = Δx_j·(k_s·u² + k_r·u),
///
///     r_j = u_j² + Σ_l G_jl·f_l − h_j,      (D + G)·δf = −r,      D = 2u/f′,      δu = δf/f′
///
/// in time proportional to J: G is semiseparable (SectionInfluence), and D + G = L·Δ·Lᵀ with L of
/// the same form. G being linear, a step leaves only what u² and f have beyond their tangents, δu²
/// and Δx·k_s·δu², but for rounding:
///
///     |r_j| ≤ (1 + max_j Σ_l |G_jl|·Δx_l·k_s)·max_l δu_l²
///
/// so a step is known to be the last one without r being formed once more. A radius that such steps
/// do not bring to a solution with all u > 0 is left to CoupledSections::solve().
class CoupledRadii {
public:
    static constexpr std::size_t sideBySide = 8;
    using Set = std::bitset<sideBySide>; ///< of the eight radii
    static constexpr int mostSteps = 8;

    /// What eight radii have in one section.
    struct alignas(64) Row {
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
        std::vector<double> rows, columns; ///< numbers of the influence, section by section
        std::vector<double> own, bks, bkr; ///< G_jj, Δx_j·k_s and Δx_j·k_r
        std::vector<Row> rest;             ///< r, then −δf as far as it is known
        std::vector<Row> inverse;          ///< 1/f′
        std::vector<Row> gain;             ///< L_jl = row_j·gain_l
    };
    struct Step {
        const Row* lag;
        Row* root;
        Row moving{}; ///< > 0: this radius moves
        Row least{};  ///< the smallest u after the step
        Row most{};   ///< the largest δu²
    };

private:
    Balance m_balance;
    double m_leaves = 1; ///< the bound on |r| is this times max δu² [1]
    void (*m_step)(Balance& balance, Step& step);
};

} // namespace sparkout
