// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/quality/verdict.h"
#include "core/result.h"
#include "core/simulation/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

/// Judgement of a cycle as fit: for the part that was run, for every stock of the blank within one
/// infeed, and for the batch if there is one. The window, its reports and the command line all
/// state this judgement.
namespace sparkout {

/// Reason why a requirement cannot be decided.
enum class UndecidedReason {
    notCalibrated,  ///< the value is an estimate whose range contains the limit
    inputMissing,   ///< only some of the inputs of its limit are given
    machineNotKnown ///< its value does not include the machine's own form
};
/// Returns the key of a reason in files: "not_calibrated".
[[nodiscard]] const char* reasonKey(UndecidedReason reason);

struct Undecided {
    ConstraintKind kind;
    UndecidedReason reason;
    std::string path; ///< JSON pointer of the input that would decide it
};
[[nodiscard]] std::span<const Output<Undecided>> undecidedOutputs();

/// Returns the requirements of a project that cannot be decided, in the order of the kinds. A
/// requirement that fails in any case is decided and not among them.
[[nodiscard]] std::vector<Undecided> undecided(const Project& project,
                                               const std::vector<ConstraintResult>& constraints);

/// Judgement of the cycle over every stock of usualPhases().
struct JudgedStocks {
    StockRange range;
    bool holds = false;
    /// Share of failing stocks, with stocks distributed evenly over the range; 0…1.
    double failingShare = 0;
    /// Status of stocks whose cycle does not end by itself; completed if there are none.
    RunStatus status = RunStatus::completed;
    /// The requirement to report first, at the stock where it is worst; settings only if not met.
    /// Empty if none is checked.
    std::optional<ConstraintResult> worst{};
    /// For a machine with an unknown number of lobes whose cycle is fit with an odd number: the
    /// requirement that fails for some stocks with an even number.
    std::optional<ConstraintKind> failsIfEven{};
    bool hasOpenEstimate = false; ///< for some stock, the range of an estimate contains its limit
};

/// Greatest number of visits of radii, estimated beforehand, for a decision on the stocks: some
/// seconds of one processor.
inline constexpr std::int64_t mostJudgedVisits = 200'000'000;

/// Decides on the stocks of the project of a result. Returns nullopt under position control, if all
/// pieces together would take more than mostJudgedVisits by an estimate from the run, and after a
/// stop.
[[nodiscard]] std::optional<JudgedStocks> judgeStocks(const SimulationResult& result,
                                                      const std::stop_token& stop = {});

/// Judgement of a batch by its rejected parts.
struct JudgedBatch {
    std::int64_t parts = 0, bad = 0;
    int seed = 1;
    std::optional<Interval>
        interval;            ///< 95 % interval of the share of rejected parts; not for corners
    double allowedShare = 0; ///< allowed share of rejected parts: most_outside_share
    bool isWhole = false;    ///< every part of the batch was run
    /// 95 % interval of the least P_pk, where that or the expected share outside misses the batch's
    /// limit.
    std::optional<Interval> lowPpk{};

    [[nodiscard]] bool fails() const {
        return static_cast<double>(bad) > allowedShare * static_cast<double>(parts);
    }
    [[nodiscard]] bool holds() const { return isWhole && parts > 0 && !fails(); }
};
[[nodiscard]] JudgedBatch judgeBatch(const BatchResult& result, const BatchSummary& summary);

/// A quantity of measured parts whose mean differs from the predicted one.
struct MeasuredBias {
    /// The requirement on the quantity; on a diameter its minimum.
    ConstraintKind kind = ConstraintKind::diameterMin;
    Zone zone = Zone::section;
    int section = -1;   ///< −1: the whole part
    double bias_um = 0; ///< measured mean less the predicted one
};

/// State of a cycle: the first of these that applies.
enum class JudgedState {
    notComputed,    ///< inputs refused, or stopped
    fails,          ///< the part that was run fails
    stocksFail,     ///< the cycle fails for some stocks within one infeed
    batchFails,     ///< more parts of the batch are rejected than allowed
    measuredDiffer, ///< measured parts differ from the prediction, which meets all requirements
    undecided,      ///< all requirements are met except those that cannot be checked
    close,          ///< all requirements are met, with little margin or a low P_pk of the batch
    batchNotRun,    ///< the cycle is fit for every stock; its batch was not run, or only in part
    batchHolds,
    stocksHold, ///< the cycle is fit for every stock within one infeed; there is no batch
    nominal     ///< the part that was run is good; other parts are not known
};
/// Returns the key of a state in files: "stocks_fail".
[[nodiscard]] const char* stateKey(JudgedState state);
/// Returns whether a state is one of the first four, in which the cycle is not fit.
[[nodiscard]] constexpr bool isFailure(JudgedState state) {
    return state <= JudgedState::batchFails;
}

struct Judgement {
    JudgedState state = JudgedState::notComputed;
    RunStatus status = RunStatus::refused; ///< status of the part that was run
    /// The requirement to report first, over all judged stocks; settings only if not met. If the
    /// part that was run fails, it is a requirement of that part. Empty if none is checked.
    std::optional<ConstraintResult> worst;
    std::optional<JudgedStocks> stocks;   ///< empty: not decided
    std::optional<JudgedBatch> batch;     ///< empty: there is no batch, or it was not run
    std::optional<MeasuredBias> measured; ///< empty: no measured parts differ from a prediction
    std::vector<Undecided> notDecided;

    [[nodiscard]] bool isNominalGood() const {
        return state != JudgedState::notComputed && state != JudgedState::fails;
    }
    /// Whether the state is that of the stocks or of the batch, not only of the part that was run.
    [[nodiscard]] bool isOfMoreParts() const {
        using enum JudgedState;
        return state == stocksFail || state == batchFails || state == batchNotRun
               || state == batchHolds || state == stocksHold
               || (state == close && batch && batch->lowPpk);
    }
};

/// Judges a run by its requirements and, where given, its stocks, its batch and measured parts.
/// Unless the project's batch counts, as in a laboratory work, it is not missed.
[[nodiscard]] Judgement judge(const SimulationResult& result,
                              const std::vector<ConstraintResult>& constraints,
                              std::optional<JudgedStocks> stocks = {},
                              std::optional<JudgedBatch> batch = {},
                              std::optional<MeasuredBias> measured = {}, bool countsBatch = true);

/// Returns the judgement of a cycle together with its batch, which was run later.
[[nodiscard]] Judgement judgedWith(Judgement judgement, const JudgedBatch& batch);

} // namespace sparkout
