// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"
#include "core/result.h"
#include "core/surface/formula.h"

#include <optional>
#include <span>
#include <vector>

namespace sparkout {

/// Added to each diameter limit before comparing, to tolerate rounding.
inline constexpr double diameterSlack_mm = 1e-9;

/// The result of checking one requirement, in the unit of its row. `limit` is the limit that the
/// value is compared with, so that always
///
///     margin = limit − value,  or, where the limit is a minimum,  margin = value − limit
///
/// * burn: the depth of cut nearest to the greatest one whose damaged layer stays within the stock
///   left, and that depth;
/// * self-sharpening: the pressure P_y/(b·L) at the largest depth of cut, and 0.25·f_cr·n_g;
/// * roundness and cylindricity: of the minimum zone;
/// * a range of the machine: the setting and the nearer end;
/// * overlap: B·n/S_ax of a stage of a traverse cycle, and 1. Where it is not met strips stay
///   uncut, and requirements on sections and the part fail with it, since their values are not
///   known for the whole surface. A stricter requirement of the stage replaces 1;
/// * steps of a stage: the fewest that any stage with stock made.
struct ConstraintResult {
    ConstraintKind kind;
    Zone zone = Zone::section;
    int section = 0; ///< index in SimulationResult::sections; −1: not of one section
    double limit = 0;
    double value = 0;
    double margin = 0;         ///< positive when met
    double relativeMargin = 0; ///< margin relative to the tolerance, range or limit
    bool holds = false;        ///< never if the value does not cover the whole surface
    bool isLeast = false;      ///< the limit is a minimum, otherwise a maximum
    std::optional<Place> at{}; ///< place in the cycle at which the value was reached, if in a pass
    int stage = 0;             ///< stage of the setting, from 1; 0: common to all, or not a setting
    std::optional<double>
        otherEnd{}; ///< other end of a machine range, where `limit` is the nearer one
    std::optional<double> mostValue{}; ///< upper end of an estimate, whose lower end is the value
    bool isWhole = true; ///< false: strips stay uncut, and value and margin cover the rest alone
    /// False: what the machine, or of the waviness the wheel, prints is unknown and not included.
    bool knowsMachine = true;
};

/// Whether its value is computed: not of the waves that a wheel of unknown runout prints.
[[nodiscard]] bool isComputed(const ConstraintResult& constraint);

/// Whether the machine's form error or the wheel's runout affects the requirement: roundness,
/// cylindricity, runouts and waviness.
[[nodiscard]] bool isPrinted(ConstraintKind kind);
/// Whether what they print is known and so included in the value; true if it does not affect it.
[[nodiscard]] bool knowsMachine(ConstraintKind kind, const Project& project);

/// The side on which a limit bounds.
enum class Side { atLeast, atMost };

/// A value compared with its limit, without a section; the relative margin is a share of the width.
[[nodiscard]] ConstraintResult held(ConstraintKind kind, Side side, double limit, double value,
                                    double width);

/// Form and position of the ground part [MODEL-7], by section and for the whole. The longitudinal
/// profile is read from the headstock on.
[[nodiscard]] PartAccuracy accuracyOf(const SimulationResult& result);

/// Evaluates every requirement that is on [MODEL-8]. A given accuracy is not computed again;
/// otherwise only what the requirements need of it is computed.
[[nodiscard]] std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result);
[[nodiscard]] std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result,
                                                                const PartAccuracy& accuracy);

/// The worst result of each kind, in the order of the kinds, as the command line lists them.
[[nodiscard]] std::vector<ConstraintResult>
worstByKind(const std::vector<ConstraintResult>& constraints);

/// The result of a requirement for a cycle.
[[nodiscard]] std::span<const Output<ConstraintResult>> requirementOutputs();

/// The calculation of a requirement's value at its worst place: the last step gives the value, for
/// burn and self-sharpening the limit of the depth of cut. Empty for values read off (diameters,
/// settings), for the power of coupled sections, which is an integral, and where nothing was cut.
[[nodiscard]] std::optional<FormulaSheet> constraintSheet(const SimulationResult& result,
                                                          const PartAccuracy& accuracy,
                                                          const ConstraintResult& constraint);

} // namespace sparkout
