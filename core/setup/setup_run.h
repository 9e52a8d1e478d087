// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/piece_time.h"
#include "core/setup/setup.h"
#include "core/setup/surface_run.h"

#include <stop_token>
#include <vector>

namespace sparkout {

/// The cycles of a set-up in their order, each with the wheel as the earlier cycles leave it.
struct SetupRun {
    std::vector<SurfaceRun> surfaces;
    /// Faults of the first surface that was not run, with the wheel in its state there, by their
    /// paths in its project.
    Issues issues;
    PieceTime time; ///< given when every surface is completed

    [[nodiscard]] bool isCompleted(const Setup& setup) const;
    [[nodiscard]] bool holds(const Setup& setup) const;
};

/// Runs every surface. A stop keeps the finished ones.
[[nodiscard]] SetupRun runSetup(const Setup& setup, const std::stop_token& stop = {});

} // namespace sparkout
