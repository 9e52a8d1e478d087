// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <vector>

/// The form that the machine prints onto every part, fixed to the work [MODEL-7].
///
/// Centres, headstock and spindle move the axis towards the wheel by c(φ) = A_1·cos(φ − φ_1) +
/// A_j·cos jφ. The cycle runs in the machine's frame; the part has R_k − c(φ_k), a bore R_k +
/// c(φ_k). The roundness deviation is 2·A_j, and without lobes the runout 2·A_1. Of both together
/// the runout depends on φ_1: A_1 is what makes its mean over all φ_1 the one given. A diameter
/// changes by −2·A_j·cos jφ where j is even, and by nothing where it is odd.
namespace sparkout {

/// c(φ) of one zone or section.
struct PrintedForm {
    double eccentricity_mm = 0; ///< A_1
    double lobe_mm = 0;         ///< A_j
    int lobes = 0;              ///< j
    double at = 0;              ///< φ_1 [rad]

    [[nodiscard]] double at_mm(double angle) const;
    /// max c − min c, at most: 2·A_1 + 2·A_j.
    [[nodiscard]] double most_mm() const { return 2 * (eccentricity_mm + lobe_mm); }
};

/// Runout max c − min c of A_1 and A_j, and its mean over all φ_1.
[[nodiscard]] double printedRunout_mm(const PrintedForm& form);
[[nodiscard]] double meanPrintedRunout_mm(const PrintedForm& form);

/// The same part with an even number of lobes.
[[nodiscard]] Project withEvenLobes(Project project);

/// Of a zone or section; nothing is printed where no form is given.
[[nodiscard]] PrintedForm printedForm(const Project& project, std::size_t place);
/// c(φ_k) of K radii at φ_k = 2πk/K; empty where nothing is printed.
[[nodiscard]] std::vector<double> printedDepths(const Project& project, std::size_t place);

/// By how much half a diameter, and so the gauge's reading per side, may differ through it [mm].
[[nodiscard]] double mostOfDiameters_mm(const Project& project);
/// By how much the radii of the part may stand apart through it [mm].
[[nodiscard]] double mostPrinted_mm(const Project& project);

} // namespace sparkout
