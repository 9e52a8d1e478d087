// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/identification/fitted_parameter.h"

#include <vector>

namespace sparkout {

/// The parameters that data of these kinds can determine [MODEL-13]: size alone gives α and β,
/// never γ and k_s separately; with the force it gives γ, σ_i and η. Power gives its two products,
/// and the idle power if that is not given. Offsets of the traces are added. Finished parts give β
/// and the setting of the gauge, those of one place the setting alone. With a threshold of the
/// force, factors of K and F'_0 replace those of σ_i and η.
[[nodiscard]] std::vector<FittedKind> proposedParameters(const FitData& data,
                                                         bool hasThreshold = false);

} // namespace sparkout
