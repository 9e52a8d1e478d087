// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/project.h"
#include "core/quality/run_summary.h"
#include "core/simulation/feed_series.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// A kept run recomputed by this version of the engine.
struct RecalledRun {
    Issues issues;                           ///< with errors it is not run
    std::optional<RunSummary> summary;       ///< empty: the inputs were refused
    std::shared_ptr<const FeedSeries> feeds; ///< null: not kept
};

/// Computes the run of inputs that are given as the text of a project. A stopped run gives an empty
/// value.
[[nodiscard]] RecalledRun recallRun(const std::string& inputs, const std::stop_token& stop);

/// Comparison of a kept run with the engine.
struct KeptRunCheck {
    std::string name;
    std::string engineVersion;               ///< engine that computed the kept run
    Issues issues;                           ///< errors of its inputs: it cannot be run
    bool isReadable = true;                  ///< its numbers can be read as a summary
    std::shared_ptr<const ReadSummary> kept; ///< the kept numbers, to which `changed` refers
    std::shared_ptr<const RunSummary> now;
    std::vector<ChangedValue> changed; ///< numbers that differ from the engine's

    [[nodiscard]] bool isTrue() const { return issues.empty() && isReadable && changed.empty(); }
};

/// Runs the inputs of a kept run again and compares its numbers with the result by changedSince().
/// A stopped check counts as equal.
[[nodiscard]] KeptRunCheck checkKeptRun(const KeptRun& run, const std::stop_token& stop = {});

/// Returns the checks of those kept runs of a project whose numbers differ from the engine's.
[[nodiscard]] std::vector<KeptRunCheck> untrueRuns(const Project& project,
                                                   const std::stop_token& stop = {});

} // namespace sparkout
