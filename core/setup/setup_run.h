// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/result.h"
#include "core/setup/setup.h"
#include "core/setup/wheel_wear.h"
#include "core/simulation/result.h"

#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// The cycle of one surface of a set-up.
struct SurfaceRun {
    std::string name;
    SimulationResult result;
    std::vector<ConstraintResult> constraints;
    double removed_mm3 = 0;

    [[nodiscard]] RemovedMetal removed() const { return removedMetal(result.project, removed_mm3); }
    [[nodiscard]] bool isCompleted() const { return result.status == RunStatus::completed; }
    [[nodiscard]] bool holds() const; ///< completed, and every checked requirement is met
};

[[nodiscard]] SurfaceRun runSurface(const std::string& name, const Project& project,
                                    const std::stop_token& stop);

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

/// A set-up and its run.
struct SetupRunOf {
    const Setup& setup;
    const SetupRun& run;
};

/// The outputs for the part as a whole.
[[nodiscard]] std::span<const Output<SetupRunOf>> setupOutputs();

/// One JSON object: "surfaces", each with its name and the keys of resultJson(), and "part" with
/// completed, holds and the times, which are null unless every surface is completed.
[[nodiscard]] std::string
setupJson(const Setup& setup, const SetupRun& run,
          const std::function<std::string(const SurfaceRun&)>& surfaceJson = {});

} // namespace sparkout
