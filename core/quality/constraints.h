// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/accuracy.h"
#include "core/simulation/result.h"

#include <optional>
#include <vector>

namespace sparkout {

enum class ConstraintKind {
    diameterMin,
    diameterMax,
    radialRunout,
    roundness,
    cylindricity,
    totalRunout,
    roughness,
    burn,
    selfSharpening,
    wheelPower,
    workPower,
    rangeRadialFeed,
    rangeAxialFeed,
    rangePlungeFeed,
    rangeWorkSpeed,
    gaugeCommands,
    overlap,
};
inline constexpr int constraintKinds = 17;

/// What a requirement is held against.
enum class ConstraintScope {
    section, ///< each zone or section at the end of the cycle
    part,    ///< the whole part at the end of the cycle
    pass,    ///< every pass; kept is the worst
    setting, ///< the settings of the machine and its cycle, for a stage or for all
};
[[nodiscard]] ConstraintScope scopeOf(ConstraintKind kind);

/// Added to each diameter limit before comparing, so that a last bit fails nobody.
inline constexpr double diameterSlack_mm = 1e-9;

/// One requirement held against what it is about, in its unit (constraintUnit):
///
/// * burn: the depth of cut nearest to the greatest one whose damaged layer stays within the stock
///   left, and that depth;
/// * self-sharpening: the pressure P_y/(b·L) at the largest depth of cut, and 0.25·f_cr·n_g;
/// * roundness and cylindricity: of the minimum zone;
/// * a range of the machine: the setting and the nearer end;
/// * overlap: B·n/S_ax of a stage of a traverse cycle, and 1. Where it fails strips stay uncut, and
///   what is held against sections and the part fails with it, since it is not known of the whole
///   surface.
struct ConstraintResult {
    ConstraintKind kind;
    Zone zone = Zone::section;
    int section = 0; ///< index in SimulationResult::sections; −1: not of one section
    double limit = 0;
    double value = 0;
    double margin = 0;         ///< positive when it holds
    double relativeMargin = 0; ///< margin over the width of the field or range, or over the limit
    bool holds = false;        ///< never where the value is not of the whole surface
    bool isLeast = false;      ///< the limit is the least that holds, else the greatest
    std::optional<Place> at{}; ///< where in the cycle the value was reached, when in a pass
    int stage = 0;             ///< stage whose setting it is, from 1; 0: set for all, or no setting
    std::optional<double> otherEnd{}; ///< of a range of the machine; `limit` is the nearer one
    bool isWhole = true; ///< else strips stay uncut, and value and margin are of the rest alone
};

/// Name of a constraint in files and on the command line.
[[nodiscard]] const char* constraintName(ConstraintKind kind);

/// Unit of limit, value and margin; none for a number of commands.
[[nodiscard]] const char* constraintUnit(ConstraintKind kind);

/// Form and position of what a cycle left, section by section and of the part [MODEL-7]. The
/// longitudinal profile is read from the headstock on.
[[nodiscard]] PartAccuracy accuracyOf(const SimulationResult& result);

/// Every requirement that is on, held against everything it is about [MODEL-8]. With the accuracy
/// given nothing is computed twice; else no more of it is computed than is required.
[[nodiscard]] std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result);
[[nodiscard]] std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result,
                                                                const PartAccuracy& accuracy);

/// The worst of each kind, in the order of the kinds: what the command line lists.
[[nodiscard]] std::vector<ConstraintResult>
worstByKind(const std::vector<ConstraintResult>& constraints);

} // namespace sparkout
