// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search_outputs.h"

#include "core/file/output_json.h"
#include "core/file/project_file.h"
#include "core/project/optimisation.h"
#include "core/search/grid.h"
#include "core/search/optimise.h"
#include "core/setup/dressing_interval.h"
#include "core/text.h"
#include "core/units.h"

namespace sparkout {

namespace {

using Found = SearchOutcome;
using nlohmann::ordered_json;

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
      .label = SPARKOUT_NOOP("Output", "Minimum margin of all requirements, relative to its limit"),
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
      .label = SPARKOUT_NOOP("Output", "Excess over the stepless limit"),
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
    {{.key = "scenarios_added", .label = SPARKOUT_NOOP("Output", "Scenarios added")},
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
      .label = SPARKOUT_NOOP("Output", "Time of the quickest cycle for the part alone"),
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

ordered_json cycleJson(const SearchOutcome& outcome, const FoundCycle& found) {
    Project best = outcome.project;
    best.runs.clear();
    *best.cycle = found.cycle;
    return ordered_json::parse(writeProject(best))["cycle"];
}

ordered_json machineJson(const SearchOutcome& outcome, const FoundCycle& found) {
    ordered_json settings = ordered_json::object();
    for (const FreeSetting& each : freeSettings(outcome.project, found.machine)) {
        settings[each.key] = each.value;
    }
    return settings;
}

ordered_json keysJson(const std::vector<ConstraintKind>& kinds) {
    ordered_json keys = ordered_json::array();
    for (const ConstraintKind kind : kinds) {
        keys.push_back(requirementOf(kind).key);
    }
    return keys;
}

/// Null if not searched, or if the wheel does not wear.
ordered_json dressingJson(const SearchOutcome& outcome) {
    if (!outcome.interval || !outcome.interval->held) {
        return nullptr;
    }
    const PartsHeld& held = *outcome.interval->held;
    return {{"parts", held.parts},
            {"endless", held.isEndless},
            {"at_least", held.isAll && !held.isEndless},
            {"mean_time_min", inMinutes(held.meanTime_s)},
            {"ends_by", held.end ? ordered_json(requirementOf(*held.end).key) : nullptr}};
}

ordered_json levelsJson(const SearchOutcome& outcome) {
    ordered_json levels = ordered_json::object();
    for (const StageFeed& feed : outcome.searched.operation->feeds) {
        levels[feed.key] = levelValues((*outcome.searched.optimisation).*feed.levels);
    }
    const StageFeed* const continuous = outcome.searched.operation->continuous;
    if (continuous && levelCount((*outcome.searched.optimisation).*continuous->levels) > 0) {
        levels[continuous->key] = levelValues((*outcome.searched.optimisation).*continuous->levels);
    }
    return levels;
}

ordered_json edgesJson(const SearchOutcome& outcome) {
    ordered_json edges = ordered_json::array();
    for (const LevelEdge& edge : outcome.edges) {
        edges.push_back({{"feed", edge.feed->key},
                         {"stage", edge.stage + 1},
                         {"side", edge.isMost ? "greatest" : "least"},
                         {"level", edge.level},
                         {"allowed", edge.limit ? ordered_json(*edge.limit) : ordered_json(0)},
                         {"is_allowed_end", edge.isLimit}});
    }
    return edges;
}

ordered_json settingEdgesJson(const SearchOutcome& outcome) {
    ordered_json edges = ordered_json::array();
    for (const SettingEdge& edge : outcome.settingEdges) {
        edges.push_back({{"setting", edge.key},
                         {"side", edge.isMost ? "greatest" : "least"},
                         {"level", edge.level},
                         {"allowed", jsonOrNull(edge.limit)},
                         {"is_allowed_end", edge.isLimit}});
    }
    return edges;
}

/// The requirements that the answer just meets, and the inputs on which its simulation would
/// remark.
ordered_json remarksJson(const SearchOutcome& outcome) {
    ordered_json paths = ordered_json::array();
    for (const Issue& issue : outcome.remarks.issues) {
        paths.push_back(issue.path);
    }
    return {{"no_margin", keysJson(outcome.remarks.noMargin)},
            {"inputs", std::move(paths)},
            {"rotation_ratio_near_integer", jsonOrNull(outcome.remarks.ratioNearInteger)}};
}

ordered_json limitBoundsJson(const SteplessLimit& limit) {
    ordered_json bounds = ordered_json::array();
    for (const LimitPiece& piece : limit.pieces) {
        bounds.push_back({{"from_mm", piece.from_mm},
                          {"to_mm", piece.to_mm},
                          {"bound", limitBoundKey(piece.bound, piece.kind)},
                          {"cut_mm", piece.cut_mm},
                          {"time_min", inMinutes(piece.time_s)}});
    }
    return bounds;
}

/// Null without a known limit.
ordered_json limitCyclesJson(const SteplessLimit& limit) {
    if (!isKnownLimit(limit.time_s)) {
        return nullptr;
    }
    return {{"continuous_feed_mm_min", limit.cycles.continuousFeed_mm_min},
            {"draw_back", limit.cycles.drawBack},
            {"spark_out_by_count", limit.cycles.sparkOut}};
}

ordered_json givenJson(const SearchOutcome& outcome) {
    const GivenCycle& given = outcome.given;
    return {{"cycle_time_min",
             given.time_s ? ordered_json(inMinutes(*given.time_s)) : ordered_json(nullptr)},
            {"cost_per_part", given.time_s ? jsonOrNull(costPerPart(outcome.project, *given.time_s))
                                           : ordered_json(nullptr)},
            {"fails", given.isStopped ? ordered_json(nullptr) : keysJson(given.fails)}};
}

ordered_json freshPhasesJson(const SearchOutcome& outcome) {
    const RobustSummary& robust = *outcome.robust;
    const int phases = robust.freshPhases; // 0: no answer was tried
    const int candidate = outcome.refined() ? outcome.refined()->candidate : robust.candidate;
    return {{"tried", phases},
            {"failed", 0},
            {"candidate", phases > 0 ? ordered_json(candidate) : ordered_json(nullptr)},
            {"failing_share_at_most",
             phases > 0 ? ordered_json(mostFailing(phases, candidate)) : ordered_json(nullptr)},
            {"confidence", 0.95},
            {"cycles_that_failed", robust.freshFailures}};
}

/// For a batch whose corners were searched; null if no answer was tried on any.
ordered_json freshPartsJson(const SearchOutcome& outcome) {
    const auto share = outcome.mostPartsBad();
    if (!share) {
        return nullptr;
    }
    const FreshParts& parts = outcome.answer()->freshParts;
    return {{"tried", parts.tried},
            {"bad", 0},
            {"candidate", std::max(outcome.answer()->candidate, 1)},
            {"bad_share_at_most", *share},
            {"ppk_at_least", jsonOrNull(parts.ppk)},
            {"is_capable", parts.isCapable},
            {"cycles_not_capable", outcome.robust->incapable},
            {"confidence", 0.95}};
}

/// The cycles for which no other is both quicker and farther from its limits.
ordered_json frontJson(const SearchOutcome& outcome) {
    ordered_json front = ordered_json::array();
    for (const FoundCycle* each : outcome.front()) {
        front.push_back({{"cycle_time_min", inMinutes(each->time_s)},
                         {"least_relative_margin", each->leastRelativeMargin},
                         {"cycle", cycleJson(outcome, *each)},
                         {"machine", machineJson(outcome, *each)}});
    }
    return front;
}

ordered_json numbersJson(const SearchOutcome& outcome) {
    ordered_json numbers = ordered_json::array();
    for (const SearchedNumber& each : outcome.numbers) {
        numbers.push_back({{"stages", each.stages},
                           {"status", searchStatusName(each.status)},
                           {"cycle_time_min", each.best_s ? ordered_json(inMinutes(*each.best_s))
                                                          : ordered_json(nullptr)},
                           {"bound_time_min", inMinutes(each.bound_s)}});
    }
    return numbers;
}

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

std::string searchJson(const SearchOutcome& outcome) {
    ordered_json root = outputsJson(searchOutputs(), outcome);
    root["cycle"] = nullptr;
    if (const FoundCycle* answer = outcome.answer()) {
        root["cycle"] = cycleJson(outcome, *answer);
        if (ordered_json machine = machineJson(outcome, *answer); !machine.empty()) {
            root["machine"] = std::move(machine);
        }
    }
    root["dressing"] = dressingJson(outcome);
    root["limit_cycles"] = limitCyclesJson(outcome.limit);
    root["limit_bounds"] = limitBoundsJson(outcome.limit);
    root["binding"] = outcome.binding ? keysJson(*outcome.binding) : ordered_json(nullptr);
    if (outcome.refinement) {
        root["refined"] = {{"is_quicker", outcome.refinement->isQuicker},
                           {"grid_status", searchStatusName(outcome.search.status)},
                           {"grid_time_min", inMinutes(outcome.search.best->time_s)},
                           {"grid_bound_time_min", inMinutes(outcome.search.bound_s)},
                           {"cycles_run", outcome.refinement->runs}};
    }
    root["levels"] = levelsJson(outcome);
    root["edges"] = edgesJson(outcome);
    root["setting_edges"] = settingEdgesJson(outcome);
    root["not_decided"] = outputsJsonOfEach(undecidedOutputs(), outcome.remarks.notDecided);
    if (leastRatioDistance(outcome.searched)) {
        root["left_out_work_speeds_rpm"] = searchedSpeeds(outcome.searched).leftOut;
    }
    root["remarks"] = remarksJson(outcome);
    ordered_json& cuts = root["cut_by"] = ordered_json::object();
    for (const auto& [kind, count] : outcome.cuts()) {
        cuts[requirementOf(kind).key] = count;
    }
    root["given"] = givenJson(outcome);
    if (outcome.robust) {
        root["fresh_phases"] = freshPhasesJson(outcome);
        root["fresh_parts"] = freshPartsJson(outcome);
        const FoundCycle* const answer = outcome.answer();
        root["decided_corners"] =
            answer && answer->decided ? ordered_json(answer->decided->corners) : nullptr;
    }
    if (outcome.wishesFront) {
        root["by_stages"] = numbersJson(outcome);
        root["front"] = frontJson(outcome);
        root["front_is_whole"] = outcome.isFrontWhole;
    }
    return root.dump(2) + '\n';
}

} // namespace sparkout
