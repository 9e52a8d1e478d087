// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <vector>

namespace sparkout {

/// Factors on the inputs that determine the depths of cut.
struct CycleFactors {
    double alpha = 1, beta = 1, compliance = 1, flowStress = 1, dullness = 1;
    std::vector<double> places; ///< factors of the compliance of each zone or section; empty: 1
    double blankRunout_mm = 0;  ///< ΔR itself
    friend bool operator==(const CycleFactors&, const CycleFactors&) = default;
};

/// The factors of an unchanged project.
[[nodiscard]] CycleFactors factorsOf(const Project& project);

/// Whether zones or sections can have their own compliances: given, or computed separately.
[[nodiscard]] bool hasPlaceCompliances(const Project& project);

/// Multiplies γ place by place; a computed γ becomes a given one.
void scalePlaceCompliances(Project& project, const std::vector<double>& factors);

/// Where the force has a threshold alpha is the factor of K and beta that of F'_0.
///
/// The project whose cycle has these α and β in every balance; with a wheel contact, whose balance
/// is no sum of the two, α and β are to be 1. Its forces are not those of the
/// factors: they follow from the depths of cut.
[[nodiscard]] Project scaledProject(const Project& project, const CycleFactors& factors);

} // namespace sparkout
