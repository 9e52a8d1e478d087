// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/batch/sensitivity.h"
#include "core/issue.h"
#include "core/project/given_factors.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// All that one batch gives: an immutable value. With issues nothing was run.
struct BatchOutcome {
    Issues issues; ///< why the batch cannot be run
    BatchResult result;
    BatchSummary summary;
    std::vector<std::optional<RankRegression>> regressions; ///< by characteristic
    std::vector<GivenFactor> factors;
    std::vector<std::vector<double>> drawn; ///< values of the factors, by kept part

    [[nodiscard]] bool ran() const { return issues.empty(); }
};

using BatchOutcomePtr = std::shared_ptr<const BatchOutcome>;

/// Checks and runs the batch of a project, in this thread.
[[nodiscard]] BatchOutcomePtr runWholeBatch(const Project& project,
                                            const BatchOptions& options = {});

/// How many parts the batch of a project has.
[[nodiscard]] std::int64_t partsOf(const Project& project);

/// How many parts Sobol indices take.
[[nodiscard]] std::int64_t partsOfIndices(const Project& project, int points);

} // namespace sparkout
