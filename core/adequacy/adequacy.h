// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/measured_statistics.h"
#include "core/adequacy/prediction.h"
#include "core/statistics/comparison.h"
#include "core/statistics/intervals.h"

#include <optional>
#include <vector>

/// Whether a model's prediction and measured parts agree [MODEL-13]: the interval of the difference
/// of their means against a limit up to which they count as the same, and their variances. The
/// sources' own criterion stands beside it [ALSIGAR2021, table 2]: the interval of the mean of the
/// parts against the predicted range.
namespace sparkout {

enum class AdequacyVerdict {
    adequate,
    biased,            ///< the means differ by more than the limit, or otherwise than by chance
    scatterDiffers,    ///< the parts scatter more or less than predicted
    biasedAndScatters, ///< both
    tooFewParts,       ///< the interval of the bias holds 0 and is wider than the limit
    notPredicted       ///< the cycle does not give this quantity
};

/// Where the interval of the mean stands to the predicted range.
enum class MeanPlace { inside, below, above, undecided };

/// Measured parts within the predicted 95 % range.
struct InsideShare {
    std::int64_t inside = 0, count = 0;
    Interval interval; ///< Clopper's and Pearson's, 95 %
};

/// One quantity in one zone or section.
struct AdequacyRow {
    MeasuredStatistics measured;
    std::optional<PredictedRange> predicted;
    std::optional<Interval> mean95; ///< Student's, of two parts or more
    MeanPlace meanPlace = MeanPlace::undecided;
    /// Of measured mean − predicted mean: Welch's, widened by the uncertainty of measuring.
    std::optional<Interval> bias95;
    double biasLimit = 0;
    std::optional<VarianceRatio> scatter; ///< measured to predicted and measuring, 95 %
    std::optional<InsideShare> share;     ///< where it is known of every part
    AdequacyVerdict verdict = AdequacyVerdict::notPredicted;
};

/// What a quantity is judged by [µm].
struct AdequacyLimits {
    double bias = 0;        ///< up to which the means count as the same
    double uncertainty = 0; ///< standard uncertainty of one measured value
};
/// Of the project's batch, which does not speak of Ra, else of its drawing: a tenth of the
/// tolerance, or where that is not given half the standard deviation of the parts, predicted or
/// measured.
[[nodiscard]] AdequacyLimits adequacyLimits(const Project& project,
                                            const MeasuredStatistics& measured,
                                            const std::optional<PredictedRange>& predicted);

/// Judges one quantity.
[[nodiscard]] AdequacyRow judgeAdequacy(MeasuredStatistics measured,
                                        std::optional<PredictedRange> predicted,
                                        const AdequacyLimits& limits);

/// Judges all that the project's section `measured` holds against a batch of predictingProject().
[[nodiscard]] std::vector<AdequacyRow> judgeAdequacy(const Project& project,
                                                     const BatchResult& batch);

/// Whether nothing speaks against the model: no row is biased or scatters otherwise.
[[nodiscard]] bool speaksForModel(const std::vector<AdequacyRow>& rows);

} // namespace sparkout
