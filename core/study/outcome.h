// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/process/system_compliance.h"
#include "core/quality/constraints.h"
#include "core/quality/limit_series.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/feed_series.h"
#include "core/simulation/result.h"
#include "core/simulation/step_shares.h"
#include "core/simulation/stock_layers.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace sparkout {

/// All results of one run, as an immutable value. With errors among the issues nothing was run and
/// the rest is empty.
struct Outcome {
    Issues issues; ///< errors and warnings of the inputs
    SimulationResult result;
    Trajectory trajectory;
    FeedSeries feeds;      ///< the trajectory summed up pass by pass
    LayerSeries layers;    ///< layers with the means over the radii
    StepShares steps;      ///< by stage and step of the double strokes
    PartAccuracy accuracy; ///< form of every zone or section and of the part
    std::vector<ConstraintResult> constraints;
    LimitSeries limits;                     ///< depths of cut and the limits of the feed
    std::vector<CompliantPlace> compliance; ///< γ along the part; none where it is given
    ShopNumbers shop;

    [[nodiscard]] bool ran() const { return !hasErrors(issues); }
};

using OutcomePtr = std::shared_ptr<const Outcome>;

/// Checks a project, runs its cycle and checks the result against the drawing. Returns null when
/// stopped.
[[nodiscard]] OutcomePtr evaluate(const Project& project, const std::stop_token& stop = {});

} // namespace sparkout
