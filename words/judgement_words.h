// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/judgement.h"
#include "core/result.h"
#include "words/issue_words.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// Judgements as texts. The English ones are defined here, marked for translation in the context
/// "Judgement": the command line prints them, the window and its documents translate them.

namespace sparkout {

/// A decision on the stocks; empty if there is none.
using StocksDecision = std::optional<JudgedStocks>;

[[nodiscard]] std::span<const Output<Judgement>> judgementOutputs();
[[nodiscard]] std::span<const Output<StocksDecision>> judgedStocksOutputs();
[[nodiscard]] std::span<const Output<JudgedBatch>> judgedBatchOutputs();
[[nodiscard]] std::span<const Output<MeasuredBias>> measuredBiasOutputs();

/// The object of `simulate --json`: that of resultJson() and, under "judged", the judgement of the
/// cycle for every stock within one infeed and, if it was run, for the batch and by measured parts:
///
///     { "state", "headline", "nominal",
///       "stocks": { "decided", "holds", "stock_mm", "failing_share", "worst" },
///       "batch": null or { "parts", "seed", "bad", "interval_95", "low_ppk_95" },
///       "measured": null or { "name", "where", "bias_um" },
///       "not_decided": [ { "name", "why", "input" }, … ] }
///
/// "worst" is an element of "constraints".
[[nodiscard]] std::string judgedResultJson(const SimulationResult& result,
                                           const std::vector<ConstraintResult>& constraints,
                                           const Judgement& judgement);

/// Formulates judgements; this class in English.
class JudgementWording {
public:
    JudgementWording() = default;
    virtual ~JudgementWording() = default;
    JudgementWording(const JudgementWording&) = delete;
    JudgementWording& operator=(const JudgementWording&) = delete;

    /// "Fit for the batch: 0 of 50 rejected (≤ 7.1 %)".
    [[nodiscard]] std::string headline(const Judgement& judgement) const;
    /// "Met, except roughness Ra: not decided".
    [[nodiscard]] std::string exceptions(const std::vector<Undecided>& undecided) const;
    /// "Every stock per side 0.1490…0.1510 mm: fit"; or why the stocks are not decided.
    [[nodiscard]] std::string stocks(const Judgement& judgement, bool areComing = false) const;
    /// "Batch: 0 of 50 rejected (≤ 7.1 %)"; or that it is not known.
    [[nodiscard]] std::string batch(const Judgement& judgement, bool isComing = false) const;
    /// "roughness Ra: not calibrated".
    [[nodiscard]] std::string notDecided(const Undecided& undecided) const;

protected:
    [[nodiscard]] virtual std::string translated(const char* text) const { return text; }
    /// With this number of decimals.
    [[nodiscard]] virtual std::string number(double value, int decimals) const;
    [[nodiscard]] virtual std::string stock(double value_mm) const;
    /// The name of a requirement within a sentence.
    [[nodiscard]] virtual std::string requirement(ConstraintKind kind) const;
    [[nodiscard]] virtual std::string where(const ConstraintResult& constraint) const;
    /// A text of the requirements' table.
    [[nodiscard]] virtual std::string ofRequirement(const char* text) const { return text; }
    /// An amount and a value, without and with their unit.
    [[nodiscard]] virtual std::string amount(const ConstraintResult& constraint) const;
    [[nodiscard]] virtual std::string value(const ConstraintResult& constraint) const;
    [[nodiscard]] virtual std::string unit(const char* unit) const { return unit; }

private:
    [[nodiscard]] std::string filled(const char* text, TextPlaces places) const;
    [[nodiscard]] std::string percent(double share) const;
    [[nodiscard]] std::string failure(RunStatus status,
                                      const std::optional<ConstraintResult>& worst) const;
    [[nodiscard]] std::string bad(const JudgedBatch& batch) const;
    [[nodiscard]] std::string differing(const MeasuredBias& bias) const;
    [[nodiscard]] std::string withPpk(const char* text, const Interval& ppk) const;
};

} // namespace sparkout
