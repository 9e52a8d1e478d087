// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"

#include <optional>
#include <vector>

/// Which factor matters most.
namespace sparkout {

/// Standardised rank regression of a batch that was run: the coefficients of the least-squares
/// plane through the ranks of a characteristic over the ranks of the factors [IMAN1979]. Sign and
/// size show direction and weight as far as the dependence is monotone; R² shows how far that is.
struct RankRegression {
    std::vector<double> coefficients; ///< by factor
    double determination = 0;         ///< R²
};

/// By characteristic, over all parts; nothing for a characteristic or a factor that does not vary,
/// or fewer parts than twice the factors and two. Where not all parts are kept one by one, the
/// factors' ranks are those of their laws, and a characteristic's that of its bin.
[[nodiscard]] std::vector<std::optional<RankRegression>> rankRegressions(const BatchResult& result);

/// Sobol indices: the share of a characteristic's variance that a factor accounts for alone (first)
/// and with all its interactions (total) [SALTELLI2010]. Estimates: they may leave 0…1 a little.
struct SobolIndex {
    double first = 0, total = 0;
};

struct SobolIndices {
    std::int64_t simulations = 0;
    /// By characteristic and factor; empty for a characteristic that does not vary or that some of
    /// the parts lack.
    std::vector<std::vector<SobolIndex>> byCharacteristic;
};

/// Simulates points·(factors + 2) parts. The factors are taken as independent, a law over the batch
/// as uniform between its ends. Nothing with correlated factors, for which the indices have no
/// such meaning, without a batch or points, and when it is stopped. Of a project that, if it has a
/// batch, checkBatch() passes.
[[nodiscard]] std::optional<SobolIndices> sobolIndices(const Project& project, int points,
                                                       const BatchOptions& options = {});

} // namespace sparkout
