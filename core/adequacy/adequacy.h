// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/adequacy/measured_statistics.h"
#include "core/adequacy/prediction.h"
#include "core/judgement/judgement.h"
#include "core/project/project.h"
#include "core/quality/result_names.h"
#include "core/result.h"
#include "core/statistics/intervals.h"

#include <optional>
#include <span>
#include <vector>

/// Whether a model's prediction agrees with measured parts [MODEL-13]: compares the interval of the
/// difference of the means with a limit of equivalence, and the variances. The sources' own
/// criterion is given, too [ALSIGAR2021, table 2]: the interval of the mean of the parts relative
/// to the predicted range.
namespace sparkout {

enum class AdequacyVerdict {
    adequate,
    biased,            ///< the means differ by more than the limit, or by more than chance
    scatterDiffers,    ///< the parts scatter more or less than predicted
    biasedAndScatters, ///< both
    tooFewParts,       ///< the interval of the bias contains 0 and is wider than the limit
    notPredicted       ///< the cycle does not give this quantity
};

/// The position of the mean's interval relative to the predicted range.
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
    /// Welch's interval of measured mean − predicted mean, widened by the uncertainty of measuring.
    std::optional<Interval> bias95;
    double biasLimit = 0;
    std::optional<VarianceRatio> scatter; ///< measured to predicted and measuring, 95 %
    std::optional<InsideShare> share;     ///< given if it is known for every part
    AdequacyVerdict verdict = AdequacyVerdict::notPredicted;
};

/// The limits for judging a quantity [µm].
struct AdequacyLimits {
    double bias = 0;        ///< difference of the means that counts as none
    double uncertainty = 0; ///< standard uncertainty of one measured value
};
/// Of the project's batch, which has none for Ra, otherwise of its drawing: a tenth of the
/// tolerance, or without one half the standard deviation of the parts, predicted or measured.
[[nodiscard]] AdequacyLimits adequacyLimits(const Project& project,
                                            const MeasuredStatistics& measured,
                                            const std::optional<PredictedRange>& predicted);

[[nodiscard]] AdequacyRow judgeAdequacy(MeasuredStatistics measured,
                                        std::optional<PredictedRange> predicted,
                                        const AdequacyLimits& limits);

/// Compares all data in the project's section `measured` with a batch of predictingProject().
[[nodiscard]] std::vector<AdequacyRow> judgeAdequacy(const Project& project,
                                                     const BatchResult& batch);

/// Whether there is no contradiction with the model: no row with a bias or a different scatter.
[[nodiscard]] bool speaksForModel(const std::vector<AdequacyRow>& rows);

/// The greatest bias of these rows by its limit, for the judgement of the cycle; empty if none is
/// biased. Where the prediction is not whole, an Ra that is not calibrated or a form without the
/// machine's own, the requirement is not decided, and a bias is no news.
[[nodiscard]] std::optional<MeasuredBias> greatestBias(const Project& project,
                                                       const std::vector<AdequacyRow>& rows);

/// A judged quantity, and its project.
struct AdequacyOf {
    const Project& project;
    const AdequacyRow& row;
};

[[nodiscard]] std::span<const Output<AdequacyOf>> adequacyOutputs();
[[nodiscard]] std::span<const Output<PredictedRange>> predictedOutputs();
[[nodiscard]] std::span<const Output<VarianceRatio>> varianceRatioOutputs();
[[nodiscard]] std::span<const Output<InsideShare>> insideShareOutputs();

/// Names in files and on the command line: "diameter_deviation", "scatter_differs".
[[nodiscard]] const char* keyOf(MeasuredQuantity quantity);
[[nodiscard]] const char* keyOf(AdequacyVerdict verdict);
[[nodiscard]] const char* keyOf(MeanPlace place);
/// A zone or section by its name in JSON, or the part.
[[nodiscard]] std::string placeKey(const Project& project, int place, First first = First::inFiles);

} // namespace sparkout
