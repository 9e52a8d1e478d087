// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/contact_compliance.h"
#include "core/process/force.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

class SectionInfluence;

/// The elastic balance of sections that deflect each other [MODEL-6]: one radius, one revolution.
/// Sections j = 0…J−1 of width Δx_j carry the pressures p_j = p(a_j), the normal force per unit
/// width of the force law, p(a) = k_s·a + k_r·√a [N/mm]. With the influence function G [mm/N] at
/// the sections' middles and the lag h_j = t_П − depth_j [mm], find a_j ≥ 0 such that
///
///     r_j = a_j + Σ_l G_jl·p(a_l)·Δx_l − h_j ≥ 0,     a_j·r_j = 0
///
/// There is exactly one solution. In the slice forces f_j = p_j·Δx_j, with φ(p) the depth at which
/// the pressure is p (φ(0) = 0, strictly increasing), r is the gradient of
///
///     Ψ(f) = Σ Δx_j·∫₀^{p_j} φ dp + ½·fᵀGf − hᵀf
///
/// G is symmetric and positive semidefinite (½·fᵀGf is the strain energy), each ∫φ is strictly
/// convex and outgrows every linear function, so Ψ is strictly convex and coercive on f ≥ 0; the
/// conditions above are those of its one minimum there. G may be singular (a quill: all sections
/// move together).
///
/// With the wheel's contact in series a section yields by a_j + δ_c(P_j) in place of a_j, where P_j
/// = p_j·ΣΔx is the force of the whole width at its pressure, as with independent sections. δ_c
/// rises strictly too, so all of this holds for the sum.
///
/// With a threshold (ForceLaw) φ(p) = max(0, p − F'_0)/K: r_j = 0 of a touching section, too, whose
/// force is below Δx·F'_0. Ψ is convex still, and strictly so where G is positive definite: then
/// there is one solution. Where G is singular (a quill) the depths of all sections and G·f are
/// unique, and so is the sum of the forces; how touching sections share theirs is left open.
///
/// Solved by Newton's method on min(a_j + G_jj·f_j, r_j) = 0 (the same conditions, the first term
/// being the depth of a section that loses contact) in the unknowns f, where the Jacobian is
/// analytic and symmetric: (D + G)·δ = −r over the sections in contact, D = diag(da/df) =
/// diag(2u/((2·k_s·u + k_r)·Δx)), u = √a, in time proportional to J (SectionInfluence). A full step
/// is taken when it halves the largest residual; else interior-point steps on Ψ(f) − μ·Σ ln f, μ →
/// 0, find which sections are in contact. From the last revolution's roots it takes one or two
/// steps.
///
/// These quick steps may end short of the solution where a section barely touches: there dw/df → 0
/// and both sets of sections seem right alternately. A descent on Ψ from the best of these points
/// follows, which converges from everywhere:
///
/// 1. a sweep: section by section f_j becomes the minimum of Ψ along f_j ≥ 0, the root of w(f_j) +
///    G_jj·f_j = h_j − Σ_{l≠j} G_jl·f_l (w = a + δ_c), or 0 where the right side is not positive;
/// 2. Newton's steps over the sections with f_j > 0, as far as the first force that they bring to
///    0, each cut back until it lowers Ψ, up to where these sections are in balance, at most 50;
///    then again 1.
///
/// Proof. No step raises Ψ, so all points lie in a bounded set (Ψ is coercive). A sweep is
/// continuous in f, for each of its roots is; and it lowers Ψ unless no f_j alone can lower it,
/// when the conditions above hold. Let f* be a limit of points that a sweep begins at: Ψ there and
/// Ψ behind the sweeps have one limit, so the sweep from f* does not lower Ψ, f* is the solution,
/// and as each limit is, all points tend to it. (The steps of 2 only speed that up: near the
/// solution, once its set of sections is met, they converge as Newton's do.) That a step lowers Ψ
/// is decided by the slope r·δ alone, which rises along it, Ψ being convex: where it is not
/// positive Ψ fell; a little beyond its zero the rise is less than the fall before it, by the areas
/// under it. So differences of Ψ itself, lost to rounding near the minimum, are never formed.
///
/// A failure to converge is reported.
class CoupledSections {
public:
    /// `influence_mm_n` is G, J×J; `widths_mm` are the Δx; k_s > 0.
    CoupledSections(const std::vector<double>& influence_mm_n, const std::vector<double>& widths_mm,
                    const ForceLaw& law, std::optional<ContactCompliance> contact = std::nullopt);
    ~CoupledSections();
    CoupledSections(const CoupledSections& other);
    CoupledSections(CoupledSections&&) noexcept;
    CoupledSections& operator=(CoupledSections&&) noexcept;

    struct Outcome {
        bool converged = false;
        int iterations = 0;     ///< number of steps
        double residual_mm = 0; ///< largest |min(a + G·f, r)| of the returned solution
    };

    /// Solves for u = √a of each section [√mm]: `root` holds the starting values, usually of the
    /// last revolution (all zero: a cold start), and receives the solution. Allocates nothing. A
    /// stop ends it after at most one factorisation, not converged. With a threshold, `rubbing`
    /// holds v of each section in the same way.
    Outcome solve(const double* lag_mm, double* root, const std::stop_token& stop = {},
                  double* rubbing = nullptr);

    /// u of a cold start of solve(): each section in its own balance, its neighbours at its
    /// pressure, a + γ·p(a) = h, γ_j = Σ_l G_jl·Δx_l, without the wheel contact. For a force
    /// without a threshold.
    void begin(const double* lag_mm, double* root) const;

    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] const SectionInfluence& influence() const; ///< G

    /// Largest residual of a solution [mm], in addition to rounding errors at a large h.
    static constexpr double tolerance_mm = 1e-13;
    static constexpr int maxIterations = 100;  ///< greatest number of quick steps
    static constexpr int maxDescents = 20'000; ///< steps of the descent; about ten are needed

private:
    class Solver;
    std::unique_ptr<Solver> m_solver;
};

/// Whether a project's cycle has its sections coupled.
[[nodiscard]] inline bool isCoupled(const Project& project) {
    return !project.operation->travels && project.sections_coupled;
}

} // namespace sparkout
