// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/judgement_words.h"

#include "core/digits.h"
#include "core/file/output_json.h"
#include "core/file/strict_json.h"
#include "core/quality/constraints.h"
#include "core/quality/result_json.h"
#include "core/quality/result_names.h"
#include "core/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr Output<Judgement> judgementRows[] = {
    {{.key = "state",
      .hint = "the first that applies: not_computed, fails, stocks_fail, batch_fails, "
              "measured_differ, undecided, close, batch_not_run, batch, every_stock, nominal"},
     [](const Judgement& j) { return std::string(stateKey(j.state)); }},
    {{.key = "headline", .hint = "the state in words"},
     [](const Judgement& j) { return JudgementWording().headline(j); }},
    {{.key = "nominal",
      .hint = "whether the part that was run reaches size and meets every requirement"},
     [](const Judgement& j) { return j.isNominalGood(); }},
};

constexpr Output<StocksDecision> stocksRows[] = {
    {{.key = "decided",
      .hint = "whether the stocks within one infeed are decided; not under position control, nor "
              "for a cycle of too many passes"},
     [](const StocksDecision& s) { return s.has_value(); }},
    {{.key = "holds", .hint = "whether every requirement is met for each of these stocks"},
     [](const StocksDecision& s) { return s ? std::optional(s->holds) : std::nullopt; }},
    {{.key = "stock_mm", .unit = "mm", .hint = "range of stocks per side"},
     [](const StocksDecision& s) {
         return s ? std::optional(Interval{s->range.from_mm, s->range.to_mm}) : std::nullopt;
     }},
    {{.key = "failing_share",
      .hint = "share of these stocks for which a requirement is not met, 0…1"},
     [](const StocksDecision& s) { return s ? std::optional(s->failingShare) : std::nullopt; }},
};

constexpr Output<JudgedBatch> batchRows[] = {
    {{.key = "parts", .hint = "parts that were run"}, [](const JudgedBatch& b) { return b.parts; }},
    {{.key = "seed", .hint = "seed of their scatter"},
     [](const JudgedBatch& b) { return std::int64_t{b.seed}; }},
    {{.key = "bad", .hint = "rejected parts"}, [](const JudgedBatch& b) { return b.bad; }},
    {{.key = "interval_95",
      .hint = "95 % interval of the share of rejected parts; null for corners"},
     [](const JudgedBatch& b) { return b.interval; }},
    {{.key = "low_ppk_95",
      .hint = "95 % interval of the lowest P_pk, if it or the expected share outside does not meet "
              "the batch's limit; otherwise null"},
     [](const JudgedBatch& b) { return b.lowPpk; }},
};

constexpr Output<MeasuredBias> biasRows[] = {
    {{.key = "name",
      .hint = "requirement on the quantity whose measured mean differs from the predicted one; "
              "diameter_min for a diameter"},
     [](const MeasuredBias& b) { return std::string(requirementOf(b.kind).key); }},
    {{.key = "where", .hint = "zone, section or part"},
     [](const MeasuredBias& b) { return sectionOrPart(b.zone, b.section); }},
    {{.key = "bias_um", .unit = "µm", .hint = "measured mean less the predicted one"},
     [](const MeasuredBias& b) { return b.bias_um; }},
};

ordered_json judgementJson(const Judgement& judgement) {
    ordered_json json = outputsJson(judgementOutputs(), judgement);
    json["stocks"] = outputsJson(judgedStocksOutputs(), judgement.stocks);
    json["stocks"]["worst"] = outputsJson(
        requirementOutputs(), judgement.stocks ? judgement.stocks->worst : std::nullopt);
    json["batch"] = outputsJson(judgedBatchOutputs(), judgement.batch);
    json["measured"] = outputsJson(measuredBiasOutputs(), judgement.measured);
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

std::span<const Output<MeasuredBias>> measuredBiasOutputs() {
    return biasRows;
}

std::string judgedResultJson(const SimulationResult& result,
                             const std::vector<ConstraintResult>& constraints,
                             const Judgement& judgement) {
    ordered_json json = ordered_json::parse(resultJson(result, constraints));
    json["judged"] = judgementJson(judgement);
    return printJson(json);
}

namespace {

constexpr int significantDigits = 3;

} // namespace

std::string JudgementWording::number(double value, int decimals) const {
    return fixed(value, decimals);
}

std::string JudgementWording::stock(double value_mm) const {
    constexpr int decimals = 4; // 0.1 µm
    return number(value_mm, decimals);
}

std::string JudgementWording::requirement(ConstraintKind kind) const {
    std::string name = requirementOf(kind).label;
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return name;
}

std::string JudgementWording::where(const ConstraintResult& constraint) const {
    return whereText(constraint, First::inTexts);
}

std::string JudgementWording::amount(const ConstraintResult& constraint) const {
    const double amount = std::abs(constraint.margin);
    return number(amount, decimalsOf(amount, significantDigits));
}

std::string JudgementWording::value(const ConstraintResult& constraint) const {
    return number(constraint.value, decimalsOf(constraint.value, significantDigits));
}

std::string JudgementWording::filled(const char* text, TextPlaces places) const {
    return placedText(translated(text), places);
}

/// A share in per cent that never rounds to 0 or 100 %.
std::string JudgementWording::percent(double share) const {
    constexpr double hundred = 100, few = 10, nothing = 1e-6;
    const double value = hundred * share;
    const double toEnd = std::min(value, hundred - value);
    int decimals = value > 0 && value < few ? 1 : 0;
    if (toEnd > nothing && toEnd < 1) {
        decimals = std::max(1, static_cast<int>(std::ceil(-std::log10(toEnd))));
    }
    return number(value, decimals);
}

/// "minimum diameter by 10.7 µm", for a setting its sentence.
std::string JudgementWording::failure(RunStatus status,
                                      const std::optional<ConstraintResult>& worst) const {
    if (status != RunStatus::completed || !worst) {
        return translated(SPARKOUT_NOOP("Judgement", "the cycle does not end by itself"));
    }
    const Requirement& row = requirementOf(worst->kind);
    if (!row.broken || row.isOfSurface()) {
        return filled(*row.unit ? SPARKOUT_NOOP("Judgement", "{name} by {amount} {unit}")
                                : SPARKOUT_NOOP("Judgement", "{name} by {amount}"),
                      {{"name", requirement(worst->kind)},
                       {"amount", amount(*worst)},
                       {"unit", unit(row.unit)}});
    }
    std::string text = ofRequirement(row.broken);
    const auto put = [&text](const char* place, const std::string& what) {
        if (const std::size_t at = text.find(place); at != std::string::npos) {
            text.replace(at, std::string(place).size(), what);
        }
    };
    put("%1", where(*worst));
    put("%2", amount(*worst));
    put("%3", value(*worst));
    return text;
}

/// "17 of 50 (21…49 %)".
std::string JudgementWording::bad(const JudgedBatch& batch) const {
    const std::string count = number(static_cast<double>(batch.bad), 0);
    const std::string parts = number(static_cast<double>(batch.parts), 0);
    if (!batch.interval) {
        return filled(SPARKOUT_NOOP("Judgement", "{bad} of {parts}"),
                      {{"bad", count}, {"parts", parts}});
    }
    return filled(batch.bad == 0 ? SPARKOUT_NOOP("Judgement", "{bad} of {parts} (≤ {high} %)")
                                 : SPARKOUT_NOOP("Judgement", "{bad} of {parts} ({low}…{high} %)"),
                  {{"bad", count},
                   {"parts", parts},
                   {"low", percent(batch.interval->low)},
                   {"high", percent(batch.interval->high)}});
}

std::string JudgementWording::differing(const MeasuredBias& bias) const {
    ConstraintResult place{bias.kind};
    place.zone = bias.zone;
    place.section = bias.section;
    const std::string name = bias.kind == ConstraintKind::diameterMin
                                 ? translated(SPARKOUT_NOOP("Judgement", "diameter"))
                                 : requirement(bias.kind);
    return filled(
        SPARKOUT_NOOP("Judgement", "Met, but measured parts differ from the prediction: "
                                   "{name}, {where}, by {value} {unit}"),
        {{"name", name},
         {"where", where(place)},
         {"value", (bias.bias_um > 0 ? "+" : "")
                       + number(bias.bias_um, decimalsOf(bias.bias_um, significantDigits))},
         {"unit", unit("µm")}});
}

std::string JudgementWording::withPpk(const char* text, const Interval& ppk) const {
    constexpr int decimals = 2;
    return filled(text, {{"low", number(ppk.low, decimals)}, {"high", number(ppk.high, decimals)}});
}

std::string JudgementWording::exceptions(const std::vector<Undecided>& undecided) const {
    std::string names;
    for (const Undecided& each : undecided) {
        names += (names.empty() ? "" : ", ") + requirement(each.kind);
    }
    return filled(SPARKOUT_NOOP("Judgement", "Met, except {names}: not decided"),
                  {{"names", names}});
}

std::string JudgementWording::headline(const Judgement& judgement) const {
    switch (judgement.state) {
    case JudgedState::notComputed:
        return translated(judgement.status == RunStatus::stopped
                              ? SPARKOUT_NOOP("Judgement", "Not computed: stopped")
                              : SPARKOUT_NOOP("Judgement", "Not computed: inputs refused"));
    case JudgedState::fails:
        return filled(SPARKOUT_NOOP("Judgement", "Not met: {what}"),
                      {{"what", failure(judgement.status, judgement.worst)}});
    case JudgedState::stocksFail:
        return filled(SPARKOUT_NOOP("Judgement", "Unfit for {share} % of stocks: {what}"),
                      {{"share", percent(judgement.stocks->failingShare)},
                       {"what", failure(judgement.stocks->status, judgement.stocks->worst)}});
    case JudgedState::batchFails:
        return filled(SPARKOUT_NOOP("Judgement", "Rejects in the batch: {bad}"),
                      {{"bad", bad(*judgement.batch)}});
    case JudgedState::measuredDiffer: return differing(*judgement.measured);
    case JudgedState::undecided: return exceptions(judgement.notDecided);
    case JudgedState::close:
        if (judgement.batch && judgement.batch->lowPpk) {
            return withPpk(
                SPARKOUT_NOOP("Judgement", "Met, Ppk of the batch too low: {low}…{high}"),
                *judgement.batch->lowPpk);
        }
        return filled(SPARKOUT_NOOP("Judgement", "Met, close to the limit: {name}, {share} %"),
                      {{"name", requirement(judgement.worst->kind)},
                       {"share", percent(std::max(judgement.worst->relativeMargin, 0.0))}});
    case JudgedState::batchNotRun:
        return translated(judgement.batch
                              ? SPARKOUT_NOOP("Judgement", "Fit for every stock; batch run in part")
                              : SPARKOUT_NOOP("Judgement", "Fit for every stock; batch not run"));
    case JudgedState::batchHolds:
        return filled(SPARKOUT_NOOP("Judgement", "Fit for the batch: rejected {bad}"),
                      {{"bad", bad(*judgement.batch)}});
    case JudgedState::stocksHold:
        return translated(SPARKOUT_NOOP("Judgement", "Fit for every stock"));
    case JudgedState::nominal: break;
    }
    return translated(SPARKOUT_NOOP("Judgement", "Nominal part only"));
}

std::string JudgementWording::stocks(const Judgement& judgement, bool areComing) const {
    if (!judgement.stocks) {
        return translated(areComing ? SPARKOUT_NOOP("Judgement", "Stocks: being decided")
                                    : SPARKOUT_NOOP("Judgement", "Stocks: not decided"));
    }
    const JudgedStocks& stocks = *judgement.stocks;
    return filled(
        stocks.holds
            ? SPARKOUT_NOOP("Judgement", "Every stock per side {from}…{to} mm: fit")
            : SPARKOUT_NOOP("Judgement", "Stocks per side {from}…{to} mm: {share} % unfit"),
        {{"from", stock(stocks.range.from_mm)},
         {"to", stock(stocks.range.to_mm)},
         {"share", percent(stocks.failingShare)}});
}

std::string JudgementWording::batch(const Judgement& judgement, bool isComing) const {
    if (!judgement.batch) {
        return translated(isComing ? SPARKOUT_NOOP("Judgement", "Batch: being run")
                                   : SPARKOUT_NOOP("Judgement", "Batch: not run"));
    }
    const std::string text = filled(SPARKOUT_NOOP("Judgement", "Batch: rejected {bad}"),
                                    {{"bad", bad(*judgement.batch)}});
    return judgement.batch->lowPpk ? text
                                         + withPpk(SPARKOUT_NOOP("Judgement", "; Ppk {low}…{high}"),
                                                   *judgement.batch->lowPpk)
                                   : text;
}

std::string JudgementWording::notDecided(const Undecided& undecided) const {
    const auto why = [](UndecidedReason reason) {
        switch (reason) {
        case UndecidedReason::notCalibrated:
            return SPARKOUT_NOOP("Judgement", "{name}: not calibrated");
        case UndecidedReason::inputMissing:
            return SPARKOUT_NOOP("Judgement", "{name}: input missing");
        case UndecidedReason::machineNotKnown: break;
        }
        return SPARKOUT_NOOP("Judgement", "{name}: machine not known");
    };
    return filled(why(undecided.reason), {{"name", requirement(undecided.kind)}});
}

} // namespace sparkout
