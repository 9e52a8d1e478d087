// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/constraint_sheet.h"

namespace sparkout {

std::optional<FormulaSheet> constraintSheet(const SimulationResult& result,
                                            const PartAccuracy& accuracy,
                                            const ConstraintResult& constraint) {
    const auto sheet = requirementOf(constraint.kind).sheet;
    return sheet ? sheet({result, accuracy, constraint.section}) : std::nullopt;
}

} // namespace sparkout
