// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"

#include <optional>

namespace sparkout {

enum class Fitness { fit, conditional, unfit };

/// What decided a verdict on a batch, the gravest first.
enum class BatchReason {
    noPart,    ///< none was run
    partsFail, ///< too many of the parts run are not good
    someFail,  ///< some are, but no more than allowed
    stopped,   ///< not all parts were run
    noSample,  ///< corners give no capability
    fewParts,  ///< nor does one part
    outside,   ///< the share expected out of tolerance
    ppk,       ///< the lower bound of P_pk
    allHold    ///< nothing speaks against it
};

/// Whether a cycle holds for its batch: by the parts that were run, then by what is to be expected
/// of more of them.
struct BatchVerdict {
    Fitness fitness = Fitness::unfit;
    BatchReason reason = BatchReason::noPart;
    /// Index of the characteristic that decided, of `outside` and `ppk`, and of `allHold` that of
    /// the least P_pk, if there is any.
    std::optional<std::size_t> characteristic;
    double value = 0; ///< what was weighed: a share or the lower bound of P_pk
    double limit = 0; ///< against which limit of the batch
};

/// Unfit when a greater share of the parts fails than the batch's `most_outside_share` (none, if
/// not given). Conditionally fit when some fail, when capability is not known, when the greatest
/// expected share outside is beyond that limit, or when a lower 95 % bound of P_pk is below
/// `least_ppk`. A characteristic whose scatter is nothing beside its field has no P_pk and needs
/// none.
[[nodiscard]] BatchVerdict weigh(const BatchSummary& summary, const BatchResult& result);

} // namespace sparkout
