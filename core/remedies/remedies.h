// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/remedies/remedy_setting.h"
#include "core/result.h"
#include "core/simulation/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

/// Changes of one setting after which a cycle that fails holds everything, or one that is close to
/// a limit has room; beside them a starting cycle for the part as it is and, where no single
/// setting helps, the stock of finishing together with a slower feed of the first stage. A value is
/// good where that is so
///
/// * for the part as stated,
/// * whatever the stock of the blank within one phase: where the last step of a stage falls changes
///   with it, and the size too. Under gauge control that is decided for every stock within half the
///   largest infeed of the stated one, usualPhases(); under position control it is tried on sixteen
///   stocks a stage, stockPhases(), and then on those drawn afresh, failingPhase(): there is no
///   more than a confidence, mostFailing();
/// * for the parts of the project's batch, if it has one: no more of them are bad than its
///   `most_outside_share` allows.
///
/// Each setting is tried at values ever farther from where it is and to both sides, until one is
/// good: one by one where there are few and, of a count, near by, else each half as far again as
/// the one before. Between the last value that was not good and the first that was the edge is
/// found by bisection. From there on value after value is run until one is not good, or there are
/// Remedy::mostValues: the interval of the remedy. All its values can be set, each was run in full
/// and is good; a control that misses by a step, or an input that is not quite as stated, does not
/// leave it. Its middle is offered, if of as many parts of the batch drawn afresh for it no greater
/// share is bad than allowed. Outside the intervals other values may be good, too; that is not
/// excluded, since a cycle does not answer evenly.
///
/// Remedies are in the order of what they cost: the change of the cycle's time as a share of it,
/// and half the logarithm of how many times as much the setting becomes, of a pair of both; a tenth
/// a double stroke or revolution, 0.3 for one more stage, 0.6 for a starting cycle.
namespace sparkout {

/// What a remedy is to reach.
enum class RemedyGoal {
    none,  ///< all holds, with room: nothing is looked for
    holds, ///< every requirement holds, and the cycle ends by itself
    room,  ///< none is close to its limit, either
};

/// Its name in files and on the command line: "holds".
[[nodiscard]] const char* goalKey(RemedyGoal goal);

/// What the outcome of a valid project that ran asks for, as far as the part as stated tells.
[[nodiscard]] RemedyGoal remedyGoal(const SimulationResult& result,
                                    const std::vector<ConstraintResult>& constraints);

/// Parts of the batch drawn afresh for a remedy.
struct RemedyBatch {
    std::int64_t parts = 0, bad = 0;
    int candidate = 0; ///< number of the remedy among the changes that were tried on such, from 1
};

/// The largest share of bad parts, with 95 % confidence, of the k-th change that was tried on parts
/// drawn independently for it: the upper bound of Clopper and Pearson with a risk of
/// 0.05/(k·(k + 1)), so that all of them together have no more than 5 %, as with mostFailing().
[[nodiscard]] double mostBad(const RemedyBatch& batch);

struct Remedy {
    static constexpr int mostValues = 9; ///< of an interval

    RemedySetting setting;
    double value = 0; ///< that the setting is to have: the middle of the interval, of two middles
                      ///< the one farther from the present value
    Interval interval{}; ///< every value in it that can be set was run and is good
    int values = 0;      ///< so many
    /// The next one before the interval towards the present value; run, and it is not good. Nothing
    /// where that one is good, but brings a warning, or is a stage more with the feed there is, or
    /// was not run; of a pair the present value is not.
    std::optional<double> failing{};
    bool holdsBeyond = false;             ///< the next one behind the interval is good, too
    double time_s = 0;                    ///< of the cycle
    std::optional<double> timeChange_s{}; ///< against the cycle as it is, if that ends by itself
    std::vector<ConstraintResult> requirements{}; ///< the worst of each kind
    std::optional<StockRange> stocks{}; ///< per side, for each of which it was decided to hold
    int phases = 0;                     ///< else stocks drawn afresh for it that it holds for
    int candidate = 0; ///< its number among the changes that were tried on such, from 1
    std::optional<RemedyBatch> batch{}; ///< nothing: the project has none that can be run
    double rank = 0;                    ///< what it costs: the less, the better

    [[nodiscard]] Project applied(Project project) const {
        return setting.applied(std::move(project), value);
    }
    /// The value there is; nothing for a stage more or another cycle.
    [[nodiscard]] std::optional<double> before() const {
        return setting.addsStage() || setting.isWholeCycle() ? std::nullopt
                                                             : std::optional(setting.before);
    }
};

/// Why no single setting helps, of the values that were tried.
struct RemedyConflict {
    enum class Kind {
        narrow,   ///< the value below is good, but too few next to it are
        batch,    ///< all holds with the setting below for every stock, but too many parts of the
                  ///< batch are bad
        stocks,   ///< all holds with the setting below, but not for another stock of the phase
        warned,   ///< all holds with the setting below, which brings a warning
        idle,     ///< all holds with the setting below, but one more stage is run over
        opposed,  ///< what mends the first breaks the second, which holds as it is
        several,  ///< both fail; what mends the first does not mend the second, nor does any mend
                  ///< all
        unmended, ///< no setting mends the first; the one below brings it closest, if any does
    };
    Kind kind = Kind::unmended;
    std::optional<ConstraintResult> first;  ///< as it is; nothing: the cycle does not end by itself
    std::optional<ConstraintResult> second; ///< what fails most with the setting below, if any does
    std::optional<RemedySetting> setting;   ///< with which that is so
    double value = 0;                       ///< of the setting
    double stock_mm = 0;                    ///< per side, for which it fails with the setting
};

/// Its name in files and on the command line: "opposed".
[[nodiscard]] const char* conflictKey(RemedyConflict::Kind kind);

/// What is not good as it is.
enum class RemedyFault {
    none,   ///< all holds
    part,   ///< the part as stated
    stocks, ///< that holds, but another stock of the phase fails
    batch,  ///< every stock holds, but too many parts of the batch are bad
};
/// Its name in files: "stocks".
[[nodiscard]] const char* faultKey(RemedyFault fault);

struct RemedyResult {
    static constexpr std::size_t most = 3;

    RemedyGoal goal = RemedyGoal::none;
    RemedyFault fault = RemedyFault::none;
    std::vector<Remedy> remedies;           ///< at most three; that of the least rank first
    std::size_t found = 0;                  ///< settings that help
    std::size_t tried = 0;                  ///< settings that were tried, or need not be
    std::size_t settings = 0;               ///< that there are to try
    long long runs = 0;                     ///< of cycles
    bool stopped = false;                   ///< before all were tried, by a stop
    bool outOfTime = false;                 ///< or as the time was up
    std::optional<RemedyConflict> conflict; ///< all were tried, and none helps

    [[nodiscard]] bool isComplete() const { return tried == settings; }
};

struct RemedyOptions {
    std::stop_token stop; ///< ends it within a revolution of the cycle that runs
    /// Looked at before every run of a cycle; nothing: until all is tried.
    std::optional<std::chrono::steady_clock::duration> budget;
    /// Called after each setting with what was found so far.
    std::function<void(const RemedyResult&)> progress;
};

/// Of a cycle that ran, with its requirements. One that holds for the part as stated is looked at
/// for every stock of the phase and for the batch, too, and mended if it fails there. The answer
/// does not depend on how fast the computer is, unless the time is up.
[[nodiscard]] RemedyResult findRemedies(const SimulationResult& result,
                                        const std::vector<ConstraintResult>& constraints,
                                        const RemedyOptions& options = {});

} // namespace sparkout
