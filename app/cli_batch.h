// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_state.h"
#include "core/batch/batch_summary.h"
#include "core/batch/sensitivity.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// The figures of a batch as text, with Sobol indices if they were requested.
[[nodiscard]] std::string batchText(const BatchResult& result,
                                    const std::optional<SobolIndices>& indices);

/// The reasons why shards cannot be joined: lines that name the shards, in the order of `files`.
[[nodiscard]] std::string joinText(const JoinedBatch& joined,
                                   const std::vector<BatchResult>& shards,
                                   const std::vector<std::string>& files);

/// The reason why a file is not a shard.
[[nodiscard]] std::string stateSentence(StateFault fault);

} // namespace sparkout::cli
