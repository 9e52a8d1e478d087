// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/project.h"

/// Edits of the search for a project's quickest cycle.

namespace sparkout {

/// Returns the project with a usual search about its cycle: roughing, finishing and, where the
/// cycle has one, spark-out, as in a shop. Its answer is fit for every corner of the batch, or
/// without a valid batch for every stock within one infeed; levels are preferred numbers R10 in
/// steps of the machine, and the feeds of the cycle, which no answer is slower than where it is fit
/// itself and within the limits below.
///
/// * Plunge: roughing from half its current feed to Q'_w = 2 mm³/(mm·s) and 1.2 mm/min (unhardened
///   steel and iron 3 and 1.6), in a bore half of that Q'_w; finishing from 0.05 to 0.08, 0.125 or
///   0.16 mm/min by the required roughness.
/// * Traverse: roughing from 0.5 to 1.6 of its current infeed, at most 25 µm, finishing from 0.6 to
///   2 of its current infeed, at most 5 µm, both per double stroke; S_ax from 0.15 to 0.4 B·n.
///   Where the machine has a range of the continuous infeed, stages may instead have one that feeds
///   as much in a double stroke.
/// * A cycle that does not rough, finish and spark out, and that is unfit for some stock, is not
///   searched about: the grid is about startingCycleInSteps() instead.
/// * Where a roughness is required that is only estimated, as a range, nothing else keeps finishing
///   slow: then its feeds are within these limits also where those of the cycle are beyond them,
///   and its S_ax is at most 0.2, 0.25 or 0.35 B·n by the required roughness, as in a starting
///   cycle.
/// * Finishing takes at least 15 µm and three quarters of its current stock, at most twice that; a
///   spark-out takes at most 6 µm and what a late gauge lets finishing feed meanwhile, and lasts 3
///   s, its current time or half as long again, in whole revolutions, or two and three double
///   strokes.
///
/// Stages that take stock have the usual overlap and steps, as with withPracticalLimits(). The
/// project must be valid; where such a grid has no cycle the grid is that of withOfferedSearch().
[[nodiscard]] Project usualSearch(Project project);

/// Returns startingStages() with stocks in the steps of the project's search, or of a usual one.
/// The cycle is mostly fit for every stock and for the batch: a search that has it in its grid has
/// an answer early.
[[nodiscard]] Cycle startingCycleInSteps(const Project& project);

/// Returns the project with a usual grid: preferred numbers over the machine's whole ranges as
/// levels of the feeds, which follow the answer, about 15 steps of stock, up to two stages or three
/// where the cycle has them, and feeds that never rise.
[[nodiscard]] Project withUsualSearch(Project project);

/// Returns the project with the usual practical limits of a stage where it states none: least
/// overlap of every stage and of the last, least number of steps. A cycle that a shop would not run
/// then violates a requirement, possibly also the current one.
[[nodiscard]] Project withPracticalLimits(Project project);

/// Returns the project with the usual search that is offered: with practical limits, so that its
/// answer can be run.
[[nodiscard]] Project withOfferedSearch(Project project);

/// Returns the project with usual levels in its search for those feeds of its operation that have
/// none. All other inputs of the search are kept, including those for the other operation.
[[nodiscard]] Project withSearchFor(Project project);

/// Returns whether a search of two projects has the same answer: only their cycles, names, notes
/// and kept runs differ.
[[nodiscard]] bool sameSearch(const Project& a, const Project& b);

} // namespace sparkout
