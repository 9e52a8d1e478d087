// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/result.h"
#include "core/simulation/result.h"
#include "core/study/remedy_setting.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// Changes of one setting that make a failing cycle meet every requirement, or give a close one a
/// margin; also a starting cycle for the part and, if no single setting helps, the stock of
/// finishing together with a slower feed of the first stage. A value is good if this is so
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
/// Each setting is tried at values ever farther from the current one in both directions, until one
/// is good: one by one if there are few and, for a count, nearby, otherwise each half as far again
/// as the one before. The edge between the last bad value and the first good one is found by
/// bisection. From there value after value is run until one is bad, or there are
/// Remedy::mostValues: the interval of the remedy. All its values can be set, and each was run in
/// full and is good, so that it tolerates an error of a step, or of an input. Its middle is offered
/// if the share of rejected parts among as many newly drawn parts of the batch is allowed. Values
/// outside the intervals may be good, too, since the result of a cycle is not monotonic.
///
/// Remedies are ordered by rank: the relative change of the cycle's time, plus half the logarithm
/// of the ratio of the setting, for a pair of both; a tenth for each double stroke or revolution,
/// the share of the field for a target diameter, 0.3 for one more stage, 0.6 for a starting cycle.

namespace sparkout {

/// The goal of a remedy.
enum class RemedyGoal {
    none,  ///< all requirements are met with a margin: nothing is searched
    holds, ///< every requirement is met, and the cycle ends by itself
    room,  ///< also none is close to its limit
};

/// The key in files and on the command line: "holds".
[[nodiscard]] const char* goalKey(RemedyGoal goal);

/// The goal for the outcome of a valid project that ran, by its nominal part.
[[nodiscard]] RemedyGoal remedyGoal(const SimulationResult& result,
                                    const std::vector<ConstraintResult>& constraints);

/// Parts of the batch drawn for a remedy.
struct RemedyBatch {
    std::int64_t parts = 0, bad = 0;
    int candidate = 0; ///< number of the remedy among the changes tried on such parts, from 1
};

/// The largest share of bad parts, with 95 % confidence, of the k-th change tried on parts drawn
/// independently for it: the upper bound of Clopper and Pearson with a risk of 0.05/(k·(k + 1)), so
/// that all of them together have at most 5 %, like mostFailing().
[[nodiscard]] double mostBad(const RemedyBatch& batch);

struct Remedy {
    static constexpr int mostValues = 9; ///< in an interval

    RemedySetting setting;
    double value = 0; ///< offered value: the middle of the interval, of two middles the one farther
                      ///< from the current value
    Interval interval{}; ///< every value in it that can be set was run and is good
    int values = 0;      ///< number of values
    /// The next value before the interval towards the current one, which was run and is bad. Empty
    /// if it is good but adds a warning, or if it is one more stage with the current feed, or was
    /// not run; for a pair the current value does not count.
    std::optional<double> failing{};
    bool holdsBeyond = false;             ///< the next value behind the interval is good, too
    double time_s = 0;                    ///< time of the cycle
    std::optional<double> timeChange_s{}; ///< of the unchanged cycle, if that ends by itself
    std::vector<ConstraintResult> requirements{}; ///< the worst of each kind
    std::optional<StockRange> stocks{}; ///< per side, for all of which it was decided to be good
    int phases = 0;    ///< otherwise the number of random stocks for which it is good
    int candidate = 0; ///< number among the changes tried on such stocks, from 1
    std::optional<RemedyBatch> batch{}; ///< empty: the project has no valid batch
    double rank = 0;                    ///< less is better

    [[nodiscard]] Project applied(Project project) const {
        return setting.applied(std::move(project), value);
    }
    /// The current value; empty for an additional stage or another cycle.
    [[nodiscard]] std::optional<double> before() const {
        return setting.addsStage() || setting.isWholeCycle() ? std::nullopt
                                                             : std::optional(setting.before);
    }
};

/// The reason why no single setting helps, among the tried values.
struct RemedyConflict {
    enum class Kind {
        narrow,   ///< the value below is good, but too few neighbours are
        batch,    ///< with the setting below all is met for every stock, but too many parts of the
                  ///< batch are rejected
        stocks,   ///< with the setting below all is met, but not for another stock
        warned,   ///< with the setting below all is met, but it adds a warning
        idle,     ///< with the setting below all is met, but one more stage is overrun
        opposed,  ///< a remedy for the first violates the second, which is met now
        several,  ///< both are violated; remedies for the first do not help the second, and none
                  ///< helps all
        unmended, ///< no setting helps the first; the one below comes nearest, if any
    };
    Kind kind = Kind::unmended;
    std::optional<ConstraintResult> first;  ///< unchanged; empty: the cycle does not end
    std::optional<ConstraintResult> second; ///< the worst violation with the setting below, if any
    std::optional<RemedySetting> setting;   ///< the setting of the conflict
    double value = 0;                       ///< value of the setting
    double stock_mm = 0;                    ///< per side, at which it fails with the setting
};

/// The key in files and on the command line: "opposed".
[[nodiscard]] const char* conflictKey(RemedyConflict::Kind kind);

/// The failure of the unchanged cycle.
enum class RemedyFault {
    none,   ///< all is met
    part,   ///< the nominal part
    stocks, ///< the nominal part is good, but another stock fails
    batch,  ///< every stock is good, but too many parts of the batch are rejected
};
/// The key in files: "stocks".
[[nodiscard]] const char* faultKey(RemedyFault fault);

struct RemedyResult {
    static constexpr std::size_t most = 3;

    RemedyGoal goal = RemedyGoal::none;
    RemedyFault fault = RemedyFault::none;
    std::vector<Remedy> remedies;           ///< at most three, by rank
    std::size_t found = 0;                  ///< settings that help
    std::size_t tried = 0;                  ///< settings that were tried, or need not be
    std::size_t settings = 0;               ///< number of settings to try
    long long runs = 0;                     ///< number of cycles
    bool stopped = false;                   ///< before all were tried, by a stop
    bool outOfTime = false;                 ///< or by the time limit
    std::optional<RemedyConflict> conflict; ///< all were tried, and none helps

    [[nodiscard]] bool isComplete() const { return tried == settings; }
};

struct RemedyOptions {
    std::stop_token stop; ///< ends it within a revolution of the running cycle
    /// Checked before every run of a cycle; empty: until all is tried.
    std::optional<std::chrono::steady_clock::duration> budget;
    /// Called after each setting with the results so far.
    std::function<void(const RemedyResult&)> progress;
};

/// For a cycle that ran, with its requirements. If it is good for the nominal part, it is checked
/// for every stock and for the batch, too, and remedies are searched if it fails there. The answer
/// does not depend on the computer's speed, except for the time limit.
[[nodiscard]] RemedyResult findRemedies(const SimulationResult& result,
                                        const std::vector<ConstraintResult>& constraints,
                                        const RemedyOptions& options = {});

/// A remedy of a project.
struct RemedyOf {
    const Project& project;
    const Remedy& remedy;
};

/// The data of a conflict for its outputs.
struct RemedyConflictOf {
    const Project& project;
    const RemedyConflict& conflict;
};

[[nodiscard]] std::span<const Output<RemedyOf>> remedyOutputs();
/// The random stocks for which a remedy is good.
[[nodiscard]] std::span<const Output<Remedy>> remedyPhasesOutputs();
/// The random parts of the batch for a remedy.
[[nodiscard]] std::span<const Output<RemedyBatch>> remedyBatchOutputs();
[[nodiscard]] std::span<const Output<RemedyConflictOf>> remedyConflictOutputs();
[[nodiscard]] std::span<const Output<RemedyResult>> remedyResultOutputs();

/// The object of `remedies --json`.
[[nodiscard]] std::string remediesJson(const Project& project, const RemedyResult& found);

} // namespace sparkout
