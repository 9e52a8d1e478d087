// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <vector>

/// The form error that the machine transfers to every part, fixed to the work [MODEL-7].
///
/// Centres, headstock and spindle move the axis towards the wheel by c(φ) = A_1·cos(φ − φ_1) +
/// A_j·cos jφ. The cycle runs in the machine's frame; the part has R_k − c(φ_k), a bore R_k +
/// c(φ_k). The roundness deviation is 2·A_j, and without lobes the runout 2·A_1. With both the
/// runout depends on φ_1; A_1 is such that its mean over all φ_1 is the given one. A diameter
/// changes by −2·A_j·cos jφ for even j, and not at all for odd j.
namespace sparkout {

/// c(φ) of one zone or section.
struct PrintedForm {
    double eccentricity_mm = 0; ///< A_1
    double lobe_mm = 0;         ///< A_j
    int lobes = 0;              ///< j, number of lobes
    double at = 0;              ///< φ_1 [rad]

    [[nodiscard]] double at_mm(double angle) const;
    /// The upper bound of max c − min c: 2·A_1 + 2·A_j.
    [[nodiscard]] double most_mm() const { return 2 * (eccentricity_mm + lobe_mm); }
};

/// Runout max c − min c of A_1 and A_j.
[[nodiscard]] double printedRunout_mm(const PrintedForm& form);

/// The project with an even number of lobes.
[[nodiscard]] Project withEvenLobes(Project project);

/// The form of a zone or section; zero where none is given.
[[nodiscard]] PrintedForm printedForm(const Project& project, std::size_t place);
/// c(φ_k) of K radii at φ_k = 2πk/K; empty without a form.
[[nodiscard]] std::vector<double> printedDepths(const Project& project, std::size_t place);

/// The greatest change of half a diameter, and so of the gauge's reading per side, by the form
/// [mm].
[[nodiscard]] double mostOfDiameters_mm(const Project& project);
/// The greatest difference of the part's radii by the form [mm].
[[nodiscard]] double mostPrinted_mm(const Project& project);

} // namespace sparkout
