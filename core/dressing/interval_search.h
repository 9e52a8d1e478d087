// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"
#include "core/project/optimisation.h"
#include "core/quality/constraints.h"
#include "core/setup/surface_wear.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

/// The cycle of a grid and the number of parts between dressings together: what of a grid is the
/// cheapest, or keeps the wheel longest [MODEL-12].
///
/// A cycle c holds for N parts when it ends by itself and meets every requirement for each of the
/// parts 1…N, part n with the wheel as the metal that c removes of the parts before it leaves it
/// (WheelCourse); its life L(c) is the greatest such N, ∞ where from a part on the wheel comes to
/// all parts alike and none fails. t(c) is its time on the part as it stands, the first after
/// dressing, by which all searches compare. What a part costs, f(t, N) = partCost(), grows with t
/// and never grows with N. Let T(N) be the least t(c) of the cycles with L(c) ≥ N, none: ∞.
///
/// 1. T never falls: the cycles that hold for N + 1 parts are among those that hold for N.
/// 2. The least cost of all cycles and intervals they hold for is the least f(T(N), N) of all N,
///    since of the cycles that hold for N parts that of the time T(N) is the cheapest.
/// 3. Let a search for m parts find c, with the life l ≥ m. Then T(N) = t(c) for all N from m to l:
///    not less by (1), not more as c holds for them. Of these l is the best. What is left to look
///    at lies below m, or beyond l with T no less than t(c). Where it finds nothing, no cycle holds
///    for m parts or more.
/// 4. Of the numbers from a to b with T no less than τ none is better than f(τ, b): they are left
///    out where that is not better than the best so far. The numbers with the best such bound are
///    gone on with, so a search that is stopped knows a bound of all.
/// 5. For the wheel's life −N stands for f, and all this holds as well.
///
/// Each search leaves fewer numbers, so it ends. That a wheel gets duller from part to part is not
/// made use of: a cycle may fail for one part and hold for a later one, and all are tried, those
/// first that shut out cycles before. From a part on to which the wheel comes as to all further
/// ones, one stands for all.
///
/// Among equal costs the quicker cycle wins, then the longer interval. Among the cycles of the time
/// T(N) the one of the greatest least margin over the parts 1…N, then as optimise() has it.
namespace sparkout {

/// Why a project's objective cannot be searched.
enum class ObjectiveFault {
    none,
    noRates,   ///< the cost, without what an hour costs
    otherAim,  ///< a greatest margin is asked for, too
    otherParts ///< it must hold for phases of the stock or a batch, too
};
[[nodiscard]] ObjectiveFault objectiveFault(const Project& project, bool isRobust);

/// The objective of a project's search; without one: time.
[[nodiscard]] SearchObjective objectiveOf(const Project& project);

/// How a cycle does from one dressing to the next.
struct PartsHeld {
    std::int64_t parts = 0; ///< it holds for; at most so many were asked for
    bool isEndless = false; ///< and for any number more
    bool isAll = false;     ///< that were asked for: it may hold for more
    double meanTime_s = 0;  ///< of these parts
    /// What fails by most for the next part; nothing: it does not reach size there, or none fails.
    std::optional<ConstraintKind> end;
};

/// Parts that are tried at most, where the project does not allow fewer.
inline constexpr std::int64_t mostPartsTried = 10000;

/// Of the project's cycle, part by part up to the first that fails, or the last that the project
/// allows. A stop leaves it short.
[[nodiscard]] PartsHeld partsHeld(const Project& project, const SurfaceWear& wear,
                                  std::int64_t most = mostPartsTried,
                                  const std::stop_token& stop = {});

struct IntervalOptions {
    /// Of a method that proves, for the least time, without a challenge or test of the margin.
    SearchOptions search;
    std::int64_t most = mostPartsTried;
};

struct IntervalSummary {
    /// The answer, or the best so far; what was counted is of all searches. Its bound is of the
    /// time.
    SearchSummary search;
    std::optional<PartsHeld> held; ///< by the answer, where the wheel wears
    std::optional<double> cost;    ///< of a part, by the time of the part as it stands
    std::optional<double> bound;   ///< stopped: no cost is less, or no life longer, than that
    std::vector<Project> parts;    ///< of the answer, some of 2…N that shut out cycles, and N
    int searches = 0;

    /// What the answer is compared by among those of several grids, less is better: its cost, its
    /// parts below 0; the time where neither is known.
    [[nodiscard]] double value(SearchObjective objective) const;
};

/// Searches a valid project for the objective it states, of those without fault. Without wear its
/// answer is that for the least time.
[[nodiscard]] IntervalSummary searchInterval(const Project& given, const SurfaceWear& wear,
                                             const IntervalOptions& options);

} // namespace sparkout
