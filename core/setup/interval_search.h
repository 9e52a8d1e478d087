// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/optimisation.h"
#include "core/quality/constraints.h"
#include "core/search/optimise.h"
#include "core/setup/worn_project.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

/// The cycle of a grid and the number of parts between dressings together: the cheapest combination
/// of a grid, or the one with the longest life of the wheel [MODEL-12].
///
/// A cycle c is fit for N parts if it ends by itself and meets every requirement for each of the
/// parts 1…N, part n with the wheel as the metal that c removes of the parts before it leaves it
/// (WheelCourse); its life L(c) is the greatest such N, ∞ if from a part on the wheel no longer
/// changes and none fails. t(c) is its time on the nominal part, the first after dressing, by which
/// all searches compare. The cost of a part, f(t, N) = partCost(), grows with t and never grows
/// with N. Let T(N) be the least t(c) of the cycles with L(c) ≥ N, none: ∞.
///
/// 1. T never falls: the cycles that are fit for N + 1 parts are among those that are fit for N.
/// 2. The least cost over all cycles and the intervals they are fit for is the least f(T(N), N)
///    over all N, since among the cycles that are fit for N parts that of the time T(N) is the
///    cheapest.
/// 3. Let a search for m parts find c, with the life l ≥ m. Then T(N) = t(c) for all N from m to l:
///    not less by (1), not more as c is fit for them. Of these l is the best. The remaining numbers
///    lie below m, or beyond l with T no less than t(c). If the search finds nothing, no cycle is
///    fit for m parts or more.
/// 4. Among the numbers from a to b with T no less than τ none is better than f(τ, b): they are
///    left out if that is not better than the best so far. The numbers with the best such bound are
///    searched next, so a stopped search knows a bound of all.
/// 5. For the wheel's life, f is −N, and all this holds as well.
///
/// Each search leaves fewer numbers, so it ends. It does not rely on a wheel that gets duller from
/// part to part: a cycle may fail for one part and hold for a later one. All parts are tried, first
/// those that excluded cycles before. From the part after which the state of the wheel no longer
/// changes, one stands for all.
///
/// Among equal costs the quicker cycle wins, then the longer interval. Among the cycles of the time
/// T(N) the one of the greatest least margin over the parts 1…N, then as optimise() has it.
namespace sparkout {

/// Why a project's objective cannot be searched.
enum class ObjectiveFault {
    none,
    noRates,   ///< for cost, without hourly rates
    otherAim,  ///< a greatest margin is required, too
    otherParts ///< it must also be fit for phases of the stock or a batch
};
[[nodiscard]] ObjectiveFault objectiveFault(const Project& project, bool isRobust);

/// The objective of a project's search; without one: time.
[[nodiscard]] SearchObjective objectiveOf(const Project& project);

/// The life of a cycle between dressings.
struct PartsHeld {
    std::int64_t parts = 0; ///< parts for which it is fit, limited by the requested number
    bool isEndless = false; ///< also fit for any greater number
    bool isAll = false;     ///< limited by the requested number: it may be fit for more
    double meanTime_s = 0;  ///< mean time of these parts
    /// The requirement violated most by the next part; empty if it does not reach size, or if none
    /// fails.
    std::optional<ConstraintKind> end;
};

/// Greatest number of parts tried, unless the project allows fewer.
inline constexpr std::int64_t mostPartsTried = 10000;

/// For the project's cycle: runs part by part up to the first that fails, or the last that the
/// project allows. A stop shortens it.
[[nodiscard]] PartsHeld partsHeld(const Project& project, const SurfaceWear& wear,
                                  std::int64_t most = mostPartsTried,
                                  const std::stop_token& stop = {});

struct IntervalOptions {
    /// Requires a proving method, for the least time, without a challenge or test of the margin.
    SearchOptions search;
    std::int64_t most = mostPartsTried;
};

struct IntervalSummary {
    /// The answer, or the best found; the counts are those of all searches. Its bound is that of
    /// the time.
    SearchSummary search;
    std::optional<PartsHeld> held; ///< parts held by the answer, if the wheel wears
    std::optional<double> cost;    ///< cost of a part, by the time of the nominal part
    std::optional<double> bound;   ///< after a stop: lower bound of the cost, upper of the life
    std::vector<Project> parts;    ///< for the answer: some of 2…N that excluded cycles, and N
    int searches = 0;

    /// The key for comparing the answers of several grids, less is better: its cost, or minus its
    /// parts; the time if neither is known.
    [[nodiscard]] double value(SearchObjective objective) const;
};

/// Searches a valid project without fault for its objective. Without wear the answer is that for
/// the least time.
[[nodiscard]] IntervalSummary searchInterval(const Project& given, const SurfaceWear& wear,
                                             const IntervalOptions& options);

} // namespace sparkout
