// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/cutting.h"
#include "core/simulation/result.h"

#include <numbers>
#include <optional>

namespace sparkout {

/// How far one wheel and dressing may lie from another, up or down: an estimate.
inline constexpr double roughnessSpread = std::numbers::sqrt3;

/// What Ra is multiplied by [MODEL-8]: as it was measured, or an estimate's range.
struct RoughnessFactor {
    double least = 1, most = 1;
    [[nodiscard]] bool isMeasured() const { return least == most; }
    /// The greatest Ra of an estimate by its least one; nothing where the factor is measured.
    [[nodiscard]] std::optional<double> greatestOf(double leastRa) const {
        return isMeasured() ? std::nullopt : std::optional(leastRa * most / least);
    }
};
/// The factor that is given or follows from a measured Ra; else, while it stands at 1, the range
/// that usual wheels lie in.
[[nodiscard]] RoughnessFactor roughnessFactor(const Project& project);

/// Whether a measured Ra has been put in relation to the computed one. Until then Ra is a range,
/// and the depth of cut that a limit of Ra allows is no number to go by.
[[nodiscard]] bool isRoughnessCalibrated(const Project& project);

/// Returns Ra [mm], computed with a factor of 1, at the infeed and the spark-out of the measured Ra
/// of the wheel, or else of the cycle, for an infeed that has become steady at the gauge. Empty
/// where none is measured, or the project has errors or no infeed.
[[nodiscard]] std::optional<double> computedAsMeasured(const Project& project);
/// Returns the factor by which the measured Ra follows from the computed one. Empty also
/// where it is 0 to rounding, or beyond mostRoughnessFactor.
[[nodiscard]] std::optional<double> factorOfMeasuredRa(const Project& project);
/// The project with that factor as its own, where it has none: from here on speeds, diameters and
/// dullness may change, and what was measured stays.
[[nodiscard]] Project withMeasuredRa(Project project);

/// Roughness after Isakov [MODEL-8, PEREVERZEV1999]:
///
///     Ra = f·0.2·( (d_g/tg φ)·√(Δ/(4·N_s))·( √(η + s) − √η ) )^(2/3)
///     s = (π²/V_k)·√(d(d + D)·n·S_ф/D) = π·(V_d/V_k)·√(a/D_e),   N_s = 0.5·(62 − 100·W_g)
///
/// with S_ф = a·n, a = a_s/u what a revolution took of the depth a_s of the last revolution or
/// double stroke with infeed [mm], u = 1 of a plunge and the overlap B·n/S_ax of a stroke, f the
/// factor. The form with D_e is the printed one for external grinding and carries it to bores.
/// Ra rises with a from 0 on: a limit of Ra is a limit of a. In the spark-out after it
///
///     Ra_e = Ra·( r + (1 − r)·exp(−t/τ) ),   τ = 2·T·h/a_s,   r = ½
///
/// falls towards a rest: T·h/a_s is how long the system would take to give back at the rate of that
/// step what the step had to take, which is no less than the time constant of its deflection.
class RoughnessModel {
public:
    /// With the least factor of the project.
    explicit RoughnessModel(const Project& project);
    RoughnessModel(const Project& project, double factor);

    /// Ra [mm] straight after infeed that took so much a revolution [mm].
    double roughness(double a, FormulaSheet* sheet = nullptr) const;
    /// Ra [mm] at the end of the cycle.
    double roughness(const LastCut& cut, FormulaSheet* sheet = nullptr) const;
    /// What a step of the overlap u may take [mm] that leaves this Ra [mm] without a spark-out;
    /// S_f = limitDepth·n.
    double limitDepth(double Ra, double overlap = 1, FormulaSheet* sheet = nullptr) const;
    /// What a revolution of a plunge may take if any spark-out may follow [mm]: no less than the
    /// last cut of a cycle that leaves this Ra.
    [[nodiscard]] double mostDepth(double Ra) const;

private:
    void stateGrain(FormulaSheet* sheet) const;

    Cutting m_cutting;
    double m_grain, m_grainShare, m_tipAngle_deg, m_chipping, m_factor;
    double m_structure; ///< N_s
    double m_profile;   ///< G = (d_g/tg φ)·√(Δ/(4·N_s)) [mm^1.5]
};

/// Straight after the infeed.
[[nodiscard]] FormulaSheet roughnessSheet(const Project& project, double a);
[[nodiscard]] FormulaSheet roughnessSheet(const Project& project, const LastCut& cut);
/// The limiting depth of a pass of the effective width b and, as its last step, the limiting feed
/// S_ф = a·n [mm/min].
[[nodiscard]] FormulaSheet roughnessLimitSheet(const Project& project, double Ra, double b);

/// u of passes of the effective width b: revolutions that the wheel takes over a point in a stroke,
/// 1 in a plunge.
[[nodiscard]] double strokeOverlap(const Project& project, double b);

} // namespace sparkout
