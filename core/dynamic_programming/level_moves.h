// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/state_grid.h"
#include "core/optimisation/cycle_runner.h"
#include "core/optimisation/stage_runs.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Moves between levels of stock, each simulated from the previous state.
class LevelMoves {
public:
    /// Requires a project with the search of a grid.
    LevelMoves(const Project& searched, StateGridSize size, const std::stop_token& stop);

    /// Returns the prefix of the blank, with no level reached.
    [[nodiscard]] CyclePrefix blank() const;
    struct Reached {
        StateMove move;                   ///< end `slower`: admissible by the limits of its passes
        std::optional<CyclePrefix> there; ///< prefix at its level, if reached
        std::optional<ConstraintKind>
            beyondSize; ///< move into the last level: requirement violated by a diameter
    };
    [[nodiscard]] Reached move(const CyclePrefix& from, std::size_t feed) const;

    /// Result of the whole cycle of a path, run with the project's stocks.
    struct Judged {
        bool completed = false;
        std::int64_t time_us = 0;
        double time_s = 0;
        double leastMargin = 0;
        std::optional<ConstraintKind> broken;
        [[nodiscard]] bool holds() const { return completed && !broken; }
    };
    [[nodiscard]] Judged judge(const std::vector<std::size_t>& path) const;
    [[nodiscard]] Cycle cycle(const std::vector<std::size_t>& path) const;

    [[nodiscard]] const Grid& grid() const { return m_grid; }
    [[nodiscard]] static int stagesOf(const std::vector<std::size_t>& path);

private:
    std::stop_token m_stop;
    Project m_project; ///< with one stage per level
    Grid m_grid;
    CycleRunner m_runner;
    StageRuns m_runs;
};

} // namespace sparkout
