// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/constraints.h"

#include "core/units.h"

#include <algorithm>

namespace sparkout {

namespace {

/// Which way a limit holds.
enum class Side { atLeast, atMost };

ConstraintResult compare(ConstraintKind kind, const SectionResult& section, std::size_t index,
                         Side side, double limit_um, double value_um, double width_um) {
    ConstraintResult result{kind};
    result.zone = section.zone;
    result.section = static_cast<int>(index);
    result.limit = limit_um;
    result.value = value_um;
    result.margin = side == Side::atLeast ? value_um - limit_um : limit_um - value_um;
    result.relativeMargin = result.margin / width_um;
    result.holds = result.margin >= -diameterSlack_mm * units::umPerMm;
    return result;
}

bool isGiven(const Field& field, const void* owner) {
    return field.kind == Kind::optionalNumber
               ? field.as<std::optional<double>>(owner).has_value()
               : field.as<std::optional<std::vector<double>>>(owner).has_value();
}

void collectUnchecked(const StructInfo& table, const void* owner,
                      std::vector<const Field*>& found) {
    for (const Field& field : table.fields) {
        if (field.kind == Kind::object || field.kind == Kind::optionalObject) {
            if (const void* object = field.objectIn(owner)) {
                collectUnchecked(*field.nested, object, found);
            }
        } else if (field.unchecked && isGiven(field, owner)) {
            found.push_back(&field);
        }
    }
}

} // namespace

std::vector<const Field*> uncheckedRequirements(const Project& project) {
    std::vector<const Field*> found;
    collectUnchecked(tableOf<Project>(), &project, found);
    return found;
}

const char* constraintName(ConstraintKind kind) {
    switch (kind) {
    case ConstraintKind::diameterMin: return "diameter_min";
    case ConstraintKind::diameterMax: return "diameter_max";
    case ConstraintKind::radialRunout: return "radial_runout";
    }
    return "";
}

std::vector<ConstraintResult> evaluateConstraints(const SimulationResult& result) {
    const Part& part = result.project.part;
    const double low = part.lower_deviation_um;
    const double high = part.upper_deviation_um;
    std::vector<ConstraintResult> constraints;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        constraints.push_back(compare(ConstraintKind::diameterMin, section, i, Side::atLeast, low,
                                      section.diameterDeviationMin_mm * units::umPerMm,
                                      high - low));
        constraints.push_back(compare(ConstraintKind::diameterMax, section, i, Side::atMost, high,
                                      section.diameterDeviationMax_mm * units::umPerMm,
                                      high - low));
        if (const auto& limit = part.tolerance.radial_runout_um) {
            constraints.push_back(compare(ConstraintKind::radialRunout, section, i, Side::atMost,
                                          *limit, section.radialRunout_mm * units::umPerMm,
                                          *limit));
        }
    }
    return constraints;
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
