// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_state.h"

#include "core/batch/state_seal.h"
#include "core/format/project_file.h"
#include "core/project/given_factors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

Json partValueJson(const PartValue& value) {
    return Json::array({value.value, value.part});
}

/// Writes the bins and products of the given factors, which come first.
Json valuesJson(const ValueStatistics& values, std::size_t factors) {
    Json sums = Json::array(), bins = Json::array();
    for (const ExactSum& sum : values.powers) {
        sums.push_back(sum.digits());
    }
    for (const auto& [number, bin] : values.bins.bins()) {
        bins.push_back(Json::array({number, bin.count}));
        for (std::size_t f = 0; f < factors; ++f) {
            bins.back().push_back(bin.scores[f]);
        }
    }
    Json products = Json::array();
    for (std::size_t i = 0; i < factors; ++i) {
        for (std::size_t j = i; j < factors; ++j) {
            products.push_back(values.products[productPlace(i, j)]);
        }
    }
    return {{"count", values.count},
            {"powers", std::move(sums)},
            {"least", partValueJson(values.least)},
            {"most", partValueJson(values.most)},
            {"below", values.below},
            {"above", values.above},
            {"bin_level", values.bins.level()},
            {"bins", std::move(bins)},
            {"score_products", std::move(products)}};
}

Json rowJson(const PartRow& row) {
    Json values = Json::array();
    for (const double value : row.values) {
        values.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
    }
    return Json::array({row.part, std::move(values)});
}

Json statisticsJson(const BatchStatistics& statistics, std::size_t factors) {
    Json values = Json::array(), rows = Json::array();
    for (const ValueStatistics& value : statistics.values) {
        values.push_back(valuesJson(value, factors));
    }
    for (const PartRow& row : statistics.rows) {
        rows.push_back(rowJson(row));
    }
    return {{"parts", statistics.parts},     {"failed", statistics.failed},
            {"bad", statistics.bad},         {"worst", partValueJson(statistics.worst)},
            {"rejects", statistics.rejects}, {"values", std::move(values)},
            {"rows", std::move(rows)}};
}

/// The common properties of shards of one batch.
auto identityOf(const BatchResult& shard) {
    return std::pair(projectDigest(shard.project), shard.batchParts);
}

auto engineOf(const BatchResult& shard) {
    return std::pair(shard.engineVersion, shard.build);
}

/// Finds what prevents joining shards, and lists all cases of the gravest fault.
class JoinCheck {
public:
    explicit JoinCheck(const std::vector<BatchResult>& shards) : m_shards(shards) {}

    JoinedBatch check() {
        if (m_shards.empty()) {
            m_joined.fault = JoinFault::nothing;
            return m_joined;
        }
        findForeign(JoinFault::otherProject, identityOf);
        findForeign(JoinFault::otherEngine, engineOf);
        if (m_joined.fault == JoinFault::none) {
            comparePlaces();
        }
        return std::move(m_joined);
    }

private:
    /// The shards that differ from the majority; in a tie from the first.
    template <class Trait>
    void findForeign(JoinFault fault, Trait trait) {
        if (m_joined.fault != JoinFault::none) {
            return;
        }
        std::vector<decltype(trait(m_shards[0]))> traits;
        for (const BatchResult& shard : m_shards) {
            traits.push_back(trait(shard));
        }
        std::ptrdiff_t most = 0;
        for (std::size_t i = 0; i < traits.size(); ++i) {
            const auto equal = std::count(traits.begin(), traits.end(), traits[i]);
            if (equal > most) {
                most = equal;
                m_joined.model = i;
            }
        }
        for (std::size_t i = 0; i < traits.size(); ++i) {
            if (traits[i] != traits[m_joined.model]) {
                m_joined.foreign.push_back(i);
                m_joined.fault = fault;
            }
        }
    }

    void comparePlaces() {
        std::vector<std::size_t> order(m_shards.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
            return m_shards[a].range.first < m_shards[b].range.first;
        });
        std::int64_t next = 0;
        std::size_t farthest = order.front(); // farthest shard so far
        for (const std::size_t i : order) {
            const PartRange& range = m_shards[i].range;
            const PartRange shared{range.first, std::min(next, range.end)};
            if (shared.first < shared.end) {
                m_joined.doubled.push_back({farthest, i, shared});
            } else if (range.first > next) {
                m_joined.missing.push_back({next, range.first});
            }
            if (m_shards[i].statistics.parts != range.end - range.first) {
                m_joined.stopped.push_back(i);
            }
            if (range.end > next) {
                next = range.end;
                farthest = i;
            }
        }
        if (next < m_shards.front().batchParts) {
            m_joined.missing.push_back({next, m_shards.front().batchParts});
        }
        m_joined.fault = !m_joined.doubled.empty() ? JoinFault::overlap
                         : !m_joined.missing.empty() || !m_joined.stopped.empty()
                             ? JoinFault::incomplete
                             : JoinFault::none;
    }

    const std::vector<BatchResult>& m_shards;
    JoinedBatch m_joined;
};

} // namespace

std::string writeBatchState(const BatchResult& result) {
    const Json project = Json::parse(writeProject(result.project));
    const std::size_t factors = scatteredFactors(result.project).size();
    return sealed({{"format", batchStateFormat},
                   {"version", batchStateVersion},
                   {"engine_version", result.engineVersion},
                   {"build", result.build},
                   {"project_digest", checksumOf(project.dump())},
                   {"project", project},
                   {"batch_parts", result.batchParts},
                   {"first", result.range.first},
                   {"end", result.range.end},
                   {"status", static_cast<int>(result.status)},
                   {"statistics", statisticsJson(result.statistics, factors)}});
}

std::optional<std::string> sealBatchState(std::string_view text) {
    std::optional<Json> state = parseState(text);
    return state ? std::optional(sealed(std::move(*state))) : std::nullopt;
}

std::string projectDigest(const Project& project) {
    return checksumOf(Json::parse(writeProject(project)).dump());
}

void BatchJoiner::add(BatchResult shard) {
    const std::int64_t parts = shard.statistics.parts;
    if (m_total.parts + parts <= shard.batchParts) { // otherwise some overlap, which join() refuses
        m_total.add(shard.statistics);
    }
    shard.statistics = {};
    shard.statistics.parts = parts;
    m_shards.push_back(std::move(shard));
}

JoinedBatch BatchJoiner::join() const {
    JoinedBatch joined = JoinCheck(m_shards).check();
    if (joined.fault != JoinFault::none) {
        return joined;
    }
    joined.result = m_shards[joined.model];
    joined.result.range = {0, joined.result.batchParts};
    joined.result.statistics = m_total;
    joined.result.statistics.sort();
    return joined;
}

} // namespace sparkout
