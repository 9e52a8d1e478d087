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
inline constexpr int batchStateVersion = 3;

/// One UTF-8 JSON text with everything, bit for bit: equal results, equal bytes.
[[nodiscard]] std::string writeBatchState(const BatchResult& result);

/// The JSON text of a state with the checksum that belongs to it, in place of any it had. Nothing
/// for a text that nests deeper than limits::depth or is no JSON object.
[[nodiscard]] std::optional<std::string> sealBatchState(std::string_view text);

/// Digest of a project as it is written: names what a shard is of. The kept runs of the file are no
/// part of it, for runBatch() leaves them out.
[[nodiscard]] std::string projectDigest(const Project& project);

/// Why shards cannot be joined.
enum class JoinFault { none, nothing, otherProject, otherEngine, overlap, incomplete };

/// What came of joining shards. They are named by their places in the order they were given.
struct JoinedBatch {
    struct Doubled {
        std::size_t first = 0, second = 0;
        PartRange parts; ///< that both hold
    };

    JoinFault fault = JoinFault::none;
    std::size_t model = 0;            ///< one of those that most shards agree with
    std::vector<std::size_t> foreign; ///< of another project or engine than it
    std::vector<Doubled> doubled;     ///< of an overlap
    std::vector<PartRange> missing;   ///< of an incomplete batch: parts of no shard
    std::vector<std::size_t> stopped; ///< shards that were ended before their last part
    BatchResult result;               ///< without a fault
};

/// Joins shards given in any order: what one run of all their parts gives. They must be of one
/// project and one build of the engine and together hold every part once.
class BatchJoiner {
public:
    /// Takes a shard in; but for what it is of, nothing of it is kept beside the sums.
    void add(BatchResult shard);
    [[nodiscard]] JoinedBatch join() const;
    /// The shards so far, of their statistics only the number of parts.
    [[nodiscard]] const std::vector<BatchResult>& shards() const { return m_shards; }

private:
    std::vector<BatchResult> m_shards;
    BatchStatistics m_total;
};

} // namespace sparkout
