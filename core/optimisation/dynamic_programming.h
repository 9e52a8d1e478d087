// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

/// Dynamic programming for plunge cycles, as it was published and a little better. Both are
/// heuristics: what they find holds, but a quicker cycle may hold too, and where they find nothing
/// there may be one. They are here to be compared with the proven answer.
///
/// The thesis of 1999 divides the stock into levels n and lists feeds m; a state [n, m] is a level
/// reached with a feed. Of all moves into a state that break no requirement only the quickest is
/// kept, with its predecessor (eq. 27):
///
///     T[n,m] = min over m' of ( T[n−1,m'] + τ )
///
/// That would be exact if what comes after a state did not depend on how it was reached. In an
/// elastic system it does: the deflection stored by every radius of every section is part of the
/// state. The quickest way to a level is the one with the largest forces; it leaves the largest
/// deflection, and what follows then overshoots, runs out or burns, where a slower way would have
/// held. Of 60 small random cases the rule that keeps the quickest predecessor found no cycle in
/// 29 where one exists and a slower one in 8; keeping all labels that are not dominated in time
/// and deflection was still wrong in about a quarter of 300 [MODEL-8]. On the 193 random cases with
/// a cycle of test_dynamic_programming, whose states have the feed as printed, the published rule
/// finds none in 30 and a slower one in 6, the labels a slower one in 50; the tests print it anew.
///
/// Here a state is a number of stages done, a level (steps of stock taken by them) and, as
/// published, the last feed: the grid limits the stages, of which the thesis has as many as
/// levels. A move is a stage, from any level before; τ is its simulated time. The size is gauged
/// at the end of the move alone, as the drawing is: a move into the last level is admissible when
/// the whole cycle holds, any other when its passes break no limit.
namespace sparkout {

/// The rule as published: one label a state, the quickest.
[[nodiscard]] SearchSummary publishedProgramming(const Project& project, const Grid& grid,
                                                 const SearchOptions& options);

/// A state keeps every label that no other beats in both time and stored deflection, t_П less what
/// the gauge sees removed; its feed is no part of it, unless feeds must not rise. The labels that
/// cannot become the best, by the proven bound of their time, are dropped as well.
[[nodiscard]] SearchSummary labelSetting(const Project& project, const Grid& grid,
                                         const SearchOptions& options);

} // namespace sparkout
