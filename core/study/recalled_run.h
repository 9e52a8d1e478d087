// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/quality/run_summary.h"
#include "core/simulation/feed_series.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace sparkout {

/// A kept run computed again: as this version of the engine has it.
struct RecalledRun {
    Issues issues;                           ///< with errors nothing was run
    std::optional<RunSummary> summary;       ///< nothing: refused
    std::shared_ptr<const FeedSeries> feeds; ///< null: not kept
};

/// Computes the run of such inputs, the text of a project. One that was stopped is empty.
[[nodiscard]] RecalledRun recallRun(const std::string& inputs, const std::stop_token& stop);

} // namespace sparkout
