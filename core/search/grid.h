// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace sparkout {

/// Rounds a number to ten decimals, as one would write it: 0.15 − 6·0.01 is 0.09.
[[nodiscard]] double asWritten(double value);

/// Returns the single levels; a step that ends within a millionth of its length at `to` reaches it.
[[nodiscard]] std::vector<double> levelValues(const Levels& levels);

/// Returns the number of levels without listing them.
[[nodiscard]] double levelCount(const Levels& levels);

/// Setting of a stage in the grid: its feeds or a spark-out.
struct StageSetting {
    double radial = 0;                ///< traverse: per double stroke [mm]; plunge: [mm/min]
    double axialFeed_mm_min = 0;      ///< traverse
    int sparkOut = 0;                 ///< > 0: number of steps without feed, in a last stage
    double continuousFeed_mm_min = 0; ///< traverse: > 0 replaces the radial feed, which is then 0
};

/// A stage of a cycle of the grid.
struct GridStage {
    std::size_t setting = 0;
    int steps = 0; ///< stock in steps of the grid; last stage: the remainder
    friend bool operator==(const GridStage&, const GridStage&) = default;
};
using GridCycle = std::vector<GridStage>;

/// Reason why a grid has no cycles.
enum class GridFault {
    none,
    notGiven,        ///< the project has no optimisation
    noLevels,        ///< a feed of the operation has no levels
    tooManyLevels,   ///< more than mostSettings
    tooManySteps,    ///< more than mostStockSteps steps of stock
    tooManyVariants, ///< more than mostVariants of the machine and the spark-out
    noDivision, ///< stock and feeds cannot be divided into these numbers of stages within their
                ///< bounds
    wholeRatio, ///< no work speed keeps n_k/n far enough from a whole number
};
inline constexpr double mostSettings = 5000, mostStockSteps = 10'000, mostVariants = 500;

/// Cycles that a project's optimisation allows with the current machine settings and the first of
/// its spark-out counts (see Variants). Every stage takes any listed feeds within its bounds: a
/// radial or a continuous one, and an axial one. Stage stocks are positive multiples of the stock
/// step that sum to the part's stock; the last stage takes the remainder, however small, which in
/// cycles of several stages lies within last_stock_mm. With non_increasing no feed rises from stage
/// to stage; a feed that a stage does not have counts as 0. A spark-out is an additional last stage
/// with any listed axial feed and a remainder that may be zero; then the stage before it takes the
/// rest of a step.
///
/// Grid order: numbers of stages as listed, then stage by stage from the first on: radial feed,
/// continuous feeds after all radial ones, axial feed and stock, feeds as listed and stocks rising.
class Grid {
public:
    /// A grid with a fault is empty.
    explicit Grid(const Project& project);

    [[nodiscard]] GridFault fault() const { return m_fault; }
    [[nodiscard]] const std::vector<StageSetting>& settings() const { return m_settings; }
    /// Numbers of stages, the spark-out included.
    [[nodiscard]] const std::vector<std::size_t>& stageCounts() const { return m_stageCounts; }
    [[nodiscard]] int sparkOut() const { return m_sparkOut; }
    /// Returns whether single stages have their own bounds.
    [[nodiscard]] bool hasStageBounds() const { return m_bounded; }
    /// Least and greatest number of stock steps taken by the end of stage z, which is not the last
    /// of `stages`, when `taken` were taken by the end of the stage before: the later stages can
    /// then share the rest.
    [[nodiscard]] int leastTaken(std::size_t stages, std::size_t z, int taken) const;
    [[nodiscard]] int mostTaken(std::size_t stages, std::size_t z, int taken) const;
    /// Greatest stock of a last stage [mm].
    [[nodiscard]] double mostLast_mm() const;
    /// Returns whether stage z of `stages` may have the setting, whatever the stages before it are.
    [[nodiscard]] bool mayHave(std::size_t stages, std::size_t z, std::size_t setting) const {
        return m_shapes[stages].allowed[z][setting] != 0;
    }
    /// Returns whether a stage with the second setting may follow one with the first.
    [[nodiscard]] bool mayFollow(std::size_t first, std::size_t second) const;
    /// Returns whether a stage with the setting may follow the stages begun.
    [[nodiscard]] bool mayExtend(const GridCycle& begun, std::size_t stages,
                                 std::size_t setting) const {
        return mayHave(stages, begun.size(), setting)
               && (begun.empty() || mayFollow(begun.back().setting, setting));
    }
    /// Stock left [mm] after this number of stock steps.
    [[nodiscard]] double remainder(int stepsTaken) const {
        return std::max(asWritten(m_stock_mm - stepsTaken * m_step_mm), 0.0);
    }

    /// Combines, for every setting, the values of all settings that may follow it, beginning with
    /// `first`; the result must not depend on their order. The time is proportional to the number
    /// of settings.
    template <class Value, class Combine>
    [[nodiscard]] std::vector<Value> overFollowers(const std::vector<Value>& each, Value first,
                                                   Combine combine) const;
    /// Returns this grid with another spark-out count, which is above 0 where this grid's is.
    [[nodiscard]] Grid withSparkOut(int count) const;

    /// Number of cycles, at most 2^63 − 1, counted without visiting them.
    [[nodiscard]] std::int64_t size() const;
    /// Advances to the next cycle in grid order, from an empty cycle to the first one; returns
    /// false after the last.
    [[nodiscard]] bool next(GridCycle& cycle) const;
    /// Returns the first cycle of this number of stages in which all feeding stages have one
    /// setting; empty if there is none.
    [[nodiscard]] GridCycle uniform(std::size_t stages, std::size_t setting) const;
    /// Returns whether a comes before b in grid order.
    [[nodiscard]] bool before(const GridCycle& a, const GridCycle& b) const;
    [[nodiscard]] bool contains(const GridCycle& cycle) const;
    /// Returns the cycle of the grid that a project's cycle is; nothing: the grid does not have it.
    [[nodiscard]] std::optional<GridCycle> find(const Cycle& stated) const;
    /// Converts a cycle of the grid to the form of a project.
    [[nodiscard]] Cycle cycle(const GridCycle& cycle) const;

private:
    /// Bounds of the cycles with one number of stages.
    struct Shape {
        std::vector<std::vector<char>> allowed; ///< by stage and setting
        std::vector<int> least, most;           ///< steps of each stage but the last
        std::vector<int> leastAfter, mostAfter; ///< steps of all later stages but the last
        int leastBefore = 0, mostBefore = 0;    ///< steps of all stages but the last
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
    int m_steps = 0; ///< steps of stock that the stages before the last may take together
    int m_sparkOut = 0;
    bool m_nonIncreasing = false, m_bounded = false;
    std::vector<StageSetting> m_settings;
    /// Ranks of the settings among their feeds. A setting has a radial feed, a continuous feed or
    /// none, so the ranks of continuous feeds follow those of radial feeds, the first of which is
    /// that of 0.
    std::vector<std::size_t> m_radialRanks, m_axialRanks;
    std::size_t m_radials = 0, m_axials = 0; ///< numbers of different feeds
    std::size_t m_infeeds = 0;               ///< radial and continuous feeds together
    std::vector<std::size_t> m_stageCounts;
    std::vector<Shape> m_shapes; ///< by number of stages
    GridFault m_fault;
};

// A setting may be followed by those that are not above it in any feed: sums over a corner of a
// table of infeed and axial feed, row by row and then column by column. Continuous feeds continue
// from the row of settings without either.
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
