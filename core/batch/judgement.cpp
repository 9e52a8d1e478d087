// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/judgement.h"

#include "core/process/printed_form.h"
#include "core/project/batch.h"
#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "core/quality/roughness.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace sparkout {

namespace {

/// Whether an estimate is known and lies on one side of its limit everywhere.
bool isDecided(ConstraintKind kind, const std::vector<ConstraintResult>& constraints) {
    const auto isIt = [kind](const ConstraintResult& each) { return each.kind == kind; };
    return std::ranges::any_of(constraints, isIt) && std::ranges::none_of(constraints, isOpen);
}

const Undecided roughnessNotKnown{ConstraintKind::roughness, UndecidedReason::notCalibrated,
                                  "/wheel/roughness_factor"};

std::optional<Undecided> undecidedOf(const Requirement& row, const Project& project,
                                     const std::vector<ConstraintResult>& constraints) {
    if (!isAskedFor(row, project)) {
        return std::nullopt;
    }
    if (std::string path = missingInput(row, project); !path.empty()) {
        return Undecided{row.kind, UndecidedReason::inputMissing, std::move(path)};
    }
    if (row.kind == ConstraintKind::roughness && !isRoughnessCalibrated(project)
        && !isDecided(row.kind, constraints)) {
        return roughnessNotKnown;
    }
    if (row.kind == ConstraintKind::waviness && !project.wheel->runout) {
        return Undecided{row.kind, UndecidedReason::inputMissing, "/wheel/runout"};
    }
    if (!knowsMachine(row.kind, project)) {
        return Undecided{row.kind, UndecidedReason::machineNotKnown, "/machine/form"};
    }
    return std::nullopt;
}

/// Keeps the worse of two; for settings only if not met.
void keepWorst(std::optional<ConstraintResult>& worst,
               const std::vector<ConstraintResult>& constraints) {
    for (const ConstraintResult& each : constraints) {
        const bool isSpokenOf =
            !each.holds || requirementOf(each.kind).scope != ConstraintScope::setting;
        if (isSpokenOf && (!worst || isWorse(each, *worst))) {
            worst = each;
        }
    }
}

JudgedStocks judgedStocks(const PhaseDecision& decision) {
    JudgedStocks stocks{.range = decision.range, .holds = decision.failing.empty()};
    for (const DecidedPiece& piece : decision.pieces) {
        for (const auto* end : {&piece.low.constraints, &piece.high.constraints}) {
            keepWorst(stocks.worst, *end);
            stocks.hasOpenEstimate |= std::ranges::any_of(*end, isOpen);
        }
        if (piece.piece.status != RunStatus::completed) {
            stocks.status = piece.piece.status;
        }
    }
    for (const FailingStocks& each : decision.failing) { // also of other phases of the wheel
        if (each.worst) {
            keepWorst(stocks.worst, {*each.worst});
        }
        stocks.status = each.status != RunStatus::completed ? each.status : stocks.status;
    }
    const double width_mm = decision.range.to_mm - decision.range.from_mm;
    if (!stocks.holds && width_mm > 0) {
        stocks.failingShare = failingShare(decision, [&](double stock_mm) {
                                  return (stock_mm - decision.range.from_mm) / width_mm;
                              }).failing;
    } else if (!stocks.holds) {
        stocks.failingShare = 1;
    }
    return stocks;
}

/// In the order of the kinds, without duplicates.
void addUndecided(std::vector<Undecided>& all, const Undecided& one) {
    const auto at = std::ranges::lower_bound(all, one.kind, {}, &Undecided::kind);
    if (at == all.end() || at->kind != one.kind) {
        all.insert(at, one);
    }
}

JudgedState stateOf(const Judgement& of, bool nominalFails, bool hasBatch) {
    if (of.status == RunStatus::refused || of.status == RunStatus::stopped) {
        return JudgedState::notComputed;
    }
    if (of.status != RunStatus::completed || nominalFails) {
        return JudgedState::fails;
    }
    if (of.stocks && !of.stocks->holds) {
        return JudgedState::stocksFail;
    }
    if (of.batch && of.batch->fails()) {
        return JudgedState::batchFails;
    }
    if (of.measured) {
        return JudgedState::measuredDiffer;
    }
    if (!of.notDecided.empty()) {
        return JudgedState::undecided;
    }
    if ((of.worst && isClose(*of.worst)) || (of.batch && of.batch->lowPpk)) {
        return JudgedState::close;
    }
    if (of.batch && of.batch->holds()) {
        return JudgedState::batchHolds;
    }
    return !of.stocks ? JudgedState::nominal
           : hasBatch ? JudgedState::batchNotRun
                      : JudgedState::stocksHold;
}

constexpr Output<Undecided> undecidedRows[] = {
    {{.key = "name", .hint = "of the requirement"},
     [](const Undecided& u) { return std::string(requirementOf(u.kind).key); }},
    {{.key = "why", .hint = "not_calibrated, input_missing or machine_not_known"},
     [](const Undecided& u) { return std::string(reasonKey(u.reason)); }},
    {{.key = "input", .hint = "JSON pointer of the input that decides it"},
     [](const Undecided& u) { return u.path; }},
};

} // namespace

std::span<const Output<Undecided>> undecidedOutputs() {
    return undecidedRows;
}

const char* reasonKey(UndecidedReason reason) {
    constexpr std::array keys{"not_calibrated", "input_missing", "machine_not_known"};
    return keys[static_cast<std::size_t>(reason)];
}

const char* stateKey(JudgedState state) {
    constexpr std::array keys{"not_computed",    "fails",       "stocks_fail", "batch_fails",
                              "measured_differ", "undecided",   "close",       "batch_not_run",
                              "batch",           "every_stock", "nominal"};
    return keys[static_cast<std::size_t>(state)];
}

std::vector<Undecided> undecided(const Project& project,
                                 const std::vector<ConstraintResult>& constraints) {
    std::vector<Undecided> found;
    for (const Requirement& row : requirementRows) {
        const bool fails = std::ranges::any_of(constraints, [&row](const ConstraintResult& each) {
            return each.kind == row.kind && !each.holds;
        });
        std::optional<Undecided> one = undecidedOf(row, project, constraints);
        if (one && !fails) {
            found.push_back(*std::move(one));
        }
    }
    return found;
}

std::optional<JudgedStocks> judgeStocks(const SimulationResult& result,
                                        const std::stop_token& stop) {
    const Project& project = result.project;
    if (result.status == RunStatus::refused || !canDecidePhases(project)) {
        return std::nullopt;
    }
    constexpr std::int64_t runsOfPiece = 2; // at both ends
    const std::int64_t most =
        mostJudgedVisits / (runsOfPiece * std::max<std::int64_t>(result.visits, 1));
    if (most < 1) {
        return std::nullopt;
    }
    const auto decided = [&](const Project& of) {
        const PhaseDecision decision = decidePhases(
            of, usualPhases(of), stop, std::min(static_cast<std::size_t>(most), mostDecidedPieces));
        return decision.isDecided ? std::optional(judgedStocks(decision)) : std::nullopt;
    };
    std::optional<JudgedStocks> stocks = decided(project);
    if (stocks && stocks->holds && areLobesUnknown(*project.machine)) {
        const std::optional<JudgedStocks> even = decided(withEvenLobes(project));
        if (!even) {
            return std::nullopt;
        }
        if (!even->holds && even->worst) {
            stocks->failsIfEven = even->worst->kind;
        }
    }
    return stocks;
}

JudgedBatch judgeBatch(const BatchResult& result, const BatchSummary& summary) {
    const Batch batch = result.project.batch.value_or(Batch{});
    JudgedBatch judged{summary.parts,
                       summary.bad.count,
                       batch.seed,
                       summary.bad.interval,
                       batch.most_outside_share.value_or(0),
                       result.status != BatchStatus::stopped};
    const BatchVerdict verdict = weigh(summary, result);
    if (verdict.missesForecast()) {
        judged.lowPpk = summary.characteristics[*verdict.characteristic].ppk->interval;
    }
    return judged;
}

Judgement judge(const SimulationResult& result, const std::vector<ConstraintResult>& constraints,
                std::optional<JudgedStocks> stocks, std::optional<JudgedBatch> batch,
                std::optional<MeasuredBias> measured, bool countsBatch) {
    Judgement judgement;
    judgement.measured = measured;
    judgement.status = result.status;
    keepWorst(judgement.worst, constraints);
    const bool fails = judgement.worst && !judgement.worst->holds;
    if (!fails && result.status == RunStatus::completed && stocks) {
        judgement.worst = stocks->worst;
    }
    judgement.notDecided = undecided(result.project, constraints);
    if (stocks && stocks->hasOpenEstimate) { // it may be decided for the part that was run
        addUndecided(judgement.notDecided, roughnessNotKnown);
    }
    judgement.stocks = std::move(stocks);
    judgement.batch = std::move(batch);
    if (!fails && judgement.stocks && judgement.stocks->failsIfEven) {
        addUndecided(judgement.notDecided,
                     {*judgement.stocks->failsIfEven, UndecidedReason::machineNotKnown,
                      "/machine/form/lobes"});
    }
    const bool hasBatch = (countsBatch && result.project.batch) || judgement.batch;
    judgement.state = stateOf(judgement, fails, hasBatch);
    return judgement;
}

Judgement judgedWith(Judgement judgement, const JudgedBatch& batch) {
    const bool fails = judgement.state == JudgedState::fails;
    judgement.batch = batch;
    judgement.state = stateOf(judgement, fails, true);
    return judgement;
}

} // namespace sparkout
