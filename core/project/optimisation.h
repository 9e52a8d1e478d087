// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

enum class OptimisationScenarios {
    nominal, ///< the nominal part
    stocks,  ///< every stock within one infeed
    corners, ///< also every corner of the batch
    batch    ///< also the parts of the batch
};
/// Whether the scenarios are those of the project's batch.
[[nodiscard]] constexpr bool areOfBatch(OptimisationScenarios scenarios) {
    return scenarios >= OptimisationScenarios::corners;
}

/// The criterion of the best cycle: least time, least cost, or most parts between dressings.
enum class SearchObjective { time, cost, wheel_life };

/// The cost of a part, in any currency: reported, and minimised if it is the objective.
struct Cost {
    double machine_per_h = 0;                   ///< hourly cost of machine and operator [1/h]
    double handling_s = 0;                      ///< loading and measuring, per part [s]
    double dressing_s = 0;                      ///< time of a dressing [s]
    double dressing_cost = 0;                   ///< wheel and diamond worn by a dressing
    std::optional<int> parts_between_dressings; ///< not given: see costPerPart()
};

/// The grid the optimiser searches.
struct Optimisation {
    std::vector<double> stages = {1, 2}; ///< numbers of stages tried
    double stock_step_mm = 0.01;         ///< [mm]
    std::optional<std::vector<double>>
        last_stock_mm; ///< least and greatest stock of the last of several stages [mm]
    bool non_increasing = false;
    SearchObjective objective = SearchObjective::time;
    bool adaptive = false; ///< levels are added around and beyond the answer
    /// Time within which the greatest margin is searched; not given: the least time is searched
    /// [min].
    std::optional<double> margin_within_min;
    OptimisationScenarios scenarios = OptimisationScenarios::nominal;
    /// Least distance of n_k/n from a whole number; not given: any ratio.
    std::optional<double> least_ratio_distance;
    Levels radial_feed_mm;     ///< traverse, per double stroke [mm]
    Levels axial_feed_mm_min;  ///< traverse [mm/min]
    Levels radial_feed_mm_min; ///< plunge [mm/min]
    /// Traverse, for stages without a radial feed; not given: no continuous feed [mm/min].
    Levels continuous_feed_mm_min;
    Levels work_speed_rpm; ///< n; not given: the machine's [rev/min]
    Levels dwell_entry_s;  ///< traverse; not given: the machine's [s]
    Levels dwell_exit_s;   ///< traverse; not given: the machine's [s]
    Levels unfed_steps;    ///< a spark-out's strokes or revolutions; 0: without this stage
    // Lower and upper bound of each stage, a row for each stage from the first.
    NumberRows stage_radial_feed_mm;         ///< [mm]
    NumberRows stage_axial_feed_mm_min;      ///< [mm/min]
    NumberRows stage_radial_feed_mm_min;     ///< plunge [mm/min]
    NumberRows stage_continuous_feed_mm_min; ///< [mm/min]
    NumberRows stage_stock_mm;               ///< [mm]
    std::optional<Cost> cost;                ///< not given: not reported
};

template <>
std::span<const Choice> choicesOf<OptimisationScenarios>();
template <>
std::span<const Choice> choicesOf<SearchObjective>();
template <>
const StructInfo& tableOf<Cost>();
template <>
const StructInfo& tableOf<Optimisation>();

} // namespace sparkout
