// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/quality/accuracy_limit.h"
#include "core/quality/depth_limits.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// A stretch of the stock left in which one bound makes the limit.
struct LimitPiece {
    double from_mm = 0, to_mm = 0;              ///< stock left per side, falling
    LimitBound bound = LimitBound::stock;       ///< feed: with the build-up from no deflection on
    ConstraintKind kind = ConstraintKind::burn; ///< of a requirement
    double cut_mm = 0;                          ///< the greatest there
    double time_s = 0;                          ///< its share of the limit
};

/// Which of the bounds below is the greatest.
enum class LimitBy {
    steps,  ///< |R_first − R_t| by the greatest infeed
    rates,  ///< the integral of ds/ρ
    passes, ///< whole passes counted
};

/// Whose passes are counted.
struct CountedRadius {
    std::size_t section = 0;
    SpreadOf spread = SpreadOf::eachRadius; ///< that its last cuts are bounded by
    int together = 0;                       ///< so many last ones by their sum
};

/// Which cycles a limit is of, beside what holds for all of them.
struct LimitedCycles {
    double continuousFeed_mm_min = 0; ///< the greatest S_c that they have; 0: none
    bool drawBack = false;            ///< those that draw the wheel head back are among them
    bool sparkOut = false;            ///< those that end by a number of steps without feed, too
};

struct SteplessLimit {
    double time_s = 0; ///< steplessLimit_s()
    LimitBy by = LimitBy::steps;
    CountedRadius counted{}; ///< by passes
    /// By falling stock, next to each other, none of the bound of its neighbour; their times add up
    /// to the limit. None where it is 0 or a stop cut it short.
    std::vector<LimitPiece> pieces;
    LimitedCycles cycles{};
};

/// The stepless limit with what makes it, piece by piece: the bound of a piece is the least at each
/// of its stocks of those that count where the limit is found.
///
/// * rates: of the requirements on a pass, at the axial feed of ρ(s), by cells of the stock;
/// * passes: of A_i and M(S') for each pass, over the stock that it takes; accuracy of the last
///   ones where their sum counts;
/// * steps: the greatest infeed alone.
///
/// The time of plunging in is spread over them by the stock.
[[nodiscard]] SteplessLimit steplessLimitBounds(const Project& project,
                                                const std::stop_token& stop = {});

[[nodiscard]] const char* limitByKey(LimitBy by); ///< steps, rates or passes

/// The stepless limit: no cycle that ends by the gauge and holds the requirements on burn, power,
/// self-sharpening and, in a plunge, accuracy is quicker, however many stages it has and whatever
/// their feeds [MODEL-8]. Which cycles are meant beside those of the grid follows from the project,
/// so that its own cycle is always one of them:
///
/// * a continuous infeed S_c goes up to the end of the machine's range, without one up to the
///   greatest of the grid and of the project's cycle, which may have none;
/// * the wheel head draws back where the project's cycle does: its grid never does;
/// * work speed, dwells and a spark-out by count are those of the grid or of the project's cycle.
///
/// When the gauge ends the cycle, Π_rem ≤ slack. Π_rem is |R_first − R_t| less a mean of depths of
/// the gauged section, so one of its radii stands within the slack of target or beyond. It came
/// from a stock of at least Π, the least of the blank. Let s be the stock it has left. A pass of
/// the width b takes a ≤ L_b(s after it), the least of the depths that the requirements allow; L
/// rises with s (burn) or does not depend on it. Between two passes at least τ(v) passes: 1/n in
/// plunge; in traverse the gauged zone sees two passes in a double stroke, whose dwells and two
/// strokes at the axial feed v, b = min(v/n, B), are charged in halves. With
///
///     ρ(s) = max over v of L_b(s)/τ(v),
///
/// which does not fall with s, a pass from s₁ to s₂ < s₁ has
///
///     ∫_{s₂}^{s₁} ds/ρ(s) ≤ (s₁ − s₂)/ρ(s₂) = a/ρ(s₂) ≤ τ(v),
///
/// and the sum over all passes is T_lim = ∫₀^Π ds/ρ(s) ≤ T. The integral is taken as its lower
/// sum, with ρ at the upper end of each cell; over a cell of v, L_b at its lower and τ at its upper
/// end is not less than L_b/τ within. So what is returned is itself a bound. Of a pass no more than
/// Π counts, so L_b = Π where nothing limits it.
///
/// Feeds are free up to the machine's range, without one up to the greatest of the grid and of the
/// project's cycle. With the greatest infeed f of a step also T ≥ ⌈|R_first − R_t|/f⌉ steps, since
/// no depth exceeds t_П; the greater of the two bounds holds. Under position control, where the
/// size is not gauged, only the second does.
///
/// In traverse both count the dwells and strokes of a double stroke alone. What it feeds, x, takes
/// ⌈n·x/S_rad⌉ revolutions of plunging in besides, S_rad as the machine is set, at either reversal
/// or at both. All that is fed is at least |R_first − R_t|, so these add to either bound
///
///     Σ⌈n·x_i/S_rad⌉ ≥ ⌈n·Σx_i/S_rad⌉ ≥ ⌈n·|R_first − R_t|/S_rad⌉
///
/// revolutions.
///
/// A continuous infeed goes on all the time, in plunging in too. With all strokes and dwells taking
/// τ and all plunging in τ_p, what is fed is at most S_c·(τ + τ_p) and what the reversals feed:
/// S_rad·τ_p at most, and N·f in N double strokes, of which each takes c. So a time T = τ + τ_p has
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
/// (1) in the gauged section one that stands within the slack, of the deepest of the blank or less;
/// (2) in every section one of two opposite radii stands δ before target at the most, κ = δ: of
///     the diameter of which the deeper end of the blank is the shallowest;
/// (3) in the gauged section each of these two, κ = r beside the slack: all are so near to (1);
/// (4) in every section each of these two, κ = δ + r/2, as their mean is δ at the most.
///
/// For (2) and (4) the gauged and the most compliant section are taken. Each pass of such a radius
/// keeps a + γ·P(a) = γ·P(a_before) + Δt, Δt ≤ f, from no deflection on, or it cuts nothing. So
///
/// * build-up: the i-th cut is A_i at most, A_i + γ·P(A_i) = γ·P(A_{i−1}) + f, A_0 = 0;
/// * release, where the wheel head never draws back and so 0 ≤ Δt: a cut after which S is still
/// lost is at most the release curve of
///   core/quality/accuracy_limit.h at S, for the last cut that is proved there: of (1) and (2) for
///   every radius, of (3) and (4), which two opposite radii share, for one of two;
/// * burn, power and self-sharpening: at most L(S + κ).
///
/// The least of the last two, M(S), does not fall with S. From S a pass leads to the least S' with
/// S' + min(A_i, M(S')) ≥ S, whose left side rises; and from less, with more passes made, to no
/// more. So the cuts that are greatest throughout need the least passes N, and T ≥ N/n. M is taken
/// at the upper end of each of its cells. A radius that loses more than S needs no fewer.
///
/// Where the wheel head never draws back, the last m cuts take together B_m at the most
/// (lastCutsOfSpread() there, each of them f and M at the most). Where S > B_m there are more than
/// m, and before them S comes down to B_m, which needs N_m passes of the same greatest cuts, so N ≥
/// N_m + m; of m = 2 and 3 and of all radii (1) to (4) the greatest N is taken.
///
/// In traverse only the first two bounds are taken. The release does not follow there: γ·P_b(a)
/// grows with the width b of a pass, so one at a smaller axial feed may cut more than the one
/// before though nothing is fed [MODEL-8].
///
/// Work speeds and dwells are those that the grid lists and those of the project: the least over
/// these variants is returned, whose n and dwells are in τ and in L_b.
///
/// A cycle that sparks out in the end by a count is not ended by the gauge. But where
/// it holds, every diameter of the gauged section is within the drawing's field, so the two radii
/// of one stand, in the mean, no more than δ before target, the distance from R_t to the field's
/// edge on the side of the stock: the integral is taken from δ, and the infeed is at least |R_first
/// − R_t| − δ, in steps beside which at least one sparks out. With sections coupled the drive has
/// the power of all sections, of which one has at least its slice's.
///
/// [s]; infinite where a requirement is not met at any depth. The gauge must stand on a section
/// that the requirements are held against: for a free position the second bound alone is taken.
///
/// A stop leaves out the integrals, soon after it was requested, or all: what is returned is a
/// bound still, 0 at the least.
[[nodiscard]] double steplessLimit_s(const Project& project, const std::stop_token& stop = {});

/// Whether a limit says something: 0 is none that is known, and infinite that no cycle holds.
[[nodiscard]] inline bool isKnownLimit(double limit_s) {
    return limit_s > 0 && std::isfinite(limit_s);
}

/// The share of a cycle's time that a stepless one might at most save: 1 − T_lim/T. Nothing without
/// a known limit.
[[nodiscard]] inline std::optional<double> gapToLimit(double time_s, double limit_s) {
    return time_s > 0 && isKnownLimit(limit_s) ? std::optional(1 - limit_s / time_s) : std::nullopt;
}

} // namespace sparkout
