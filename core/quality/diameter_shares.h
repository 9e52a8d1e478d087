// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

namespace sparkout {

/// The diameter of a section to explain.
enum class DiameterEnd { smallest, largest };

/// The parts of a section's diameter deviation [µm on the diameter]; the three add up to it.
struct DiameterShares {
    double reading_um = 0; ///< gauge reading at the end, less the nominal diameter
    double section_um = 0; ///< the section's mean diameter, less that reading
    double form_um = 0;    ///< its smallest or largest diameter, less its mean
    /// The section's compliance relative to that of the section with the gauge; 1 if it is that
    /// section or a position of its own.
    double complianceRatio = 1;

    [[nodiscard]] double deviation_um() const { return reading_um + section_um + form_um; }
};

/// Shares of result.sections[section]'s smallest or largest diameter deviation.
[[nodiscard]] DiameterShares diameterShares(const SimulationResult& result, std::size_t section,
                                            DiameterEnd end);

} // namespace sparkout
