// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/adequacy/adequacy_outputs.h"

#include "core/quality/result_names.h"
#include "core/text.h"

#include <array>
#include <cstddef>

namespace sparkout {

namespace {

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

std::string placeKey(const Project& project, int place) {
    return sectionOrPart(project.operation->hasZones && place >= 0 ? static_cast<Zone>(place)
                                                                   : Zone::section,
                         place);
}

} // namespace sparkout
