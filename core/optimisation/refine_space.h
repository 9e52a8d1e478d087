// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

namespace sparkout {

/// Settings of a cycle that a refinement may change, and their ranges.
class RefineSpace {
public:
    /// The project must have a grid.
    RefineSpace(const Project& project, Cycle cycle);

    struct Setting {
        std::size_t stage = 0;
        std::optional<double> Stage::*feed = nullptr; ///< null: the stage's stock
        double low = 0, high = 0;
        double base = 0, step = 0; ///< base + k·step; 0: three significant digits
        [[nodiscard]] bool isStock() const { return feed == nullptr; }
        /// Returns the step at a value.
        [[nodiscard]] double stepAt(double value) const;
        /// Returns the nearest value that can be set.
        [[nodiscard]] double rounded(double value) const;
    };
    [[nodiscard]] const std::vector<Setting>& settings() const { return m_settings; }

    [[nodiscard]] std::vector<double> valuesOf(const Cycle& cycle) const;
    /// Returns the cycle with these settings; its last stage takes the remaining stock. Returns
    /// nullopt if that is too little or too much, or if a feed rises that must not.
    [[nodiscard]] std::optional<Cycle> cycleOf(const std::vector<double>& values) const;
    [[nodiscard]] std::vector<double> rounded(std::vector<double> values) const;

private:
    void addFeeds(const StageFeed& feed, const Optimisation& asked, const MachineLimits& limits);
    void addStocks(const Optimisation& asked);

    Operation m_operation;
    Cycle m_cycle;
    std::vector<Setting> m_settings;
    double m_stock_mm, m_leastLast_mm, m_mostLast_mm;
    bool m_nonIncreasing;
};

/// Step to which stocks are rounded [mm].
inline constexpr double refinedStock_mm = 1e-4;

} // namespace sparkout
