// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_statistics.h"
#include "core/batch/characteristics.h"
#include "core/batch/scenario_source.h"
#include "core/issue.h"
#include "core/project/project.h"

#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace sparkout {

/// Restores the order of parts that several threads run, for a sink. It holds few of them: a thread
/// far ahead of the slowest part waits.
class PartQueue {
public:
    /// `first` is the place of the first part.
    PartQueue(const PartSink& sink, std::int64_t first, std::stop_token stop)
        : m_sink(sink), m_next(first), m_stop(std::move(stop)) {}

    /// False if the sink wants no more, or a stop was requested.
    bool put(std::int64_t place, PartRecord record);

private:
    const PartSink& m_sink;
    std::mutex m_mutex;
    std::condition_variable_any m_moved;
    std::map<std::int64_t, PartRecord> m_waiting; ///< waiting parts by place
    std::int64_t m_next;
    std::stop_token m_stop;
    bool m_over = false;
};

/// Faults of a project with a batch: its own, the batch's, and those of the extreme parts, each of
/// which must be a valid project. Empty: the batch can be run.
[[nodiscard]] Issues checkBatch(const Project& project);

/// The parts first…end−1 of a batch.
struct PartRange {
    std::int64_t first = 0, end = 0;
};

/// The parts of shard `index` (from 1) of `shards`: every part is in exactly one.
[[nodiscard]] PartRange shardRange(std::int64_t parts, int index, int shards);

struct BatchOptions {
    int threads = 0;                ///< 0: as many as the processor runs at once
    std::optional<PartRange> range; ///< a shard; not given: all parts
    /// Ends the batch when every Student 95 % interval of a mean in µm is no wider than this [µm].
    /// Checked after every `round` parts, so that the result is independent of the number of
    /// threads; the parts are run in random order, so that an early end samples the whole of a law
    /// over the batch. Not for a shard; all corners are run.
    std::optional<double> meanWidth_um;
    std::int64_t round = 1024;
    std::stop_token stop;
    std::atomic<std::int64_t>* done = nullptr; ///< number of finished parts during the run
    /// Receives every part, one at a time and in the order of the run, whatever the number of
    /// threads; returning false ends the batch like a stop request.
    PartSink sink = nullptr;
};

/// The first three are stored as numbers in the state of a shard, which a refused batch does not
/// have.
enum class BatchStatus { completed, narrowEnough, stopped, refused };

/// The result of a batch, or of a part of one, with its inputs.
struct BatchResult {
    Project project; ///< with its batch, without the kept runs
    std::string engineVersion;
    std::string build;           ///< buildId() of the engine
    PartRange range;             ///< requested parts; a stopped batch may lack some
    std::int64_t batchParts = 0; ///< number of parts of the whole batch
    BatchStatus status = BatchStatus::completed;
    Issues issues; ///< why it was refused, by checkBatch()
    BatchStatistics statistics;
};

/// Runs a batch; refuses one that fails checkBatch(). The result is independent of the number of
/// threads, bit for bit; a stop request ends it within a revolution of each thread and keeps the
/// finished parts.
[[nodiscard]] BatchResult runBatch(const Project& project, const BatchOptions& options = {});

/// Runs a batch that is known to pass checkBatch().
[[nodiscard]] BatchResult runBatchUnchecked(const Project& project,
                                            const BatchOptions& options = {});

} // namespace sparkout
