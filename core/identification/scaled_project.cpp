// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/scaled_project.h"

#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
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

void scaleCompliance(Project& project, double factor) {
    Machine& machine = *project.machine;
    if (project.gauge->compliance_mm_per_n) {
        *project.gauge->compliance_mm_per_n *= factor;
    }
    if (auto* const zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        *zones = {zones->rz1 * factor, zones->nz * factor, zones->rz2 * factor};
    } else if (auto* const sections =
                   std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        for (double& value : *sections) {
            value *= factor;
        }
    } else {
        if (machine.stiffness_n_um) {
            machine.stiffness_n_um->headstock /= factor;
            machine.stiffness_n_um->tailstock /= factor;
            machine.stiffness_n_um->wheel_head /= factor;
        }
        project.part->shaft.youngs_modulus_gpa /= factor;
        for (SteadyRest& rest : project.part->shaft.steady_rests) {
            rest.stiffness_n_um /= factor;
        }
    }
}

void scaleCompliance(Project& project, const std::vector<double>& factors) {
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

// σ_i and α act on α alike, for γ stands before both: γ' = γ·c·σ·α. What is left for β is η.
Project scaledProject(const Project& project, const CycleFactors& factors) {
    Project scaled = project;
    scaled.runs.clear();
    scaled.measured.reset();
    scaleCompliance(scaled, factors.compliance * factors.flowStress * factors.alpha);
    if (!factors.places.empty()) {
        scaleCompliance(scaled, factors.places);
    }
    scaled.wheel->dullness *= factors.dullness * factors.beta / factors.alpha;
    scaled.part->initial_runout_mm = factors.blankRunout_mm;
    return scaled;
}

} // namespace sparkout
