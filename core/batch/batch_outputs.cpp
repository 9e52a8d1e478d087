// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_outputs.h"

#include "core/batch/batch_statistics.h"
#include "core/batch/characteristics.h"
#include "core/file/csv_line.h"
#include "core/file/output_json.h"
#include "core/file/project_file.h"
#include "core/text.h"

#include <array>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

using Figures = CharacteristicFigures;
using nlohmann::ordered_json;

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

// Outputs as columns of a CSV table: an interval takes two columns, an estimate and a share three.

constexpr double emptyCell = std::numeric_limits<double>::quiet_NaN();

void addInterval(CsvLine& line, const std::optional<Interval>& interval) {
    line.number(interval ? interval->low : emptyCell).number(interval ? interval->high : emptyCell);
}

void addCsvHeads(CsvLine& line, const OutputRow& row, OutputKind kind) {
    const std::string name = row.columnName();
    if (name.empty()) {
        return;
    }
    if (kind != OutputKind::interval) {
        line.text(name);
    }
    if (kind == OutputKind::interval || kind == OutputKind::estimate || kind == OutputKind::share) {
        line.text(name + "_low").text(name + "_high");
    }
}

void addCsvCells(CsvLine& line, OutputKind kind, const OutputValue& value) {
    switch (kind) {
    case OutputKind::number:
    case OutputKind::optionalNumber: {
        const auto* number = std::get_if<double>(&value);
        line.number(number ? *number : emptyCell);
        break;
    }
    case OutputKind::whole:
    case OutputKind::optionalWhole: {
        const auto* whole = std::get_if<std::int64_t>(&value);
        whole ? line.whole(*whole) : line.empty();
        break;
    }
    case OutputKind::truth:
    case OutputKind::optionalTruth: {
        const auto* truth = std::get_if<bool>(&value);
        line.text(!truth ? "" : *truth ? "true" : "false");
        break;
    }
    case OutputKind::text:
    case OutputKind::optionalText: {
        const auto* text = std::get_if<std::string>(&value);
        line.text(text ? *text : std::string());
        break;
    }
    case OutputKind::interval: {
        const auto* interval = std::get_if<Interval>(&value);
        addInterval(line, interval ? std::optional(*interval) : std::nullopt);
        break;
    }
    case OutputKind::estimate: {
        const auto* estimate = std::get_if<Estimate>(&value);
        line.number(estimate ? estimate->value : emptyCell);
        addInterval(line, estimate ? std::optional(estimate->interval) : std::nullopt);
        break;
    }
    case OutputKind::share: {
        const auto* share = std::get_if<Share>(&value);
        line.number(share ? share->value : emptyCell);
        addInterval(line, share ? share->interval : std::nullopt);
        break;
    }
    }
}

ordered_json characteristicJson(const CharacteristicFigures& figures) {
    ordered_json json = outputsJson(characteristicOutputs(), figures);
    const CharacteristicSummary& summary = *figures.of;
    if (!figures.isSample || summary.count == 0) {
        return json;
    }
    for (const Percentile& percentile : summary.percentiles) {
        json["percentiles"].push_back(
            {{"order", percentile.order},
             {"value", percentile.value},
             {"interval_95",
              percentile.interval ? outputJson(*percentile.interval) : ordered_json(nullptr)}});
    }
    for (const HistogramBar& bar : summary.histogram) {
        json["histogram"].push_back({bar.low, bar.high, bar.count});
    }
    return json;
}

ordered_json notCountedJson(const Project& project) {
    ordered_json json = ordered_json::array();
    for (const FactorKind kind : notCounted(project)) {
        json.push_back(factorKey(kind));
    }
    return json;
}

/// Parts by cause of rejection, the most frequent first.
ordered_json rejectsJson(const BatchSummary& summary) {
    ordered_json json = ordered_json::object();
    for (const RejectCause& cause : summary.causes) {
        json[cause.kind ? requirementOf(*cause.kind).key : "size_not_reached"] = cause.count;
    }
    return json;
}

ordered_json worstJson(const BatchResult& result, std::int64_t part) {
    if (part < 0) {
        return nullptr;
    }
    const ScenarioSource source(result.project);
    const std::vector<double> values = source.values(part);
    ordered_json factors = ordered_json::object();
    for (std::size_t i = 0; i < values.size(); ++i) {
        factors[factorKey(source.factors()[i])] = values[i];
    }
    return {{"part", part},
            {"factors", std::move(factors)},
            {"project", ordered_json::parse(writeProject(source.project(part)))}};
}

/// Coefficients by factor; null if the ranks could not be regressed.
ordered_json regressionJson(const std::optional<RankRegression>& regression,
                            const std::vector<GivenFactor>& factors, std::int64_t batchParts) {
    if (!regression) {
        return nullptr;
    }
    ordered_json coefficients = ordered_json::object();
    for (std::size_t f = 0; f < factors.size(); ++f) {
        coefficients[factorKey(factors[f])] = regression->coefficients[f];
    }
    return {{"coefficients", std::move(coefficients)},
            {"determination", regression->determination},
            {"of_parts_below", batchParts}};
}

/// Indices by factor; null for a characteristic that does not vary.
ordered_json sobolJson(const std::vector<SobolIndex>& indices,
                       const std::vector<GivenFactor>& factors) {
    if (indices.empty()) {
        return nullptr;
    }
    ordered_json json = ordered_json::object();
    for (std::size_t f = 0; f < factors.size(); ++f) {
        json[factorKey(factors[f])] = {{"first", indices[f].first}, {"total", indices[f].total}};
    }
    return json;
}

constexpr std::array fitnessNames{"conforms", "conditionally_conforms", "does_not_conform"};
constexpr std::array reasonNames{"no_part",          "parts_fail", "some_parts_fail",
                                 "stopped",          "no_sample",  "few_parts",
                                 "expected_outside", "ppk",        "all_hold"};

ordered_json verdictJson(const BatchVerdict& verdict, const BatchSummary& summary) {
    ordered_json json = {{"fitness", fitnessNames[static_cast<std::size_t>(verdict.fitness)]},
                         {"decided_by", reasonNames[static_cast<std::size_t>(verdict.reason)]},
                         {"value", verdict.value},
                         {"limit", verdict.limit}};
    if (verdict.characteristic) {
        const Characteristic& of = summary.characteristics[*verdict.characteristic].characteristic;
        json["where"] = placeKey(of);
        json["name"] = of.name;
    }
    return json;
}

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

const char* batchStatusKey(BatchStatus status) {
    constexpr std::array keys{"completed", "narrow_enough", "stopped", "refused"};
    return keys[static_cast<std::size_t>(status)];
}

std::string batchJson(const BatchResult& result, const std::optional<SobolIndices>& indices) {
    const BatchSummary summary = summarise(result);
    ordered_json json = {{"engine_version", result.engineVersion},
                         {"status", batchStatusKey(result.status)},
                         {"batch", ordered_json::parse(writeProject(result.project)).at("batch")},
                         {"batch_parts", result.batchParts},
                         {"parts", summary.parts},
                         {"is_sample", summary.isSample},
                         {"did_not_reach_size", summary.failed},
                         {"strips_uncut", summary.stripped},
                         {"not_good", outputJson(summary.bad)},
                         {"rejects", rejectsJson(summary)},
                         {"verdict", verdictJson(weigh(summary, result), summary)},
                         {"drifts", summary.drifts},
                         {"not_counted", notCountedJson(result.project)},
                         {"exact_percentiles", summary.exactPercentiles},
                         {"characteristics", ordered_json::array()},
                         {"worst", worstJson(result, summary.worstPart)}};
    if (indices) {
        json["sobol_simulations"] = indices->simulations;
    }
    const auto regressions = rankRegressions(result);
    const auto factors = scatteredFactors(result.project);
    const std::vector<CharacteristicFigures> figures = figuresOf(summary);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        json["characteristics"].push_back(characteristicJson(figures[i]));
        if (summary.isSample) {
            json["characteristics"].back()["standardised_rank_regression"] =
                regressionJson(regressions[i], factors, result.batchParts);
        }
        if (indices) {
            json["characteristics"].back()["sobol_indices"] =
                sobolJson(indices->byCharacteristic[i], factors);
        }
    }
    return json.dump(2) + '\n';
}

std::string batchCsv(const BatchResult& result) {
    const BatchSummary summary = summarise(result);
    CsvLine line;
    for (const Output<Figures>& row : characteristicRows) {
        addCsvHeads(line, row, row.kind());
    }
    std::string text = line.end();
    for (const Figures& figures : figuresOf(summary)) {
        for (const Output<Figures>& row : characteristicRows) {
            if (*row.columnName()) {
                addCsvCells(line, row.kind(), row.of(figures));
            }
        }
        text += line.end();
    }
    return text;
}

} // namespace sparkout
