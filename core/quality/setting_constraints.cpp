// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/setting_constraints.h"

#include "core/quality/ranges.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

void evaluateRange(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    for (const MachineRange& range : checkMachineRanges(of.result.project, kind)) {
        const bool low = range.value - range.low < range.high - range.value;
        const double width = range.high - range.low;
        found.push_back(held(kind, low ? Side::atLeast : Side::atMost, low ? range.low : range.high,
                             range.value, width > 0 ? width : std::max(std::abs(range.high), 1.0)));
        found.back().stage = range.stage;
        found.back().otherEnd = low ? range.high : range.low;
    }
}

void evaluateGaugeCommands(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto gauge = checkGaugeCommands(of.result.project)) {
        found.push_back(held(kind, Side::atMost, gauge->commands, gauge->stages, gauge->commands));
    }
}

void evaluateOverlap(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    for (const OverlapCheck& check : checkOverlaps(of.result.project)) {
        if (check.kind == kind) {
            found.push_back(held(kind, Side::atLeast, check.least, check.overlap, check.least));
            found.back().stage = check.stage;
            found.back().holds = check.holds();
        }
    }
}

void evaluateLeastSteps(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const std::optional<int>& least = of.result.project.least_steps;
    const std::optional<StageSteps> fewest = least ? fewestSteps(of.result) : std::nullopt;
    if (fewest) {
        found.push_back(held(kind, Side::atLeast, *least, fewest->steps, *least));
        found.back().stage = fewest->stage;
    }
}

} // namespace sparkout
