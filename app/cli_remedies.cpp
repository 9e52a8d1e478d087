// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_remedies.h"

#include "app/io/batch_watch.h"
#include "app/io/cli_io.h"
#include "app/io/cli_surfaces.h"
#include "app/io/stop_signals.h"
#include "core/format/output_json.h"
#include "core/format/project_file.h"
#include "core/phases/sampled_phases.h"
#include "core/quality/light.h"
#include "core/quality/requirement_outputs.h"
#include "core/quality/result_names.h"
#include "core/remedies/remedies.h"
#include "core/simulation/simulate.h"
#include "core/units.h"
#include "words/remedy_words.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

/// The change of the project file, as RFC 6902 has it.
ordered_json patchOf(const Project& before, const Project& after) {
    return ordered_json::parse(nlohmann::json::diff(nlohmann::json::parse(writeProject(before)),
                                                    nlohmann::json::parse(writeProject(after)))
                                   .dump());
}

ordered_json valueJson(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json();
}

/// Null: its stocks are decided.
ordered_json phasesJson(const Remedy& remedy) {
    constexpr double confidence = 0.95;
    return remedy.stocks ? ordered_json()
                         : ordered_json{{"tried", remedy.phases},
                                        {"candidate", remedy.candidate},
                                        {"failing_share_at_most",
                                         mostFailing(remedy.phases, remedy.candidate)},
                                        {"confidence", confidence}};
}

ordered_json remedyJson(const Project& project, const Remedy& remedy) {
    ordered_json json = {
        {"path", remedy.setting.path(project)},
        {"before", valueJson(remedy.before())},
        {"value", remedy.value},
        {"failing", valueJson(remedy.failing)},
        {"holds_beyond", remedy.holdsBeyond},
        {"time_min", remedy.time_s / units::secondsPerMinute},
        {"time_change_min", remedy.timeChange_s
                                ? ordered_json(*remedy.timeChange_s / units::secondsPerMinute)
                                : ordered_json()},
        {"stock_mm", remedy.stocks ? ordered_json{remedy.stocks->from_mm, remedy.stocks->to_mm}
                                   : ordered_json()},
        {"phases", phasesJson(remedy)},
        {"patch", patchOf(project, remedy.applied(project))},
        {"requirements", ordered_json::array()}};
    for (const ConstraintResult& each : remedy.requirements) {
        json["requirements"].push_back(outputsJson(requirementOutputs(), each));
    }
    return json;
}

ordered_json conflictJson(const Project& project, const RemedyConflict& conflict) {
    ordered_json json = {{"kind", conflictKey(conflict.kind)},
                         {"first", nullptr},
                         {"second", nullptr},
                         {"path", nullptr},
                         {"value", nullptr},
                         {"stock_mm", nullptr}};
    if (conflict.first) {
        json["first"] = requirementOf(conflict.first->kind).key;
    }
    if (conflict.second) {
        json["second"] = requirementOf(conflict.second->kind).key;
    }
    if (conflict.setting) {
        json["path"] = conflict.setting->path(project);
        json["value"] = conflict.value;
    }
    if (conflict.kind == RemedyConflict::Kind::stocks) {
        json["stock_mm"] = conflict.stock_mm;
    }
    return json;
}

std::string remediesJson(const Project& project, const RemedyResult& found) {
    ordered_json json = {{"goal", goalKey(found.goal)},
                         {"status", found.isComplete() ? "completed" : "stopped"},
                         {"settings", found.settings},
                         {"tried", found.tried},
                         {"runs", found.runs},
                         {"found", found.found},
                         {"remedies", ordered_json::array()},
                         {"conflict", nullptr}};
    for (const Remedy& remedy : found.remedies) {
        json["remedies"].push_back(remedyJson(project, remedy));
    }
    if (found.conflict) {
        json["conflict"] = conflictJson(project, *found.conflict);
    }
    return json.dump(2) + '\n';
}

/// What fails, or is close.
std::string stateText(const SimulationResult& result, const RemedyResult& found,
                      const std::vector<ConstraintResult>& constraints) {
    if (found.goal == RemedyGoal::none) {
        return "everything holds, with room\n";
    }
    if (result.status != RunStatus::completed) {
        return "the cycle does not end by itself\n";
    }
    const ConstraintResult& worst = *worstRequirement(constraints);
    return std::string(requirementOf(worst.kind).key)
           + (worst.holds ? " is close to its limit in " : " fails in ") + whereText(worst) + '\n';
}

std::string remediesText(const Project& project, const RemedyResult& found) {
    if (found.goal == RemedyGoal::none) {
        return {};
    }
    const RemedyWording wording;
    std::string text;
    for (const Remedy& remedy : found.remedies) {
        text += "  " + wording.line(project, remedy) + '\n';
        text += "    " + wording.proof(project, found.goal, remedy) + '\n';
    }
    if (const std::string scope = wording.scope(found); !scope.empty()) {
        text += "  " + scope + '\n';
    }
    if (found.conflict) {
        text += "  " + wording.conflict(project, found.goal, *found.conflict) + '\n';
    }
    if (const std::string extent = wording.extent(found); !extent.empty()) {
        text += "  " + extent + '\n';
    }
    return text + std::to_string(found.tried) + " of " + std::to_string(found.settings)
           + " settings tried in " + std::to_string(found.runs) + " runs; "
           + std::to_string(found.found) + (found.found == 1 ? " helps\n" : " help\n");
}

int findRemediesOf(const Project& project, const Options& options) {
    SimulationResult result;
    RemedyResult found;
    std::vector<ConstraintResult> constraints;
    {
        BatchWatch watch(static_cast<std::int64_t>(remedySettings(project).size()), false,
                         "settings");
        result = simulate(project, nullptr, watch.stop());
        constraints = evaluateConstraints(result);
        RemedyOptions run;
        run.stop = watch.stop();
        run.progress = [&watch](const RemedyResult& sofar) {
            *watch.done() = static_cast<std::int64_t>(sofar.tried);
        };
        found = findRemedies(result, constraints, run);
    }
    if (result.status == RunStatus::stopped) {
        return interrupted + caughtSignal();
    }
    print(stdout, options.json
                      ? remediesJson(project, found)
                      : stateText(result, found, constraints) + remediesText(project, found));
    return caughtSignal() == 0 ? done : interrupted + caughtSignal();
}

} // namespace

int runRemediesCommand(const Options& options) {
    const Surfaces surfaces(options.operand, options.surface);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    return surfaces.run([&options](const Project& project, std::size_t,
                                   const std::string&) { return findRemediesOf(project, options); },
                        options.json);
}

} // namespace sparkout::cli
