// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/characteristics.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace sparkout {

/// One part of a batch, as it was run.
struct PartRecord {
    std::int64_t part = 0;
    std::vector<double> factors; ///< values, in the order of givenFactors()
    PartOutcome outcome;
};

/// Takes a part; false: no more of them are wanted, the batch is to end.
using PartSink = std::function<bool(const PartRecord&)>;

} // namespace sparkout
