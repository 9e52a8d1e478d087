// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

/// Dynamic programming for plunge cycles: the published rule and an improved one. Both are
/// heuristics: a cycle they find is feasible, but a quicker one may be, too, and if they find none
/// there may be one. They serve as a comparison with the proven answer.
///
/// The thesis of 1999 divides the stock into levels n and lists feeds m; a state [n, m] is a level
/// reached with a feed. Among all moves into a state that violate no requirement only the quickest
/// is kept, with its predecessor (eq. 27):
///
///     T[n,m] = min over m' of ( T[n−1,m'] + τ )
///
/// The rule would be exact if everything after a state were independent of how the state was
/// reached. In an elastic system it is not: the deflection stored by every radius of every section
/// is part of the state. The quickest way to a level is the one with the largest forces; it leaves
/// the largest deflection, and the following stages then overshoot, run out or burn where a slower
/// way would not. In 60 small random cases the rule that keeps the quickest predecessor found no
/// cycle in 29 where one exists and a slower one in 8; keeping all labels that are not dominated in
/// time and deflection was still wrong in about a quarter of 300 [MODEL-8]. In the 193 random cases
/// with a cycle of test_dynamic_programming, whose states have the feed as printed, the published
/// rule finds none in 30 and a slower one in 6, the labels a slower one in 50; the tests print
/// these numbers.
///
/// Here a state is a number of finished stages, a level (steps of stock taken by them) and, as
/// published, the last feed: the grid limits the stages, of which the thesis has as many as levels.
/// A move is a stage, from any earlier level; τ is its simulated time. Size and drawing are checked
/// only at the end of a move: a move into the last level is admissible if the whole cycle is
/// feasible, any other if its passes exceed no limit.
namespace sparkout {

/// Searches by the published rule: each state keeps one label, the quickest.
[[nodiscard]] SearchSummary publishedProgramming(const Project& project, const Grid& grid,
                                                 const SearchOptions& options);

/// Searches with several labels per state: a state keeps every label that no other beats in both
/// time and stored deflection, t_П less the removal read by the gauge; its feed is part of the
/// state only where feeds must not rise. Labels that the proven bound of their time excludes from
/// being the best are dropped as well.
[[nodiscard]] SearchSummary labelSetting(const Project& project, const Grid& grid,
                                         const SearchOptions& options);

} // namespace sparkout
