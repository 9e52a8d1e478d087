// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/scaled_project.h"

#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/process/recipe_force.h"
#include "core/process/scaled_compliance.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <cstddef>
#include <utility>
#include <variant>

namespace sparkout {

CycleFactors factorsOf(const Project& project) {
    CycleFactors factors;
    factors.blankRunout_mm = initialRunout(*project.part);
    return factors;
}

bool hasPlaceCompliances(const Project& project) {
    const bool isGiven =
        !std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
    return isGiven || (!project.sections_coupled && zoneSectionCount(project) == 0);
}

void scalePlaceCompliances(Project& project, const std::vector<double>& factors) {
    const std::vector<CompliantPoint> points = compliantPoints(project);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); ++i) {
        values.push_back(points[i].gamma_mm_n * (i < factors.size() ? factors[i] : 1));
    }
    if (project.operation->hasZones && values.size() == 3) {
        project.machine->compliance_mm_per_n = ZoneCompliance{values[0], values[1], values[2]};
    } else {
        project.machine->compliance_mm_per_n = std::move(values);
    }
}

// σ_i and α have the same effect on α, since γ precedes both: γ' = γ·c·σ·α. η then corrects β. The
// nonlinear wheel contact must deflect under P as before under σ·P.
Project scaledProject(const Project& project, const CycleFactors& factors) {
    Project scaled = project;
    scaled.runs.clear();
    scaled.measured.reset();
    if (hasThreshold(project)) {
        scaled.material->specific_force_mpa *= factors.alpha;
        scaled.material->threshold_force_n_mm *= factors.beta;
        scaleCompliance(scaled, factors.compliance);
        if (!factors.places.empty()) {
            scalePlaceCompliances(scaled, factors.places);
        }
        scaled.part->initial_runout_mm = factors.blankRunout_mm;
        return scaled;
    }
    scaleCompliance(scaled, factors.compliance * factors.flowStress * factors.alpha);
    if (auto& contact = scaled.machine->wheel_contact; contact && contact->n_um_at_n) {
        for (std::vector<double>& row : *contact->n_um_at_n) {
            row[0] /= factors.flowStress;
        }
    }
    if (!factors.places.empty()) {
        scalePlaceCompliances(scaled, factors.places);
    }
    setDullness(*scaled.wheel,
                dullnessOf(*scaled.wheel) * (factors.dullness * factors.beta / factors.alpha));
    scaled.part->initial_runout_mm = factors.blankRunout_mm;
    return scaled;
}

} // namespace sparkout
