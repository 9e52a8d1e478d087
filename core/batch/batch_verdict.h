// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"

#include <optional>

namespace sparkout {

enum class Fitness { fit, conditional, unfit };

/// The reason of a verdict on a batch, the gravest first.
enum class BatchReason {
    noPart,    ///< none was run
    partsFail, ///< too many of the run parts are rejected
    someFail,  ///< some are rejected, but no more than allowed
    stopped,   ///< not all parts were run
    noSample,  ///< corners give no capability
    fewParts,  ///< too few parts for a capability
    outside,   ///< the share expected out of tolerance
    ppk,       ///< the lower bound of P_pk
    allHold    ///< no objection
};

/// Whether a cycle is fit for its batch: by the parts that were run, then by the forecast for
/// further parts.
struct BatchVerdict {
    Fitness fitness = Fitness::unfit;
    BatchReason reason = BatchReason::noPart;
    /// Index of the deciding characteristic, for `outside` and `ppk`; for `allHold` that with the
    /// least P_pk, if any.
    std::optional<std::size_t> characteristic;
    double value = 0; ///< a share or the lower bound of P_pk
    double limit = 0; ///< its limit for the batch

    /// Whether all parts that were run are good, but not enough of the further ones are expected to
    /// be; of a characteristic with a P_pk.
    [[nodiscard]] bool missesForecast() const {
        return reason == BatchReason::outside || reason == BatchReason::ppk;
    }
};

/// Unfit if the share of rejected parts exceeds the batch's `most_outside_share` (0, if not given).
/// Conditionally fit if some are rejected, if capability is not known, if the greatest expected
/// share outside exceeds that limit, or if a lower 95 % bound of P_pk is below `least_ppk`. A
/// characteristic with negligible scatter has no P_pk and needs none.
[[nodiscard]] BatchVerdict weigh(const BatchSummary& summary, const BatchResult& result);

} // namespace sparkout
