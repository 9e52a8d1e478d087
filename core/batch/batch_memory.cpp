// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_memory.h"

#include "core/batch/batch_statistics.h"
#include "core/batch/scenario_source.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace sparkout {

namespace {

constexpr std::size_t program = std::size_t{48} << 20; ///< it and its libraries, one run's states
constexpr std::size_t aThread = std::size_t{4} << 20;  ///< its run and its stack
constexpr std::size_t ofTheHeap = 16;                  ///< kept by the heap beside what it gives
constexpr std::size_t ofTheTree = 32;                  ///< and by a map
constexpr std::size_t growth = 2;         ///< what grows by doubling has room for twice as much
constexpr std::size_t longestNumber = 25; ///< of the longest number with its comma

/// The sizes that everything is counted from.
class Sizes {
public:
    explicit Sizes(const Project& project) {
        const ScenarioSource source(project);
        const auto parts = static_cast<std::size_t>(source.parts());
        m_factors = source.factors().size();
        m_characteristics = characteristicsOf(source.nominal()).size();
        m_bins = m_characteristics * (std::min(parts, ValueBins::mostFor(m_characteristics)) + 1);
        m_cells = m_characteristics
                  * std::min(parts, static_cast<std::size_t>(BatchStatistics::keptRows));
    }

    /// What a thread gathers, but for the rows.
    [[nodiscard]] std::size_t statistics() const {
        return m_characteristics * (sizeof(ValueStatistics) + ofTheHeap)
               + m_bins * (ofTheTree + sizeof(ValueBins::Map::value_type) + ofTheHeap);
    }
    /// Those of all threads together.
    [[nodiscard]] std::size_t rows() const {
        return m_cells * growth * sizeof(double)
               + BatchStatistics::keptRows * growth * (sizeof(PartRow) + ofTheHeap);
    }
    /// A state as a tree of JSON.
    [[nodiscard]] std::size_t tree() const {
        constexpr std::size_t value = sizeof(nlohmann::ordered_json);
        const std::size_t bin = growth * value + sizeof(nlohmann::ordered_json::array_t) + ofTheHeap
                                + growth * value * (numbersOfABin() + 1) + ofTheHeap;
        return m_bins * bin + m_cells * growth * value + m_characteristics * (std::size_t{4} << 10);
    }
    /// Its text.
    [[nodiscard]] std::size_t text() const {
        return (m_bins * numbersOfABin() + m_cells) * longestNumber
               + m_characteristics * (std::size_t{2} << 10);
    }

private:
    [[nodiscard]] std::size_t numbersOfABin() const { return 2 + m_factors; }

    std::size_t m_factors = 0, m_characteristics = 0;
    std::size_t m_bins = 0;  ///< of all characteristics
    std::size_t m_cells = 0; ///< of all rows
};

} // namespace

std::size_t batchMemory(const Project& project, int threads) {
    const Sizes sizes(project);
    const auto workers = static_cast<std::size_t>(std::max(threads, 1));
    // The heap need not give back what the threads gathered before the state is written.
    return program + workers * aThread + (workers + 1) * sizes.statistics() + growth * sizes.rows()
           + sizes.tree() + growth * sizes.text();
}

std::size_t mergeMemory(const Project& project) {
    const Sizes sizes(project);
    // The text and the tree of a shard, what it holds, the sum, and the report that is written.
    return program + growth * sizes.text() + sizes.tree() + 3 * (sizes.statistics() + sizes.rows());
}

} // namespace sparkout
