// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/project.h"

#include <optional>
#include <vector>

namespace sparkout {

/// The settings of a cycle that a refinement may change, and what they may be.
class RefineSpace {
public:
    /// Of a project with a grid.
    RefineSpace(const Project& project, Cycle cycle);

    struct Setting {
        std::size_t stage = 0;
        std::optional<double> Stage::*feed = nullptr; ///< not set: the stage's stock
        double low = 0, high = 0;
        double base = 0, step = 0; ///< base + k·step; 0: three significant digits
        [[nodiscard]] bool isStock() const { return feed == nullptr; }
        /// The step about a value.
        [[nodiscard]] double stepAt(double value) const;
        /// The nearest value that can be set.
        [[nodiscard]] double rounded(double value) const;
    };
    [[nodiscard]] const std::vector<Setting>& settings() const { return m_settings; }

    [[nodiscard]] std::vector<double> valuesOf(const Cycle& cycle) const;
    /// The cycle with these settings; its last stage has what stock remains. Nothing where that is
    /// too little or too much, or a feed rises that must not.
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

/// What stocks are rounded to [mm].
inline constexpr double refinedStock_mm = 1e-4;

} // namespace sparkout
