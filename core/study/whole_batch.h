// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/batch/sensitivity.h"
#include "core/issue.h"
#include "core/judgement/judgement.h"
#include "core/project/given_factors.h"
#include "core/study/outcome.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace sparkout {

/// All results of one batch, as an immutable value. With issues nothing was run.
struct BatchOutcome {
    Issues issues; ///< reasons why the batch cannot be run
    BatchResult result;
    BatchSummary summary;
    std::vector<std::optional<RankRegression>> regressions; ///< by characteristic
    std::vector<GivenFactor> factors;
    std::vector<std::vector<double>> drawn; ///< values of the factors, by recorded part
    std::vector<Undecided> notDecided;      ///< requirements that cannot be decided for any part

    [[nodiscard]] bool ran() const { return issues.empty(); }

    // Quantities of a part by number: the factors, then the characteristics.
    [[nodiscard]] std::size_t quantityCount() const {
        return factors.size() + summary.characteristics.size();
    }
    [[nodiscard]] const Characteristic* characteristicOf(std::size_t quantity) const; ///< or null
    /// Returns a quantity of the part in a kept row.
    [[nodiscard]] double valueOf(std::size_t row, std::size_t quantity) const;
    [[nodiscard]] bool isOutside(std::size_t row, std::size_t quantity) const; ///< its limits
};

using BatchOutcomePtr = std::shared_ptr<const BatchOutcome>;

/// Checks and runs the batch of a project, in this thread.
[[nodiscard]] BatchOutcomePtr runWholeBatch(const Project& project,
                                            const BatchOptions& options = {});

/// Returns the number of parts in the batch of a project.
[[nodiscard]] std::int64_t partsOf(const Project& project);

/// Returns the number of parts needed for Sobol indices.
[[nodiscard]] std::int64_t partsOfIndices(const Project& project, int points);

/// Judges an outcome for every stock within one infeed, which is decided here, for a batch of the
/// same inputs and by measured parts that a batch predicts; both batches may be null. Used by
/// reports, which wait for the decision.
[[nodiscard]] Judgement judgementOf(const Outcome& outcome, const BatchOutcome* batch = nullptr,
                                    const BatchOutcome* predicting = nullptr);

} // namespace sparkout
