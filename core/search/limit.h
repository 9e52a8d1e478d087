// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/quality/accuracy_limit.h"
#include "core/quality/limit_series.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Range of the remaining stock in which one bound determines the limit.
struct LimitPiece {
    double from_mm = 0, to_mm = 0;              ///< stock left per side, falling
    LimitBound bound = LimitBound::stock;       ///< feed: with the build-up from zero deflection
    ConstraintKind kind = ConstraintKind::burn; ///< kind of the requirement, where one is the bound
    double cut_mm = 0;                          ///< greatest depth of cut in the range
    double time_s = 0;                          ///< its share of the limit
};

/// The decisive one of the bounds described below.
enum class LimitBy {
    steps,  ///< |R_first − R_t| by the greatest infeed
    rates,  ///< the integral of ds/ρ
    passes, ///< whole passes counted
};

/// Radius whose passes are counted.
struct CountedRadius {
    std::size_t section = 0;
    SpreadOf spread = SpreadOf::eachRadius; ///< the spread that bounds its last cuts
    int together = 0;                       ///< number of last cuts that are bounded by their sum
};

/// Cycles to which a limit applies.
struct LimitedCycles {
    double continuousFeed_mm_min = 0; ///< greatest S_c of these cycles; 0: they have none
    bool drawBack = false;            ///< includes cycles that retract the wheel head
    bool sparkOut = false; ///< cycles that end after a number of steps without feed are included
};

struct SteplessLimit {
    double time_s = 0; ///< steplessLimit_s()
    LimitBy by = LimitBy::steps;
    CountedRadius counted{}; ///< the counted radius, for LimitBy::passes
    /// Pieces in the order of falling stock, adjacent, each with another bound than its neighbour;
    /// their times add up to the limit. Empty where the limit is 0 or a stop cut the computation
    /// short.
    std::vector<LimitPiece> pieces;
    LimitedCycles cycles{};
};

/// Returns the stepless limit with its bounds piece by piece: the bound of a piece is, at each of
/// its stocks, the least of those that count where the limit is found.
///
/// * rates: of the requirements on a pass, at the axial feed of ρ(s), by cells of the stock;
/// * passes: of A_i and M(S') for each pass, over the stock that it takes; accuracy of the last
///   ones where their sum counts;
/// * steps: the greatest infeed alone.
///
/// The time of plunging in is distributed over the pieces by their stock.
[[nodiscard]] SteplessLimit steplessLimitBounds(const Project& project,
                                                const std::stop_token& stop = {});

[[nodiscard]] const char* limitByKey(LimitBy by); ///< steps, rates or passes

/// Returns the stepless limit: no cycle that is ended by the gauge and meets the requirements on
/// burn, power, self-sharpening and, in plunge grinding, accuracy is quicker, whatever the number
/// and the feeds of its stages [MODEL-8]. The project determines which cycles besides those of the
/// grid are included, so that its own cycle is always one of them:
///
/// * a continuous infeed S_c goes up to the end of the machine's range, without one up to the
///   greatest of the grid and of the project's cycle, which may have none;
/// * the wheel head retracts only if the project's cycle does: its grid never does;
/// * work speed, dwells and a spark-out by count are those of the grid or of the project's cycle.
///
/// When the gauge ends the cycle, Π_rem ≤ slack. Π_rem is |R_first − R_t| less a mean of depths of
/// the gauged section, so one of its radii is within the slack of target or beyond. It started from
/// a stock of at least Π, the least of the blank. Let s be its remaining stock. A pass of the width
/// b takes a ≤ L_b(s after it), the least of the depths that the requirements allow; L rises with s
/// (burn) or does not depend on it. The time between two passes is at least τ(v): 1/n in plunge; in
/// traverse the gauged zone sees two passes in a double stroke, whose dwells and two strokes at the
/// axial feed v, b = min(v/n, B), are charged in halves. With
///
///     ρ(s) = max over v of L_b(s)/τ(v),
///
/// which does not fall with s, a pass from s₁ to s₂ < s₁ has
///
///     ∫_{s₂}^{s₁} ds/ρ(s) ≤ (s₁ − s₂)/ρ(s₂) = a/ρ(s₂) ≤ τ(v),
///
/// and the sum over all passes is T_lim = ∫₀^Π ds/ρ(s) ≤ T. The integral is taken as its lower sum,
/// with ρ at the upper end of each cell; over a cell of v, L_b at its lower and τ at its upper end
/// is not less than L_b/τ within. So the returned value is itself a bound. A pass counts with at
/// most Π, so L_b = Π where nothing limits it.
///
/// Feeds are free up to the machine's range, without one up to the greatest of the grid and of the
/// project's cycle. With the greatest infeed f of a step also T ≥ ⌈|R_first − R_t|/f⌉ steps, since
/// no depth exceeds t_П, or t_П + e under a wheel out of true, for which |R_first − R_t| counts e
/// less and single passes are not counted; the greater of the two bounds holds. Under position
/// control, where the size is not gauged, only the second does.
///
/// In traverse both count the dwells and strokes of a double stroke alone. Its infeed x takes
/// ⌈n·x/S_rad⌉ additional revolutions of plunging in, S_rad as the machine is set, at either
/// reversal or at both. The total infeed is at least |R_first − R_t|, so plunging in adds to either
/// bound
///
///     Σ⌈n·x_i/S_rad⌉ ≥ ⌈n·Σx_i/S_rad⌉ ≥ ⌈n·|R_first − R_t|/S_rad⌉
///
/// revolutions.
///
/// A continuous infeed runs all the time, during plunging in too. With all strokes and dwells
/// taking τ and all plunging in τ_p, the total infeed is at most S_c·(τ + τ_p) plus the infeed of
/// the reversals: S_rad·τ_p at most, and N·f in N double strokes, of which each takes c. So a time
/// T = τ + τ_p has
///
///     T ≥ τ,   S_c·T + S_rad·(T − τ) ≥ |R_first − R_t|,   S_c·T + N·f ≥ |R_first − R_t|,   τ ≥
///     N·c.
///
/// The first two add to the bound of the integral, which is one of τ; all four are the second
/// bound, the least over N. Its third side falls with N, the others rise, so the least T is at the
/// first N where they meet or the one before.
///
/// In a plunge of uncoupled sections without wheel contact and threshold of the force passes are
/// whole, and counted [MODEL-8]. A radius makes one in each revolution. With the allowance r of the
/// radial runout, less the machine's, and δ as below, there is one that loses at least S and may
/// stop κ above the target:
///
/// (1) in the gauged section one that ends within the slack of target, its stock at least that of
///     the blank's deepest radius;
/// (2) in every section, on the diameter of which the deeper end of the blank is the shallowest,
///     one of the two opposite radii, at most δ before target, κ = δ;
/// (3) in the gauged section each of these two, κ = r plus the slack: all radii are that near to
///     (1);
/// (4) in every section each of these two, κ = δ + r/2, as their mean is at most δ.
///
/// For (2) and (4) the gauged and the most compliant section are taken. Each pass of such a radius
/// keeps a + γ·P(a) = γ·P(a_before) + Δt, Δt ≤ f, starting from zero deflection, or it cuts
/// nothing. So
///
/// * build-up: the i-th cut is A_i at most, A_i + γ·P(A_i) = γ·P(A_{i−1}) + f, A_0 = 0;
/// * release, where the wheel head never draws back and so 0 ≤ Δt: a cut after which S is still
///   lost is at most the release curve of core/quality/accuracy_limit.h at S, for the last cut that
///   is proved there: of (1) and (2) for every radius, of (3) and (4), which two opposite radii
///   share, for one of two;
/// * burn, power and self-sharpening: at most L(S + κ).
///
/// The least of the last two, M(S), does not fall with S. From S a pass leads to the least S' with
/// S' + min(A_i, M(S')) ≥ S, whose left side rises; from a smaller S, after more passes, it leads
/// to no greater S'. So the cuts that are greatest throughout need the least passes N, and T ≥ N/n.
/// M is taken at the upper end of each of its cells. A radius that loses more than S needs at least
/// as many passes.
///
/// Where the wheel head never draws back, the last m cuts take together B_m at the most
/// (lastCutsOfSpread() there, each of them f and M at the most). Where S > B_m there are more than
/// m, and before them S comes down to B_m, which needs N_m passes of the same greatest cuts, so N ≥
/// N_m + m; of m = 2 and 3 and of all radii (1) to (4) the greatest N is taken.
///
/// In traverse only the first two bounds are taken. The release cannot be used there: γ·P_b(a)
/// grows with the width b of a pass, so one at a smaller axial feed may cut more than the one
/// before though nothing is fed [MODEL-8].
///
/// Work speeds and dwells are those that the grid lists and those of the project: the least over
/// these variants is returned, whose n and dwells are in τ and in L_b.
///
/// A cycle with a counted spark-out is not ended by the gauge. But where it holds, every diameter
/// of the gauged section is within the drawing's field, so the two radii of one are, in the mean,
/// at most δ before target, the distance from R_t to the field's edge on the side of the stock: the
/// integral is taken from δ, and the infeed is at least |R_first − R_t| − δ, in steps beside which
/// at least one sparks out. With sections coupled the drive has the power of all sections, of which
/// one has at least its slice's.
///
/// The limit is in seconds; it is infinite where a requirement is not met at any depth. The gauge
/// must stand on a section for which the requirements are checked: for a free position only the
/// second bound is used.
///
/// A stop soon ends the computation and leaves out the integrals, or all: the returned value is
/// still a bound, at least 0.
[[nodiscard]] double steplessLimit_s(const Project& project, const std::stop_token& stop = {});

/// Returns whether a limit is known and can be met: 0 is an unknown limit, an infinite one means
/// that no cycle is feasible.
[[nodiscard]] inline bool isKnownLimit(double limit_s) {
    return limit_s > 0 && std::isfinite(limit_s);
}

/// Returns the greatest share of a cycle's time that a stepless cycle might save, 1 − T_lim/T;
/// empty without a known limit.
[[nodiscard]] inline std::optional<double> gapToLimit(double time_s, double limit_s) {
    return time_s > 0 && isKnownLimit(limit_s) ? std::optional(1 - limit_s / time_s) : std::nullopt;
}

} // namespace sparkout
