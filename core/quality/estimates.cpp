// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/estimates.h"

#include "core/process/force.h"
#include "core/process/recipe_force.h"
#include "core/project/member.h"
#include "core/project/wheel.h"

namespace sparkout {

std::vector<const Field*> estimatesBehind(const Project& project, ConstraintKind kind) {
    const Requirement& row = requirementOf(kind);
    if (row.scope == ConstraintScope::setting) {
        return {};
    }
    static const Project any;
    std::vector<const Field*> fields;
    const auto add = [&fields](const char* path) { fields.push_back(findMember(any, path).field); };
    const bool threshold = hasThreshold(project);
    for (const char* path :
         {threshold ? "/material/threshold_force_n_mm" : "/material/flow_stress_mpa",
          threshold ? "/material/specific_force_mpa" : dullnessPath(*project.wheel),
          "/machine/compliance_mm_per_n"}) {
        add(path);
    }
    for (const char* path : row.estimates) {
        if (path) {
            add(path);
        }
    }
    return fields;
}

} // namespace sparkout
