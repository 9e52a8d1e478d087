// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A batch, or a shard of one, as text, so that shards computed apart can be joined.
namespace sparkout {

inline constexpr const char* batchStateFormat = "sparkout-batch";
inline constexpr int batchStateVersion = 1;

/// One UTF-8 JSON text with everything, bit for bit: equal results, equal bytes.
[[nodiscard]] std::string writeBatchState(const BatchResult& result);

/// Reads it back; nothing when no batch writes such a text.
[[nodiscard]] std::optional<BatchResult> readBatchState(std::string_view text);

/// Why shards cannot be joined.
enum class JoinFault { none, nothing, otherProject, otherEngine, overlap, incomplete };

/// Joins shards given in any order: what one run of all their parts gives. They must be of one
/// project and one engine version and together hold every part once.
struct JoinedBatch {
    JoinFault fault = JoinFault::none;
    BatchResult result; ///< without a fault
};
[[nodiscard]] JoinedBatch joinBatches(std::vector<BatchResult> shards);

} // namespace sparkout
