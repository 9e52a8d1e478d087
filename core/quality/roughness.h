// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"
#include "core/surface/cutting.h"

#include <numbers>
#include <optional>

namespace sparkout {

/// Estimated factor between wheels and dressings, up or down.
inline constexpr double roughnessSpread = std::numbers::sqrt3;

/// The factor on Ra [MODEL-8]: by measurement, or an estimated range.
struct RoughnessFactor {
    double least = 1, most = 1;
    [[nodiscard]] bool isMeasured() const { return least == most; }
    /// The greatest Ra of an estimate by its least one; empty if the factor is measured.
    [[nodiscard]] std::optional<double> greatestOf(double leastRa) const {
        return isMeasured() ? std::nullopt : std::optional(leastRa * most / least);
    }
};
/// The factor that is given or follows from a measured Ra; while it is 1, the range of usual
/// wheels.
[[nodiscard]] RoughnessFactor roughnessFactor(const Project& project);

/// Whether the computed Ra is calibrated by a measured one. Until then Ra is a range, and the depth
/// of cut by a limit of Ra is not a single value.
[[nodiscard]] bool isRoughnessCalibrated(const Project& project);

/// Ra [mm] with a factor of 1, at the infeed and the spark-out of the wheel's measured Ra, or else
/// of the cycle, for a steady infeed at the gauge. Empty without a measured Ra, with errors in the
/// project, or without infeed.
[[nodiscard]] std::optional<double> computedAsMeasured(const Project& project);
/// Ra [mm] that the project's cycle usually leaves, for a steady infeed at the gauge: with the
/// measured factor, or else the middle of the usual ones. Empty with errors in the project, or
/// without infeed.
[[nodiscard]] std::optional<double> usualRoughness(const Project& project);
/// The ratio of the measured Ra to the computed one. Empty also where it is 0 to rounding, or above
/// mostRoughnessFactor.
[[nodiscard]] std::optional<double> factorOfMeasuredRa(const Project& project);
/// The project with that factor set, if it has none: then speeds, diameters and dullness may change
/// without changing the calibration.
[[nodiscard]] Project withMeasuredRa(Project project);

/// Roughness after Isakov [MODEL-8, PEREVERZEV1999]:
///
///     Ra = f·0.2·( (d_g/tg φ)·√(Δ/(4·N_s))·( √(η + s) − √η ) )^(2/3)
///     s = (π²/V_k)·√(d(d + D)·n·S_ф/D) = π·(V_d/V_k)·√(a/D_e),   N_s = 0.5·(62 − 100·W_g)
///
/// with S_ф = a·n, a = a_s/u the share of a revolution in the depth a_s of the last revolution or
/// double stroke with infeed [mm], u = 1 in plunge and the overlap B·n/S_ax in a stroke, f the
/// factor. The form with D_e is the printed one for external grinding and carries it to bores. Ra
/// rises with a from 0 on: a limit of Ra is a limit of a. In the spark-out after it
///
///     Ra_e = Ra·( r + (1 − r)·exp(−t/τ) ),   τ = 2·T·h/a_s,   r = ½
///
/// falls towards a remainder: T·h/a_s is the time in which the system would release the lag of that
/// step at its rate, no less than the time constant of its deflection.
class RoughnessModel {
public:
    /// Uses the least factor of the project.
    explicit RoughnessModel(const Project& project);
    RoughnessModel(const Project& project, double factor);

    /// Ra [mm] immediately after an infeed that cuts `a` per revolution [mm].
    double roughness(double a, FormulaSheet* sheet = nullptr) const;
    /// Ra [mm] at the end of the cycle.
    double roughness(const LastCut& cut, FormulaSheet* sheet = nullptr) const;
    /// The greatest depth of a step of the overlap u [mm] that leaves this Ra [mm] without a
    /// spark-out; S_f = limitDepth·n.
    double limitDepth(double Ra, double overlap = 1, FormulaSheet* sheet = nullptr) const;
    /// The greatest depth per revolution of a plunge if any spark-out may follow [mm]: no less than
    /// the last cut of a cycle that leaves this Ra.
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

/// u of passes of the effective width b: revolutions in which the wheel covers a point in a stroke,
/// 1 in plunge.
[[nodiscard]] double strokeOverlap(const Project& project, double b);

} // namespace sparkout
