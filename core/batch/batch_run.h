// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_statistics.h"
#include "core/batch/part_record.h"
#include "core/batch/scenario_source.h"
#include "core/issue.h"

#include <atomic>
#include <optional>
#include <stop_token>
#include <string>

namespace sparkout {

/// The parts first…end−1 of a batch.
struct PartRange {
    std::int64_t first = 0, end = 0;
};

/// The parts of shard `index` (from 1) of `shards`: every part is in exactly one.
[[nodiscard]] PartRange shardRange(std::int64_t parts, int index, int shards);

struct BatchOptions {
    int threads = 0;                ///< 0: as many as the processor carries out at once
    std::optional<PartRange> range; ///< a shard; not given: all parts
    /// Ends the batch when every Student 95 % interval of a mean in µm is no wider than this [µm].
    /// Asked after every `round` parts, so that the answer is the same for any number of threads;
    /// the parts are then taken in random order, so that a law over the batch is met all along it
    /// however early it ends. Of all parts, not of a shard; corners are all run.
    std::optional<double> meanWidth_um;
    std::int64_t round = 1024;
    std::stop_token stop;
    std::atomic<std::int64_t>* done = nullptr; ///< parts done, while it runs
    /// Receives every part, one at a time and in the order they are taken, whatever the number of
    /// threads; when it wants no more the batch ends as by a stop request.
    PartSink sink = nullptr;
};

/// The first three stand as numbers in the state of a shard, which a refused batch has not.
enum class BatchStatus { completed, narrowEnough, stopped, refused };

/// What came out of a batch, or of a part of one. A value; it says what was run.
struct BatchResult {
    Project project; ///< with its batch, without kept runs
    std::string engineVersion;
    std::string build;           ///< of the engine, buildId()
    PartRange range;             ///< asked for; of a stopped batch not every part of it is in
    std::int64_t batchParts = 0; ///< parts of the whole batch
    BatchStatus status = BatchStatus::completed;
    Issues issues; ///< why it was refused, as checkBatch() has them
    BatchStatistics statistics;
};

/// Runs a batch: no part of one that checkBatch() does not pass, which is refused. The same for any
/// number of threads, bit for bit; a stop request ends it within a revolution of each thread and
/// keeps what was done.
[[nodiscard]] BatchResult runBatch(const Project& project, const BatchOptions& options = {});

/// The same of a batch that is known to pass.
[[nodiscard]] BatchResult runBatchUnchecked(const Project& project,
                                            const BatchOptions& options = {});

} // namespace sparkout
