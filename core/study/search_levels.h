// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/cycle.h"
#include "core/project/operation.h"
#include "core/project/project.h"
#include "core/search/optimise.h"
#include "core/search/variants.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace sparkout {

/// A feed of a cycle that is the least or the greatest level of its grid.
struct LevelEdge {
    const StageFeed* feed = nullptr;
    std::size_t stage = 0; ///< counted from 0
    double level = 0;
    bool isMost = false;           ///< the greatest, otherwise the least
    std::optional<double> limit;   ///< limit of the machine or of the stage's own bounds
    bool isLimit = false;          ///< the level itself is the limit, which no grid exceeds
    bool isOfStage = false;        ///< the limit is that of the stage's own bounds
    std::optional<double> machine; ///< end of the machine's range, where it is given
};

/// Returns the edges that a cycle found by a search of this project reaches, by stage; a stage
/// without feed has none. A feed with one level was not searched and has none.
[[nodiscard]] std::vector<LevelEdge> edgesReached(const Project& searched, const Cycle& cycle);

/// A setting of the machine, or the spark-out, that is the least or the greatest level of its grid.
struct SettingEdge {
    const char* key = ""; ///< of its row in the search: "work_speed_rpm"
    double level = 0;
    bool isMost = false;         ///< the greatest, otherwise the least
    std::optional<double> limit; ///< limit of the machine's range or of the row
    bool isLimit = false;        ///< the level itself is the limit, which no grid exceeds
};

/// Returns the edges that a cycle found by a search of this project reaches with these machine
/// settings. A setting with at most one level was not searched and has none. Levels and limits of
/// the work speed are those that leastRatioDistance() allows.
[[nodiscard]] std::vector<SettingEdge>
settingEdgesReached(const Project& searched, const Cycle& cycle, const MachineSettings& machine);

/// A search whose levels follow its answer. After the answer of one grid, levels are added
///
/// * beyond it, where it is at the edge of the grid and the machine allows more: three, each
///   greater or smaller by the ratio of the last two, within the machine's range;
/// * on either side of each of its feeds, halfway to the next level (geometric mean), as long as
///   they are more than 5 % apart and the last levels between saved more than 0.5 % of the time, or
///   added more than 0.005 to the margin that is searched for.
///
/// All levels are steps of the machine. No level is removed, so each grid contains the earlier
/// ones, and a proof for the last grid holds for all.
class SearchLevels {
public:
    /// Takes a project with a grid; only with Optimisation::adaptive there is more than one round.
    explicit SearchLevels(Project project);

    /// Returns the project to be searched in this round.
    [[nodiscard]] const Project& searched() const { return m_searched; }
    [[nodiscard]] int round() const { return m_round; } ///< from 1
    /// Adds levels after the best cycle of this round and the values by which it is compared;
    /// returns whether there is another round.
    bool beginNextRound(const Cycle& best, const FeasibleCycle& found);

private:
    Project m_searched;
    int m_round = 1;
    std::optional<double> m_time_s, m_margin; ///< best values of the previous round
};

} // namespace sparkout
