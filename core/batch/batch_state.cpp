// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_state.h"

#include "core/batch/state_seal.h"
#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/project/given_factors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

/// Thrown for a state that no batch writes.
struct NoState {
    Issue issue;
};

Detail shown(const Json& value) {
    return quoted(nlohmann::json(value));
}

/// A value of a state and its path, for messages.
class Node {
public:
    explicit Node(const Json& value) : m_value(value) {}

    // The parent must outlive the node, since a message follows it to build the path.
    [[nodiscard]] Node at(const char* key) const& {
        const auto found = m_value.is_object() ? m_value.find(key) : m_value.end();
        if (found == m_value.end()) {
            refuse(IssueCode::missingKey, {}, Keys{{key}, Keys::Kind::members});
        }
        return {*found, this, key, 0};
    }
    [[nodiscard]] Node item(std::size_t index) const& {
        expectSize(index + 1, std::numeric_limits<std::size_t>::max());
        return {m_value.at(index), this, nullptr, index};
    }
    Node at(const char* key) const&& = delete;
    Node item(std::size_t index) const&& = delete;

    [[nodiscard]] bool isNull() const { return m_value.is_null(); }
    [[nodiscard]] std::size_t size() const { return m_value.is_array() ? m_value.size() : 0; }
    void expectSize(std::size_t least, std::size_t most) const {
        const std::size_t size = this->size();
        if (!m_value.is_array() || size < least || size > most) {
            constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
            Bounds bounds{.range = {.low = static_cast<double>(least)}};
            bounds.range.high = most == unlimited ? bounds.range.high : static_cast<double>(most);
            refuse(IssueCode::wrongCount, countOf(size), bounds);
        }
    }
    void expectSize(std::size_t size) const { expectSize(size, size); }

    [[nodiscard]] std::int64_t whole(std::int64_t low, std::int64_t high) const {
        const bool isWhole =
            m_value.is_number_integer()
            && (!m_value.is_number_unsigned()
                || m_value.get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max());
        if (!isWhole) {
            refuse(IssueCode::wrongType, shown(m_value), Phrase::wholeNumber);
        }
        const auto number = m_value.get<std::int64_t>();
        if (number < low || number > high) {
            refuse(IssueCode::outOfRange, Count{number},
                   Bounds{{static_cast<double>(low), static_cast<double>(high)}});
        }
        return number;
    }
    [[nodiscard]] double number(const Range& range) const {
        if (!m_value.is_number()) {
            refuse(IssueCode::wrongType, shown(m_value), Phrase::number);
        }
        const auto number = m_value.get<double>();
        expectIn(number, range);
        return number;
    }
    /// Checks a number against the range of its quantity.
    void expectIn(double number, const Range& range) const {
        if (!std::isfinite(number) || !range.contains(number)) {
            refuse(IssueCode::outOfRange, Amount{number}, Bounds{range});
        }
    }
    [[nodiscard]] std::string text() const {
        if (!m_value.is_string()) {
            refuse(IssueCode::wrongType, shown(m_value), Phrase::text);
        }
        return m_value.get<std::string>();
    }
    void expectText(const std::string& expected) const {
        if (text() != expected) {
            refuse(IssueCode::notOneOf, shown(m_value), Keys{{expected}, Keys::Kind::choices});
        }
    }
    [[nodiscard]] std::string dump() const { return m_value.dump(); }

    [[noreturn]] void refuse(IssueCode code, Detail value, Detail limit) const {
        throw NoState{{code, Severity::error, path(), std::move(value), std::move(limit)}};
    }

private:
    Node(const Json& value, const Node* parent, const char* key, std::size_t index)
        : m_value(value), m_parent(parent), m_key(key), m_index(index) {}

    [[nodiscard]] std::string path() const {
        return m_parent ? m_parent->path() + '/' + (m_key ? m_key : std::to_string(m_index)) : "";
    }

    const Json& m_value;
    const Node* m_parent = nullptr;
    const char* m_key = nullptr;
    std::size_t m_index = 0;
};

/// Range of the values of a batch, in µm, kW, s, % or MPa: outside it fourth powers could not be
/// summed.
constexpr Range possible{-1e9, 1e9};

/// Reads a state and refuses values that would corrupt the joining or the figures.
class StateReader {
public:
    explicit StateReader(const Json& state) : m_state(state) {}

    BatchResult read() {
        const Node project = m_state.at("project");
        ReadResult read = readProject(project.dump());
        if (!read.project || !checkBatch(*read.project).empty()) {
            const Issues issues = read.project ? checkBatch(*read.project) : read.issues;
            Issue issue = issues.front();
            issue.path = "/project" + issue.path;
            throw NoState{std::move(issue)};
        }
        m_result.project = std::move(*read.project);
        m_characteristics = characteristicsOf(m_result.project);
        m_factors = scatteredFactors(m_result.project).size();
        m_state.at("project_digest").expectText(projectDigest(m_result.project));
        m_result.engineVersion = m_state.at("engine_version").text();
        m_result.build = m_state.at("build").text();
        const std::int64_t parts = ScenarioSource(m_result.project).parts();
        m_result.batchParts = m_state.at("batch_parts").whole(parts, parts);
        m_result.range.end = m_state.at("end").whole(0, m_result.batchParts);
        m_result.range.first = m_state.at("first").whole(0, m_result.range.end);
        m_result.status = static_cast<BatchStatus>(
            m_state.at("status").whole(0, static_cast<int>(BatchStatus::stopped)));
        const Node statistics = m_state.at("statistics");
        readStatistics(statistics);
        return std::move(m_result);
    }

private:
    void readStatistics(const Node& state) {
        BatchStatistics& statistics = m_result.statistics;
        statistics.parts = state.at("parts").whole(0, m_result.range.end - m_result.range.first);
        statistics.failed = state.at("failed").whole(0, statistics.parts);
        statistics.bad = state.at("bad").whole(statistics.failed, statistics.parts);
        const Node rejects = state.at("rejects");
        std::int64_t causes = 0;
        rejects.expectSize(statistics.rejects.size());
        for (std::size_t i = 0; i < statistics.rejects.size(); ++i) {
            statistics.rejects[i] = rejects.item(i).whole(0, statistics.bad - statistics.failed);
            causes += statistics.rejects[i];
        }
        // Each bad part that did not fail has at least one cause.
        rejects.expectIn(static_cast<double>(causes),
                         {.low = static_cast<double>(statistics.bad - statistics.failed)});
        constexpr double ofFailed = std::numeric_limits<double>::lowest();
        const Node worst = state.at("worst");
        statistics.worst = partValue(worst, statistics.parts == 0,
                                     statistics.failed > 0 ? Range{ofFailed, ofFailed} : possible);
        const std::int64_t measured = statistics.parts - statistics.failed;
        const Node values = state.at("values");
        values.expectSize(statistics.parts > 0 ? m_characteristics.size() : 0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Node one = values.item(i);
            statistics.values.push_back(readValues(one, measured, m_characteristics[i]));
        }
        const Node rows = state.at("rows");
        rows.expectSize(0, static_cast<std::size_t>(measured));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Node row = rows.item(i);
            statistics.rows.push_back(readRow(row));
        }
    }

    [[nodiscard]] PartValue partValue(const Node& state, bool none, const Range& range) const {
        state.expectSize(2);
        if (none) {
            (void)state.item(1).whole(-1, -1);
            return {};
        }
        return {state.item(0).number(range),
                state.item(1).whole(m_result.range.first, m_result.range.end - 1)};
    }

    [[nodiscard]] ValueStatistics readValues(const Node& state, std::int64_t measured,
                                             const Characteristic& characteristic) const {
        ValueStatistics values;
        values.count = state.at("count").whole(0, measured);
        const Node least = state.at("least"), most = state.at("most");
        values.least = partValue(least, values.count == 0, possible);
        values.most = partValue(most, values.count == 0, {values.least.value, possible.high});
        const Node powers = state.at("powers");
        powers.expectSize(values.powers.size());
        for (std::size_t i = 0; i < values.powers.size(); ++i) {
            const Node power = powers.item(i);
            values.powers[i] = readSum(power);
        }
        checkPowers(powers, values);
        values.below = state.at("below").whole(0, values.count);
        values.above = state.at("above").whole(0, values.count - values.below);
        readBins(state, values, characteristic.resolution);
        return values;
    }

    /// Checks sums of powers of values between the least and the greatest: each within its ends,
    /// and Σx²·n at least (Σx)², Σx⁴·n at least (Σx²)² [Cauchy and Schwarz], up to rounding.
    static void checkPowers(const Node& powers, const ValueStatistics& values) {
        constexpr double rounding = 1e-9;
        const double n = static_cast<double>(values.count);
        const double low = values.least.value, high = values.most.value;
        const double farthest = std::max(std::abs(low), std::abs(high));
        const bool crosses = low < 0 && high > 0;
        double size = 1; // magnitude of the greatest power
        double ends[2] = {1, 1};
        for (std::size_t i = 0; i < values.powers.size(); ++i) {
            size *= farthest;
            ends[0] *= low;
            ends[1] *= high;
            const bool isEven = i % 2 == 1;
            const double least = isEven && crosses ? 0 : std::min(ends[0], ends[1]);
            const double slack = n * size * rounding;
            const Range range{n * least - slack, n * std::max(ends[0], ends[1]) + slack};
            powers.item(i).expectIn(values.powers[i].value(), range);
        }
        const auto sum = [&](std::size_t power) { return values.powers[power - 1].value(); };
        const auto atLeast = [&](std::size_t power, double square) {
            const double least = n > 0 ? square * square / n * (1 - rounding) : 0;
            powers.item(power - 1).expectIn(sum(power), {.low = least});
        };
        atLeast(2, sum(1));
        atLeast(4, sum(2));
    }

    void readBins(const Node& state, ValueStatistics& values, double resolution) const {
        const auto level =
            static_cast<int>(state.at("bin_level").whole(0, ValueBins::highestLevel));
        ValueBins::Map bins;
        std::int64_t left = values.count;
        const Node list = state.at("bins");
        list.expectSize(values.count > 0 ? 1 : 0, ValueBins::mostFor(m_characteristics.size()));
        const std::int64_t lowest = ValueBins::lowest(level), highest = ValueBins::highest(level);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Node given = list.item(i);
            given.expectSize(2 + m_factors);
            const std::int64_t at =
                given.item(0).whole(bins.empty() ? lowest : bins.rbegin()->first + 1, highest);
            ValueBins::Bin& bin = bins[at];
            left -= bin.count = given.item(1).whole(1, left);
            for (std::size_t f = 0; f < m_factors; ++f) {
                const std::int64_t most = bin.count << (rankScoreBits - 1);
                bin.scores[f] = given.item(2 + f).whole(-most, most);
            }
        }
        list.expectIn(static_cast<double>(values.count - left),
                      {static_cast<double>(values.count), static_cast<double>(values.count)});
        values.bins = ValueBins::of(level, std::move(bins));
        checkBins(list, values, resolution);
        const Node products = state.at("score_products");
        products.expectSize(m_factors * (m_factors + 1) / 2);
        std::size_t next = 0;
        for (std::size_t i = 0; i < m_factors; ++i) {
            for (std::size_t j = i; j < m_factors; ++j) {
                const std::int64_t most = values.count << (2 * (rankScoreBits - 1));
                values.products[productPlace(i, j)] = products.item(next++).whole(-most, most);
            }
        }
    }

    /// The outermost bins contain the least and the greatest value; the outermost possible ones
    /// contain everything beyond.
    static void checkBins(const Node& list, const ValueStatistics& values, double resolution) {
        if (values.count == 0) {
            return;
        }
        const int level = values.bins.level();
        const double width = values.bins.width(resolution);
        const auto binOf = [&](double value) {
            return std::clamp(std::floor(value / width),
                              static_cast<double>(ValueBins::lowest(level)),
                              static_cast<double>(ValueBins::highest(level)));
        };
        const double first = binOf(values.least.value), last = binOf(values.most.value);
        list.expectIn(static_cast<double>(values.bins.bins().begin()->first), {first, first});
        list.expectIn(static_cast<double>(values.bins.bins().rbegin()->first), {last, last});
    }

    static ExactSum readSum(const Node& state) {
        constexpr std::int64_t base = std::int64_t{1} << 32;
        ExactSum::Limbs digits{};
        state.expectSize(digits.size());
        for (std::size_t i = 0; i < digits.size(); ++i) {
            const bool isLast = i + 1 == digits.size();
            digits[i] = state.item(i).whole(isLast ? -base : 0, isLast ? base : base - 1);
        }
        return ExactSum::ofDigits(digits);
    }

    [[nodiscard]] PartRow readRow(const Node& state) const {
        state.expectSize(2);
        const auto& rows = m_result.statistics.rows;
        const std::int64_t first = rows.empty() ? m_result.range.first : rows.back().part + 1;
        PartRow row{
            state.item(0).whole(first, std::min(m_result.range.end, BatchStatistics::keptRows) - 1),
            {}};
        const Node values = state.item(1);
        values.expectSize(m_characteristics.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Node value = values.item(i);
            const ValueStatistics& all = m_result.statistics.values[i];
            row.values.push_back(value.isNull() ? std::numeric_limits<double>::quiet_NaN()
                                                : value.number({all.least.value, all.most.value}));
        }
        return row;
    }

    Node m_state;
    BatchResult m_result;
    std::vector<Characteristic> m_characteristics;
    std::size_t m_factors = 0;
};

ReadBatchState contentsOf(const Json& state) {
    try {
        return {StateFault::none, StateReader(state).read(), {}};
    } catch (const NoState& none) {
        return {StateFault::impossible, {}, none.issue};
    }
}

} // namespace

ReadBatchState readBatchState(std::string_view text) {
    if (nestingOf(text) > limits::depth) {
        return {StateFault::tooDeep, {}, {}};
    }
    std::optional<Json> state = parseState(text);
    if (!state || !state->contains("format") || state->at("format") != batchStateFormat) {
        return {StateFault::otherFormat, {}, {}};
    }
    if (!state->contains("version") || state->at("version") != batchStateVersion) {
        return {StateFault::otherVersion, {}, {}};
    }
    if (!unseal(*state)) {
        return {StateFault::changed, {}, {}};
    }
    return contentsOf(*state);
}

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
