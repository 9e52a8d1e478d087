// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

#include <limits>

/// Diameters, runouts, form and roughness compared with the drawing [MODEL-8].
namespace sparkout {

/// The part of accuracyOf() that the drawing's tolerances need. A section whose radii lie between
/// circles about the axis nearer to each other than its roundness tolerance by at least `clear_um`
/// may have these instead of its minimum zone, which is no wider.
[[nodiscard]] PartAccuracy
requiredAccuracy(const SimulationResult& result,
                 double clear_um = std::numeric_limits<double>::infinity());

/// Positions and radii of the sections, as input of the part's accuracy.
[[nodiscard]] std::vector<SectionShape> shapesOf(const SimulationResult& result);

/// The shapes of one of the result's zones or sections: its own, or those of its sections.
[[nodiscard]] std::vector<SectionShape> shapesOfPlace(const SimulationResult& result,
                                                      std::size_t section);

/// The greatest roundness deviation by the minimum zone [mm].
[[nodiscard]] double roundnessOf(const SimulationResult& result, std::size_t section);

void evaluateLeastDiameter(ConstraintKind kind, const Judged& of, ConstraintResults& found);
void evaluateLargestDiameter(ConstraintKind kind, const Judged& of, ConstraintResults& found);

void evaluateRadialRunout(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfRadialRunout(const Judged& of);

void evaluateRoundness(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfRoundness(const Judged& of);

void evaluateCylindricity(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfCylindricity(const Judged& of);

void evaluateTotalRunout(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfTotalRunout(const Judged& of);

void evaluateWaviness(ConstraintKind kind, const Judged& of, ConstraintResults& found);

void evaluateRoughness(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfRoughness(const Judged& of);
[[nodiscard]] std::optional<double> roughnessDepth(const Project& project, double b, double stock);

} // namespace sparkout
