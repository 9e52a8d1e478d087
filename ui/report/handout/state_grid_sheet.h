// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/dynamic_programming/state_grid_outcome.h"
#include "ui/report/format/report.h"

#include <QCoreApplication>

#include <functional>

namespace sparkout::report {

/// The grid of dynamic programming in the hand-out: the rule, the grid, both answers, the way back
/// state by state. A project without a search uses a usual one.
class StateGridSheet {
    Q_DECLARE_TR_FUNCTIONS(StateGridSheet)
public:
    /// In the window's thread; `breathe` is called during the proof, which is abandoned after some
    /// seconds.
    static std::vector<Block> blocks(const OutcomePtr& outcome,
                                     const std::function<void()>& breathe);

private:
    static Table wayBack(const StateGrid& grid);
    static Table wrongStates(const ExactAnswer& exact);
};

} // namespace sparkout::report
