// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sweep/sweep_run.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// The readable results of a sweep.
namespace sparkout {

/// Quantities of one name, of all zones or of one.
struct SweepEntry {
    std::string key; ///< "radial_runout", "radial_runout 1"
    std::vector<std::size_t> quantities;
};

/// The entries of a sweep, in its order; `each`: also every zone separately.
[[nodiscard]] std::vector<SweepEntry> sweepEntries(const SweepResult& sweep, bool each);

/// The quantity of an entry with the least margin at a point, without limits the greatest value;
/// empty if the point has none.
[[nodiscard]] std::optional<std::size_t> worstAt(const SweepPoint& point, const SweepEntry& entry);

/// Whether every point was run and all have the same results as the first.
[[nodiscard]] bool changesNothing(const SweepResult& sweep);

} // namespace sparkout
