// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/contact_compliance.h"
#include "core/process/force.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

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
/// With the wheel's contact in series a section gives by a_j + δ_c(P_j) in place of a_j, where P_j
/// = p_j·ΣΔx is the force of the whole width at its pressure, as with independent sections. δ_c
/// rises strictly too, so all of this holds for the sum.
///
/// Solved by Newton's method on min(a_j + G_jj·f_j, r_j) = 0 (the same conditions, the first term
/// being what a section gives when it lets go) in the unknowns f, where the Jacobian is analytic
/// and symmetric: (D + G)·δ = −r over the sections in contact, D = diag(da/df)
/// = diag(2u/((2·k_s·u + k_r)·Δx)), u = √a, by Cholesky. A full step is taken when it halves the
/// largest residual; else interior-point steps on Ψ(f) − μ·Σ ln f, μ → 0, find which sections are
/// in contact. From the last revolution's roots it takes one or two steps. What is not solved is
/// reported, never returned as if it were.
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
        int iterations = 0;     ///< Cholesky factors it took
        double residual_mm = 0; ///< largest |min(a + G·f, r)| of what is returned
    };

    /// `root` holds u = √a of each section [√mm], from the last revolution as the start, and takes
    /// the solution; all zero is a cold start. Allocates nothing.
    Outcome solve(const double* lag_mm, double* root);

    [[nodiscard]] std::size_t size() const;
    /// f of the last solution [N], J values; their sum is the normal force on the wheel.
    [[nodiscard]] const double* sliceForces_n() const;

    /// Largest residual of a solution [mm], beside what rounding costs at a large h.
    static constexpr double tolerance_mm = 1e-13;
    static constexpr int maxIterations = 100;

private:
    class Solver;
    std::unique_ptr<Solver> m_solver;
};

/// Whether a project's cycle has its sections coupled.
[[nodiscard]] inline bool isCoupled(const Project& project) {
    return project.operation == Operation::plunge && project.sections_coupled;
}

} // namespace sparkout
