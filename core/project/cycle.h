// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <vector>

namespace sparkout {

/// One stage of the cycle: its feeds and the radial stock it removes.
struct Stage {
    std::optional<double> radial_feed_mm;     ///< S_t, per double stroke (traverse) [mm]
    std::optional<double> axial_feed_mm_min;  ///< S_ax (traverse) [mm/min]
    std::optional<double> radial_feed_mm_min; ///< S_p (plunge) [mm/min]
    double stock_mm = 0;                      ///< Π_z, per side [mm]
    SparkOut spark_out;                       ///< last stage only: feed nothing
};

struct Cycle {
    std::vector<Stage> stages;
};

/// The wheel head may be drawn back between stages that feed, where the gauge ends stages. The
/// stage is one of the project's.
[[nodiscard]] bool mayRetract(const Project& project, const Stage& stage);

template <>
const StructInfo& tableOf<Stage>();
template <>
const StructInfo& tableOf<Cycle>();

} // namespace sparkout
