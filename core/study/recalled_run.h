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

/// A kept run computed again: as this version of the engine has it.
struct RecalledRun {
    Issues issues;                           ///< with errors nothing was run
    std::optional<RunSummary> summary;       ///< nothing: refused
    std::shared_ptr<const FeedSeries> feeds; ///< null: not kept
};

/// Computes the run of such inputs, the text of a project. One that was stopped is empty.
[[nodiscard]] RecalledRun recallRun(const std::string& inputs, const std::stop_token& stop);

/// A kept run held against the engine.
struct KeptRunCheck {
    std::string name;
    std::string engineVersion;               ///< by which it was kept
    Issues issues;                           ///< errors of its inputs: it cannot be run
    bool isReadable = true;                  ///< its numbers are a summary
    std::shared_ptr<const ReadSummary> kept; ///< the values below are of these
    std::shared_ptr<const RunSummary> now;
    std::vector<ChangedValue> changed; ///< numbers that are not the engine's

    [[nodiscard]] bool isTrue() const { return issues.empty() && isReadable && changed.empty(); }
};

/// Runs the inputs of a kept run again and holds its numbers against what comes out, as
/// changedSince() does. Stopped: it is taken for true.
[[nodiscard]] KeptRunCheck checkKeptRun(const KeptRun& run, const std::stop_token& stop = {});

/// Of all kept runs of a project, those whose numbers are not the engine's.
[[nodiscard]] std::vector<KeptRunCheck> untrueRuns(const Project& project,
                                                   const std::stop_token& stop = {});

} // namespace sparkout
