// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/scaled_project.h"
#include "core/project/project.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// The sizes of many parts with an unknown stock within the steps of the feed: for each zone or
/// section the mean diameter less the nominal one.
struct SizesOverPhases {
    std::vector<double> means_um;      ///< empty: no cycle reached size
    std::vector<double> deviations_um; ///< standard deviations of single parts
};

/// Computes the sizes over usualPhases(), one infeed of stock, for 256 evenly spaced stocks: a step
/// of the size over the stock is located to a 256th of the range.
[[nodiscard]] SizesOverPhases sizesOverPhases(const Project& project, const CycleFactors& factors,
                                              const std::stop_token& stop = {});

} // namespace sparkout
