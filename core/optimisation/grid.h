// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sparkout {

/// The number as one would write it, with ten decimals at most: 0.15 − 6·0.01 is 0.09.
[[nodiscard]] double asWritten(double value);

/// A setting of a stage's feeds in the grid.
struct FeedSetting {
    double radial = 0;           ///< traverse: per double stroke [mm]; plunge: [mm/min]
    double axialFeed_mm_min = 0; ///< traverse
};

/// A stage of a cycle of the grid.
struct GridStage {
    std::size_t setting = 0; ///< index of its feeds
    int steps = 0;           ///< stock in steps of the grid; of the last stage: what remains
    friend bool operator==(const GridStage&, const GridStage&) = default;
};
using GridCycle = std::vector<GridStage>;

/// Why a grid has no cycles.
enum class GridFault {
    none,
    notGiven,      ///< the project has no optimisation
    noLevels,      ///< a feed of its kind of grinding has no levels
    tooManyLevels, ///< more than mostSettings
    tooManySteps,  ///< of stock, more than mostStockSteps
    noDivision,    ///< of the stock into these numbers of stages, the last within its bounds
};
inline constexpr double mostSettings = 5000, mostStockSteps = 10'000;

/// The cycles that a project's optimisation asks for: every stage takes any listed feeds; stage
/// stocks are positive multiples of the stock step that sum to the part's, the last stage takes
/// the remainder, however small, in cycles of several stages within last_stock_mm; with
/// non_increasing neither feed rises from stage to stage.
///
/// Grid order: the numbers of stages as listed, then stage by stage from the first on the radial
/// feed, the axial feed and the stock, each as listed, stocks rising.
class Grid {
public:
    /// With a fault the grid is empty.
    explicit Grid(const Project& project);

    [[nodiscard]] GridFault fault() const { return m_fault; }
    [[nodiscard]] const std::vector<FeedSetting>& settings() const { return m_settings; }
    [[nodiscard]] const std::vector<std::size_t>& stageCounts() const { return m_stageCounts; }
    /// Steps of stock that all stages but the last share at most; each takes at least one.
    [[nodiscard]] int mostSteps() const { return m_steps; }
    /// Steps that the first of so many stages up to the last takes at least, behind `taken`.
    [[nodiscard]] int leastOf(std::size_t stagesLeft, int taken) const {
        return stagesLeft == 2 ? std::max(1, m_leastSteps - taken) : 1;
    }
    /// May a stage with the second setting follow one with the first?
    [[nodiscard]] bool mayFollow(std::size_t first, std::size_t second) const;
    /// Stock left [mm] when so many steps of it have been taken.
    [[nodiscard]] double remainder(int stepsTaken) const {
        return asWritten(m_stock_mm - stepsTaken * m_step_mm);
    }

    /// The number of cycles, 2^63 − 1 when there are more.
    [[nodiscard]] std::int64_t size() const;
    /// The cycles one after the other, in grid order; false after the last. Starts from an empty
    /// cycle.
    [[nodiscard]] bool next(GridCycle& cycle) const;
    /// Whether a comes before b.
    [[nodiscard]] bool before(const GridCycle& a, const GridCycle& b) const;
    /// The cycle as the project states cycles.
    [[nodiscard]] Cycle cycle(const GridCycle& cycle) const;

private:
    [[nodiscard]] GridFault read(const Project& project);
    [[nodiscard]] bool complete(GridCycle& cycle, std::size_t stages) const;
    [[nodiscard]] bool advance(GridCycle& cycle) const;

    Operation m_operation;
    double m_stock_mm, m_step_mm = 0;
    int m_steps = 0, m_leastSteps = 0;
    bool m_nonIncreasing = false;
    std::vector<FeedSetting> m_settings;
    std::vector<std::size_t> m_stageCounts;
    GridFault m_fault;
};

/// The levels one by one; a step that ends within a millionth of it at `to` reaches it.
[[nodiscard]] std::vector<double> levelValues(const Levels& levels);

} // namespace sparkout
