// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch_json.h"

#include "core/batch/batch_outputs.h"
#include "core/batch/batch_verdict.h"
#include "core/batch/part_table.h"
#include "core/format/output_csv.h"
#include "core/format/output_json.h"
#include "core/format/project_file.h"

#include <array>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

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
    return outputsCsv(characteristicOutputs(), figuresOf(summary));
}

} // namespace sparkout
