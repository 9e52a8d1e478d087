// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/recalled_run.h"

#include "core/format/project_file.h"
#include "core/study/evaluate.h"

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
            column.passIndex = {}; // the trajectory is gone
        }
        run.feeds = std::make_shared<const FeedSeries>(std::move(feeds));
    }
    return run;
}

} // namespace sparkout
