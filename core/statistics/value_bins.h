// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace sparkout {

inline constexpr std::size_t factorKinds = 16; ///< greatest number of factors of a batch

/// Ranks of a part's factors within their laws, from −2¹⁹ to 2¹⁹: whole numbers, so that their sums
/// are exact. Missing factors are 0 after the others.
using RankScores = std::array<std::int32_t, factorKinds>;
inline constexpr int rankScoreBits = 20;

/// A histogram with bins as narrow as their number allows, and the sums of the factors' ranks in
/// each.
///
/// The bins are ⌊x/(finest·2^level)⌋ for the least level at which no more than `most` are filled.
/// This depends on the values alone: any order and any grouping of them gives the same level and
/// counts, and memory does not grow with their number.
class ValueBins {
public:
    struct Bin {
        std::int64_t count = 0;
        std::array<std::int64_t, factorKinds> scores{};
        friend bool operator==(const Bin&, const Bin&) = default;
    };
    using Map = std::map<std::int64_t, Bin>;

    /// Bins of level 0 are a 2²⁰-th of a characteristic's resolution; values farther out than 2²⁰
    /// times the resolution are counted in the last bin of their side.
    static constexpr int levelOfResolution = 20;
    static constexpr int highestLevel = 41;

    /// The greatest number of filled bins for each of `characteristics`, limited by their total
    /// memory.
    static std::size_t mostFor(std::size_t characteristics);

    void add(double value, double resolution, const RankScores& scores, std::size_t most);
    void add(const ValueBins& other, std::size_t most);

    [[nodiscard]] int level() const { return m_level; }
    [[nodiscard]] const Map& bins() const { return m_bins; }
    /// For a state that was read: the numbers of the bins must be in range.
    static ValueBins of(int level, Map bins);

    /// The values in bins at least as wide as those of a level.
    [[nodiscard]] ValueBins atLeast(int level) const;
    /// Bin width for a characteristic's resolution.
    [[nodiscard]] double width(double resolution) const;
    /// The outermost numbers of bins at a level.
    [[nodiscard]] static std::int64_t lowest(int level);
    [[nodiscard]] static std::int64_t highest(int level);

    friend bool operator==(const ValueBins&, const ValueBins&) = default;

private:
    void coarsen();

    int m_level = 0;
    Map m_bins;
};

} // namespace sparkout
