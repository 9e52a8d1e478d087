// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/measured.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sparkout {

/// The measurements of one quantity in one zone or section [µm].
struct MeasuredStatistics {
    MeasuredQuantity quantity = MeasuredQuantity::diameter_deviation;
    int place = 0; ///< −1: the whole part
    std::int64_t count = 0;
    double mean = 0;
    std::optional<double> deviation; ///< standard deviation of two or more values, or as given
    std::optional<double> least, greatest;
    std::vector<double> values; ///< in rising order; empty for a summary
    bool isSummary = false;
};

/// For all measurements in existing zones or sections, by quantity and place; summaries follow
/// single parts. Several diameters of a part count as their mean.
[[nodiscard]] std::vector<MeasuredStatistics> statisticsOfMeasured(const Project& project);

} // namespace sparkout
