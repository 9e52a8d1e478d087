// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/cutting.h"

namespace sparkout {

/// Roughness after Isakov [MODEL-8, PEREVERZEV1999]:
///
///     Ra = f·0.2·( (d_g/tg φ)·√(Δ/(4·N_s))·( √(η + s) − √η ) )^(2/3)
///     s = (π²/V_k)·√(d(d + D)·n·S_ф/D) = π·(V_d/V_k)·√(a/D_e),   N_s = 0.5·(62 − 100·W_g)
///
/// with S_ф = a·n, a the depth of cut of the last pass [mm], f the calibration factor. The form
/// with D_e is the printed one for external grinding and carries it to bores. Ra rises with a from
/// 0 on: a limit of Ra is a limit of a.
class RoughnessModel {
public:
    explicit RoughnessModel(const Project& project);

    /// Ra [mm].
    double roughness(double a, FormulaSheet* sheet = nullptr) const;
    /// The depth of cut [mm] that leaves this Ra [mm]; S_f = limitDepth·n.
    double limitDepth(double Ra, FormulaSheet* sheet = nullptr) const;

private:
    void stateGrain(FormulaSheet* sheet) const;

    Cutting m_cutting;
    double m_grain, m_grainShare, m_tipAngle_deg, m_chipping, m_factor;
    double m_structure; ///< N_s
    double m_profile;   ///< G = (d_g/tg φ)·√(Δ/(4·N_s)) [mm^1.5]
};

/// Whether a measured Ra has been put in relation to the computed one. Until then Ra comes out too
/// small, and the depth of cut that a limit of Ra allows is no number to go by.
[[nodiscard]] bool isRoughnessCalibrated(const Project& project);

[[nodiscard]] FormulaSheet roughnessSheet(const Project& project, double a);
/// The limiting depth and, as its last step, the limiting feed S_ф = a·n [mm/min].
[[nodiscard]] FormulaSheet roughnessLimitSheet(const Project& project, double Ra);

} // namespace sparkout
