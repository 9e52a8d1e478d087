// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/adequacy/adequacy.h"

#include "core/batch/batch_statistics.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/quality/result_names.h"
#include "core/quality/roughness.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sparkout {

namespace {

MeanPlace placeOfMean(const Interval& mean, const PredictedRange& range) {
    // A prediction without scatter is one value: it is inside if the interval contains it.
    const bool isOne = range.low == range.high && mean.low <= range.low && mean.high >= range.high;
    if (isOne || (mean.low >= range.low && mean.high <= range.high)) {
        return MeanPlace::inside;
    }
    return mean.high < range.low   ? MeanPlace::below
           : mean.low > range.high ? MeanPlace::above
                                   : MeanPlace::undecided;
}

/// A summary determines it only if its extremes do.
std::optional<InsideShare> shareInside(const MeasuredStatistics& measured,
                                       const PredictedRange& range) {
    InsideShare share;
    share.count = measured.count;
    if (!measured.isSummary) {
        share.inside = std::ranges::count_if(measured.values, [&range](double value) {
            return value >= range.low && value <= range.high;
        });
    } else if (measured.least && measured.greatest && *measured.least >= range.low
               && *measured.greatest <= range.high) {
        share.inside = measured.count;
    } else {
        return std::nullopt;
    }
    share.interval = clopperPearson(share.inside, share.count, confidence95);
    return share;
}

AdequacyVerdict verdictOf(const AdequacyRow& row) {
    const bool scatters = row.scatter && row.scatter->differs();
    const bool isSame =
        row.bias95 && row.bias95->low >= -row.biasLimit && row.bias95->high <= row.biasLimit;
    const bool isBiased = row.bias95 && !isSame && (row.bias95->low > 0 || row.bias95->high < 0);
    if (isBiased) {
        return scatters ? AdequacyVerdict::biasedAndScatters : AdequacyVerdict::biased;
    }
    return scatters ? AdequacyVerdict::scatterDiffers
           : isSame ? AdequacyVerdict::adequate
                    : AdequacyVerdict::tooFewParts;
}

/// The interval of the measured mean less the predicted one. An error of measuring may be common to
/// all parts, so it is not reduced by their number.
Interval biasOf(const MeasuredStatistics& parts, const PredictedRange& predicted,
                const Interval& mean95, double uncertainty) {
    const bool scatters = predicted.deviation && predicted.count >= 2;
    const Interval chance =
        scatters
            ? welchInterval({parts.mean, *parts.deviation, parts.count},
                            {predicted.mean, *predicted.deviation, predicted.count}, confidence95)
            : Interval{mean95.low - predicted.mean, mean95.high - predicted.mean};
    constexpr double normal95 = 1.959964;
    const double middle = (chance.low + chance.high) / 2;
    const double half = std::hypot((chance.high - chance.low) / 2, normal95 * uncertainty);
    return {middle - half, middle + half};
}

/// The tolerance of the drawing; empty if it has none.
std::optional<double> toleranceOf(const Part& part, MeasuredQuantity quantity) {
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation:
        return part.upper_deviation_um - part.lower_deviation_um;
    case MeasuredQuantity::radial_runout: return part.tolerance.radial_runout_um;
    case MeasuredQuantity::roundness: return part.tolerance.roundness_um;
    case MeasuredQuantity::cylindricity: return part.tolerance.cylindricity_um;
    case MeasuredQuantity::roughness_ra: break;
    }
    return part.tolerance.roughness_ra_um;
}

/// The requirement on a quantity; on a diameter its minimum.
ConstraintKind requirementKind(MeasuredQuantity quantity) {
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation: break;
    case MeasuredQuantity::radial_runout: return ConstraintKind::radialRunout;
    case MeasuredQuantity::roundness: return ConstraintKind::roundness;
    case MeasuredQuantity::cylindricity: return ConstraintKind::cylindricity;
    case MeasuredQuantity::roughness_ra: return ConstraintKind::roughness;
    }
    return ConstraintKind::diameterMin;
}

bool isPredictionWhole(ConstraintKind kind, const Project& project) {
    return kind == ConstraintKind::roughness ? isRoughnessCalibrated(project)
                                             : knowsMachine(kind, project);
}

constexpr Output<AdequacyOf> adequacyRows[] = {
    {{.key = "quantity"},
     [](const AdequacyOf& a) { return std::string(keyOf(a.row.measured.quantity)); }},
    {{.key = "where"},
     [](const AdequacyOf& a) { return placeKey(a.project, a.row.measured.place); }},
    {{.key = "summary", .hint = "whether the parts are summed up, not listed"},
     [](const AdequacyOf& a) { return a.row.measured.isSummary; }},
    {{.key = "count",
      .label = SPARKOUT_NOOP("Output", "n"),
      .hint = SPARKOUT_NOOP("Output", "Number of measured parts")},
     [](const AdequacyOf& a) { return a.row.measured.count; }},
    {{.key = "mean_um", .label = SPARKOUT_NOOP("Output", "Mean"), .unit = "µm"},
     [](const AdequacyOf& a) { return a.row.measured.mean; }},
    {{.key = "mean_95_um",
      .label = SPARKOUT_NOOP("Output", "Mean"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP(
          "Output", "Mean of the measured parts with Student's interval: with 95 % confidence it "
                    "contains the mean of an unlimited number of such parts")},
     [](const AdequacyOf& a) { return a.row.mean95; }},
    {{.key = "deviation_um", .label = SPARKOUT_NOOP("Output", "s"), .unit = "µm"},
     [](const AdequacyOf& a) { return a.row.measured.deviation; }},
    {{.key = "bias_95_um",
      .label = SPARKOUT_NOOP("Output", "Bias"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP("Output", "Measured less predicted mean: Welch's interval, 95 %, with "
                                      "the uncertainty of measuring")},
     [](const AdequacyOf& a) { return a.row.bias95; }},
    {{.key = "bias_limit_um",
      .label = SPARKOUT_NOOP("Output", "Limit of bias"),
      .unit = "µm",
      .hint =
          SPARKOUT_NOOP("Output", "Largest difference at which the two means count as the same")},
     [](const AdequacyOf& a) { return a.row.biasLimit; }},
    {{.key = "mean_place",
      .hint = "where the interval of the mean lies to the predicted range, the criterion of the "
              "sources: inside, below, above or undecided"},
     [](const AdequacyOf& a) { return std::string(keyOf(a.row.meanPlace)); }},
    {{.key = "verdict"}, [](const AdequacyOf& a) { return std::string(keyOf(a.row.verdict)); }},
};

constexpr Output<PredictedRange> predictedRows[] = {
    {{.key = "count", .hint = "parts of the batch; 0: as stated"},
     [](const PredictedRange& p) { return p.count; }},
    {{.key = "mean_um", .label = SPARKOUT_NOOP("Output", "Predicted mean"), .unit = "µm"},
     [](const PredictedRange& p) { return p.mean; }},
    {{.key = "low_um",
      .label = SPARKOUT_NOOP("Output", "Predicted from"),
      .unit = "µm",
      .hint = SPARKOUT_NOOP(
          "Output", "Range that contains 95 % of the parts of the batch; of corners, all of them")},
     [](const PredictedRange& p) { return p.low; }},
    {{.key = "high_um", .label = SPARKOUT_NOOP("Output", "Predicted to"), .unit = "µm"},
     [](const PredictedRange& p) { return p.high; }},
    {{.key = "deviation_um", .label = SPARKOUT_NOOP("Output", "Predicted s"), .unit = "µm"},
     [](const PredictedRange& p) { return p.deviation; },
     nullptr,
     [](const PredictedRange& p) { return p.deviation.has_value(); }},
};

constexpr Output<VarianceRatio> ratioRows[] = {
    {{.key = "value",
      .label = SPARKOUT_NOOP("Output", "F"),
      .hint = SPARKOUT_NOOP("Output",
                            "Variance of the measured parts over that of the batch, with the "
                            "limits that chance leaves it within in 95 % of cases: Fisher's test")},
     [](const VarianceRatio& v) { return v.ratio; }},
    {{.key = "low", .label = SPARKOUT_NOOP("Output", "F, 95 % from")},
     [](const VarianceRatio& v) { return v.low; }},
    {{.key = "high", .label = SPARKOUT_NOOP("Output", "F, 95 % to")},
     [](const VarianceRatio& v) { return v.high; }},
    {{.key = "probability", .hint = "of a ratio at least so far from 1 by chance"},
     [](const VarianceRatio& v) { return v.probability; }},
};

constexpr Output<InsideShare> insideRows[] = {
    {{.key = "count", .label = SPARKOUT_NOOP("Output", "Parts inside")},
     [](const InsideShare& s) { return s.inside; }},
    {{.key = "of", .hint = "measured parts"}, [](const InsideShare& s) { return s.count; }},
    {{.key = "interval_95",
      .label = SPARKOUT_NOOP("Output", "Share inside"),
      .hint = SPARKOUT_NOOP("Output",
                            "Measured parts within the predicted range, as a share with the 95 % "
                            "bounds of Clopper and Pearson")},
     [](const InsideShare& s) { return std::optional(s.interval); }},
};

} // namespace

AdequacyLimits adequacyLimits(const Project& project, const MeasuredStatistics& measured,
                              const std::optional<PredictedRange>& predicted) {
    constexpr double shareOfTolerance = 0.1, shareOfDeviation = 0.5;
    AdequacyLimits limits;
    const double deviation = std::max(measured.deviation.value_or(0),
                                      predicted ? predicted->deviation.value_or(0) : 0.0);
    const auto tolerance = toleranceOf(*project.part, measured.quantity);
    limits.bias = tolerance ? shareOfTolerance * *tolerance : shareOfDeviation * deviation;
    if (project.batch && measured.quantity != MeasuredQuantity::roughness_ra) {
        const Batch& batch = *project.batch;
        limits.uncertainty = batch.measuring_uncertainty_um;
        limits.bias = batch.bias_limit_um.value_or(limits.bias);
        if (measured.quantity != MeasuredQuantity::diameter_deviation) {
            limits.uncertainty = batch.form_measuring_uncertainty_um.value_or(limits.uncertainty);
            limits.bias = batch.form_bias_limit_um.value_or(limits.bias);
        }
    }
    return limits;
}

AdequacyRow judgeAdequacy(MeasuredStatistics measured, std::optional<PredictedRange> predicted,
                          const AdequacyLimits& limits) {
    AdequacyRow row;
    row.biasLimit = limits.bias;
    row.measured = std::move(measured);
    row.predicted = predicted;
    const MeasuredStatistics& parts = row.measured;
    const bool hasScatter = parts.deviation && parts.count >= 2;
    if (hasScatter) {
        row.mean95 = studentInterval(parts.mean, *parts.deviation, parts.count, confidence95);
    }
    if (!predicted) {
        return row;
    }
    row.share = shareInside(parts, *predicted);
    if (row.mean95) {
        row.meanPlace = placeOfMean(*row.mean95, *predicted);
        row.bias95 = biasOf(parts, *predicted, *row.mean95, limits.uncertainty);
    }
    if (hasScatter && predicted->deviation && predicted->count >= 2) {
        row.scatter = varianceRatio(*parts.deviation, parts.count,
                                    std::hypot(*predicted->deviation, limits.uncertainty),
                                    predicted->count, confidence95);
    }
    row.verdict = verdictOf(row);
    return row;
}

std::vector<AdequacyRow> judgeAdequacy(const Project& project, const BatchResult& batch) {
    std::vector<AdequacyRow> rows;
    for (MeasuredStatistics& measured : statisticsOfMeasured(project)) {
        const auto range = predicted(batch, measured.quantity, measured.place);
        const AdequacyLimits limits = adequacyLimits(project, measured, range);
        rows.push_back(judgeAdequacy(std::move(measured), range, limits));
    }
    return rows;
}

bool speaksForModel(const std::vector<AdequacyRow>& rows) {
    return std::ranges::all_of(rows, [](const AdequacyRow& row) {
        return row.verdict == AdequacyVerdict::adequate
               || row.verdict == AdequacyVerdict::tooFewParts
               || row.verdict == AdequacyVerdict::notPredicted;
    });
}

std::optional<MeasuredBias> greatestBias(const Project& project,
                                         const std::vector<AdequacyRow>& rows) {
    constexpr double leastLimit_um = 1e-3; // of parts without scatter
    std::optional<MeasuredBias> found;
    double greatest = 0;
    for (const AdequacyRow& row : rows) {
        const ConstraintKind kind = requirementKind(row.measured.quantity);
        const bool isBiased = row.verdict == AdequacyVerdict::biased
                              || row.verdict == AdequacyVerdict::biasedAndScatters;
        if (!isBiased || !isPredictionWhole(kind, project)) {
            continue;
        }
        const double bias_um = (row.bias95->low + row.bias95->high) / 2;
        const double ratio = std::abs(bias_um) / std::max(row.biasLimit, leastLimit_um);
        if (ratio > greatest) {
            greatest = ratio;
            const int place = row.measured.place;
            const bool isZone = project.operation->travels && place >= 0;
            found = MeasuredBias{kind, isZone ? static_cast<Zone>(place) : Zone::section, place,
                                 bias_um};
        }
    }
    return found;
}

std::span<const Output<AdequacyOf>> adequacyOutputs() {
    return adequacyRows;
}

std::span<const Output<PredictedRange>> predictedOutputs() {
    return predictedRows;
}

std::span<const Output<VarianceRatio>> varianceRatioOutputs() {
    return ratioRows;
}

std::span<const Output<InsideShare>> insideShareOutputs() {
    return insideRows;
}

const char* keyOf(MeasuredQuantity quantity) {
    return choicesOf<MeasuredQuantity>()[static_cast<std::size_t>(quantity)].key;
}

const char* keyOf(AdequacyVerdict verdict) {
    constexpr std::array keys{"adequate",        "biased",
                              "scatter_differs", "biased_and_scatter_differs",
                              "too_few_parts",   "not_predicted"};
    return keys[static_cast<std::size_t>(verdict)];
}

const char* keyOf(MeanPlace place) {
    constexpr std::array keys{"inside", "below", "above", "undecided"};
    return keys[static_cast<std::size_t>(place)];
}

std::string placeKey(const Project& project, int place, First first) {
    return sectionOrPart(project.operation->travels && place >= 0 ? static_cast<Zone>(place)
                                                                  : Zone::section,
                         place, first);
}

} // namespace sparkout
