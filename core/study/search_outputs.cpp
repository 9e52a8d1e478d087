// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search_outputs.h"

#include "core/dressing/dressing_interval.h"
#include "core/optimisation/levels.h"
#include "core/optimisation/search_names.h"
#include "core/project/optimisation.h"
#include "core/text.h"
#include "core/units.h"

namespace sparkout {

namespace {

using Found = SearchOutcome;

double inMinutes(double time_s) {
    return time_s / units::secondsPerMinute;
}

bool isRobust(const Found& f) {
    return f.robust.has_value();
}

const char* aimKey(const Found& f) {
    if (f.marginWithin_us) {
        return "greatest_margin";
    }
    switch (f.objective()) {
    case SearchObjective::time: break;
    case SearchObjective::cost: return "least_cost";
    case SearchObjective::wheel_life: return "longest_wheel_life";
    }
    return "least_time";
}

/// The answer's cases, if it was decided.
std::optional<PhaseCases> decidedBy(const Found& f) {
    return f.answer() ? f.answer()->decided : std::nullopt;
}

constexpr Output<Found> searchRows[] = {
    {{.key = "status", .hint = "proved, found, stopped, infeasible or not_found"},
     [](const Found& f) {
         return std::string(searchStatusName(f.refined() ? SearchStatus::found : f.search.status));
     }},
    {{.key = "method"}, [](const Found& f) { return std::string(searchMethodName(f.method)); }},
    {{.key = "heuristic"}, [](const Found& f) { return isHeuristic(f.method); }},
    {{.key = "aim"}, [](const Found& f) { return std::string(aimKey(f)); }},
    {{.key = "margin_within_min"},
     [](const Found& f) {
         return f.marginWithin_us ? f.project.optimisation->margin_within_min : std::nullopt;
     }},
    {{.key = "cycle_time_min",
      .label = SPARKOUT_NOOP("Output", "Time of the cycle found"),
      .unit = "min"},
     [](const Found& f) {
         return f.answer() ? std::optional(inMinutes(f.answer()->time_s)) : std::nullopt;
     }},
    {{.key = "least_relative_margin",
      .label = SPARKOUT_NOOP("Output", "Minimum margin of all requirements, of its limit"),
      .shownUnit = "%",
      .shownFactor = 100},
     [](const Found& f) {
         return f.answer() ? std::optional(f.answer()->leastRelativeMargin) : std::nullopt;
     }},
    {{.key = "cost_per_part",
      .label = SPARKOUT_NOOP("Output", "Cost of a part with its share of the dressing"),
      .sparse = true},
     costOfAnswer},
    {{.key = "limit_time_min", .label = SPARKOUT_NOOP("Output", "Stepless limit"), .unit = "min"},
     [](const Found& f) {
         return isKnownLimit(f.limit.time_s) ? std::optional(inMinutes(f.limit.time_s))
                                             : std::nullopt;
     }},
    {{.key = "gap",
      .label = SPARKOUT_NOOP("Output", "Gap to the stepless limit"),
      .shownUnit = "%",
      .shownFactor = 100},
     [](const Found& f) {
         return f.answer() ? gapToLimit(f.answer()->time_s, f.limit.time_s) : std::nullopt;
     }},
    {{.key = "limit_by"}, [](const Found& f) { return std::string(limitByKey(f.limit.by)); }},
    {{.key = "bound_time_min",
      .label = SPARKOUT_NOOP("Output", "No cycle of the grid is quicker than"),
      .unit = "min"},
     [](const Found& f) { // off the grid only the limit is proved
         return inMinutes(f.refinement ? f.limit.time_s : f.search.bound_s);
     }},
    {{.key = "grid_size", .label = SPARKOUT_NOOP("Output", "Cycles in the grid")},
     [](const Found& f) { return f.search.gridSize; }},
    {{.key = "level_rounds", .label = SPARKOUT_NOOP("Output", "Rounds of levels")},
     [](const Found& f) { return std::int64_t(f.rounds); }},
    {{.key = "evaluations", .label = SPARKOUT_NOOP("Output", "Cycles judged")},
     [](const Found& f) { return std::int64_t(f.evaluations()); }},
    {{.key = "visits", .label = SPARKOUT_NOOP("Output", "Radii under the wheel in all runs")},
     [](const Found& f) { return std::int64_t(f.visits()); }},
    {{.key = "scenarios_added", .label = SPARKOUT_NOOP("Output", "Scenarios added to hold in")},
     [](const Found& f) {
         return f.robust ? std::int64_t(f.robust->added.size()) : std::int64_t{0};
     }},
    {{.key = "rounds", .detail = true},
     [](const Found& f) { return f.robust ? std::int64_t(f.robust->rounds) : std::int64_t{0}; },
     nullptr,
     isRobust},
    {{.key = "holds_in_sample", .detail = true},
     [](const Found& f) {
         return f.robust ? std::optional(f.robust->holdsInSample) : std::nullopt;
     },
     nullptr,
     isRobust},
    {{.key = "decided_stock_mm", .detail = true},
     [](const Found& f) {
         const auto cases = decidedBy(f);
         return cases ? std::optional(Interval{cases->stocks.from_mm, cases->stocks.to_mm})
                      : std::nullopt;
     },
     nullptr,
     isRobust},
    {{.key = "nominal_time_min",
      .label = SPARKOUT_NOOP("Output", "Time of the quickest for the part alone"),
      .unit = "min",
      .sparse = true},
     [](const Found& f) {
         return f.robust && f.robust->nominalTime_s > 0
                    ? std::optional(inMinutes(f.robust->nominalTime_s))
                    : std::nullopt;
     },
     nullptr,
     isRobust},
};

} // namespace

std::span<const Output<SearchOutcome>> searchOutputs() {
    return searchRows;
}

std::optional<double> costOfAnswer(const SearchOutcome& outcome) {
    if (!outcome.answer()) {
        return std::nullopt;
    }
    return outcome.interval ? outcome.interval->cost
                            : costPerPart(outcome.project, outcome.answer()->time_s);
}

std::vector<FreeSetting> freeSettings(const Project& searched, const MachineSettings& found) {
    const Optimisation& asked = *searched.optimisation;
    std::vector<FreeSetting> settings;
    const auto add = [&settings](const Levels& levels, const FreeSetting& setting) {
        if (levelCount(levels) > 0) {
            settings.push_back(setting);
        }
    };
    add(asked.work_speed_rpm, {"work_speed_rpm", found.work_speed_rpm});
    if (searched.operation->travels) {
        add(asked.dwell_entry_s, {"dwell_entry_s", found.dwell_entry_s});
        add(asked.dwell_exit_s, {"dwell_exit_s", found.dwell_exit_s});
    }
    return settings;
}

} // namespace sparkout
