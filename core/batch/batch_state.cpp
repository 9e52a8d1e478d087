// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_state.h"

#include "core/project/project_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

Json partValueJson(const PartValue& value) {
    return Json::array({value.value, value.part});
}

Json valuesJson(const ValueStatistics& values) {
    Json sums = Json::array(), bins = Json::array();
    for (const ExactSum& sum : values.powers) {
        sums.push_back(sum.digits());
    }
    for (const auto& [bin, count] : values.bins) {
        bins.push_back(Json::array({bin, count}));
    }
    return {{"count", values.count},
            {"powers", std::move(sums)},
            {"least", partValueJson(values.least)},
            {"most", partValueJson(values.most)},
            {"below", values.below},
            {"above", values.above},
            {"bins", std::move(bins)}};
}

Json rowJson(const PartRow& row) {
    Json values = Json::array();
    for (const double value : row.values) {
        values.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
    }
    return Json::array({row.part, std::move(values)});
}

Json statisticsJson(const BatchStatistics& statistics) {
    Json values = Json::array(), rows = Json::array();
    for (const ValueStatistics& value : statistics.values) {
        values.push_back(valuesJson(value));
    }
    for (const PartRow& row : statistics.rows) {
        rows.push_back(rowJson(row));
    }
    return {{"parts", statistics.parts},     {"failed", statistics.failed},
            {"bad", statistics.bad},         {"worst", partValueJson(statistics.worst)},
            {"rejects", statistics.rejects}, {"values", std::move(values)},
            {"rows", std::move(rows)}};
}

JoinFault joinFault(const std::vector<BatchResult>& shards) {
    if (shards.empty()) {
        return JoinFault::nothing;
    }
    std::int64_t next = 0;
    for (const BatchResult& shard : shards) {
        if (!sameProject(shard.project, shards.front().project)
            || shard.batchParts != shards.front().batchParts) {
            return JoinFault::otherProject;
        }
        if (shard.engineVersion != shards.front().engineVersion) {
            return JoinFault::otherEngine;
        }
        if (shard.range.first < next) {
            return JoinFault::overlap;
        }
        if (shard.range.first > next
            || shard.statistics.parts != shard.range.end - shard.range.first) {
            return JoinFault::incomplete;
        }
        next = shard.range.end;
    }
    return next == shards.front().batchParts ? JoinFault::none : JoinFault::incomplete;
}

} // namespace

std::string writeBatchState(const BatchResult& result) {
    const Json json = {{"format", batchStateFormat},
                       {"version", batchStateVersion},
                       {"engine_version", result.engineVersion},
                       {"project", Json::parse(writeProject(result.project))},
                       {"batch_parts", result.batchParts},
                       {"first", result.range.first},
                       {"end", result.range.end},
                       {"status", static_cast<int>(result.status)},
                       {"statistics", statisticsJson(result.statistics)}};
    return json.dump() + '\n';
}

JoinedBatch joinBatches(std::vector<BatchResult> shards) {
    std::sort(shards.begin(), shards.end(), [](const BatchResult& a, const BatchResult& b) {
        return a.range.first < b.range.first;
    });
    JoinedBatch joined{joinFault(shards), {}};
    if (joined.fault != JoinFault::none) {
        return joined;
    }
    joined.result = std::move(shards.front());
    for (std::size_t i = 1; i < shards.size(); ++i) {
        joined.result.statistics.add(shards[i].statistics);
    }
    joined.result.range = {0, joined.result.batchParts};
    joined.result.statistics.sort();
    return joined;
}

} // namespace sparkout
