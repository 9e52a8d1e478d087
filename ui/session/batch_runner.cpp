// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/batch_runner.h"

namespace sparkout {

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
