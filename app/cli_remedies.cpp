// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/stop_signals.h"
#include "core/quality/result_names.h"
#include "core/quality/verdict.h"
#include "core/simulation/simulate.h"
#include "core/study/remedies.h"
#include "words/remedy_words.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sparkout::cli {

namespace {

/// The requirements that are violated, or met by a small margin.
std::string stateText(const SimulationResult& result, const RemedyResult& found,
                      const std::vector<ConstraintResult>& constraints) {
    if (found.goal == RemedyGoal::none) {
        return "all requirements are met with a sufficient margin\n";
    }
    if (result.status != RunStatus::completed) {
        return "the cycle does not end by itself\n";
    }
    if (found.fault == RemedyFault::stocks) {
        return "fit for the stated stock, but not for every stock\n";
    }
    if (found.fault == RemedyFault::batch) {
        return "fit for every stock, but not for the batch\n";
    }
    const ConstraintResult& worst = *worstRequirement(constraints);
    return std::string(requirementOf(worst.kind).key)
           + (worst.holds ? " is close to its limit in " : " is not met in ")
           + whereText(worst, First::inTexts) + '\n';
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

int findRemediesOf(const Project& project, const manual::Given& given) {
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
    print(stdout, given.has("--json")
                      ? remediesJson(project, found)
                      : stateText(result, found, constraints) + remediesText(project, found));
    return caughtSignal() == 0 ? done : interrupted + caughtSignal();
}

} // namespace

int runRemediesCommand(const manual::Given& given) {
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    return surfaces.run([&given](const Project& project, std::size_t, const std::string&) {
        return findRemediesOf(project, given);
    });
}

} // namespace sparkout::cli
