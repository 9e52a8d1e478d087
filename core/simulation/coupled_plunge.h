// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/simulation/run.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Sections coupled [MODEL-6]: what the plunge cycle does differently when a force in one section
/// deflects the others too. Before a revolution it solves the balance of all sections for every
/// radius and sets the coefficients under which the pass then cuts exactly these depths. Stages,
/// gauge, trajectory and books are those of the cycle with independent sections.
///
/// The discrete influence of the sections is G(x_j,x_l)·Δx, Δx = L_p/J. A section of the
/// independent model is one whose G has nothing beside G_jj·Δx = γ_j·L_p. A free gauge is a place
/// without force of its own: a = h − Σ_l G(x,x_l)·p(a_l)·Δx, or h − γ·ΣP where the gauge's own γ is
/// given; with the wheel's contact a + δ_c(L_p·p(a)) stands in place of a. Section by section the
/// forces are those of the whole width at the section's pressure, L_p·p(a_j), as with independent
/// sections; peak force and power, of a stage and of all, are integrals over the length.
class SectionCoupling {
public:
    /// `points` are the sections, and after them the free gauge if there is one.
    SectionCoupling(const Project& project, const std::vector<CompliantPoint>& points,
                    const Blank& blank, const std::stop_token& stop = {});

    enum class Outcome { solved, notSolved, stopped };

    /// Solves the coming revolution and puts it into `width`. `at` is where it stands in the cycle.
    Outcome solve(const PassFeed& feed, const Place& at, CutWidth& width,
                  const std::stop_token& stop);

    /// Peak force and peak power of the integrals, in place of the largest section's.
    void putPeaks(SimulationResult& result) const;

private:
    struct StagePeaks {
        Peak normalForce_n, power_w;
    };
    void keepPeaks(const double* roots, const Place& at);
    [[nodiscard]] double gaugeRoot(double lag_mm, double from) const;
    void impose(std::size_t lane, double root, double lag_mm, CutWidth& width);

    std::size_t m_radii, m_sections, m_points;
    double m_sliceWidth;
    ForceLaw m_law;
    std::optional<ContactCompliance> m_contact;
    CoupledSections m_balance;
    std::vector<double> m_gaugeInfluence; ///< G(x_gauge, x_l), empty without a free gauge
    std::vector<double> m_depth;          ///< of each lane, as the run keeps it [mm]
    std::vector<double> m_roots;          ///< of the last revolution, radius by radius, J each
    std::vector<double> m_lag;            ///< of one radius, J values
    double m_wheelSpeed_m_s;
    double m_gaugeRoot = 0;          ///< of the last radius
    std::vector<StagePeaks> m_peaks; ///< of each stage of the cycle
};

} // namespace sparkout
