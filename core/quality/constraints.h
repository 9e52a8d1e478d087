// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <string>
#include <vector>

namespace sparkout {

enum class ConstraintKind { diameterMin, diameterMax, radialRunout };

/// Added to each diameter limit before comparing, so that a last bit fails nobody.
inline constexpr double diameterSlack_mm = 1e-9;

/// One requirement of the drawing held against one zone or section.
struct ConstraintResult {
    ConstraintKind kind;
    Zone zone = Zone::section;
    int section = 0;           ///< index in SimulationResult::sections
    double limit = 0;          ///< [µm]
    double value = 0;          ///< [µm]
    double margin = 0;         ///< positive when it holds [µm]
    double relativeMargin = 0; ///< margin over the width of the field or over the limit
    bool holds = false;
};

/// Name of a constraint in files and on the command line.
[[nodiscard]] const char* constraintName(ConstraintKind kind);

/// Every requirement of the drawing that is on, held against every zone or section [MODEL-8].
[[nodiscard]] std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result);

/// Requirements and limits that are given but not evaluated, in the order of the tables: a verdict
/// must name them.
[[nodiscard]] std::vector<const Field*> uncheckedRequirements(const Project& project);

/// The worst of each kind, in the order of the kinds: what the command line lists.
[[nodiscard]] std::vector<ConstraintResult>
worstByKind(const std::vector<ConstraintResult>& constraints);

} // namespace sparkout
