// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/project/measured.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace sparkout {

/// Values that a quarter, a half and three quarters of the parts do not exceed.
struct Quartiles {
    double low = 0, median = 0, high = 0;
};

/// Requires at least one value, in rising order.
[[nodiscard]] Quartiles quartilesOf(const std::vector<double>& sorted);

/// The prediction for one quantity in one zone or section [µm].
struct PredictedRange {
    double low = 0, high = 0; ///< contains 95 % of the parts; for corners, or as given: all
    double mean = 0;
    std::optional<double> deviation{};    ///< empty for corners, and without scatter
    std::int64_t count = 0;               ///< parts of the batch; 0: as given
    double least = 0, most = 0;           ///< extremes of all parts
    std::optional<Quartiles> quartiles{}; ///< given with a deviation
};

/// The project whose batch predicts all measured quantities: it has a batch, and limits for
/// quantities that the drawing does not limit, so that they are evaluated for every part.
[[nodiscard]] Project predictingProject(Project project);

/// For a batch of that project; empty if it has no such value.
[[nodiscard]] std::optional<PredictedRange> predicted(const BatchResult& batch,
                                                      MeasuredQuantity quantity, int place);

} // namespace sparkout
