// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/contact_compliance.h"
#include "core/process/coupled_radii.h"
#include "core/process/coupled_sections.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/simulation/run.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Coupling of sections [MODEL-6], by which a force in one section also deflects the others of a
/// plunge cycle. Before a revolution it solves the balance of all sections for every radius, twelve
/// at a time where that is possible, and sets the coefficients with which the pass then cuts
/// exactly these depths. Stages, gauge, trajectory and sums are those of the cycle with independent
/// sections.
///
/// The discrete influence of the sections is G(x_j,x_l)·Δx, Δx = L_p/J. A section of the
/// independent model is one whose only entry of G is G_jj·Δx = γ_j·L_p. A free gauge is a place
/// without a force of its own: a = h − Σ_l G(x,x_l)·p(a_l)·Δx, or h − γ·ΣP where the gauge's own γ
/// is given; with the wheel's contact a + δ_c(L_p·p(a)) replaces a. Section by section the forces
/// are those of the whole width at the section's pressure, L_p·p(a_j), as with independent
/// sections; peak force and power, of a stage and of all, are integrals over the length.
class SectionCoupling {
public:
    /// `points` are the sections, followed by the free gauge if there is one.
    SectionCoupling(const Project& project, const std::vector<CompliantPoint>& points,
                    const Blank& blank, const std::stop_token& stop = {});

    enum class Outcome { solved, notSolved, stopped };

    /// Prepares, once, the width that is given to solve(), so that only C², and with a threshold C
    /// as v, determines the depth of a pass.
    static void takeOver(CutWidth& width);
    /// Solves the next revolution and writes it to `width`. `at` is its place in the cycle.
    Outcome solve(const Run& run, const PassFeed& feed, const Place& at, CutWidth& width,
                  const std::stop_token& stop);

    /// Replaces the largest section's peak force and power by those of the integrals over the
    /// length.
    void putPeaks(SimulationResult& result) const;

private:
    struct StagePeaks {
        Peak normalForce_n, power_w;
    };
    using Row = CoupledRadii::Row;
    void expect(std::size_t block);
    [[nodiscard]] bool balance(std::size_t block, const std::stop_token& stop);
    [[nodiscard]] bool begin(std::size_t block, std::size_t k);
    [[nodiscard]] bool balanceAlone(std::size_t block, std::size_t k, const std::stop_token& stop);
    void sumForces(std::size_t block);
    void impose(CutWidth& width);
    void imposeRubbing(CutWidth& width);
    [[nodiscard]] double forceOf(const Row* roots, std::size_t block, std::size_t section,
                                 std::size_t k) const;
    void imposeGauge(CutWidth& width);
    void keepPeaks(const Place& at);
    [[nodiscard]] std::size_t countIn(std::size_t block) const; ///< radii of a block
    [[nodiscard]] std::size_t deepest(std::size_t k) const;

    std::size_t m_radii, m_sections;
    double m_sliceWidth;
    ForceLaw m_law;
    std::optional<ContactCompliance> m_contact;
    CoupledSections m_balance;
    std::optional<CoupledRadii> m_sideBySide; ///< present where the balance allows it
    std::vector<double> m_gaugeInfluence;     ///< G(x_gauge, x_l), empty without a free gauge
    // Radii are grouped in blocks of twelve; each block has a row for each section.
    std::vector<Row> m_depth; ///< depth of each lane before the last revolution, as in the run [mm]
    std::vector<Row> m_root;  ///< u of the last revolution, after expect() of the next one [√mm]
    std::vector<Row> m_rootBefore, m_rootTwoBefore; ///< u of the two revolutions before that
    std::vector<Row> m_lag;                         ///< lags of one block [mm]
    std::vector<Row> m_rubbing; ///< v of the last revolution; empty: no threshold
    std::vector<double> m_oneLag, m_oneRoot, m_oneRubbing; ///< for one radius
    std::vector<bool> m_cutAll;       ///< by radius: all sections cut it in the last revolution
    std::vector<double> m_gaugeDepth; ///< for each radius [mm]
    std::vector<Row> m_fed;           ///< where the wheel stands, a row for each block [mm]
    std::vector<Row> m_normal,
        m_tangential; ///< the sums of the forces of all sections [N]
    double m_wheelSpeed_m_s;
    double m_gaugeRoot = 0;          ///< for the last radius
    std::vector<StagePeaks> m_peaks; ///< for each stage of the cycle
};

} // namespace sparkout
