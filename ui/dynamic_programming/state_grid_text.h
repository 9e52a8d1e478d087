// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/exact_answer.h"
#include "core/dynamic_programming/state_grid.h"
#include "ui/dynamic_programming/state_grid_outcome.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QString>

#include <optional>

namespace sparkout {

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
    static QString wrong(const StateFault& fault); ///< why a state is wrong
    /// The kept move of a state, the slower ones and those struck out, by cause.
    static QString moves(const StateGrid& grid, int level, std::size_t feed);
    static QString moment(const StateGrid& grid, const GridMoment& moment);
    static QString struckOut(const GridState& state); ///< "burn 2, stages 1"; may be empty
};

} // namespace sparkout
