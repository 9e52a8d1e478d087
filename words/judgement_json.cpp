// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/judgement_json.h"

#include "core/format/output_json.h"
#include "core/format/strict_json.h"
#include "core/quality/constraints.h"
#include "core/quality/result_json.h"
#include "words/judgement_words.h"

#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr Output<Judgement> judgementRows[] = {
    {{.key = "state",
      .hint = "the first that applies: not_computed, fails, stocks_fail, batch_fails, "
              "measured_differ, undecided, close, batch_not_run, batch, every_stock, nominal"},
     [](const Judgement& j) { return std::string(stateKey(j.state)); }},
    {{.key = "headline", .hint = "the same in words"},
     [](const Judgement& j) { return JudgementWording().headline(j); }},
    {{.key = "nominal",
      .hint = "whether the part that was run reaches size and meets every requirement"},
     [](const Judgement& j) { return j.isNominalGood(); }},
};

constexpr Output<StocksDecision> stocksRows[] = {
    {{.key = "decided",
      .hint = "whether the stocks within one infeed are; not under position control, nor of a "
              "cycle of too many passes"},
     [](const StocksDecision& s) { return s.has_value(); }},
    {{.key = "holds", .hint = "whether every requirement is met for each of these stocks"},
     [](const StocksDecision& s) { return s ? std::optional(s->holds) : std::nullopt; }},
    {{.key = "stock_mm", .unit = "mm", .hint = "range of stocks per side"},
     [](const StocksDecision& s) {
         return s ? std::optional(Interval{s->range.from_mm, s->range.to_mm}) : std::nullopt;
     }},
    {{.key = "failing_share", .hint = "share of these stocks for which a requirement fails, 0…1"},
     [](const StocksDecision& s) { return s ? std::optional(s->failingShare) : std::nullopt; }},
};

constexpr Output<JudgedBatch> batchRows[] = {
    {{.key = "parts", .hint = "parts that were run"}, [](const JudgedBatch& b) { return b.parts; }},
    {{.key = "seed", .hint = "number that their scatter is drawn by"},
     [](const JudgedBatch& b) { return std::int64_t{b.seed}; }},
    {{.key = "bad", .hint = "parts that are not good"}, [](const JudgedBatch& b) { return b.bad; }},
    {{.key = "interval_95", .hint = "of the share that is not good; null for corners"},
     [](const JudgedBatch& b) { return b.interval; }},
    {{.key = "low_ppk_95",
      .hint = "of the least P_pk, where that or the expected share outside misses the batch's "
              "limit; else null"},
     [](const JudgedBatch& b) { return b.lowPpk; }},
};

ordered_json judgementJson(const Judgement& judgement) {
    ordered_json json = outputsJson(judgementOutputs(), judgement);
    json["stocks"] = outputsJson(judgedStocksOutputs(), judgement.stocks);
    json["stocks"]["worst"] = outputsJson(
        requirementOutputs(), judgement.stocks ? judgement.stocks->worst : std::nullopt);
    json["batch"] = outputsJson(judgedBatchOutputs(), judgement.batch);
    json["not_decided"] = outputsJsonOfEach(undecidedOutputs(), judgement.notDecided);
    return json;
}

} // namespace

std::span<const Output<Judgement>> judgementOutputs() {
    return judgementRows;
}

std::span<const Output<StocksDecision>> judgedStocksOutputs() {
    return stocksRows;
}

std::span<const Output<JudgedBatch>> judgedBatchOutputs() {
    return batchRows;
}

std::string judgedResultJson(const SimulationResult& result,
                             const std::vector<ConstraintResult>& constraints,
                             const Judgement& judgement) {
    ordered_json json = ordered_json::parse(resultJson(result, constraints));
    json["judged"] = judgementJson(judgement);
    return printJson(json);
}

} // namespace sparkout
