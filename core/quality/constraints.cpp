// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/constraints.h"

#include "core/quality/cycle_constraints.h"
#include "core/quality/drawing_constraints.h"
#include "core/quality/finished_surface.h"

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

struct KindInfo {
    const char* name;
    const char* unit;
    ConstraintScope scope;
};

constexpr std::array<KindInfo, constraintKinds> kinds{{
    {"diameter_min", "µm", ConstraintScope::section},
    {"diameter_max", "µm", ConstraintScope::section},
    {"radial_runout", "µm", ConstraintScope::section},
    {"roundness", "µm", ConstraintScope::section},
    {"cylindricity", "µm", ConstraintScope::part},
    {"total_runout", "µm", ConstraintScope::part},
    {"roughness", "µm", ConstraintScope::section},
    {"burn", "µm", ConstraintScope::pass},
    {"self_sharpening", "MPa", ConstraintScope::pass},
    {"wheel_power", "kW", ConstraintScope::pass},
    {"work_power", "kW", ConstraintScope::pass},
    {"range_radial_feed", "mm", ConstraintScope::setting},
    {"range_axial_feed", "mm/min", ConstraintScope::setting},
    {"range_plunge_feed", "mm/min", ConstraintScope::setting},
    {"range_work_speed", "rev/min", ConstraintScope::setting},
    {"gauge_commands", "", ConstraintScope::setting},
    {"overlap", "", ConstraintScope::setting},
}};

const KindInfo& infoOf(ConstraintKind kind) {
    return kinds[static_cast<std::size_t>(kind)];
}

} // namespace

const char* constraintName(ConstraintKind kind) {
    return infoOf(kind).name;
}

const char* constraintUnit(ConstraintKind kind) {
    return infoOf(kind).unit;
}

ConstraintScope scopeOf(ConstraintKind kind) {
    return infoOf(kind).scope;
}

std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result) {
    return evaluateConstraints(result, requiredAccuracy(result));
}

std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result,
                                                  const PartAccuracy& accuracy) {
    std::vector<ConstraintResult> found = drawingConstraints(result, accuracy);
    const FinishedSurface surface(result.project);
    for (ConstraintResult& constraint : found) {
        constraint.isWhole = surface.tells(constraint.kind);
        constraint.holds = constraint.holds && constraint.isWhole;
    }
    const std::vector<ConstraintResult> cycle = cycleConstraints(result);
    found.insert(found.end(), cycle.begin(), cycle.end());
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

} // namespace sparkout
