// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/measured_statistics.h"
#include "core/adequacy/prediction.h"
#include "core/statistics/comparison.h"
#include "core/statistics/intervals.h"

#include <optional>
#include <vector>

/// Whether a model's prediction and measured parts agree, as the sources judge it [ALSIGAR2021,
/// table 2]: the mean of the parts with its Student interval against the predicted range, their
/// variance against the predicted one.
namespace sparkout {

enum class AdequacyVerdict {
    adequate,
    biased,            ///< the mean lies outside the predicted range
    scatterDiffers,    ///< the parts scatter more or less than predicted
    biasedAndScatters, ///< both
    tooFewParts, ///< the interval of the mean is not wholly on one side of an end of the range
    notPredicted ///< the cycle does not give this quantity
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
    std::optional<Interval> bias95;       ///< Welch's, of measured mean − predicted mean
    std::optional<VarianceRatio> scatter; ///< measured to predicted, 95 %
    std::optional<InsideShare> share;     ///< where it is known of every part
    AdequacyVerdict verdict = AdequacyVerdict::notPredicted;
};

/// Judges one quantity.
[[nodiscard]] AdequacyRow judgeAdequacy(MeasuredStatistics measured,
                                        std::optional<PredictedRange> predicted);

/// Judges all that the project's section `measured` holds against a batch of predictingProject().
[[nodiscard]] std::vector<AdequacyRow> judgeAdequacy(const Project& project,
                                                     const BatchResult& batch);

/// Whether nothing speaks against the model: no row is biased or scatters otherwise.
[[nodiscard]] bool speaksForModel(const std::vector<AdequacyRow>& rows);

} // namespace sparkout
