// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/requirement.h"

#include <optional>
#include <vector>

namespace sparkout {

/// Added to each diameter limit before comparing, so that a last bit fails nobody.
inline constexpr double diameterSlack_mm = 1e-9;

/// One requirement held against what it is about, in the unit of its row. `limit` is the one that
/// the value is compared with, so that always
///
///     margin = limit − value,  where the limit is the least that holds  margin = value − limit
///
/// * burn: the depth of cut nearest to the greatest one whose damaged layer stays within the stock
///   left, and that depth;
/// * self-sharpening: the pressure P_y/(b·L) at the largest depth of cut, and 0.25·f_cr·n_g;
/// * roundness and cylindricity: of the minimum zone;
/// * a range of the machine: the setting and the nearer end;
/// * overlap: B·n/S_ax of a stage of a traverse cycle, and 1. Where it fails strips stay uncut, and
///   what is held against sections and the part fails with it, since it is not known of the whole
///   surface. Where more is required of the stage it is held against that instead;
/// * steps of a stage: the fewest that any stage with stock made.
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
    std::optional<double>
        otherEnd{}; ///< of a range of the machine, where `limit` is the nearer one
    std::optional<double>
        mostValue{};     ///< of an estimate, which lies between the value and this one
    bool isWhole = true; ///< else strips stay uncut, and value and margin are of the rest alone
    bool knowsMachine = true; ///< else the machine's own form is not known, and not in the value
};

/// Whether the machine prints its own onto what is required: roundness, cylindricity and runouts.
[[nodiscard]] bool isPrinted(ConstraintKind kind);
/// Whether the machine's own is known, and so in the value; true of all that it prints nothing
/// onto.
[[nodiscard]] bool knowsMachine(ConstraintKind kind, const Project& project);

/// Which way a limit holds.
enum class Side { atLeast, atMost };

/// A value held against its limit, of no section; the relative margin is a share of the width.
[[nodiscard]] ConstraintResult held(ConstraintKind kind, Side side, double limit, double value,
                                    double width);

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
