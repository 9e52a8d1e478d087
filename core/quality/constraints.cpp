// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/constraints.h"

#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/ranges.h"
#include "core/quality/result_names.h"

#include <algorithm>

namespace sparkout {

namespace {

/// Empty where strips stay uncut, or the wheel is not known.
std::optional<double> ofWhole(const ConstraintResult& c, double value) {
    return c.isWhole && isComputed(c) ? std::optional(value) : std::nullopt;
}

constexpr Output<ConstraintResult> requirementTable[] = {
    {{.key = "name"},
     [](const ConstraintResult& c) { return std::string(requirementOf(c.kind).key); }},
    {{.key = "unit", .hint = "of limit, value and margin; empty for a plain number"},
     [](const ConstraintResult& c) { return std::string(requirementOf(c.kind).unit); }},
    {{.key = "limit"}, [](const ConstraintResult& c) { return c.limit; }},
    {{.key = "value", .hint = "null where strips stay uncut or the wheel is not known"},
     [](const ConstraintResult& c) { return ofWhole(c, c.value); }},
    {{.key = "value_most",
      .hint = "upper end of an estimate, whose lower end is the value; otherwise absent"},
     [](const ConstraintResult& c) { return ofWhole(c, c.mostValue.value_or(c.value)); },
     nullptr,
     [](const ConstraintResult& c) { return c.mostValue.has_value(); }},
    {{.key = "margin", .hint = "positive when the requirement is met; null as the value is"},
     [](const ConstraintResult& c) { return ofWhole(c, c.margin); }},
    {{.key = "relative_margin",
      .hint = "the margin over the width of the field or range, or over the limit"},
     [](const ConstraintResult& c) { return ofWhole(c, c.relativeMargin); }},
    {{.key = "where"}, [](const ConstraintResult& c) { return whereText(c); }},
    {{.key = "ok"}, [](const ConstraintResult& c) { return c.holds; }},
    {{.key = "machine_known",
      .hint = "of roundness, cylindricity and runouts: whether the value includes the machine's "
              "own form, of the waviness whether it includes the wheel's runout; otherwise it is "
              "the model's only"},
     [](const ConstraintResult& c) { return c.knowsMachine; },
     nullptr,
     [](const ConstraintResult& c) { return isPrinted(c.kind); }},
};

} // namespace

ConstraintResult held(ConstraintKind kind, Side side, double limit, double value, double width) {
    ConstraintResult result{kind};
    result.section = -1;
    result.limit = limit;
    result.value = value;
    result.isLeast = side == Side::atLeast;
    result.margin = result.isLeast ? value - limit : limit - value;
    result.relativeMargin = width > 0 ? result.margin / width : result.margin;
    result.holds = result.margin >= 0;
    return result;
}

std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result) {
    return evaluateConstraints(result, requiredAccuracy(result));
}

bool isComputed(const ConstraintResult& constraint) {
    return constraint.kind != ConstraintKind::waviness || constraint.knowsMachine;
}

bool isPrinted(ConstraintKind kind) {
    return kind == ConstraintKind::roundness || kind == ConstraintKind::cylindricity
           || kind == ConstraintKind::radialRunout || kind == ConstraintKind::totalRunout
           || kind == ConstraintKind::waviness;
}

bool knowsMachine(ConstraintKind kind, const Project& project) {
    switch (kind) {
    case ConstraintKind::roundness:
    case ConstraintKind::cylindricity: return isRoundnessKnown(*project.machine);
    case ConstraintKind::radialRunout:
    case ConstraintKind::totalRunout: return isRunoutKnown(*project.machine);
    case ConstraintKind::waviness: return project.wheel->runout.has_value();
    default: return true;
    }
}

std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result,
                                                  const PartAccuracy& accuracy) {
    std::vector<ConstraintResult> found;
    found.reserve(static_cast<std::size_t>(constraintKinds) + 2 * result.sections.size());
    const auto evaluate = [&](bool ofSections, int section) {
        for (const Requirement& row : requirementRows) {
            if ((row.scope == ConstraintScope::section) == ofSections) {
                row.evaluate(row.kind, {result, accuracy, section}, found);
            }
        }
    };
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        evaluate(true, static_cast<int>(i));
    }
    evaluate(false, -1);
    const FinishedSurface surface(result.project);
    for (ConstraintResult& constraint : found) {
        constraint.isWhole = surface.tells(constraint.kind);
        constraint.knowsMachine = knowsMachine(constraint.kind, result.project);
        constraint.holds = constraint.holds && constraint.isWhole;
    }
    return found;
}

std::vector<ConstraintResult> worstByKind(const std::vector<ConstraintResult>& constraints) {
    std::vector<ConstraintResult> worst;
    for (const ConstraintResult& constraint : constraints) {
        const auto found =
            std::find_if(worst.begin(), worst.end(), [&](const ConstraintResult& other) {
                return other.kind == constraint.kind;
            });
        if (found == worst.end()) {
            worst.push_back(constraint);
        } else if (constraint.margin < found->margin) {
            *found = constraint;
        }
    }
    std::sort(worst.begin(), worst.end(),
              [](const auto& a, const auto& b) { return a.kind < b.kind; });
    return worst;
}

std::span<const Output<ConstraintResult>> requirementOutputs() {
    return requirementTable;
}

std::optional<FormulaSheet> constraintSheet(const SimulationResult& result,
                                            const PartAccuracy& accuracy,
                                            const ConstraintResult& constraint) {
    const auto sheet = requirementOf(constraint.kind).sheet;
    return sheet ? sheet({result, accuracy, constraint.section}) : std::nullopt;
}

} // namespace sparkout
