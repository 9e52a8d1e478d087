// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/levels.h"
#include "core/project/project.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sparkout {

/// A setting of a stage in the grid: its feeds, or that it sparks out.
struct StageSetting {
    double radial = 0;                ///< traverse: per double stroke [mm]; plunge: [mm/min]
    double axialFeed_mm_min = 0;      ///< traverse
    int sparkOut = 0;                 ///< > 0: so many steps without feed, as a last stage
    double continuousFeed_mm_min = 0; ///< traverse: > 0 in the place of the radial feed, which is 0
};

/// A stage of a cycle of the grid.
struct GridStage {
    std::size_t setting = 0;
    int steps = 0; ///< stock in steps of the grid; of the last stage: what remains
    friend bool operator==(const GridStage&, const GridStage&) = default;
};
using GridCycle = std::vector<GridStage>;

/// Why a grid has no cycles.
enum class GridFault {
    none,
    notGiven,        ///< the project has no optimisation
    noLevels,        ///< a feed of its kind of grinding has no levels
    tooManyLevels,   ///< more than mostSettings
    tooManySteps,    ///< of stock, more than mostStockSteps
    tooManyVariants, ///< of the machine and the spark-out, more than mostVariants
    noDivision,      ///< of stock and feeds into these numbers of stages, within their bounds
};
inline constexpr double mostSettings = 5000, mostStockSteps = 10'000, mostVariants = 500;

/// The cycles that a project's optimisation asks for with the machine as it is set and the first
/// of its counts of spark-outs (see Variants): every stage takes any listed feeds within the
/// stage's bounds, a radial or a continuous one and an axial one; stage stocks are positive
/// multiples of the stock step that sum to the part's, the last stage takes the remainder, however
/// small, in cycles of several stages within last_stock_mm; with non_increasing no feed rises from
/// stage to stage, where one that a stage does not have is 0. A spark-out is one stage more, the
/// last: any listed axial feed, and a remainder that may be nothing; then the stage before it takes
/// what is left of a step.
///
/// Grid order: the numbers of stages as listed, then stage by stage from the first on the radial
/// feed, behind all of them the continuous feed, the axial feed and the stock, each as listed,
/// stocks rising.
class Grid {
public:
    /// With a fault the grid is empty.
    explicit Grid(const Project& project);

    [[nodiscard]] GridFault fault() const { return m_fault; }
    [[nodiscard]] const std::vector<StageSetting>& settings() const { return m_settings; }
    /// Numbers of stages, with the one that sparks out.
    [[nodiscard]] const std::vector<std::size_t>& stageCounts() const { return m_stageCounts; }
    [[nodiscard]] int sparkOut() const { return m_sparkOut; }
    /// Are stages bounded one by one?
    [[nodiscard]] bool hasStageBounds() const { return m_bounded; }
    /// Steps of stock behind stage z of so many, but the last, when `taken` are behind the one
    /// before: at least and at most, so that the stages to come can share the rest.
    [[nodiscard]] int leastTaken(std::size_t stages, std::size_t z, int taken) const;
    [[nodiscard]] int mostTaken(std::size_t stages, std::size_t z, int taken) const;
    /// The most stock that a last stage may have [mm].
    [[nodiscard]] double mostLast_mm() const;
    /// May stage z of so many have the setting, for all that the stages before it leave open?
    [[nodiscard]] bool mayHave(std::size_t stages, std::size_t z, std::size_t setting) const {
        return m_shapes[stages].allowed[z][setting] != 0;
    }
    /// May a stage with the second setting follow one with the first?
    [[nodiscard]] bool mayFollow(std::size_t first, std::size_t second) const;
    /// May the setting be the next of these stages?
    [[nodiscard]] bool mayGoOn(const GridCycle& begun, std::size_t stages,
                               std::size_t setting) const {
        return mayHave(stages, begun.size(), setting)
               && (begun.empty() || mayFollow(begun.back().setting, setting));
    }
    /// Stock left [mm] when so many steps of it have been taken.
    [[nodiscard]] double remainder(int stepsTaken) const {
        return std::max(asWritten(m_stock_mm - stepsTaken * m_step_mm), 0.0);
    }

    /// Of every setting: what the function makes of the values of all settings that may follow it,
    /// from a first value on; it must not mind their order. In time proportional to the settings.
    template <class Value, class Combine>
    [[nodiscard]] std::vector<Value> overFollowers(const std::vector<Value>& each, Value first,
                                                   Combine combine) const;
    /// The same grid with another count of spark-outs, above 0 where this one has one.
    [[nodiscard]] Grid withSparkOut(int count) const;

    /// The number of cycles, 2^63 − 1 when there are more. None is looked at.
    [[nodiscard]] std::int64_t size() const;
    /// The cycles one after the other, in grid order; false after the last. Starts from an empty
    /// cycle.
    [[nodiscard]] bool next(GridCycle& cycle) const;
    /// The first cycle of so many stages with one setting in all that feed; empty: none.
    [[nodiscard]] GridCycle uniform(std::size_t stages, std::size_t setting) const;
    /// Whether a comes before b.
    [[nodiscard]] bool before(const GridCycle& a, const GridCycle& b) const;
    [[nodiscard]] bool contains(const GridCycle& cycle) const;
    /// The cycle as the project states cycles.
    [[nodiscard]] Cycle cycle(const GridCycle& cycle) const;

private:
    /// What the cycles of one number of stages may be.
    struct Shape {
        std::vector<std::vector<char>> allowed; ///< by stage and setting
        std::vector<int> least, most;           ///< steps of each stage but the last
        std::vector<int> leastAfter, mostAfter; ///< of all behind it, but the last
        int leastBefore = 0, mostBefore = 0;    ///< of all but the last
    };

    [[nodiscard]] GridFault read(const Project& project);
    void readSettings(const Optimisation& asked);
    [[nodiscard]] bool readShape(const Optimisation& asked, std::size_t stages);
    void readStocks(const Optimisation& asked, Shape& shape) const;
    [[nodiscard]] bool readFeeds(const Optimisation& asked, Shape& shape) const;
    void complete(GridCycle& cycle, std::size_t stages) const;
    [[nodiscard]] bool advance(GridCycle& cycle) const;
    [[nodiscard]] long double splits(const Shape& shape) const;
    void rankSettings();

    Operation m_operation;
    double m_stock_mm, m_step_mm = 0;
    int m_steps = 0; ///< that the stages before the last may take together
    int m_sparkOut = 0;
    bool m_nonIncreasing = false, m_bounded = false;
    std::vector<StageSetting> m_settings;
    /// Of settings among their feeds. A setting has a radial or a continuous feed or none, so that
    /// the latter follow the former's ranks, whose first is then that of 0.
    std::vector<std::size_t> m_radialRanks, m_axialRanks;
    std::size_t m_radials = 0, m_axials = 0; ///< different feeds
    std::size_t m_infeeds = 0;               ///< with the continuous ones
    std::vector<std::size_t> m_stageCounts;
    std::vector<Shape> m_shapes; ///< by number of stages
    GridFault m_fault;
};

// A setting may be followed by those that are not above it in any feed: sums over a corner of a
// table of infeed and axial feed, row by row and then column by column. Continuous feeds go on from
// the row of those that have neither.
template <class Value, class Combine>
std::vector<Value> Grid::overFollowers(const std::vector<Value>& each, Value first,
                                       Combine combine) const {
    if (!m_nonIncreasing) {
        Value all = first;
        for (const Value& value : each) {
            all = combine(all, value);
        }
        return std::vector<Value>(m_settings.size(), all);
    }
    std::vector<Value> table(m_infeeds * m_axials, first);
    const auto place = [this](std::size_t s) {
        return m_radialRanks[s] * m_axials + m_axialRanks[s];
    };
    for (std::size_t s = 0; s < m_settings.size(); ++s) {
        table[place(s)] = combine(table[place(s)], each[s]);
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = i % m_axials > 0 ? combine(table[i], table[i - 1]) : table[i];
    }
    for (std::size_t i = m_axials; i < table.size(); ++i) {
        const std::size_t row = i / m_axials, below = row == m_radials ? 0 : row - 1;
        table[i] = combine(table[i], table[below * m_axials + i % m_axials]);
    }
    std::vector<Value> over;
    over.reserve(m_settings.size());
    for (std::size_t s = 0; s < m_settings.size(); ++s) {
        over.push_back(table[place(s)]);
    }
    return over;
}

} // namespace sparkout
