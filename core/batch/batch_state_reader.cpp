// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_state_reader.h"

#include "core/batch/batch_check.h"
#include "core/batch/batch_state.h"
#include "core/batch/state_seal.h"
#include "core/format/project_file.h"
#include "core/project/given_factors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

using Json = nlohmann::ordered_json;

/// A state that no batch writes.
struct NoState {};

void expect(bool holds) {
    if (!holds) {
        throw NoState();
    }
}

std::int64_t wholeIn(const Json& value, std::int64_t low, std::int64_t high) {
    expect(value.is_number_integer()
           && (!value.is_number_unsigned()
               || value.get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max()));
    const auto number = value.get<std::int64_t>();
    expect(number >= low && number <= high);
    return number;
}

/// Reads a state and refuses whatever could lead the joining or the figures astray.
class StateReader {
public:
    explicit StateReader(const Json& state) : m_state(state) {}

    BatchResult read() {
        ReadResult project = readProject(m_state.at("project").dump());
        expect(project.project && checkBatch(*project.project).empty());
        m_result.project = std::move(*project.project);
        m_characteristics = characteristicsOf(m_result.project).size();
        m_factors = scatteredFactors(m_result.project).size();
        expect(m_state.at("project_digest") == projectDigest(m_result.project));
        m_result.engineVersion = m_state.at("engine_version").get<std::string>();
        m_result.build = m_state.at("build").get<std::string>();
        m_result.batchParts = ScenarioSource(m_result.project).parts();
        expect(m_state.at("batch_parts") == m_result.batchParts);
        m_result.range.end = wholeIn(m_state.at("end"), 0, m_result.batchParts);
        m_result.range.first = wholeIn(m_state.at("first"), 0, m_result.range.end);
        m_result.status = static_cast<BatchStatus>(
            wholeIn(m_state.at("status"), 0, static_cast<int>(BatchStatus::stopped)));
        readStatistics(m_state.at("statistics"));
        return std::move(m_result);
    }

private:
    void readStatistics(const Json& state) {
        BatchStatistics& statistics = m_result.statistics;
        statistics.parts = wholeIn(state.at("parts"), 0, m_result.range.end - m_result.range.first);
        statistics.failed = wholeIn(state.at("failed"), 0, statistics.parts);
        statistics.bad = wholeIn(state.at("bad"), statistics.failed, statistics.parts);
        const Json& rejects = state.at("rejects");
        std::int64_t causes = 0;
        expect(rejects.size() == statistics.rejects.size());
        for (std::size_t i = 0; i < statistics.rejects.size(); ++i) {
            statistics.rejects[i] = wholeIn(rejects.at(i), 0, statistics.bad - statistics.failed);
            causes += statistics.rejects[i];
        }
        expect(causes >= statistics.bad - statistics.failed); // each of these has one at least
        statistics.worst = partValue(state.at("worst"), statistics.parts == 0);
        const std::int64_t measured = statistics.parts - statistics.failed;
        for (const Json& values : state.at("values")) {
            statistics.values.push_back(readValues(values, measured));
        }
        expect(statistics.values.size() == (statistics.parts > 0 ? m_characteristics : 0));
        for (const Json& row : state.at("rows")) {
            statistics.rows.push_back(readRow(row));
        }
        expect(static_cast<std::int64_t>(statistics.rows.size()) <= measured);
    }

    [[nodiscard]] PartValue partValue(const Json& state, bool none) const {
        expect(state.size() == 2);
        if (none) {
            expect(state.at(1) == -1);
            return {};
        }
        const PartValue value{state.at(0).get<double>(),
                              wholeIn(state.at(1), m_result.range.first, m_result.range.end - 1)};
        expect(std::isfinite(value.value));
        return value;
    }

    [[nodiscard]] ValueStatistics readValues(const Json& state, std::int64_t measured) const {
        ValueStatistics values;
        values.count = wholeIn(state.at("count"), 0, measured);
        expect(state.at("powers").size() == values.powers.size());
        for (std::size_t i = 0; i < values.powers.size(); ++i) {
            values.powers[i] = readSum(state.at("powers").at(i));
        }
        values.least = partValue(state.at("least"), values.count == 0);
        values.most = partValue(state.at("most"), values.count == 0);
        expect(values.least.value <= values.most.value);
        values.below = wholeIn(state.at("below"), 0, values.count);
        values.above = wholeIn(state.at("above"), 0, values.count - values.below);
        readBins(state, values);
        return values;
    }

    void readBins(const Json& state, ValueStatistics& values) const {
        const auto level =
            static_cast<int>(wholeIn(state.at("bin_level"), 0, ValueBins::highestLevel));
        ValueBins::Map bins;
        std::int64_t left = values.count;
        for (const Json& given : state.at("bins")) {
            expect(given.size() == 2 + m_factors);
            const std::int64_t at =
                wholeIn(given.at(0), ValueBins::lowest(level), ValueBins::highest(level));
            expect(bins.empty() || at > bins.rbegin()->first);
            ValueBins::Bin& bin = bins[at];
            left -= bin.count = wholeIn(given.at(1), 1, left);
            for (std::size_t f = 0; f < m_factors; ++f) {
                const std::int64_t most = bin.count << (rankScoreBits - 1);
                bin.scores[f] = wholeIn(given.at(2 + f), -most, most);
            }
        }
        expect(left == 0 && bins.size() <= ValueBins::mostFor(m_characteristics));
        values.bins = ValueBins::of(level, std::move(bins));
        expect(state.at("score_products").size() == m_factors * (m_factors + 1) / 2);
        std::size_t next = 0;
        for (std::size_t i = 0; i < m_factors; ++i) {
            for (std::size_t j = i; j < m_factors; ++j) {
                const std::int64_t most = values.count << (2 * (rankScoreBits - 1));
                values.products[productPlace(i, j)] =
                    wholeIn(state.at("score_products").at(next++), -most, most);
            }
        }
    }

    static ExactSum readSum(const Json& state) {
        constexpr std::int64_t base = std::int64_t{1} << 32;
        ExactSum::Limbs digits{};
        expect(state.size() == digits.size());
        for (std::size_t i = 0; i + 1 < digits.size(); ++i) {
            digits[i] = wholeIn(state.at(i), 0, base - 1);
        }
        digits.back() = wholeIn(state.at(digits.size() - 1), -base, base);
        return ExactSum::ofDigits(digits);
    }

    [[nodiscard]] PartRow readRow(const Json& state) const {
        expect(state.size() == 2 && state.at(1).size() == m_characteristics);
        const auto& rows = m_result.statistics.rows;
        const std::int64_t first = rows.empty() ? m_result.range.first : rows.back().part + 1;
        PartRow row{wholeIn(state.at(0), first,
                            std::min(m_result.range.end, BatchStatistics::keptRows) - 1),
                    {}};
        for (const Json& value : state.at(1)) {
            row.values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                                 : value.get<double>());
        }
        return row;
    }

    const Json& m_state;
    BatchResult m_result;
    std::size_t m_characteristics = 0, m_factors = 0;
};

ReadBatchState contentsOf(const Json& state) {
    try {
        return {StateFault::none, StateReader(state).read()};
    } catch (const Json::exception&) {
        return {StateFault::impossible, {}};
    } catch (const NoState&) {
        return {StateFault::impossible, {}};
    }
}

} // namespace

ReadBatchState readBatchState(std::string_view text) {
    if (nestingOf(text) > limits::depth) {
        return {StateFault::tooDeep, {}};
    }
    std::optional<Json> state = parseState(text);
    if (!state || !state->contains("format") || state->at("format") != batchStateFormat) {
        return {StateFault::otherFormat, {}};
    }
    if (!state->contains("version") || state->at("version") != batchStateVersion) {
        return {StateFault::otherVersion, {}};
    }
    if (!unseal(*state)) {
        return {StateFault::changed, {}};
    }
    return contentsOf(*state);
}

} // namespace sparkout
