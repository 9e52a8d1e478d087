// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_outputs.h"

#include "core/batch/characteristics.h"
#include "core/batch/part_table.h"
#include "core/text.h"

#include <cmath>

namespace sparkout {

namespace {

using Figures = CharacteristicFigures;

bool counted(const Figures& f) {
    return f.of->count > 0;
}

bool sampled(const Figures& f) {
    return counted(f) && f.isSample;
}

/// Moments need at least two parts. NaN marks a moment lost to rounding.
std::optional<double> ifSampled(const Figures& f, double value) {
    return sampled(f) && f.of->count > 1 && !std::isnan(value) ? std::optional(value)
                                                               : std::nullopt;
}

/// An estimate for a batch without drift.
std::optional<Estimate> atRest(const Figures& f, const std::optional<Estimate>& index) {
    return f.drifts ? std::nullopt : index;
}

constexpr Output<Figures> characteristicRows[] = {
    {{.key = "where"}, [](const Figures& f) { return placeKey(f.of->characteristic); }},
    {{.key = "name", .column = "characteristic"},
     [](const Figures& f) { return std::string(f.of->characteristic.name); }},
    {{.key = "unit"}, [](const Figures& f) { return std::string(f.of->characteristic.unit); }},
    {{.key = "machine_known", .column = "", .detail = true},
     [](const Figures& f) { return f.of->characteristic.knowsMachine; },
     nullptr,
     [](const Figures& f) {
         const Requirement* const row = f.of->characteristic.requirement;
         return row && isPrinted(row->kind);
     }},
    {{.key = "low", .label = SPARKOUT_NOOP("Output", "Lower limit"), .detail = true},
     [](const Figures& f) { return f.of->characteristic.low; }},
    {{.key = "high", .label = SPARKOUT_NOOP("Output", "Upper limit"), .detail = true},
     [](const Figures& f) { return f.of->characteristic.high; }},
    {{.key = "count", .label = SPARKOUT_NOOP("Output", "Values"), .detail = true},
     [](const Figures& f) { return f.of->count; }},
    {{.key = "min", .label = SPARKOUT_NOOP("Output", "Minimum")},
     [](const Figures& f) { return counted(f) ? std::optional(f.of->least.value) : std::nullopt; },
     nullptr,
     counted},
    {{.key = "min_part", .column = "", .detail = true},
     [](const Figures& f) { return f.of->least.part; },
     nullptr,
     counted},
    {{.key = "max", .label = SPARKOUT_NOOP("Output", "Maximum")},
     [](const Figures& f) { return counted(f) ? std::optional(f.of->most.value) : std::nullopt; },
     nullptr,
     counted},
    {{.key = "max_part", .column = "", .detail = true},
     [](const Figures& f) { return f.of->most.part; },
     nullptr,
     counted},
    {{.key = "mean", .label = SPARKOUT_NOOP("Output", "Mean")},
     [](const Figures& f) { return ifSampled(f, f.of->moments.mean); },
     nullptr,
     sampled},
    {{.key = "mean_interval_95",
      .column = "mean",
      .label = SPARKOUT_NOOP("Output", "Mean"),
      .brief = SPARKOUT_NOOP("Output", "Mean, 95 %"),
      .hint = SPARKOUT_NOOP("Output", "Student's interval: with 95 % confidence it contains the "
                                      "mean of an unlimited number of such parts")},
     [](const Figures& f) { return f.of->mean95; },
     nullptr,
     sampled},
    {{.key = "standard_deviation",
      .column = "s",
      .label = SPARKOUT_NOOP("Output", "s"),
      .hint = SPARKOUT_NOOP("Output", "Standard deviation of the sample")},
     [](const Figures& f) { return ifSampled(f, f.of->moments.deviation); },
     nullptr,
     sampled},
    {{.key = "skewness",
      .column = "",
      .label = SPARKOUT_NOOP("Output", "Skewness"),
      .detail = true},
     [](const Figures& f) { return ifSampled(f, f.of->moments.skewness); },
     nullptr,
     sampled},
    {{.key = "excess_kurtosis",
      .column = "",
      .label = SPARKOUT_NOOP("Output", "Excess kurtosis"),
      .detail = true},
     [](const Figures& f) { return ifSampled(f, f.of->moments.excess); },
     nullptr,
     sampled},
    {{.key = "cp"}, [](const Figures& f) { return atRest(f, f.of->pp); }, nullptr, sampled},
    {{.key = "cpk"}, [](const Figures& f) { return atRest(f, f.of->ppk); }, nullptr, sampled},
    {{.key = "pp",
      .label = SPARKOUT_NOOP("Output", "Pp"),
      .hint = SPARKOUT_NOOP("Output",
                            "Width of the field over 6 s, with 95 % bounds; s is that of all parts "
                            "and includes any drift over the batch. Without drift Pp equals Cp")},
     [](const Figures& f) { return f.of->pp; },
     nullptr,
     sampled},
    {{.key = "ppk",
      .label = SPARKOUT_NOOP("Output", "Ppk"),
      .hint = SPARKOUT_NOOP("Output",
                            "Distance from the mean to the nearer limit over 3 s, with 95 % "
                            "bounds; it is meaningful for a normal quantity. A dash: not a size or "
                            "form of the part, or one that hardly scatters beside its field")},
     [](const Figures& f) { return f.of->ppk; },
     nullptr,
     sampled},
    {{.key = "outside",
      .label = SPARKOUT_NOOP("Output", "Out of tolerance"),
      .hint = SPARKOUT_NOOP("Output",
                            "Parts beyond the limits, as a share with the 95 % bounds of Clopper "
                            "and Pearson")},
     [](const Figures& f) {
         const Characteristic& of = f.of->characteristic;
         return counted(f) && (of.low || of.high) ? std::optional(f.of->outside) : std::nullopt;
     },
     nullptr,
     counted},
    {{.key = "expected_outside",
      .label = SPARKOUT_NOOP("Output", "Expected share out of tolerance"),
      .detail = true},
     [](const Figures& f) { return f.of->expectedOutside; },
     nullptr,
     sampled},
    {{.key = "normality_probability",
      .column = "normality",
      .label = SPARKOUT_NOOP("Output", "Normality, p"),
      .hint = SPARKOUT_NOOP("Output",
                            "Probability that normal values deviate so much from the normal law, "
                            "by the test of Shapiro and Wilk, of more than 4096 parts of Anderson "
                            "and Darling; below 0.05 the values are called not normal")},
     [](const Figures& f) {
         return f.of->normality ? std::optional(f.of->normality->probability) : std::nullopt;
     },
     nullptr,
     sampled},
    {{.key = "normality_test", .detail = true},
     [](const Figures& f) -> std::optional<std::string> {
         if (!f.of->normality) {
             return {};
         }
         return f.of->normality->test == NormalityTest::shapiroWilk ? "shapiro_wilk"
                                                                    : "anderson_darling";
     },
     nullptr,
     sampled},
    {{.key = "strips_uncut", .detail = true},
     [](const Figures& f) { return f.of->unstated; },
     nullptr,
     [](const Figures& f) { return f.of->unstated > 0; }},
};

} // namespace

std::vector<CharacteristicFigures> figuresOf(const BatchSummary& summary) {
    std::vector<CharacteristicFigures> figures;
    for (const CharacteristicSummary& each : summary.characteristics) {
        figures.push_back({&each, summary.isSample, summary.drifts});
    }
    return figures;
}

std::span<const Output<CharacteristicFigures>> characteristicOutputs() {
    return characteristicRows;
}

} // namespace sparkout
