// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/recalled_run.h"

#include "core/format/project_file.h"
#include "core/simulation/simulate.h"
#include "core/study/outcome.h"

#include <utility>

namespace sparkout {

RecalledRun recallRun(const std::string& inputs, const std::stop_token& stop) {
    RecalledRun run;
    ReadResult read = readProject(inputs);
    run.issues = std::move(read.issues);
    if (!read.project) {
        return run;
    }
    const OutcomePtr outcome = evaluate(*read.project, stop);
    if (!outcome) {
        return run; // stopped: nobody asks any more
    }
    run.issues = outcome->issues;
    if (outcome->ran()) {
        run.summary = summarise(outcome->result, outcome->accuracy, outcome->constraints);
        FeedSeries feeds = outcome->feeds;
        for (FeedColumn& column : feeds.columns) {
            column.passIndex = {}; // the trajectory does not exist any more
        }
        run.feeds = std::make_shared<const FeedSeries>(std::move(feeds));
    }
    return run;
}

KeptRunCheck checkKeptRun(const KeptRun& run, const std::stop_token& stop) {
    KeptRunCheck check;
    check.name = run.name;
    check.engineVersion = run.engine_version;
    ReadResult read = readProject(run.inputs.text, stop);
    if (stop.stop_requested()) {
        return check;
    }
    if (!read.project) {
        check.issues = std::move(read.issues);
        return check;
    }
    auto summary = readSummary(run.summary.text);
    if (!summary) {
        check.isReadable = false;
        return check;
    }
    const SimulationResult result = simulateUnchecked(*read.project, nullptr, stop);
    if (result.status == RunStatus::stopped) {
        return check;
    }
    const PartAccuracy accuracy = accuracyOf(result);
    check.kept = std::make_shared<const ReadSummary>(std::move(*summary));
    check.now = std::make_shared<const RunSummary>(
        summarise(result, accuracy, evaluateConstraints(result, accuracy)));
    check.changed = changedSince(*check.kept, *check.now);
    return check;
}

std::vector<KeptRunCheck> untrueRuns(const Project& project, const std::stop_token& stop) {
    std::vector<KeptRunCheck> untrue;
    for (const KeptRun& run : project.runs) {
        KeptRunCheck check = checkKeptRun(run, stop);
        if (!check.isTrue()) {
            untrue.push_back(std::move(check));
        }
    }
    return untrue;
}

} // namespace sparkout
