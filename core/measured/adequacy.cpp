// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/adequacy.h"

#include "core/batch/batch_statistics.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/quality/requirement.h"
#include "core/quality/result_names.h"
#include "core/quality/roughness.h"
#include "core/statistics/intervals.h"
#include "core/text.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

using Key = std::pair<MeasuredQuantity, int>;

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

int placeOf(MeasuredQuantity quantity, int place) {
    return quantity == MeasuredQuantity::cylindricity ? -1 : place;
}

MeasuredStatistics ofValues(const Key& key, std::vector<double> values) {
    MeasuredStatistics found;
    found.quantity = key.first;
    found.place = key.second;
    found.count = static_cast<std::int64_t>(values.size());
    std::ranges::sort(values);
    found.mean = meanOf(values);
    found.least = values.front();
    found.greatest = values.back();
    if (found.count >= 2) {
        const double squares =
            std::accumulate(values.begin(), values.end(), 0.0, [&found](double sum, double value) {
                return sum + (value - found.mean) * (value - found.mean);
            });
        found.deviation = std::sqrt(squares / static_cast<double>(found.count - 1));
    }
    found.values = std::move(values);
    return found;
}

// The interval of a mean is t·s/√n on either side, from which s follows.
MeasuredStatistics ofSummary(const MeasuredSummary& summary) {
    MeasuredStatistics found;
    found.quantity = summary.quantity;
    found.place = placeOf(summary.quantity, summary.place);
    found.count = summary.count;
    found.mean = summary.mean_um;
    found.deviation = summary.deviation_um;
    found.least = summary.least_um;
    found.greatest = summary.greatest_um;
    found.isSummary = true;
    if (!found.deviation && summary.half_width_um && summary.count >= 2) {
        const auto n = static_cast<double>(summary.count);
        found.deviation = *summary.half_width_um * std::sqrt(n)
                          / studentQuantile((1 + summary.confidence) / 2, n - 1);
    }
    return found;
}

} // namespace

std::vector<MeasuredStatistics> statisticsOfMeasured(const Project& project) {
    std::vector<MeasuredStatistics> found;
    if (!project.measured) {
        return found;
    }
    const Measured& measured = *project.measured;
    const int places = placeCount(project);
    std::map<Key, std::vector<double>> values;
    for (const MeasuredPart& part : measured.parts) {
        if (part.place >= places) {
            continue;
        }
        const auto add = [&](MeasuredQuantity quantity, std::optional<double> value) {
            if (value) {
                values[{quantity, placeOf(quantity, part.place)}].push_back(*value);
            }
        };
        if (!part.diameters_mm.empty()) {
            add(MeasuredQuantity::diameter_deviation,
                (meanOf(part.diameters_mm) - project.part->diameter_mm) * units::umPerMm);
        }
        add(MeasuredQuantity::radial_runout, part.radial_runout_um);
        add(MeasuredQuantity::roundness, part.roundness_um);
        add(MeasuredQuantity::cylindricity, part.cylindricity_um);
        add(MeasuredQuantity::roughness_ra, part.roughness_ra_um);
    }
    for (auto& [key, list] : values) {
        found.push_back(ofValues(key, std::move(list)));
    }
    for (const MeasuredSummary& summary : measured.summaries) {
        if (summary.place < places) {
            found.push_back(ofSummary(summary));
        }
    }
    return found;
}

namespace {

bool isOf(const Characteristic& characteristic, MeasuredQuantity quantity, int place) {
    const Requirement* const row = characteristic.requirement;
    const auto is = [row](ConstraintKind kind) { return row && row->kind == kind; };
    const bool here = characteristic.section == place || characteristic.section < 0;
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation:
        return !row && characteristic.section == place && place >= 0;
    case MeasuredQuantity::radial_runout: return here && is(ConstraintKind::radialRunout);
    case MeasuredQuantity::roundness: return here && is(ConstraintKind::roundness);
    case MeasuredQuantity::cylindricity: return is(ConstraintKind::cylindricity);
    case MeasuredQuantity::roughness_ra: return here && is(ConstraintKind::roughness);
    }
    return false;
}

/// The least value of a rank whose share is at least `order`.
double quantileOf(const std::vector<double>& sorted, double order) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(order * static_cast<double>(sorted.size()) - 1e-9));
    return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

} // namespace

Quartiles quartilesOf(const std::vector<double>& sorted) {
    return {quantileOf(sorted, 0.25), quantileOf(sorted, 0.5), quantileOf(sorted, 0.75)};
}

Project predictingProject(Project project) {
    if (!project.batch) {
        project.batch.emplace();
    }
    constexpr double anyForm_um = 1000, anyRoughness_um = 100; // greatest values of a drawing
    Tolerance& tolerance = project.part->tolerance;
    tolerance.roundness_um = tolerance.roundness_um.value_or(anyForm_um);
    tolerance.cylindricity_um = tolerance.cylindricity_um.value_or(anyForm_um);
    tolerance.roughness_ra_um = tolerance.roughness_ra_um.value_or(anyRoughness_um);
    project.measured.reset();
    return project;
}

std::optional<PredictedRange> predicted(const BatchResult& batch, MeasuredQuantity quantity,
                                        int place) {
    const std::vector<Characteristic> all = characteristicsOf(batch.project);
    const auto found = std::ranges::find_if(
        all, [&](const Characteristic& one) { return isOf(one, quantity, place); });
    const auto index = static_cast<std::size_t>(found - all.begin());
    if (found == all.end() || index >= batch.statistics.values.size()
        || batch.statistics.values[index].count == 0) {
        return std::nullopt;
    }
    const ValueStatistics& values = batch.statistics.values[index];
    const Moments moments = momentsOf(values);
    PredictedRange range{values.least.value, values.most.value,  moments.mean,      {},
                         values.count,       values.least.value, values.most.value, {}};
    const bool isSample = batch.project.batch->scenarios != Scenarios::corners;
    // A scatter by rounding alone counts as none.
    if (!isSample || values.count < 2 || !(moments.deviation > found->resolution * 1e-6)) {
        return range;
    }
    range.deviation = moments.deviation;
    std::vector<double> sorted;
    for (const PartRow& row : batch.statistics.rows) {
        if (std::isfinite(row.values[index])) {
            sorted.push_back(row.values[index]);
        }
    }
    std::ranges::sort(sorted);
    constexpr double tail = (1 - confidence95) / 2;
    if (!sorted.empty()) {
        range.low = quantileOf(sorted, tail);
        range.high = quantileOf(sorted, 1 - tail);
        range.quartiles = quartilesOf(sorted);
    }
    return range;
}

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

} // namespace

ConstraintKind requirementOn(MeasuredQuantity quantity) {
    switch (quantity) {
    case MeasuredQuantity::diameter_deviation: break;
    case MeasuredQuantity::radial_runout: return ConstraintKind::radialRunout;
    case MeasuredQuantity::roundness: return ConstraintKind::roundness;
    case MeasuredQuantity::cylindricity: return ConstraintKind::cylindricity;
    case MeasuredQuantity::roughness_ra: return ConstraintKind::roughness;
    }
    return ConstraintKind::diameterMin;
}

namespace {

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
      .hint = SPARKOUT_NOOP(
          "Output",
          "Measured minus predicted mean: Welch's interval, 95 %, with the measuring uncertainty")},
     [](const AdequacyOf& a) { return a.row.bias95; }},
    {{.key = "bias_limit_um",
      .label = SPARKOUT_NOOP("Output", "Limit of bias"),
      .unit = "µm",
      .hint =
          SPARKOUT_NOOP("Output", "Largest difference at which the two means count as the same")},
     [](const AdequacyOf& a) { return a.row.biasLimit; }},
    {{.key = "mean_place",
      .hint = "position of the interval of the mean relative to the predicted range, the criterion "
              "of the sources: inside, below, above or undecided"},
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
    {{.key = "probability", .hint = "probability of a ratio at least so far from 1 by chance"},
     [](const VarianceRatio& v) { return v.probability; }},
};

constexpr Output<InsideShare> insideRows[] = {
    {{.key = "count", .label = SPARKOUT_NOOP("Output", "Parts inside")},
     [](const InsideShare& s) { return s.inside; }},
    {{.key = "of", .hint = "measured parts"}, [](const InsideShare& s) { return s.count; }},
    {{.key = "interval_95",
      .label = SPARKOUT_NOOP("Output", "Share inside"),
      .hint = SPARKOUT_NOOP("Output", "Measured parts within the predicted range, as a share with "
                                      "the 95 % bounds of Clopper and Pearson")},
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
        const ConstraintKind kind = requirementOn(row.measured.quantity);
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
