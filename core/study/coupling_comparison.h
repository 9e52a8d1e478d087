// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/result.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// The same cycle with its sections independent and coupled [MODEL-6].
struct CouplingComparison {
    SimulationResult independent;
    SimulationResult coupled;
    /// Mean diameter of each section, coupled less independent [mm].
    std::vector<double> differences_mm;

    [[nodiscard]] bool stopped() const {
        return independent.status == RunStatus::stopped || coupled.status == RunStatus::stopped;
    }
};

/// Why the two cannot be compared.
enum class CouplingAnswer {
    comparable,
    traverse,        ///< the wheel is on one zone at a time: there is nothing to couple
    givenCompliance, ///< γ section by section says nothing of how one section moves another
};
[[nodiscard]] CouplingAnswer couplingOf(const Project& project);

/// Runs a valid project twice, whatever it says of its sections. Only when comparable.
[[nodiscard]] CouplingComparison compareCoupling(const Project& project,
                                                 const std::stop_token& stop = {});

/// Mean diameter of a section less the nominal one [mm].
[[nodiscard]] double meanDiameterDeviation(const SectionResult& section, const Part& part);

} // namespace sparkout
