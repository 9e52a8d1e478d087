// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/figure.h"
#include "core/quality/constraints.h"
#include "core/quality/shop_numbers.h"
#include "core/simulation/result.h"
#include "core/surface/accuracy.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// A run from which figures are read. The window has all of it in its outcome.
struct FigureSource {
    const SimulationResult& result;
    const PartAccuracy& accuracy;
    const std::vector<ConstraintResult>& constraints;
    const ShopNumbers& shop;
    const Trajectory& trajectory; ///< empty if the run was not recorded
};

/// A run from which figures are read.
struct StudiedRun {
    SimulationResult result;
    PartAccuracy accuracy;
    std::vector<ConstraintResult> constraints;
    ShopNumbers shop;
    Trajectory trajectory;

    [[nodiscard]] FigureSource figures() const {
        return {result, accuracy, constraints, shop, trajectory};
    }
    [[nodiscard]] bool isCompleted() const { return result.status == RunStatus::completed; }
};

/// Runs a project, recorded if requested and there is memory. A project refused by validate(), or a
/// stopped run, has only a status.
[[nodiscard]] StudiedRun studyRun(const Project& project, bool recorded,
                                  const std::stop_token& stop = {});

/// The value of a figure in its unit; empty if this run does not have it, or if it is not known
/// since strips stay uncut.
[[nodiscard]] std::optional<double> figureValue(const Figure& figure, const FigureSource& run);

} // namespace sparkout
