// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// Results of one cycle with independent and with coupled sections [MODEL-6].
struct CouplingComparison {
    SimulationResult independent;
    SimulationResult coupled;
    /// Mean diameter of each section, coupled less independent [mm].
    std::vector<double> differences_mm;

    [[nodiscard]] bool stopped() const {
        return independent.status == RunStatus::stopped || coupled.status == RunStatus::stopped;
    }
};

/// Whether the two can be compared, and the reason why not.
enum class CouplingAnswer {
    comparable,
    traverse,        ///< the wheel is on one zone at a time, so that nothing is coupled
    givenCompliance, ///< γ of each section does not contain the influence of one section on another
};
[[nodiscard]] CouplingAnswer couplingOf(const Project& project);

/// Runs a valid, comparable project with independent and with coupled sections, whatever its own
/// setting.
[[nodiscard]] CouplingComparison compareCoupling(const Project& project,
                                                 const std::stop_token& stop = {});

/// Returns the mean diameter of a section less the nominal one [mm].
[[nodiscard]] double meanDiameterDeviation(const SectionResult& section, const Part& part);

} // namespace sparkout
