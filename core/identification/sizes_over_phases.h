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
    std::vector<double> deviations_um; ///< deviations of one part
};

/// Over usualPhases(), one infeed of stock, with this number of evenly spaced stocks: a step of the
/// size over the stock is resolved to a 256th of the range.
[[nodiscard]] SizesOverPhases sizesOverPhases(const Project& project, const CycleFactors& factors,
                                              const std::stop_token& stop = {});

} // namespace sparkout
