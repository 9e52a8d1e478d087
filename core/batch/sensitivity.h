// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"

#include <optional>
#include <vector>

/// The influence of the factors on a batch.
namespace sparkout {

/// Standardised rank regression of a batch: the coefficients of the least-squares plane through the
/// ranks of a characteristic over the ranks of the factors [IMAN1979]. Sign and size show direction
/// and weight as far as the dependence is monotonic; R² shows to what extent.
struct RankRegression {
    std::vector<double> coefficients; ///< by factor
    double determination = 0;         ///< R²
};

/// By characteristic, over all parts; empty for a characteristic or a factor that does not vary, or
/// for fewer parts than twice the factors plus two. Where not all parts are stored, the factors'
/// ranks are those of their laws, and a characteristic's rank is that of its bin.
[[nodiscard]] std::vector<std::optional<RankRegression>> rankRegressions(const BatchResult& result);

/// Sobol indices: the share of a characteristic's variance due to a factor alone (first) and
/// including its interactions (total) [SALTELLI2010]. Estimates may be slightly outside 0…1.
struct SobolIndex {
    double first = 0, total = 0;
};

struct SobolIndices {
    std::int64_t simulations = 0;
    /// By characteristic and factor; empty for a characteristic that does not vary or that some
    /// parts lack.
    std::vector<std::vector<SobolIndex>> byCharacteristic;
};

/// Simulates points·(factors + 2) parts. The factors are taken as independent, a law over the batch
/// as uniform between its ends. Empty with correlated factors, for which the indices are not
/// defined, without a batch or points, or after a stop. A batch of the project must pass
/// checkBatch().
[[nodiscard]] std::optional<SobolIndices> sobolIndices(const Project& project, int points,
                                                       const BatchOptions& options = {});

} // namespace sparkout
