// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_batch.h"

#include "app/cli_report.h"
#include "core/batch/batch_outputs.h"
#include "core/batch/batch_state.h"
#include "core/batch/batch_statistics.h"
#include "core/digits.h"
#include "core/file/project_file.h"
#include "core/printable.h"
#include "core/project/validate.h"
#include "core/quality/result_names.h"

#include <string>

namespace sparkout::cli {

namespace {

/// "  ranks: stock_mm 0.93, dullness -0.04; R² 0.97"; empty without a regression.
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

std::string placeText(const Characteristic& of) {
    return sectionOrPart(of.zone, of.section, First::inTexts);
}

/// "conditionally fit: the lower 95 % bound of Ppk of rz1 diameter is 0.73, below 1".
std::string verdictText(const BatchVerdict& verdict, const BatchSummary& summary) {
    const std::string of =
        verdict.characteristic
            ? placeText(summary.characteristics[*verdict.characteristic].characteristic) + " "
                  + summary.characteristics[*verdict.characteristic].characteristic.name
            : std::string();
    const std::string limit = plainNumber(verdict.limit);
    switch (verdict.reason) {
    case BatchReason::noPart: return "unfit: no part was run";
    case BatchReason::partsFail:
        return "unfit: " + fixed(100 * verdict.value, 2) + " % of the parts are rejected, allowed "
               + plainNumber(100 * verdict.limit) + " %";
    case BatchReason::someFail:
        return "conditionally fit: some parts are rejected, but no more than the allowed "
               + plainNumber(100 * verdict.limit) + " %";
    case BatchReason::stopped: return "conditionally fit: not all parts were run";
    case BatchReason::noSample:
        return "conditionally fit: all corner combinations are good, but they are not a sample, so "
               "Ppk is not known";
    case BatchReason::fewParts: return "conditionally fit: Ppk cannot be computed from one part";
    case BatchReason::outside:
        return "conditionally fit: of " + of + " " + fixed(100 * verdict.value, 3)
               + " % are expected out of tolerance, allowed " + plainNumber(100 * verdict.limit)
               + " %";
    case BatchReason::ppk:
        return "conditionally fit: the lower 95 % bound of Ppk of " + of + " is "
               + fixed(verdict.value, decimalsBeside(verdict.limit, verdict.value, 2)) + ", below "
               + limit;
    case BatchReason::allHold:
        return of.empty() ? "fit: all parts are good, and their sizes hardly scatter"
                          : "fit: all parts are good, and the least lower 95 % bound of Ppk, of "
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
                + fixed(values[i], decimalsOf(values[i], 4));
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
std::string capabilityText(const char* name, const std::optional<Estimate>& capability) {
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
                     + " parts have no size, form and Ra: strips uncut; they have no Ppk\n";
}

/// "; 7 of 50 parts have none: strips uncut"; empty if all parts have the value.
std::string unstatedText(const CharacteristicSummary& summary) {
    return summary.unstated == 0 ? std::string()
                                 : "; " + std::to_string(summary.unstated) + " of "
                                       + std::to_string(summary.unstated + summary.count)
                                       + " parts have none: strips uncut";
}

std::string characteristicText(const CharacteristicSummary& summary, bool isSample) {
    const Characteristic& of = summary.characteristic;
    const int decimals = 3;
    std::string text = placeText(of) + " " + of.name + ", " + of.unit + ": ";
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

/// The usual causes of scatter that the batch leaves out.
std::string notCountedText(const Project& project) {
    std::string text;
    for (const FactorKind kind : notCounted(project)) {
        text += std::string(text.empty() ? "not counted: " : ", ") + factorKey(kind);
    }
    return text.empty() ? text : text + '\n';
}

} // namespace

std::string batchText(const BatchResult& result, const std::optional<SobolIndices>& indices) {
    const BatchSummary summary = summarise(result);
    std::string text =
        std::to_string(summary.parts) + " of " + std::to_string(result.batchParts) + " parts, "
        + batchStatusKey(result.status) + "\nverdict "
        + verdictText(weigh(summary, result), summary) + "\nrejected  " + shareText(summary.bad)
        + "; did not reach size " + std::to_string(summary.failed) + "\n" + strippedText(summary)
        + "worst part " + std::to_string(summary.worstPart + 1)
        + factorsText(result, summary.worstPart) + '\n' + notCountedText(result.project);
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

std::string joinText(const JoinedBatch& joined, const std::vector<BatchResult>& shards,
                     const std::vector<std::string>& files) {
    const auto parts = [](const PartRange& range) {
        return range.end - range.first == 1
                   ? "part " + std::to_string(range.end)
                   : "parts " + std::to_string(range.first + 1) + "…" + std::to_string(range.end);
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
    case StateFault::impossible: return "contains numbers that no batch produces";
    }
    return {};
}

} // namespace sparkout::cli
