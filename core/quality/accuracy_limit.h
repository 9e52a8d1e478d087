// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/force.h"
#include "core/quality/limit_series.h"
#include "core/simulation/result.h"

#include <functional>
#include <optional>
#include <vector>

/// The limit of the feed by accuracy [MODEL-8, PEREVERZEV1999], beside those of LimitSeries.
///
/// Release. A pass of a radius keeps a + γ·P(a) = γ·P(a_before) + Δt. Where the wheel head never
/// retracts, Δt ≥ 0, each cut is bounded from below by the one before:
///
///     a ≥ σ(a_before),   σ(a) + γ·P(σ(a)) = γ·P(a),   σ rising.
///
/// So where the last cut is at most a*, a cut that is followed by n others is σ^(−n)(a*) at most.
/// The stock removed after it is at least σ(a) + σ²(a) + … until a* is reached: a cut with the
/// stock S still to come is at most the a for which this sum is S. This gives the curve.
///
/// The last cut. Let two lanes (sections of a plunge) of the compliances γ_1 < γ_2 be fed alike
/// from rest on, with the same blank. The deflection D after a pass grows with the one before it
/// and with γ, so D_2 ≥ D_1 after every pass. Both lanes end at t_П less D, so their radii differ
/// by D_2 − D_1; where that is at most s, a_1 − a_2 = (D_2 − D_1) − (D_2 − D_1)_before ≤ s, and
///
///     γ_2·P(a_2) − γ_1·P(a_2 + s) ≤ D_2 − D_1 ≤ s,
///
/// whose left side rises with a_2: its root bounds the last cut of the compliant lane, and the root
/// plus s that of the others. s is the total runout, less the machine's, for every radius; or half
/// of the field of the diameter, for one radius of each two that are opposite. A roughness that is
/// calibrated bounds the last cut of every lane. Runout does not: greater cuts copy less of the
/// blank's form.
///
/// This is proved for uncoupled sections of a plunge of one blank without wheel contact, threshold
/// of the force, retraction and a wheel out of true, with S counted from the size that the radius
/// ends at. It allows for a last pass that begins without deflection and cuts the lanes
/// differently, so it is wide.
///
/// The last cuts together. A last cut as great as this follows a small one. Let x and y be the last
/// cut of the compliant lane and the one before, e = D_2 − D_1 after each pass:
///
///     e_n = γ_2·P(x) − γ_1·P(a_1) ≤ s,  so  a_1 ≥ g(x),  γ_1·P(g(x)) = max(γ_2·P(x) − s, 0),
///     e_(n−1) = e_n + x − a_1 ≤ s + x − g(x),  and  y ≤ σ^(−1)(x).
///
/// So y is a last cut where the radii may differ by s' = s + x − g(x); the same applies to the cut
/// before it. All terms rise with x except −g, which falls: over x₁ … x₂ the bounds are at most
/// those with x₂, and x₁ in g.
///
/// Where the last cuts of all lanes are equal, as at a steady feed, their radii differ by (γ_max −
/// γ_min)·P(a): the a for which that is s is an additional estimate, and the only one for zones of
/// traverse and coupled sections.
namespace sparkout {

/// σ^(−1): the greatest cut after which one of a may follow [mm].
[[nodiscard]] double depthBefore(const ForceLaw& law, double b, double gamma, double a_mm);
/// σ: the least cut that may follow one of a [mm], and the greatest one with this infeed [mm]
/// between the two.
[[nodiscard]] double depthAfter(const ForceLaw& law, double b, double gamma, double a_mm,
                                double infeed_mm = 0);

/// The greatest last cut of the more compliant of two lanes whose radii may differ by s [mm];
/// infinite where γ_1 = γ_2.
[[nodiscard]] double lastCutOfSpread(const ForceLaw& law, double b, double stiffGamma,
                                     double compliantGamma, double s_mm);

/// The greatest sum of the last `count` cuts [mm], each at most `most` of the stock left after it
/// [mm], a non-decreasing function.
[[nodiscard]] double lastCutsOfSpread(const ForceLaw& law, double b, double stiffGamma,
                                      double compliantGamma, double s_mm, int count,
                                      const std::function<double(double)>& most);

/// The cut at which two lanes with equal cuts end s apart [mm]; infinite where γ_1 = γ_2.
[[nodiscard]] double steadyCutOfSpread(const ForceLaw& law, double b, double stiffGamma,
                                       double compliantGamma, double s_mm);

/// The greatest cut as a function of the stock still to be removed, from 0 to `deepest_mm`, by
/// rising stock, for a last cut of at most a* [mm].
[[nodiscard]] LimitPoints releaseCurve(const ForceLaw& law, double b, double gamma,
                                       double lastCut_mm, double deepest_mm);

/// The validity of a curve.
enum class AccuracyProof {
    proved,  ///< over the stock that a radius loses until the end of its cycle
    estimate ///< for equal last cuts
};

struct AccuracyLimit {
    double lastCut_mm = 0; ///< a*
    LimitPoints curve;
};

/// The allowed difference of a radius of two lanes at the end: for every radius the total runout or
/// the whole tolerance of the diameter, since each pair of opposite radii keeps it in sum and the
/// difference of lanes has one sign; for one of two opposite radii half the tolerance.
enum class SpreadOf { eachRadius, oneOfTwo };
/// s [mm] required by the project; infinite where nothing is proved.
[[nodiscard]] double provedSpread_mm(const Project& project, SpreadOf of);
/// The proved a* of such a radius; infinite where nothing is proved.
[[nodiscard]] double provedLastCut_mm(const Project& project, double b, double gamma,
                                      SpreadOf of = SpreadOf::eachRadius);

/// The limit of a group of the series; empty where the drawing and the project bound no last cut,
/// the wheel head may retract, or nothing is proved.
[[nodiscard]] std::optional<AccuracyLimit> accuracyLimit(const SimulationResult& result,
                                                         const LimitSeries& series,
                                                         const LimitGroup& group,
                                                         AccuracyProof proof);

/// The limit as it was published [PEREVERZEV1999, eq. 22]: in every pass γ·(P(a_max) − P(a_min)) ≤
/// [δ], [δ] the radial runout of the drawing less the machine's, or the tolerance of the diameter.
/// Gives for the passes of a group the a_max that their a_min allows, by rising stock.
[[nodiscard]] LimitPoints publishedAccuracy(const SimulationResult& result,
                                            const Trajectory& trajectory, const LimitSeries& series,
                                            const LimitGroup& group);

/// The programmed feed per revolution, or per double stroke, over the stock: a step for each stage.
[[nodiscard]] LimitPoints programmedSteps(const SimulationResult& result, const LimitSeries& series,
                                          const LimitGroup& group);

} // namespace sparkout
