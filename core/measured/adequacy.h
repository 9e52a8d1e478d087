// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/judgement.h"
#include "core/project/measured.h"
#include "core/project/project.h"
#include "core/quality/result_names.h"
#include "core/result.h"
#include "core/statistics/intervals.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Whether a model's prediction agrees with measured parts [MODEL-13]: compares the interval of the
/// difference of the means with a limit of equivalence, and the variances. The sources' own
/// criterion is given, too [ALSIGAR2021, table 2]: the interval of the mean of the parts relative
/// to the predicted range.

namespace sparkout {

/// The measurements of one quantity in one zone or section [µm].
struct MeasuredStatistics {
    MeasuredQuantity quantity = MeasuredQuantity::diameter_deviation;
    int place = 0; ///< −1: the whole part
    std::int64_t count = 0;
    double mean = 0;
    std::optional<double> deviation; ///< standard deviation of two or more values, or as given
    std::optional<double> least, greatest;
    std::vector<double> values; ///< in rising order; empty for a summary
    bool isSummary = false;
};

/// For all measurements in existing zones or sections, by quantity and place; summaries follow
/// single parts. Several diameters of a part count as their mean.
[[nodiscard]] std::vector<MeasuredStatistics> statisticsOfMeasured(const Project& project);

/// Values that a quarter, a half and three quarters of the parts do not exceed.
struct Quartiles {
    double low = 0, median = 0, high = 0;
};

/// Requires at least one value, in rising order.
[[nodiscard]] Quartiles quartilesOf(const std::vector<double>& sorted);

/// The prediction for one quantity in one zone or section [µm].
struct PredictedRange {
    double low = 0, high = 0; ///< contains 95 % of the parts; for corners, or as given: all
    double mean = 0;
    std::optional<double> deviation{};    ///< empty for corners, and without scatter
    std::int64_t count = 0;               ///< parts of the batch; 0: as given
    double least = 0, most = 0;           ///< extremes of all parts
    std::optional<Quartiles> quartiles{}; ///< given with a deviation
};

/// The project whose batch predicts all measured quantities: it has a batch, and limits for
/// quantities that the drawing does not limit, so that they are evaluated for every part.
[[nodiscard]] Project predictingProject(Project project);

/// For a batch of that project; empty if it does not have the value.
[[nodiscard]] std::optional<PredictedRange> predicted(const BatchResult& batch,
                                                      MeasuredQuantity quantity, int place);

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

/// The requirement on a quantity; on a diameter its minimum.
[[nodiscard]] ConstraintKind requirementOn(MeasuredQuantity quantity);

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
