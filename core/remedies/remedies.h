// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/remedies/remedy_setting.h"
#include "core/simulation/result.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

/// Changes of one setting after which a cycle that fails holds everything, or one that is close to
/// a limit has room, and which hold whatever the stock of the blank within one phase: where the
/// last step of a stage falls changes with it, and the size too.
///
/// Under gauge control each cycle that is offered holds for every stock within half its largest
/// infeed of the stated one, usualPhases(): that is decided. Under position control it holds for
/// sixteen stocks a stage, stockPhases(), and then for those drawn afresh, failingPhase(): there is
/// no more than a confidence, mostFailing().
///
/// Each setting is tried at values ever farther from where it is and to both sides, until all
/// holds: one by one where there are few and, of a count, near by, else each half as far again as
/// the one before. Between the last value that did not hold and the first that did the edge is
/// found by bisection. All values are such as can be set, and every one is run in full: the value
/// offered holds, and the next one towards the present value does not. Between the values that were
/// tried others may hold, too; that is not excluded, since a cycle does not answer evenly.
namespace sparkout {

/// What a remedy is to reach.
enum class RemedyGoal {
    none,  ///< all holds, with room: nothing is looked for
    holds, ///< every requirement holds, and the cycle ends by itself
    room,  ///< none is close to its limit, either
};

/// Its name in files and on the command line: "holds".
[[nodiscard]] const char* goalKey(RemedyGoal goal);

/// What the outcome of a valid project that ran asks for.
[[nodiscard]] RemedyGoal remedyGoal(const SimulationResult& result,
                                    const std::vector<ConstraintResult>& constraints);

struct Remedy {
    RemedySetting setting;
    double value = 0; ///< that the setting is to have
    /// The next one towards the present value; run, and it fails. Nothing where that one holds, but
    /// brings a warning, or is a stage more with the feed there is.
    std::optional<double> failing{};
    bool holdsBeyond = false; ///< of the values tried, the next one farther off holds, too
    double time_s = 0;        ///< of the cycle
    std::optional<double> timeChange_s{}; ///< against the cycle as it is, if that ends by itself
    std::vector<ConstraintResult> requirements{}; ///< the worst of each kind
    std::optional<StockRange> stocks{}; ///< per side, for each of which it was decided to hold
    int phases = 0;                     ///< else stocks drawn afresh for it that it holds for
    int candidate = 0; ///< its number among the changes that were tried on such, from 1

    [[nodiscard]] Project applied(Project project) const {
        return setting.applied(std::move(project), value);
    }
    /// The value there is; nothing for a stage more.
    [[nodiscard]] std::optional<double> before() const {
        return setting.addsStage() ? std::nullopt : std::optional(setting.before);
    }
};

/// Why no single setting helps, of the values that were tried.
struct RemedyConflict {
    enum class Kind {
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

struct RemedyResult {
    static constexpr std::size_t most = 3;

    RemedyGoal goal = RemedyGoal::none;
    std::vector<Remedy> remedies;           ///< at most three; that with the shortest cycle first
    std::size_t found = 0;                  ///< settings that help
    std::size_t tried = 0;                  ///< settings that were tried
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

/// Of a cycle that ran, with its requirements. The answer does not depend on how fast the computer
/// is, unless the time is up.
[[nodiscard]] RemedyResult findRemedies(const SimulationResult& result,
                                        const std::vector<ConstraintResult>& constraints,
                                        const RemedyOptions& options = {});

} // namespace sparkout
