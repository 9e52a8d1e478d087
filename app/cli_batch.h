// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_state.h"
#include "core/batch/batch_state_reader.h"
#include "core/batch/batch_verdict.h"
#include "core/batch/sensitivity.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout::cli {

/// The figures of a batch for people; with Sobol indices where they were asked for.
[[nodiscard]] std::string batchText(const BatchResult& result,
                                    const std::optional<SobolIndices>& indices);

/// Why shards cannot be joined: lines that name them, in the order of `files`.
[[nodiscard]] std::string joinText(const JoinedBatch& joined,
                                   const std::vector<BatchResult>& shards,
                                   const std::vector<std::string>& files);

/// Why a file is no shard.
[[nodiscard]] std::string stateSentence(StateFault fault);

} // namespace sparkout::cli
