// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>

namespace sparkout {

/// Memory that a batch, or a shard of it, takes at most to be run with so many threads and to be
/// written as a state, and that a merge of shards takes [bytes]: an upper bound from the numbers of
/// characteristics, bins and kept rows, not of an unbounded batch. It does not grow with the number
/// of parts beyond BatchStatistics::keptRows.
[[nodiscard]] std::size_t batchMemory(const Project& project, int threads);
[[nodiscard]] std::size_t mergeMemory(const Project& project);

} // namespace sparkout
