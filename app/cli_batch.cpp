// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_batch.h"

#include "app/io/cli_report.h"
#include "core/batch/batch_state_reader.h"
#include "core/batch/part_table.h"
#include "core/format/project_file.h"
#include "core/printable.h"
#include "core/project/validate.h"
#include "core/tables/csv_line.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

constexpr std::array statusNames{"completed", "narrow_enough", "stopped", "refused"};

const char* statusName(BatchStatus status) {
    return statusNames[static_cast<std::size_t>(status)];
}

ordered_json intervalJson(const std::optional<Interval>& interval) {
    return interval ? ordered_json::array({interval->low, interval->high}) : ordered_json(nullptr);
}

ordered_json orNullJson(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json shareJson(const Share& share) {
    return {{"count", share.count},
            {"share", share.value},
            {"interval_95", intervalJson(share.interval)}};
}

ordered_json capabilityJson(const std::optional<Capability>& capability) {
    return capability ? ordered_json{{"value", capability->value},
                                     {"interval_95", intervalJson(capability->interval)}}
                      : ordered_json(nullptr);
}

const char* testKey(NormalityTest test) {
    return test == NormalityTest::shapiroWilk ? "shapiro_wilk" : "anderson_darling";
}

/// `cp` and `cpk`, of a process at rest, are those of a batch without a drift.
ordered_json characteristicJson(const CharacteristicSummary& summary, bool isSample, bool drifts) {
    const Characteristic& of = summary.characteristic;
    ordered_json json = {
        {"name", of.name},           {"where", placeKey(of)},       {"unit", of.unit},
        {"low", orNullJson(of.low)}, {"high", orNullJson(of.high)}, {"count", summary.count}};
    if (summary.unstated > 0) {
        json["strips_uncut"] = summary.unstated;
    }
    if (summary.count == 0) {
        return json;
    }
    json["min"] = summary.least.value;
    json["min_part"] = summary.least.part;
    json["max"] = summary.most.value;
    json["max_part"] = summary.most.part;
    json["outside"] = shareJson(summary.outside);
    if (!isSample) {
        return json;
    }
    json["mean"] = summary.moments.mean;
    json["mean_interval_95"] = intervalJson(summary.mean95);
    json["standard_deviation"] = summary.moments.deviation;
    json["skewness"] = summary.moments.skewness;
    json["excess_kurtosis"] = summary.moments.excess;
    json["normality_probability"] =
        summary.normality ? ordered_json(summary.normality->probability) : ordered_json(nullptr);
    json["normality_test"] =
        summary.normality ? ordered_json(testKey(summary.normality->test)) : ordered_json(nullptr);
    json["cp"] = drifts ? ordered_json(nullptr) : capabilityJson(summary.pp);
    json["cpk"] = drifts ? ordered_json(nullptr) : capabilityJson(summary.ppk);
    json["pp"] = capabilityJson(summary.pp);
    json["ppk"] = capabilityJson(summary.ppk);
    json["expected_outside"] = orNullJson(summary.expectedOutside);
    for (const Percentile& percentile : summary.percentiles) {
        json["percentiles"].push_back({{"order", percentile.order},
                                       {"value", percentile.value},
                                       {"interval_95", intervalJson(percentile.interval)}});
    }
    for (const HistogramBar& bar : summary.histogram) {
        json["histogram"].push_back({bar.low, bar.high, bar.count});
    }
    return json;
}

/// Parts by what makes them bad, the most frequent first.
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

/// Coefficients by factor; null where there is no regression.
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

/// "  ranks: stock_mm 0.93, dullness -0.04; R² 0.97"; nothing where there is no regression.
std::string regressionText(const std::optional<RankRegression>& regression,
                           const std::vector<GivenFactor>& factors) {
    if (!regression) {
        return {};
    }
    std::string text = "  rank regression:";
    for (std::size_t f = 0; f < factors.size(); ++f) {
        text += std::string(f == 0 ? " " : ", ") + factorKey(factors[f]) + " "
                + fixed(regression->coefficients[f], 2);
    }
    return text + "; R² " + fixed(regression->determination, 2) + '\n';
}

std::string sobolText(const std::vector<SobolIndex>& indices,
                      const std::vector<GivenFactor>& factors) {
    std::string text;
    for (std::size_t f = 0; f < indices.size(); ++f) {
        text += std::string(f == 0 ? "  Sobol indices, first and total: " : ", ")
                + factorKey(factors[f]) + " " + fixed(indices[f].first, 2) + " "
                + fixed(indices[f].total, 2);
    }
    return text.empty() ? text : text + '\n';
}

constexpr std::array fitnessNames{"conforms", "conditionally_conforms", "does_not_conform"};
constexpr std::array reasonNames{"no_part",          "parts_fail", "some_parts_fail",
                                 "stopped",          "no_sample",  "few_parts",
                                 "expected_outside", "ppk",        "all_hold"};

const char* fitnessName(const BatchVerdict& verdict) {
    return fitnessNames[static_cast<std::size_t>(verdict.fitness)];
}

ordered_json verdictJson(const BatchVerdict& verdict, const BatchSummary& summary) {
    ordered_json json = {{"fitness", fitnessName(verdict)},
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

/// "conforms conditionally: the lower 95 % bound of Ppk of rz1 diameter is 0.73, below 1".
std::string verdictText(const BatchVerdict& verdict, const BatchSummary& summary) {
    const std::string of =
        verdict.characteristic
            ? placeKey(summary.characteristics[*verdict.characteristic].characteristic) + " "
                  + summary.characteristics[*verdict.characteristic].characteristic.name
            : std::string();
    const std::string limit = numberText(verdict.limit);
    switch (verdict.reason) {
    case BatchReason::noPart: return "does not conform: no part was run";
    case BatchReason::partsFail:
        return "does not conform: " + fixed(100 * verdict.value, 2)
               + " % of the parts are not good, allowed " + numberText(100 * verdict.limit) + " %";
    case BatchReason::someFail:
        return "conforms conditionally: some parts are not good, but no more than the allowed "
               + numberText(100 * verdict.limit) + " %";
    case BatchReason::stopped: return "conforms conditionally: not all parts were run";
    case BatchReason::noSample:
        return "conforms conditionally: all corners hold, but they are no sample and tell no Ppk";
    case BatchReason::fewParts: return "conforms conditionally: a single part tells no Ppk";
    case BatchReason::outside:
        return "conforms conditionally: of " + of + " " + fixed(100 * verdict.value, 3)
               + " % are expected out of tolerance, allowed " + numberText(100 * verdict.limit)
               + " %";
    case BatchReason::ppk:
        return "conforms conditionally: the lower 95 % bound of Ppk of " + of + " is "
               + fixed(verdict.value, 2) + ", below " + limit;
    case BatchReason::allHold:
        return of.empty() ? "conforms: all parts hold, and none of their sizes scatters to speak of"
                          : "conforms: all parts hold, and the least lower 95 % bound of Ppk, of "
                                + of + ", is " + fixed(verdict.value, 2) + ", at least " + limit;
    }
    return {};
}

/// "stock_mm 0.14, dullness 0.03".
std::string factorsText(const BatchResult& result, std::int64_t part) {
    const ScenarioSource source(result.project);
    const std::vector<double> values = part < 0 ? std::vector<double>() : source.values(part);
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += std::string(i == 0 ? ": " : ", ") + factorKey(source.factors()[i]) + " "
                + numberText(values[i]);
    }
    return text;
}

std::string range(const Interval& interval, int decimals) {
    return fixed(interval.low, decimals) + "…" + fixed(interval.high, decimals);
}

std::string shareText(const Share& share) {
    std::string text = std::to_string(share.count) + " (" + fixed(100 * share.value, 2) + " %";
    if (share.interval) {
        text +=
            ", 95 %: " + range({100 * share.interval->low, 100 * share.interval->high}, 2) + " %";
    }
    return text + ")";
}

/// "Ppk 1.42 (1.20…1.64)".
std::string capabilityText(const char* name, const std::optional<Capability>& capability) {
    return capability ? std::string(", ") + name + " " + fixed(capability->value, 2) + " ("
                            + range(capability->interval, 2) + ")"
                      : std::string();
}

const char* testName(NormalityTest test) {
    return test == NormalityTest::shapiroWilk ? "(Shapiro-Wilk)" : "(Anderson-Darling)";
}

std::string strippedText(const BatchSummary& summary) {
    return summary.stripped == 0
               ? std::string()
               : std::to_string(summary.stripped) + " of " + std::to_string(summary.parts)
                     + " parts have no size, form and Ra: strips uncut; no Ppk is told of them\n";
}

/// "; 7 of 50 parts have none: strips uncut"; nothing where all have it.
std::string unstatedText(const CharacteristicSummary& summary) {
    return summary.unstated == 0 ? std::string()
                                 : "; " + std::to_string(summary.unstated) + " of "
                                       + std::to_string(summary.unstated + summary.count)
                                       + " parts have none: strips uncut";
}

std::string characteristicText(const CharacteristicSummary& summary, bool isSample) {
    const Characteristic& of = summary.characteristic;
    const int decimals = 3;
    std::string text = placeKey(of) + " " + of.name + ", " + of.unit + ": ";
    if (summary.count == 0) {
        return text + "none" + unstatedText(summary) + '\n';
    }
    text += range({summary.least.value, summary.most.value}, decimals);
    if (isSample) {
        text += ", mean " + fixed(summary.moments.mean, decimals);
        if (summary.mean95) {
            text += " (" + range(*summary.mean95, decimals) + ")";
        }
        text += ", s " + fixed(summary.moments.deviation, decimals)
                + capabilityText("Pp", summary.pp) + capabilityText("Ppk", summary.ppk);
        if (summary.normality) {
            text += ", normality " + std::string(testName(summary.normality->test)) + " p "
                    + fixed(summary.normality->probability, 3);
        }
    }
    if (of.low || of.high) {
        text += ", outside " + shareText(summary.outside);
    }
    return text + unstatedText(summary) + '\n';
}

std::string cell(const std::optional<double>& value) {
    return value ? numberText(*value) : std::string();
}

std::string cells(const std::optional<Interval>& interval) {
    return interval ? numberText(interval->low) + "," + numberText(interval->high) : ",";
}

std::string capabilityCells(const std::optional<Capability>& capability) {
    return capability ? numberText(capability->value) + "," + cells(capability->interval) : ",,";
}

} // namespace

std::string batchText(const BatchResult& result, const std::optional<SobolIndices>& indices) {
    const BatchSummary summary = summarise(result);
    std::string text = std::to_string(summary.parts) + " of " + std::to_string(result.batchParts)
                       + " parts, " + statusName(result.status) + "\nverdict "
                       + verdictText(weigh(summary, result), summary) + "\nnot good "
                       + shareText(summary.bad) + "; did not reach size "
                       + std::to_string(summary.failed) + "\n" + strippedText(summary)
                       + "worst part " + std::to_string(summary.worstPart) + " (from 0)"
                       + factorsText(result, summary.worstPart) + '\n';
    const auto regressions = rankRegressions(result);
    const auto factors = scatteredFactors(result.project);
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        text += characteristicText(summary.characteristics[i], summary.isSample);
        if (summary.isSample) {
            text += regressionText(regressions[i], factors);
        }
        if (indices) {
            text += sobolText(indices->byCharacteristic[i], factors);
        }
    }
    return text;
}

std::string batchJson(const BatchResult& result, const std::optional<SobolIndices>& indices) {
    const BatchSummary summary = summarise(result);
    ordered_json json = {{"engine_version", result.engineVersion},
                         {"status", statusName(result.status)},
                         {"batch", ordered_json::parse(writeProject(result.project)).at("batch")},
                         {"batch_parts", result.batchParts},
                         {"parts", summary.parts},
                         {"is_sample", summary.isSample},
                         {"did_not_reach_size", summary.failed},
                         {"strips_uncut", summary.stripped},
                         {"not_good", shareJson(summary.bad)},
                         {"rejects", rejectsJson(summary)},
                         {"verdict", verdictJson(weigh(summary, result), summary)},
                         {"drifts", summary.drifts},
                         {"exact_percentiles", summary.exactPercentiles},
                         {"characteristics", ordered_json::array()},
                         {"worst", worstJson(result, summary.worstPart)}};
    if (indices) {
        json["sobol_simulations"] = indices->simulations;
    }
    const auto regressions = rankRegressions(result);
    const auto factors = scatteredFactors(result.project);
    for (std::size_t i = 0; i < summary.characteristics.size(); ++i) {
        json["characteristics"].push_back(
            characteristicJson(summary.characteristics[i], summary.isSample, summary.drifts));
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
    std::string text = "where,characteristic,unit,low,high,count,min,max,mean,mean_low,mean_high,s,"
                       "cp,cp_low,cp_high,cpk,cpk_low,cpk_high,outside,outside_low,outside_high,"
                       "pp,pp_low,pp_high,ppk,ppk_low,ppk_high,expected_outside,normality,"
                       "normality_test,strips_uncut\n";
    const bool atRest = !summary.drifts;
    const std::optional<Capability> none;
    for (const CharacteristicSummary& row : summary.characteristics) {
        const Characteristic& of = row.characteristic;
        text += csvCell(placeKey(of)) + "," + csvCell(of.name) + "," + csvCell(of.unit) + ","
                + cell(of.low) + "," + cell(of.high) + "," + std::to_string(row.count) + ",";
        if (row.count == 0) {
            text += ",,,,,,,,,,,,,,,,,,,,,,,," + std::to_string(row.unstated) + "\n";
            continue;
        }
        const bool sample = summary.isSample;
        text += numberText(row.least.value) + "," + numberText(row.most.value) + ","
                + (sample ? numberText(row.moments.mean) : "") + "," + cells(row.mean95) + ","
                + (sample ? numberText(row.moments.deviation) : "") + ","
                + capabilityCells(atRest ? row.pp : none) + ","
                + capabilityCells(atRest ? row.ppk : none) + "," + numberText(row.outside.value)
                + "," + cells(row.outside.interval) + "," + capabilityCells(row.pp) + ","
                + capabilityCells(row.ppk) + "," + cell(row.expectedOutside) + ","
                + (row.normality ? numberText(row.normality->probability) : "") + ","
                + (row.normality ? testKey(row.normality->test) : "") + ","
                + std::to_string(row.unstated) + "\n";
    }
    return text;
}

std::string joinText(const JoinedBatch& joined, const std::vector<BatchResult>& shards,
                     const std::vector<std::string>& files) {
    const auto parts = [](const PartRange& range) {
        return range.end - range.first == 1
                   ? "part " + std::to_string(range.first)
                   : "parts " + std::to_string(range.first) + "…" + std::to_string(range.end - 1);
    };
    std::string text;
    const std::string model =
        joined.fault == JoinFault::nothing ? std::string() : printable(files[joined.model]);
    switch (joined.fault) {
    case JoinFault::none: break;
    case JoinFault::nothing: text = "no shards are given\n"; break;
    case JoinFault::otherProject:
        for (const std::size_t i : joined.foreign) {
            text += printable(files[i]) + ": of another batch (project "
                    + projectDigest(shards[i].project) + ", " + std::to_string(shards[i].batchParts)
                    + " parts) than " + model + " (project "
                    + projectDigest(shards[joined.model].project) + ", "
                    + std::to_string(shards[joined.model].batchParts) + " parts)\n";
        }
        break;
    case JoinFault::otherEngine:
        for (const std::size_t i : joined.foreign) {
            text += printable(files[i]) + ": of another build of the engine ("
                    + shards[i].engineVersion + ", " + shards[i].build + ") than " + model + " ("
                    + shards[joined.model].engineVersion + ", " + shards[joined.model].build
                    + ")\n";
        }
        break;
    case JoinFault::overlap:
        for (const JoinedBatch::Doubled& both : joined.doubled) {
            text += printable(files[both.second]) + ": holds " + parts(both.parts) + ", as does "
                    + printable(files[both.first]) + '\n';
        }
        [[fallthrough]];
    case JoinFault::incomplete:
        for (const std::size_t i : joined.stopped) {
            text += printable(files[i]) + ": was ended after "
                    + std::to_string(shards[i].statistics.parts) + " of "
                    + std::to_string(shards[i].range.end - shards[i].range.first) + " parts\n";
        }
        for (const PartRange& range : joined.missing) {
            text += parts(range) + " of " + std::to_string(shards.front().batchParts)
                    + (range.end - range.first == 1 ? " is" : " are") + " in no shard\n";
        }
        break;
    }
    return text;
}

std::string stateSentence(StateFault fault) {
    switch (fault) {
    case StateFault::none: break;
    case StateFault::otherFormat: return "not a shard of a batch";
    case StateFault::tooDeep:
        return "not a shard of a batch: nested deeper than " + std::to_string(limits::depth)
               + " levels";
    case StateFault::otherVersion: return "a shard of another version of Sparkout; run it again";
    case StateFault::changed: return "changed since it was written (its checksum does not fit)";
    case StateFault::impossible: return "holds numbers that no batch gives";
    }
    return {};
}

} // namespace sparkout::cli
