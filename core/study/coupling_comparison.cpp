// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/coupling_comparison.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/simulate.h"

namespace sparkout {

CouplingAnswer couplingOf(const Project& project) {
    if (project.operation->travels) {
        return CouplingAnswer::traverse;
    }
    const bool given =
        !std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
    return given ? CouplingAnswer::givenCompliance : CouplingAnswer::comparable;
}

double meanDiameterDeviation(const SectionResult& section, const Part& part) {
    return 2 * meanOfGround(section.radii_mm) - part.diameter_mm;
}

CouplingComparison compareCoupling(const Project& project, const std::stop_token& stop) {
    CouplingComparison both;
    Project run = project;
    run.machine->zone_compliance.reset(); // coupled sections have none
    run.sections_coupled = false;
    both.independent = simulateUnchecked(run, nullptr, stop);
    run.sections_coupled = true;
    both.coupled = simulateUnchecked(run, nullptr, stop);
    for (std::size_t i = 0; i < both.coupled.sections.size(); ++i) {
        both.differences_mm.push_back(
            meanDiameterDeviation(both.coupled.sections[i], *project.part)
            - meanDiameterDeviation(both.independent.sections[i], *project.part));
    }
    return both;
}

} // namespace sparkout
