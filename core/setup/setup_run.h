// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/piece_time.h"
#include "core/setup/setup.h"
#include "core/setup/surface_run.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// The cycles of a set-up in their order, each with the wheel as those before have left it.
struct SetupRun {
    std::vector<SurfaceRun> surfaces;
    /// Faults of the surface after those that were run, with the wheel as it comes to it, by their
    /// paths in its project: the run ends before it.
    Issues issues;
    PieceTime time; ///< once every surface is completed

    [[nodiscard]] bool isCompleted(const Setup& setup) const;
    [[nodiscard]] bool holds(const Setup& setup) const;
};

/// Runs every surface. A stop leaves those that were run.
[[nodiscard]] SetupRun runSetup(const Setup& setup, const std::stop_token& stop = {});

} // namespace sparkout
