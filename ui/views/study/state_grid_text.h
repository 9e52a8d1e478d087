// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/state_grid.h"
#include "ui/session/job.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QString>

#include <cstddef>
#include <memory>
#include <optional>

namespace sparkout {

/// A grid of dynamic programming as an immutable value of the window. The proven answer comes later
/// than the grid.
struct StateGridOutcome {
    Project project; ///< unchanged, with its own search
    StateGrid grid;
    std::optional<ExactAnswer> exact;
};

using StateGridOutcomePtr = std::shared_ptr<const StateGridOutcome>;

/// The units in which the progress of a proof is counted.
inline constexpr std::int64_t gridProofParts = 1000;

/// Null after a stop.
[[nodiscard]] StateGridOutcomePtr filledGrid(const Project& project, StateGridSize size,
                                             const Job::Means& means);
/// With the proven answer; after a stop with what is known.
[[nodiscard]] StateGridOutcomePtr provenGrid(const StateGridOutcome& filled,
                                             const Job::Means& means);

/// A moment of filling a grid: states are filled level by level, in each from the least feed on;
/// then the path is read back from the last level.
struct GridMoment {
    int level = 0; ///< level of the current state; 0: the blank, nothing is filled
    std::size_t feed = 0;
    int stepsBack = 0; ///< states read back so far, with that one
};

/// The number of moments after that of the blank.
[[nodiscard]] int momentCount(const StateGrid& grid);
[[nodiscard]] GridMoment momentAt(const StateGrid& grid, int number);
/// The moment in which a state is filled.
[[nodiscard]] int momentOf(const StateGrid& grid, int level, std::size_t feed);
/// The moment of the last filled state.
[[nodiscard]] int momentsOfFilling(const StateGrid& grid);

/// Texts of the page on dynamic programming.
class StateGridText {
    Q_DECLARE_TR_FUNCTIONS(StateGridText)
public:
    static QString progress(qint64 done, qint64 parts, double left_s);
    static QString fault(StateGridFault fault);  ///< why there is no grid; empty if there is one
    static TimeUnit unit(const StateGrid& grid); ///< unit of the times of its states
    static QString amount(double time_s, const TimeUnit& unit); ///< "8.241", without the unit
    static QString time(double time_s); ///< time of a whole cycle, with its unit
    static QString feed(const StageSetting& setting, Operation operation); ///< "0.004 · 1800"
    static QString state(int level, std::size_t feed);                     ///< "[5, 3]"
    static QString cycle(const Cycle& cycle);
    /// The size of the grid: "20 levels, 40 feeds, up to 3 stages".
    static QString size(const StateGrid& grid);
    /// The rule's answer and, once it is known, the proven one, with the faults of the rule.
    static QString answer(const StateGrid& grid, const std::optional<ExactAnswer>& exact);
    static QString ruleAnswer(const StateGrid& grid);
    static QString provenAnswer(const ExactAnswer& exact);
    static QString faults(const StateGrid& grid, const ExactAnswer& exact);
    static QString wrong(const StateDifference& fault); ///< why a state is wrong
    /// The kept move of a state, the slower ones and those struck out, by cause.
    static QString moves(const StateGrid& grid, int level, std::size_t feed);
    static QString moment(const StateGrid& grid, const GridMoment& moment);
    static QString struckOut(const GridState& state); ///< "burn 2, stages 1"; may be empty
};

} // namespace sparkout
