// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_measured.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/stop_signals.h"
#include "core/file/output_json.h"
#include "core/measured/trial_design.h"
#include "core/printable.h"
#include "core/project/cycle.h"
#include "core/project/project.h"
#include "core/units.h"
#include "words/measured_words.h"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

constexpr int intervalDecimals = 3;

ordered_json trialJson(const Project& project, const Trial& trial) {
    ordered_json json = {{project.operation->radial().key, trial.radialFeed},
                         {Stage::sparkOutKey, wordsOf(trial.sparkOut).key},
                         {"record", wordsOf(trial.record).key},
                         {"steps_by_stage", trial.stepsByStage},
                         {"duration_s", trial.duration_s},
                         {"samples", trial.samples},
                         {"log_determinant", jsonOrNull(trial.logDeterminant)},
                         {"expected", ordered_json::array()},
                         {"cannot_tell", ordered_json::array()}};
    for (const TrialExpectation& expected : trial.expected) {
        json["expected"].push_back({{"parameter", parameterName(expected.parameter)},
                                    {"unit", unitOf(expected.parameter.kind)},
                                    {"interval_95", {expected.low, expected.high}}});
    }
    for (const FittedParameter& parameter : trial.cannotTell) {
        json["cannot_tell"].push_back(parameterName(parameter));
    }
    return json;
}

std::string trialText(const Project& project, const Trial& trial, std::size_t rank) {
    const bool perMinute = !project.operation->travels;
    std::string text = std::to_string(rank) + ". " + fixed(trial.radialFeed, 4)
                       + (perMinute ? " mm/min for " : " mm per double stroke for ")
                       + std::to_string(trial.stepsByStage.front())
                       + (project.operation->travels ? " double strokes" : " revolutions");
    text += trial.stepsByStage.size() > 1
                ? ", then " + std::to_string(trial.stepsByStage.back()) + " without feed"
                : "";
    text +=
        "; " + std::string(wordsOf(trial.record).text) + "; " + fixed(trial.duration_s, 1) + " s\n";
    for (const TrialExpectation& expected : trial.expected) {
        const std::string unit = unitOf(expected.parameter.kind);
        text += "     " + parameterName(expected.parameter) + ": "
                + fixed(expected.low, intervalDecimals) + "…"
                + fixed(expected.high, intervalDecimals) + (unit.empty() ? "" : " " + unit) + '\n';
    }
    for (const FittedParameter& parameter : trial.cannotTell) {
        text += "     " + parameterName(parameter) + ": undetermined\n";
    }
    return text;
}

} // namespace

int designTrialOf(const Project& project, const std::string& name,
                  const std::vector<FittedParameter>& parameters, const manual::Given& given) {
    const TrialRequest request{parameters, {}};
    const BatchWatch watch(BatchWatch::uncounted, false, "trials");
    const TrialDesign design = designTrial(project, request, watch.stop());
    if (caughtSignal() != 0) {
        return interrupted + caughtSignal();
    }
    if (design.status != TrialStatus::designed) {
        print(stderr, printable(name) + ": " + wordsOf(design.status).text + '\n');
        return refused;
    }
    const TrialNoise& noise = request.noise;
    ordered_json json = {{"trials", ordered_json::array()},
                         {"noise",
                          {{"samples_per_s", noise.hertz},
                           {"size_mm", noise.size_mm},
                           {"power_kw", noise.power_kw},
                           {"force_share", noise.force_share}}}};
    std::string text = "Expected 95 % intervals about the file's values, for "
                       + fixed(noise.hertz, 0) + " samples a second with a noise of "
                       + fixed(noise.size_mm * units::umPerMm, 1) + " µm, "
                       + fixed(noise.power_kw, 2) + " kW, " + fixed(noise.force_share * 100, 0)
                       + " % of the maximum force\n";
    for (const Trial& trial : design.trials) {
        json["trials"].push_back(trialJson(project, trial));
        text += trialText(project, trial, json["trials"].size());
    }
    print(stdout, given.has("--json") ? json.dump(2) + '\n' : text);
    return given.has("--check") && !design.trials.front().cannotTell.empty() ? requirementFails
                                                                             : done;
}

} // namespace sparkout::cli
