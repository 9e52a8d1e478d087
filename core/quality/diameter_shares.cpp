// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/diameter_shares.h"

#include "core/process/system_compliance.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/units.h"

namespace sparkout {

DiameterShares diameterShares(const SimulationResult& result, std::size_t section,
                              DiameterEnd end) {
    const SectionResult& about = result.sections.at(section);
    const double mean_mm = 2 * meanOfGround(about.radii_mm);
    const double nominal_mm = result.project.part->diameter_mm;
    const double deviation_mm = end == DiameterEnd::smallest ? about.diameterDeviationMin_mm
                                                             : about.diameterDeviationMax_mm;
    DiameterShares shares;
    shares.reading_um = (result.gaugeReading_mm - nominal_mm) * units::umPerMm;
    shares.section_um = (mean_mm - result.gaugeReading_mm) * units::umPerMm;
    shares.form_um = (deviation_mm - (mean_mm - nominal_mm)) * units::umPerMm;
    if (!result.project.gauge->position_mm) {
        const auto gauge = static_cast<std::size_t>(gaugeSection(result.project));
        shares.complianceRatio =
            about.compliance_mm_per_n / result.sections.at(gauge).compliance_mm_per_n;
    }
    return shares;
}

} // namespace sparkout
