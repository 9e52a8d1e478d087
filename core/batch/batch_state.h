// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/issue.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A batch, or a shard of one, as text, so that separately computed shards can be joined.

namespace sparkout {

/// Why a text is not a state of a batch.
enum class StateFault {
    none,
    otherFormat,  ///< not a batch state
    tooDeep,      ///< nested deeper than limits::depth
    otherVersion, ///< a version that this program does not read
    changed,      ///< the checksum does not match the contents
    impossible    ///< contents no batch writes
};

/// Reads a state; without a result if no batch writes such a text.
struct ReadBatchState {
    StateFault fault = StateFault::none;
    std::optional<BatchResult> result;
    std::optional<Issue> issue; ///< the impossible value, at its JSON pointer

    explicit operator bool() const { return result.has_value(); }
};
[[nodiscard]] ReadBatchState readBatchState(std::string_view text);

namespace limits {
/// Greatest size of a shard that is read; filled bins and rows of 200 sections take less.
inline constexpr std::size_t shardBytes = std::size_t{256} << 20;
} // namespace limits

inline constexpr const char* batchStateFormat = "sparkout-batch";
inline constexpr int batchStateVersion = 3;

/// One UTF-8 JSON text with all results, bit for bit: equal results give equal bytes.
[[nodiscard]] std::string writeBatchState(const BatchResult& result);

/// The JSON text of a state with its checksum, in place of any it had. Empty for a text that nests
/// deeper than limits::depth or is not a JSON object.
[[nodiscard]] std::optional<std::string> sealBatchState(std::string_view text);

/// Digest of a project as written, by which shards are matched. It excludes the kept runs, which
/// runBatch() leaves out.
[[nodiscard]] std::string projectDigest(const Project& project);

/// Why shards cannot be joined.
enum class JoinFault { none, nothing, otherProject, otherEngine, overlap, incomplete };

/// The result of joining shards, which are named by their places in the given order.
struct JoinedBatch {
    struct Doubled {
        std::size_t first = 0, second = 0;
        PartRange parts; ///< parts that both hold
    };

    JoinFault fault = JoinFault::none;
    std::size_t model = 0;            ///< one of the shards that most others agree with
    std::vector<std::size_t> foreign; ///< shards of another project or engine
    std::vector<Doubled> doubled;     ///< overlapping shards
    std::vector<PartRange> missing;   ///< parts of an incomplete batch without a shard
    std::vector<std::size_t> stopped; ///< shards that were ended before their last part
    BatchResult result;               ///< valid without a fault
};

/// Joins shards given in any order into the result of one run of all their parts. They must be of
/// one project and one build of the engine and together contain every part once.
class BatchJoiner {
public:
    /// Adds a shard; only its identity and the sums are kept.
    void add(BatchResult shard);
    [[nodiscard]] JoinedBatch join() const;
    /// The shards so far, with only the number of parts of their statistics.
    [[nodiscard]] const std::vector<BatchResult>& shards() const { return m_shards; }

private:
    std::vector<BatchResult> m_shards;
    BatchStatistics m_total;
};

} // namespace sparkout
