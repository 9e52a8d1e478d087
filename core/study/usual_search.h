// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

namespace sparkout {

/// The project with a usual search about its cycle: roughing, finishing and, where the cycle has
/// one, spark-out, as a shop would run them. Its answer is good for every corner of the batch, or
/// where none can be run for every stock within one infeed; levels are preferred numbers R10 in
/// steps of the machine.
///
/// * Plunge: roughing from half of what it is to Q'_w = 2 mm³/(mm·s) and 1.2 mm/min, of soft steel
/// 3
///   and 1.6, of a bore half of that Q'_w; finishing from 0.05 to 0.08, 0.125 or 0.16 mm/min by the
///   required roughness.
/// * Traverse: roughing from half to 1.6 of what it is, at most 25 µm, finishing from 0.6 to 2 of
///   what it is, at most 5 µm, both a double stroke; S_ax from 0.15 to 0.4 B·n. Where the machine
///   has a range of the continuous infeed, stages may have one instead that feeds as much in a
///   double stroke.
/// * Finishing takes at least 15 µm and three quarters of what it takes now, at most twice that; a
///   spark-out at most 6 µm; it lasts 3 s, as long as now and half as long again, in whole
///   revolutions, or two and three double strokes.
///
/// Stages that take stock have the usual overlap and steps, as with withPracticalLimits(). Of a
/// valid project; where such a grid has no cycle the search is that of withOfferedSearch().
[[nodiscard]] Project usualSearch(Project project);

} // namespace sparkout
