// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_optimise_report.h"

#include "app/io/cli_report.h"
#include "core/dressing/part_cost.h"
#include "core/format/project_file.h"
#include "core/optimisation/levels.h"
#include "core/optimisation/limit.h"
#include "core/optimisation/search_names.h"
#include "core/project/cycle.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/units.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

double minutes(double time_s) {
    return time_s / units::secondsPerMinute;
}

/// What cut, the most frequent first.
std::vector<std::pair<long long, const char*>> cutsOf(const SearchSummary& search) {
    std::vector<std::pair<long long, const char*>> cuts;
    for (const Requirement& row : requirementRows) {
        if (const long long count = search.cuts[static_cast<std::size_t>(row.kind)]) {
            cuts.emplace_back(count, row.key);
        }
    }
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    return cuts;
}

ordered_json cycleJson(const GridSearchReport& report) {
    Project best = report.project;
    best.runs.clear();
    *best.cycle = cycleFound(report);
    return ordered_json::parse(writeProject(best))["cycle"];
}

std::string joined(const std::vector<const char*>& names) {
    std::string text;
    for (const char* name : names) {
        text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
}

std::vector<const char*> namesOf(const std::vector<ConstraintKind>& kinds) {
    std::vector<const char*> names;
    for (const ConstraintKind kind : kinds) {
        names.push_back(requirementOf(kind).key);
    }
    return names;
}

/// Null: not known.
ordered_json bindingJson(const GridSearchReport& report) {
    return report.binding ? ordered_json(namesOf(*report.binding)) : ordered_json(nullptr);
}

std::string bindingText(const GridSearchReport& report) {
    if (!report.binding) {
        return report.marginWithin_us
                   ? "not known: stopped before"
                   : "not known: stopped before the quicker cycles about it were run";
    }
    if (report.marginWithin_us) {
        return joined(namesOf(*report.binding)) + ": what has the minimum margin";
    }
    if (!report.binding->empty()) {
        return joined(namesOf(*report.binding)) + " in quicker cycles that differ in one setting";
    }
    if (isRefined(report)) {
        return "nothing: no cycle some steps off it is quicker";
    }
    return report.search.status == SearchStatus::proved
               ? "nothing: no cycle that differs in one setting is quicker"
               : "nothing known: a cycle that differs in one setting may be quicker and hold";
}

std::string stageLine(const Operation& operation, const Stage& stage, std::size_t number) {
    std::string feeds;
    if (const auto steps = stage.sparkOutSteps()) {
        feeds = "spark-out, " + std::to_string(*steps)
                + (operation->countsStrokes ? " double strokes" : " revolutions");
    } else {
        const double radial = *(stage.*operation->radial().value);
        feeds = operation->perMinute ? fixed(radial, 3) + " mm/min"
                                     : fixed(radial, 4) + " mm per double stroke";
    }
    if (const StageFeed* axial = operation->axial()) {
        feeds += ", " + fixed(*(stage.*axial->value), 0) + " mm/min axial";
    }
    return "  stage " + std::to_string(number) + "            " + feeds + "; stock "
           + fixed(stage.stock_mm, 4) + " mm\n";
}

/// The settings of the machine that were free to choose: key, value, words and unit.
struct FreeSetting {
    const char* key;
    double value;
    const char* words;
    const char* unit;
};
std::vector<FreeSetting> freeSettings(const GridSearchReport& report) {
    const Optimisation& asked = *report.project.optimisation;
    const MachineSettings& found = report.search.machine;
    std::vector<FreeSetting> settings;
    const auto add = [&settings](const Levels& levels, const FreeSetting& setting) {
        if (levelCount(levels) > 0) {
            settings.push_back(setting);
        }
    };
    add(asked.work_speed_rpm, {"work_speed_rpm", found.work_speed_rpm, "work speed ", " rev/min"});
    if (report.project.operation->travels) {
        add(asked.dwell_entry_s, {"dwell_entry_s", found.dwell_entry_s, "entry dwell ", " s"});
        add(asked.dwell_exit_s, {"dwell_exit_s", found.dwell_exit_s, "exit dwell ", " s"});
    }
    return settings;
}

/// Of the answer, with the parts between dressings that it holds for or that the file states.
std::optional<double> costOf(const GridSearchReport& report, double best_s) {
    return report.interval ? report.interval->cost : costPerPart(report.project, best_s);
}

std::string costText(const GridSearchReport& report, double best_s) {
    const auto cost = costOf(report, best_s);
    if (!cost) {
        return "";
    }
    const auto held = report.interval ? report.interval->held : std::nullopt;
    const auto parts = held ? std::optional(held->parts) : partsBetweenDressings(report.project);
    const bool isDressed = parts && !(held && held->isEndless);
    return "cost per part        " + fixed(*cost, 4)
           + (isDressed ? ", dressed after " + std::to_string(*parts) + " parts\n"
                        : ", without dressing\n");
}

ordered_json costJson(const std::optional<double>& cost) {
    return cost ? ordered_json(*cost) : ordered_json(nullptr);
}

/// The parts between dressings that the answer holds for.
std::string heldText(const GridSearchReport& report) {
    if (!report.interval) {
        return "";
    }
    const std::optional<PartsHeld>& held = report.interval->held;
    if (!held) {
        return "parts to a dressing  not searched: the file says nothing of how the wheel wears "
               "(/wear)\n";
    }
    if (held->isEndless) {
        return "parts to a dressing  any number: the wheel gets no duller, and every part holds\n";
    }
    std::string text = "parts to a dressing  " + std::to_string(held->parts);
    text += held->isAll ? ", no more were tried"
            : held->end ? "; the next one breaks " + std::string(requirementOf(*held->end).key)
                        : "; the next one does not reach size";
    return text + "; " + fixed(minutes(held->meanTime_s), 4) + " min each on average\n";
}

ordered_json dressingJson(const GridSearchReport& report) {
    if (!report.interval || !report.interval->held) {
        return nullptr;
    }
    const PartsHeld& held = *report.interval->held;
    return {{"parts", held.parts},
            {"endless", held.isEndless},
            {"at_least", held.isAll && !held.isEndless},
            {"mean_time_min", minutes(held.meanTime_s)},
            {"ends_by", held.end ? ordered_json(requirementOf(*held.end).key) : nullptr}};
}

const char* aimKey(const GridSearchReport& report) {
    if (report.marginWithin_us) {
        return "greatest_margin";
    }
    switch (objectiveOf(report.project)) {
    case SearchObjective::time: break;
    case SearchObjective::cost: return "least_cost";
    case SearchObjective::wheel_life: return "longest_wheel_life";
    }
    return "least_time";
}

std::string machineText(const GridSearchReport& report) {
    std::string text;
    for (const FreeSetting& each : freeSettings(report)) {
        text += (text.empty() ? "machine              " : ", ") + std::string(each.words)
                + numberText(each.value) + each.unit;
    }
    return text.empty() ? text : text + '\n';
}

double timeFound_s(const GridSearchReport& report) {
    return isRefined(report) ? report.refined->time_s : report.search.best->time_s;
}

double leastMargin(const GridSearchReport& report) {
    return isRefined(report) ? report.refined->leastRelativeMargin
                             : report.search.best->leastRelativeMargin;
}

std::string refinedText(const GridSearchReport& report) {
    const double grid_s = report.search.best->time_s;
    const std::string runs = "; " + std::to_string(report.refined->runs) + " cycles run\n";
    return isRefined(report)
               ? "refined              off the grid, "
                     + fixed(minutes(grid_s - timeFound_s(report)), 4) + " min less than its best, "
                     + fixed(minutes(grid_s), 4) + " min; not proved" + runs
               : "refined              nothing quicker was met off the grid" + runs;
}

std::string heuristicText(SearchMethod method) {
    return method == SearchMethod::published
               ? "dynamic programming as published, a heuristic (nothing is proved)"
               : "labels of time and deflection, a heuristic (nothing is proved)";
}

double within_min(const GridSearchReport& report) {
    return *report.project.optimisation->margin_within_min;
}

/// Of a search for the greatest margin.
std::string marginStatusText(const GridSearchReport& report) {
    const std::string within = "within " + numberText(within_min(report)) + " min";
    if (report.search.status == SearchStatus::stopped) {
        return "stopped: the maximum margin so far; a cycle of the grid " + within
               + " may have a larger one";
    }
    std::string text = "the maximum margin of the grid " + within;
    if (report.robust) {
        text += report.robust->decided ? ", over every stock stated below"
                                       : ", over the part and the stocks it was run on";
    }
    return text + ", proved";
}

/// Of a search over the parts between dressings.
std::string intervalStatusText(const GridSearchReport& report) {
    const bool isCost = objectiveOf(report.project) == SearchObjective::cost;
    if (report.search.status != SearchStatus::stopped) {
        return isCost ? "the cheapest of the grid for all parts of its interval, proved"
                      : "of the grid the most parts between dressings, proved";
    }
    const auto& bound = report.interval->bound;
    return std::string("stopped: the best so far")
           + (!bound   ? ""
              : isCost ? "; no part of the grid costs less than " + fixed(*bound, 4)
                       : "; none of the grid holds for more than " + fixed(*bound, 0) + " parts");
}

std::string statusText(const GridSearchReport& report) {
    const SearchSummary& search = report.search;
    if (report.interval && report.interval->held) {
        return intervalStatusText(report);
    }
    if (report.marginWithin_us) {
        return marginStatusText(report);
    }
    if (search.status == SearchStatus::proved) {
        if (report.robust && report.robust->decided) {
            return "the quickest of the grid that holds for the part, in the scenarios added and "
                   "for every stock stated below, proved";
        }
        return report.robust ? "the quickest of the grid that holds for the part and the stocks "
                               "added: proved for these, not for other phases of the stock"
                             : "the quickest of the grid, proved";
    }
    if (search.status == SearchStatus::found) {
        return "found by " + heuristicText(report.method)
               + ": it holds, but a quicker cycle may hold too";
    }
    if (isHeuristic(report.method)) {
        return "stopped: the best so far by " + heuristicText(report.method);
    }
    return "stopped: the best so far; none of the grid is quicker than "
           + fixed(minutes(search.bound_s), 4) + " min";
}

std::string gridText(std::int64_t size) {
    return size == std::numeric_limits<std::int64_t>::max() ? "more than 9e18"
                                                            : std::to_string(size);
}

std::string givenText(const GridSearchReport& report, double best_s) {
    const GivenCycle& given = report.given;
    if (given.isStopped) {
        return "the file's cycle     not known: stopped before it was run\n";
    }
    if (!given.time_s) {
        return "the file's cycle     does not end by itself\n";
    }
    const double saved = 1 - best_s / *given.time_s;
    return "the file's cycle     " + fixed(minutes(*given.time_s), 4) + " min, "
           + (given.fails.empty() ? "holds" : "fails: " + joined(namesOf(given.fails)))
           + "; the one found takes " + fixed(std::abs(saved) * 100, 1)
           + (saved < 0 ? " % longer\n" : " % less\n");
}

/// The number of the answer among the cycles that were tried on fresh phases.
int candidateOf(const GridSearchReport& report) {
    return isRefined(report) ? report.refined->candidate : report.robust->candidate;
}

/// The cases for each of which the answer was decided to hold.
std::optional<PhaseCases> decidedCases(const GridSearchReport& report) {
    if (!report.robust || !report.robust->decided) {
        return std::nullopt;
    }
    return phaseCases(withAnswer(report));
}

std::string robustText(const GridSearchReport& report, double best_s) {
    const RobustSummary& robust = *report.robust;
    const int candidate = candidateOf(report);
    const std::string cost =
        report.marginWithin_us
            ? "robustness           the margin is the least over all stocks it was run on; "
                  + std::to_string(robust.candidates) + " cycles were\n"
            : "robustness           " + std::to_string(robust.added.size()) + " stocks added in "
                  + std::to_string(robust.rounds) + " rounds; costs "
                  + fixed((best_s / robust.nominalTime_s - 1) * 100, 1) + " % of time\n";
    if (const auto decided = decidedCases(report)) {
        constexpr int digits = 6; // nm
        return cost + "decided              holds for every stock per side of "
               + fixed(decided->stocks.from_mm, digits) + "…" + fixed(decided->stocks.to_mm, digits)
               + " mm"
               + (decided->corners > 0 ? ", with the other inputs as they are and at each of the "
                                             + std::to_string(decided->corners)
                                             + " corners of the batch's other factors\n"
                                       : ", with the other inputs as they are\n");
    }
    return cost + "confidence           held in all of " + std::to_string(robust.freshPhases)
           + " phases of the stock drawn afresh, as cycle no. " + std::to_string(candidate)
           + " that was tried so: with 95 % confidence at most "
           + fixed(std::ceil(mostFailing(robust.freshPhases, candidate) * 1e4) / 1e2, 2)
           + " % of the phases fail\n";
}

/// Where the answer of the grid stands at its edge, and whether the levels followed it.
std::string levelsText(const GridSearchReport& report) {
    std::string text;
    if (report.rounds > 1) {
        text += "levels               added " + std::to_string(report.rounds - 1)
                + " times around the answer\n";
    }
    if (report.areLevelsCutShort) {
        text += "levels               stopped while further ones were searched; the answer is that "
                "of the grid before\n";
    }
    for (const LevelEdge& edge : report.edges) {
        text += "edge                 " + std::string(edge.feed->key) + " of stage "
                + std::to_string(edge.stage + 1) + " is the "
                + (edge.isMost ? "maximum" : "minimum") + " level, " + numberText(edge.level)
                + (edge.isLimit ? ": no more is allowed\n"
                   : edge.limit ? "; allowed is " + numberText(*edge.limit) + '\n'
                                : "; smaller ones are allowed\n");
    }
    return text;
}

ordered_json levelsJson(const GridSearchReport& report) {
    ordered_json levels = ordered_json::object();
    for (const StageFeed& feed : report.searched.operation->feeds) {
        levels[feed.key] = levelValues((*report.searched.optimisation).*feed.levels);
    }
    return levels;
}

ordered_json edgesJson(const GridSearchReport& report) {
    ordered_json edges = ordered_json::array();
    for (const LevelEdge& edge : report.edges) {
        edges.push_back({{"feed", edge.feed->key},
                         {"stage", edge.stage + 1},
                         {"side", edge.isMost ? "greatest" : "least"},
                         {"level", edge.level},
                         {"allowed", edge.limit ? ordered_json(*edge.limit) : ordered_json(0)},
                         {"is_allowed_end", edge.isLimit}});
    }
    return edges;
}

ordered_json limitBoundsJson(const SteplessLimit& limit) {
    ordered_json bounds = ordered_json::array();
    for (const LimitPiece& piece : limit.pieces) {
        bounds.push_back({{"from_mm", piece.from_mm},
                          {"to_mm", piece.to_mm},
                          {"bound", limitBoundKey(piece.bound, piece.kind)},
                          {"cut_mm", piece.cut_mm},
                          {"time_min", minutes(piece.time_s)}});
    }
    return bounds;
}

/// Of what cycles the limit is: none of these is quicker.
std::string limitCyclesText(const GridSearchReport& report) {
    const Operation& operation = report.project.operation;
    const LimitedCycles& cycles = report.limit.cycles;
    std::string text = "limit of cycles     ";
    if (operation->travels) {
        text += cycles.continuousFeed_mm_min > 0
                    ? " with a continuous infeed of up to "
                          + numberText(cycles.continuousFeed_mm_min) + " mm/min,"
                    : " without a continuous infeed,";
    }
    if (operation->mayRetract) {
        text += cycles.drawBack ? " that may draw the wheel head back,"
                                : " that never draw the wheel head back,";
    }
    return text
           + (cycles.sparkOut ? " ended at size or by a number of steps without feed\n"
                              : " ended at size\n");
}

/// Null: no limit is known.
ordered_json limitCyclesJson(const GridSearchReport& report) {
    if (!isKnownLimit(report.limit.time_s)) {
        return nullptr;
    }
    const LimitedCycles& cycles = report.limit.cycles;
    return {{"continuous_feed_mm_min", cycles.continuousFeed_mm_min},
            {"draw_back", cycles.drawBack},
            {"spark_out_by_count", cycles.sparkOut}};
}

/// Null: none is known, or no cycle holds.
ordered_json limitJson(double limit_s) {
    return isKnownLimit(limit_s) ? ordered_json(minutes(limit_s)) : ordered_json(nullptr);
}

std::string limitText(const GridSearchReport& report, double best_s) {
    const auto gap = gapToLimit(best_s, report.limit_s);
    return gap ? "stepless limit " + fixed(minutes(report.limit_s), 4) + " min, gap "
                     + fixed(*gap * 100, 1) + " %\n" + limitCyclesText(report)
               : std::string("stepless limit not known\n");
}

} // namespace

std::string optimiseText(const GridSearchReport& report) {
    const SearchSummary& search = report.search;
    const double best_s = timeFound_s(report);
    std::string text = "status               " + statusText(report)
                       + (isRefined(report) ? "; refined off the grid, not proved\n" : "\n");
    text +=
        "machining time       " + fixed(minutes(best_s), 4) + " min; " + limitText(report, best_s);
    const Cycle& cycle = cycleFound(report);
    for (std::size_t z = 0; z < cycle.stages.size(); ++z) {
        text += stageLine(report.project.operation, cycle.stages[z], z + 1);
    }
    text += machineText(report) + heldText(report) + costText(report, best_s);
    if (report.refined) {
        text += refinedText(report);
    }
    text += givenText(report, best_s);
    if (report.robust) {
        text += robustText(report, search.best->time_s);
    }
    text += "minimum margin       " + fixed(leastMargin(report) * 100, 1) + " %\n";
    text += "binding              " + bindingText(report) + '\n';
    text += levelsText(report);
    const long long judged = report.robust ? report.robust->evaluations : search.evaluations;
    const long long visits = report.robust ? report.robust->visits : search.visits;
    return text + "search               " + gridText(search.gridSize) + " cycles in the grid, "
           + std::to_string(judged) + " judged, " + std::to_string(visits)
           + " visits of a radius\n";
}

std::string optimiseJson(const GridSearchReport& report) {
    const SearchSummary& search = report.search;
    ordered_json root;
    root["status"] = searchStatusName(isRefined(report) ? SearchStatus::found : search.status);
    root["method"] = searchMethodName(report.method);
    root["heuristic"] = isHeuristic(report.method);
    root["aim"] = aimKey(report);
    root["margin_within_min"] =
        report.marginWithin_us ? ordered_json(within_min(report)) : ordered_json(nullptr);
    root["cycle"] = nullptr;
    root["cycle_time_min"] = nullptr;
    root["cost_per_part"] = nullptr;
    root["dressing"] = dressingJson(report);
    root["evaluations"] = report.robust ? report.robust->evaluations : search.evaluations;
    root["limit_time_min"] = limitJson(report.limit_s);
    root["limit_cycles"] = limitCyclesJson(report);
    root["limit_by"] = limitByKey(report.limit.by);
    root["limit_bounds"] = limitBoundsJson(report.limit);
    root["gap"] = nullptr;
    root["binding"] = bindingJson(report);
    root["scenarios_added"] = report.robust ? report.robust->added.size() : 0;
    if (search.best) {
        const double best_s = timeFound_s(report);
        root["cycle"] = cycleJson(report);
        for (const FreeSetting& each : freeSettings(report)) {
            root["machine"][each.key] = each.value;
        }
        root["cycle_time_min"] = minutes(best_s);
        root["cost_per_part"] = costJson(costOf(report, best_s));
        const auto gap = gapToLimit(best_s, report.limit_s);
        root["gap"] = gap ? ordered_json(*gap) : ordered_json(nullptr);
        root["least_relative_margin"] = leastMargin(report);
    }
    root["bound_time_min"] = minutes(search.bound_s);
    if (report.refined) { // off the grid only the limit is proved
        root["bound_time_min"] = minutes(report.limit_s);
        root["refined"] = {{"is_quicker", report.refined->isQuicker},
                           {"grid_status", searchStatusName(search.status)},
                           {"grid_time_min", minutes(search.best->time_s)},
                           {"grid_bound_time_min", minutes(search.bound_s)},
                           {"cycles_run", report.refined->runs}};
    }
    root["grid_size"] = search.gridSize;
    root["level_rounds"] = report.rounds;
    root["levels"] = levelsJson(report);
    root["edges"] = edgesJson(report);
    root["visits"] = report.robust ? report.robust->visits : search.visits;
    ordered_json cuts = ordered_json::object();
    for (const auto& [count, name] : cutsOf(search)) {
        cuts[name] = count;
    }
    root["cut_by"] = std::move(cuts);
    const GivenCycle& given = report.given;
    root["given"] = {
        {"cycle_time_min",
         given.time_s ? ordered_json(minutes(*given.time_s)) : ordered_json(nullptr)},
        {"cost_per_part", given.time_s ? costJson(costPerPart(report.project, *given.time_s))
                                       : ordered_json(nullptr)},
        {"fails", given.isStopped ? ordered_json(nullptr) : ordered_json(namesOf(given.fails))}};
    if (report.robust) {
        root["rounds"] = report.robust->rounds;
        root["holds_in_sample"] = report.robust->holdsInSample;
        const int phases = report.robust->freshPhases; // 0: there is no answer that was tried
        const int candidate = candidateOf(report);
        root["fresh_phases"] = {
            {"tried", phases},
            {"failed", 0},
            {"candidate", phases > 0 ? ordered_json(candidate) : ordered_json(nullptr)},
            {"failing_share_at_most",
             phases > 0 ? ordered_json(mostFailing(phases, candidate)) : ordered_json(nullptr)},
            {"confidence", 0.95},
            {"cycles_that_failed", report.robust->freshFailures}};
        const auto decided = decidedCases(report);
        root["decided_stock_mm"] =
            decided ? ordered_json{decided->stocks.from_mm, decided->stocks.to_mm}
                    : ordered_json(nullptr);
        root["decided_corners"] = decided ? ordered_json(decided->corners) : ordered_json(nullptr);
        root["nominal_time_min"] = minutes(report.robust->nominalTime_s);
    }
    return root.dump(2) + '\n';
}

std::string noAnswerSentence(const GridSearchReport& report) {
    const SearchSummary& search = report.search;
    std::string text;
    if (search.best) {
        text = "no cycle was found that holds in all phases of the stock it was tried on";
    } else if (search.status == SearchStatus::stopped) {
        text = "stopped before a feasible cycle was found";
    } else if (search.status == SearchStatus::notFound) {
        text = "the heuristic found no feasible cycle; there may be one, --method search tells";
    } else {
        text = report.marginWithin_us ? "no cycle of the grid that takes at most "
                                            + numberText(within_min(report)) + " min is feasible"
                                      : "no cycle of the grid is feasible";
    }
    std::string names;
    for (const auto& [count, name] : cutsOf(search)) {
        names += (names.empty() ? "; cut by " : ", ") + std::string(name) + " ("
                 + std::to_string(count) + " times)";
    }
    return text + names;
}

} // namespace sparkout::cli
