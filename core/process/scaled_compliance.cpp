// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/scaled_compliance.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <variant>
#include <vector>

namespace sparkout {

namespace {

void divideStiffness(Project& project, double factor) {
    if (auto& stiffness = project.machine->stiffness_n_um) {
        stiffness->headstock /= factor;
        stiffness->tailstock /= factor;
        stiffness->wheel_head /= factor;
    }
    project.part->shaft.youngs_modulus_gpa /= factor;
    for (SteadyRest& rest : project.part->shaft.steady_rests) {
        rest.stiffness_n_um /= factor;
    }
}

} // namespace

void scaleCompliance(Project& project, double factor) {
    Machine& machine = *project.machine;
    if (auto* const zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        *zones = {zones->rz1 * factor, zones->nz * factor, zones->rz2 * factor};
    } else if (auto* const sections =
                   std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        for (double& gamma : *sections) {
            gamma *= factor;
        }
    } else {
        divideStiffness(project, factor);
    }
    if (machine.wheel_contact && machine.wheel_contact->n_um_at_n) {
        for (std::vector<double>& row : *machine.wheel_contact->n_um_at_n) {
            row[1] /= factor;
        }
    }
    if (project.gauge->compliance_mm_per_n) {
        *project.gauge->compliance_mm_per_n *= factor;
    }
}

} // namespace sparkout
