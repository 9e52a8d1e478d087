// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"

/// Requirements on a cycle [MODEL-8]: burn, self-sharpening and power limit its passes, the others
/// its settings.
namespace sparkout {

/// The visit nearest to burning, with its numbers [MODEL-8].
struct BurnState {
    BurnVisit visit;
    double limitDepth_mm = 0;   ///< the greatest depth of cut allowed for the stock left
    double rise_k = 0;          ///< T at the depth of the stock left, limited by U_burn
    double damagedDepth_mm = 0; ///< h_d, limited by the stock left
};
/// Empty where no temperature rise of burn is given. Where nothing was cut, a depth of 0 with no
/// stock left.
[[nodiscard]] std::optional<BurnState> burnStateOf(const SimulationResult& result);

void evaluateBurn(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfBurn(const Judged& of);
[[nodiscard]] std::optional<double> burnDepth(const Project& project, double b, double stock);

void evaluateSelfSharpening(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfSelfSharpening(const Judged& of);
[[nodiscard]] std::optional<double> selfSharpeningDepth(const Project& project, double b,
                                                        double stock);
[[nodiscard]] std::optional<PassBound> selfSharpeningBound(const Project& project);

/// For coupled sections, whose power is an integral, there is neither a sheet nor a bound.
void evaluateWheelPower(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfWheelPower(const Judged& of);
[[nodiscard]] std::optional<double> wheelPowerDepth(const Project& project, double b, double stock);
[[nodiscard]] std::optional<PassBound> wheelPowerBound(const Project& project);

void evaluateWorkPower(ConstraintKind kind, const Judged& of, ConstraintResults& found);
[[nodiscard]] std::optional<FormulaSheet> sheetOfWorkPower(const Judged& of);
[[nodiscard]] std::optional<double> workPowerDepth(const Project& project, double b, double stock);
[[nodiscard]] std::optional<PassBound> workPowerBound(const Project& project);

// Checks of the settings: the machine's ranges, the gauge's commands, the overlap and the
// number of steps of a stage [MODEL-8].

/// Checks the range of this kind.
void evaluateRange(ConstraintKind kind, const Judged& of, ConstraintResults& found);
void evaluateGaugeCommands(ConstraintKind kind, const Judged& of, ConstraintResults& found);
/// Checks the stages to which the requirement of this kind applies: see checkOverlaps().
void evaluateOverlap(ConstraintKind kind, const Judged& of, ConstraintResults& found);
/// Checks the stage with the fewest steps; no result where no stage counts.
void evaluateLeastSteps(ConstraintKind kind, const Judged& of, ConstraintResults& found);

} // namespace sparkout
