// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/batch_runner.h"

#include "core/batch/batch_check.h"

namespace sparkout {

BatchOutcomePtr runWholeBatch(const Project& project, const BatchOptions& options) {
    auto outcome = std::make_shared<BatchOutcome>();
    outcome->issues = checkBatch(project);
    if (outcome->ran()) {
        outcome->result = runBatch(project, options);
        outcome->summary = summarise(outcome->result);
        outcome->regressions = rankRegressions(outcome->result);
        const ScenarioSource source(outcome->result.project);
        outcome->factors = source.factors();
        for (const PartRow& row : outcome->result.statistics.rows) {
            outcome->drawn.push_back(source.values(row.part));
        }
    }
    return outcome;
}

std::int64_t partsOf(const Project& project) {
    const std::size_t factors = givenFactors(project).size();
    if (!project.batch) {
        return 0;
    }
    const bool corners = project.batch->scenarios == Scenarios::corners;
    return corners || factors == 0 ? std::int64_t{1} << factors : project.batch->parts;
}

std::int64_t partsOfIndices(const Project& project, int points) {
    return std::int64_t{points} * (static_cast<std::int64_t>(givenFactors(project).size()) + 2);
}

namespace {

BatchOptions optionsOf(const CountedJob::Means& means) {
    BatchOptions options;
    options.threads = means.threads;
    options.stop = means.stop;
    options.done = means.done;
    return options;
}

} // namespace

void BatchRunner::start(const Project& project) {
    run(partsOf(project), [this, project](const Means& means) {
        return
            [this, outcome = runWholeBatch(project, optionsOf(means))] { emit finished(outcome); };
    });
}

void BatchRunner::startIndices(const Project& project, int points) {
    run(partsOfIndices(project, points), [this, project, points](const Means& means) {
        const auto found = sobolIndices(project, points, optionsOf(means));
        const auto indices = found ? std::make_shared<const SobolIndices>(*found) : nullptr;
        return [this, indices] { emit indicesFound(indices); };
    });
}

} // namespace sparkout
