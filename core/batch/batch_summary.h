// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/batch_statistics.h"
#include "core/statistics/intervals.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sparkout {

/// A percentile: the least value at or below which at least this share of the parts lies.
struct Percentile {
    double order = 0; ///< 0…1
    double value = 0;
    /// 95 % interval by order statistics; for binned values, to the bins' edges; not for corners.
    std::optional<Interval> interval;
};

struct HistogramBar {
    double low = 0, high = 0;
    std::int64_t count = 0;
};

/// Parts rejected by one cause; a part with several causes counts for each.
struct RejectCause {
    std::optional<ConstraintKind> kind; ///< none: the cycle did not reach size
    std::int64_t count = 0;
};

struct CharacteristicSummary {
    Characteristic characteristic;
    std::int64_t count = 0;
    std::int64_t unstated = 0; ///< parts without a value since strips stay uncut
    PartValue least, most;
    Moments moments;
    std::optional<Interval> mean95; ///< Student's
    std::vector<Percentile> percentiles;
    std::vector<HistogramBar> histogram;
    std::optional<Normality> normality; ///< for at least 20 values
    /// Performance indices [ISO22514]: s is that of all parts, including drift. Only for
    /// characteristics with hasCapability(); empty where the scatter is negligible (an index above
    /// 99), or where strips stay uncut and parts have no value.
    std::optional<Estimate> pp, ppk;
    std::optional<double> expectedOutside; ///< share of the normal law of this mean and s; like ppk
    Share outside;                         ///< share outside the limits
};

/// The figures of a batch. Corners are not a sample: only their extremes and counts are reported.
struct BatchSummary {
    bool isSample = true;
    std::int64_t parts = 0, failed = 0;
    std::int64_t stripped = 0; ///< parts with strips uncut, without size, form and roughness
    Share bad;
    std::vector<RejectCause> causes; ///< causes of rejected parts, the most frequent first
    std::int64_t worstPart = -1;
    bool exactPercentiles = false; ///< false: to within a bin
    bool drifts = false; ///< a factor grows over the batch, so C_p of a stable process is unknown
    std::vector<CharacteristicSummary> characteristics;
};

[[nodiscard]] BatchSummary summarise(const BatchResult& result);

/// Indices of the characteristics of one name in a summary, in the order of the places: all, or if
/// they are too many those of the least Ppk.
[[nodiscard]] std::vector<std::size_t>
placesOf(const BatchSummary& summary, const std::string& name,
         std::size_t most = std::numeric_limits<std::size_t>::max());

inline constexpr std::size_t mostPlaces = 6; ///< places of a characteristic drawn side by side

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

    /// Whether all parts that were run are good, but too few further parts are expected to be; for
    /// a characteristic with a P_pk.
    [[nodiscard]] bool missesForecast() const {
        return reason == BatchReason::outside || reason == BatchReason::ppk;
    }
};

/// Unfit if the share of rejected parts exceeds the batch's `most_outside_share` (0, if not given).
/// Conditionally fit if some are rejected, if capability is not known, if the greatest expected
/// share outside exceeds that limit, or if a lower 95 % bound of P_pk is below `least_ppk`. A
/// characteristic with negligible scatter has no P_pk and needs none.
[[nodiscard]] BatchVerdict weigh(const BatchSummary& summary, const BatchResult& result);

/// Adds P_p, P_pk and the expected share outside to a summary, from its mean, deviation and count.
/// Nothing is added where the characteristic has no capability or negligible scatter.
void addCapability(CharacteristicSummary& summary);

} // namespace sparkout
