// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamic_programming/exact_answer.h"
#include "core/dynamic_programming/state_grid.h"
#include "ui/session/counted_job.h"

#include <memory>
#include <optional>

namespace sparkout {

/// A grid of dynamic programming as the window has it: an immutable value. The proven answer comes
/// later than the grid.
struct StateGridOutcome {
    Project project; ///< as it was, with its own search
    StateGrid grid;
    std::optional<ExactAnswer> exact;
};

using StateGridOutcomePtr = std::shared_ptr<const StateGridOutcome>;

/// Fills grids and proves answers off the window's thread.
class StateGridRunner : public CountedJob {
    Q_OBJECT

public:
    using CountedJob::CountedJob;

    void fill(const Project& project, StateGridSize size);
    void prove(const StateGridOutcomePtr& filled);
    /// Of the progress, in parts.
    static constexpr std::int64_t proofParts = 1000;

signals:
    void filled(sparkout::StateGridOutcomePtr outcome); ///< null after a stop
    void proved(sparkout::StateGridOutcomePtr outcome); ///< after a stop with what is known
};

} // namespace sparkout
