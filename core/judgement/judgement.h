// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"
#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/quality/light.h"
#include "core/result.h"
#include "core/simulation/result.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// The one notion of a cycle that is fit: for the part that was run, for every stock of the blank
/// within one infeed, and for the batch where there is one. The window, its papers and the command
/// line state this and nothing else.
namespace sparkout {

/// Why a requirement that is asked for is not decided.
enum class UndecidedReason {
    notCalibrated,  ///< its value is an estimate, and the limit lies within its range
    inputMissing,   ///< some of the inputs that its limit rests on are given, but not all
    machineNotKnown ///< the machine's own form is not in its value
};
/// Its name in files: "not_calibrated".
[[nodiscard]] const char* reasonKey(UndecidedReason reason);

struct Undecided {
    ConstraintKind kind;
    UndecidedReason reason;
    std::string path; ///< of the input that decides it, a JSON pointer
};

/// What a project asks for and nothing can check, in the order of the kinds. What fails even so is
/// decided, and not among it.
[[nodiscard]] std::vector<Undecided> undecided(const Project& project,
                                               const std::vector<ConstraintResult>& constraints);

/// The cycle over every stock of usualPhases().
struct JudgedStocks {
    StockRange range;
    bool holds = false;
    /// Of stocks spread evenly over the range, the share that fails; 0…1.
    double failingShare = 0;
    /// Of the stocks whose cycle does not end by itself how it ends; else completed.
    RunStatus status = RunStatus::completed;
    /// The requirement to speak of first, at the stock where it is worst; of the settings only one
    /// that fails. Nothing where none is checked.
    std::optional<ConstraintResult> worst{};
    /// Of a machine whose number of lobes is not known, where all holds with an odd one: the
    /// requirement that fails for some stocks with an even one.
    std::optional<ConstraintKind> failsIfEven{};
    bool hasOpenEstimate = false; ///< whose limit lies within its range, for some stock
};

/// Visits of a radius that a decision on the stocks may take, estimated before it begins: some
/// seconds of one processor.
inline constexpr std::int64_t mostJudgedVisits = 200'000'000;

/// Decides over the stocks of the project of a result. Nothing under position control, where the
/// run took so many visits that all of its pieces would take more than mostJudgedVisits, and when
/// stopped.
[[nodiscard]] std::optional<JudgedStocks> judgeStocks(const SimulationResult& result,
                                                      const std::stop_token& stop = {});

/// The parts of a batch that are not good.
struct JudgedBatch {
    std::int64_t parts = 0, bad = 0;
    int seed = 1;
    std::optional<Interval> interval; ///< 95 %, of the share that is bad; not of corners
    double allowedShare = 0;          ///< that may be bad: most_outside_share
    bool isWhole = false;             ///< every part of the batch was run

    [[nodiscard]] bool fails() const {
        return static_cast<double>(bad) > allowedShare * static_cast<double>(parts);
    }
    [[nodiscard]] bool holds() const { return isWhole && parts > 0 && !fails(); }
};
/// Of a batch that ran.
[[nodiscard]] JudgedBatch judgeBatch(const BatchResult& result, const BatchSummary& summary);

/// How a cycle stands: the first of these that applies.
enum class JudgedState {
    notComputed, ///< inputs refused, or stopped
    fails,       ///< the part that was run
    stocksFail,  ///< for some stocks within one infeed
    batchFails,  ///< more parts of the batch than are allowed to
    undecided,   ///< but for what cannot be checked all holds
    close,       ///< all holds, with little room
    batchHolds,
    stocksHold, ///< for every stock within one infeed; there is no batch, or it is not run
    nominal     ///< the part that was run; nothing is known of others
};
/// Its name in files: "stocks_fail".
[[nodiscard]] const char* stateKey(JudgedState state);
/// Whether it is one of the four that do not hold.
[[nodiscard]] constexpr bool isFailure(JudgedState state) {
    return state <= JudgedState::batchFails;
}

struct Judgement {
    JudgedState state = JudgedState::notComputed;
    RunStatus status = RunStatus::refused; ///< of the part that was run
    /// The requirement to speak of first, over all stocks that were judged; of the settings only
    /// one that fails. Where the part that was run fails, it is that part's. Nothing where none is
    /// checked.
    std::optional<ConstraintResult> worst;
    std::optional<JudgedStocks> stocks; ///< nothing: not decided
    std::optional<JudgedBatch> batch;   ///< nothing: none, or not run
    std::vector<Undecided> notDecided;

    [[nodiscard]] bool isNominalGood() const {
        return state != JudgedState::notComputed && state != JudgedState::fails;
    }
};

/// Judges a run with its requirements by all that is known of it.
[[nodiscard]] Judgement judge(const SimulationResult& result,
                              const std::vector<ConstraintResult>& constraints,
                              std::optional<JudgedStocks> stocks = {},
                              std::optional<JudgedBatch> batch = {});

} // namespace sparkout
