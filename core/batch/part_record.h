// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/characteristics.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace sparkout {

/// One part of a batch that was run.
struct PartRecord {
    std::int64_t part = 0;
    std::vector<double> factors; ///< values, in the order of givenFactors()
    PartOutcome outcome;
};

/// Receives a part; returns false to end the batch.
using PartSink = std::function<bool(const PartRecord&)>;

} // namespace sparkout
